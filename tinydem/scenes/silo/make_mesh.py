#!/usr/bin/env python3
"""Write the silos, mesh.off and mesh_N.off, and the grains that fill them, particles.csv.

    python3 make_mesh.py        # writes all of them beside this file

Everything lies in the plane y = 0: the grains are spheres that roll and slide like discs, walls and
floor are edges. Lengths are in metres. The inside of the silo is |x| < WIDTH/2, z > 0; the orifice
is the free space between the rounded ends of two halves of the floor.
"""
from pathlib import Path

import numpy as np

DIAMETER = 0.006           # mean of a grain
SPREAD = 0.2               # radii differ by up to this share from the mean
WIDTH = 60 * DIAMETER
HEIGHT = 0.46               # of the walls
WALL = 0.002               # Rmesh: half the thickness of the walls
JITTER = 7e-5              # grains never stand exactly above each other
COLUMNS, ROWS, SEED = 49, 62, 1
ORIFICES = [10, 7, 8, 12, 15]  # widths in mean diameters; the first one is that of scene.ini


def off_text(orifice):
    """A silo as OFF text: two walls and two halves of a floor with an orifice [m] between them."""
    side, lip = WIDTH / 2 + WALL, orifice / 2 + WALL
    vertices = [(sign * x, z) for sign in (-1, 1)
                for x, z in ((side, HEIGHT), (side, -WALL), (lip, -WALL))]
    lines = ["OFF", f"# A silo with an orifice of {orifice:g} m, written by make_mesh.py.", "6 4 0"]
    lines += [f"{x:.6g} 0 {z:.6g}" for x, z in vertices]
    return "\n".join([*lines, "2 0 1 0", "2 1 2 0", "2 3 4 0", "2 4 5 0"]) + "\n"


def csv_text():
    """Grains on a loose square lattice; they fall together when the run starts."""
    random = np.random.default_rng(SEED)
    step = WIDTH / COLUMNS
    lines = ["x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"]
    for row in range(ROWS):
        for column in range(COLUMNS):
            radius = DIAMETER / 2 * (1 + SPREAD * random.uniform(-1, 1))
            x = step * (column + 0.5) - WIDTH / 2 + JITTER * random.uniform(-1, 1)
            z = step * (row + 0.5)
            lines.append(f"{x:.6g},0,{z:.6g},{radius:.5g},0,0,0,1,0,0,0,0,0,0")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    here = Path(__file__).parent
    for k, width in enumerate(ORIFICES):
        name = f"mesh_{width}.off" if k else "mesh.off"
        (here / name).write_text(off_text(width * DIAMETER))
    (here / "particles.csv").write_text(csv_text())

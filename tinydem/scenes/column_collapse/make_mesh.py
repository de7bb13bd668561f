#!/usr/bin/env python3
"""Write mesh.off, the ground, and columns of grains at rest, particles.csv and particles_N.csv.

    python3 make_mesh.py        # writes them beside this file, takes half a minute

The tallest column is made by the program: grains fall together inside a tube and come to rest. The
lower columns are its lower parts. Set TINYDEM to the program if it is not build/default/tinydem.
Lengths are in metres.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))  # tinydem/
from frames import fail, read_run, read_scene  # noqa: E402

DIAMETER = 0.006  # mean of a grain
SPREAD = 0.1      # radii differ by up to this share from the mean
JITTER = 8e-4     # of the places where they start to fall
TUBE = 0.048      # radius of the columns
ASPECTS = {"particles": 2, "particles_4": 4, "particles_1": 1, "particles_05": 0.5}
GROUND = 0.6      # half a side of the ground
SIDES = 24        # of the tube
FILL = 0.65       # share of the tube that the grains would fill, more than they do
SETTLE = 9000     # time steps until the column rests


def ground():
    """Corners and faces of the ground, one square at z = 0."""
    corners = [(x, y, 0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return GROUND * np.array(corners), ["4 0 1 2 3 0"]


def tube(height):
    """Corners and faces of the ground with a tube on it, SIDES rectangles."""
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    ring = TUBE / np.cos(np.pi / SIDES) * np.column_stack([np.cos(angles), np.sin(angles)])
    corners, faces = ground()
    for z in (0, height):
        corners = np.vstack([corners, np.column_stack([ring, np.full(SIDES, z)])])
    for k in range(SIDES):
        a, b = 4 + k, 4 + (k + 1) % SIDES
        faces.append(f"4 {a} {b} {b + SIDES} {a + SIDES} 0")
    return corners, faces


def write_mesh(path, corners, faces):
    """An OFF file."""
    lines = ["OFF", "# Written by make_mesh.py. Lengths in metres.",
             f"{len(corners)} {len(faces)} 0"]
    lines += [" ".join(f"{value:.9g}" for value in corner) for corner in corners]
    path.write_text("\n".join(lines + faces) + "\n")


def write_grains(path, rows):
    """A particle file of grains at rest; rows (n, 4): x, y, z, R."""
    lines = ["x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"]
    lines += [",".join(f"{value:.5g}" for value in row) + ",0,0,0,1,0,0,0,0,0,0" for row in rows]
    path.write_text("\n".join(lines) + "\n")


def loose_column(height):
    """x, y, z, R (n, 4) of a loose cubic lattice in the tube, enough for a settled height."""
    random = np.random.default_rng(1)
    step = DIAMETER * (1 + SPREAD) + 2 * JITTER
    across = np.arange(-TUBE, TUBE, step)
    x, y = (a.ravel() for a in np.meshgrid(across, across))
    inside = np.hypot(x, y) < TUBE - DIAMETER / 2 * (1 + SPREAD) - JITTER
    x, y = x[inside], y[inside]
    layers = int(np.ceil(FILL * np.pi * TUBE**2 * height / (np.pi / 6 * DIAMETER**3 * len(x))))
    rows = [np.column_stack([x, y, np.full(len(x), step * (k + 0.6)), np.zeros(len(x))])
            for k in range(layers)]
    rows = np.vstack(rows)
    rows[:, 3] = DIAMETER / 2 * (1 + SPREAD * random.uniform(-1, 1, len(rows)))
    rows[:, :3] += JITTER * random.uniform(-1, 1, (len(rows), 3))
    return rows, step * layers


def settled_column(height):
    """x, y, z, R (n, 4) of a column at rest that is higher than `height`."""
    program = os.environ.get("TINYDEM", HERE.parents[2] / "build/default/tinydem")
    rows, top = loose_column(height)
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        write_mesh(folder / "tube.off", *tube(top))
        write_grains(folder / "loose.csv", rows)
        command = [program, folder / "tube.off", folder / "loose.csv", folder / "run", "--quiet",
                   "--scene", HERE / "scene.ini", "--Nframes", "1", "--Nsteps", str(SETTLE),
                   "--mus", "0.2", "--mur", "0"]
        try:
            subprocess.run([str(word) for word in command], check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            fail(f"{program}: could not be run ({error}); try: ./dem build, or set TINYDEM")
        frame = read_run(folder / "run").frame()
    return np.column_stack([frame[name] for name in ("x", "y", "z", "R")])


def main():
    """Write the ground and all columns."""
    write_mesh(HERE / "mesh.off", *ground())
    if float(read_scene(HERE / "scene.ini")["Rmesh"][0]) != 0:
        fail(f"{HERE}/scene.ini: Rmesh must be 0; the columns stand on z = 0")
    rows = settled_column(TUBE * max(ASPECTS.values()))
    for name, aspect in ASPECTS.items():
        write_grains(HERE / f"{name}.csv", rows[rows[:, 2] + rows[:, 3] < TUBE * aspect])


if __name__ == "__main__":
    main()

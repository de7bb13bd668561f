#!/usr/bin/env python3
"""Write the mesh and the large balls of the Brazil nut scene, for the classroom and in full.

    python3 make_mesh.py     # writes mesh.off, particles.csv, full.off, full.csv beside this file

Lengths are in metres. Seven large balls lie on the base, one in the middle and six around it; the
beads are thrown in by the solver.
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
from mesh_tools import Builder  # noqa: E402
from frames import HEADER  # noqa: E402

WALL, BASE = 0, 1  # groups; the base is vibrated


def write(mesh_name, csv_name, bead, ratio, radius, height):
    """bead: radius of the beads; the others are in units of it: large balls, cylinder, height."""
    here = Path(__file__)
    mesh = Builder(f"Cylinder of inner radius {radius} bead radii and its base, in metres.")
    r, ball = radius * bead, ratio * bead
    mesh.tube((0, 0, -4 * bead), (0, 0, height * bead), r, 32, WALL)
    mesh.rectangle((-1.05 * r, -1.05 * r, 0), (2.1 * r, 0, 0), (0, 2.1 * r, 0), BASE)
    mesh.write(here.with_name(mesh_name))
    ring = (r - ball + 2 * ball) / 2  # between touching the middle one and touching the wall
    at = [(0, 0)] + [(ring * math.cos(k * math.pi / 3), ring * math.sin(k * math.pi / 3))
                     for k in range(6)]
    lines = [HEADER] + [f"{x:.6f},{y:.6f},{ball:.6g},{ball:.6g},0,0,0,1,0,0,0,0,0,0" for x, y in at]
    here.with_name(csv_name).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    write("mesh.off", "particles.csv", bead=0.004, ratio=4, radius=16, height=110)
    write("full.off", "full.csv", bead=0.002, ratio=10, radius=39, height=180)

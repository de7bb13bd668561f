#!/usr/bin/env python3
"""Write mesh.off: a marble run of gutters, a bowl with a hole, pins and a tray.

    python3 make_mesh.py        # writes mesh.off beside this file

Lengths are in metres. A gutter is two rectangles that meet at a right angle, so a marble in it
never crosses a seam.
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
from mesh_tools import Builder  # noqa: E402

GUTTERS = [  # bottom lines from (x, y, z) to (x, z), width of each side
    ((-0.20, 0.00, 0.60), (0.14, 0.560), 0.026),
    ((0.24, 0.00, 0.500), (-0.14, 0.455), 0.026),
    ((-0.24, 0.00, 0.395), (0.235, 0.335), 0.026),
    ((0.36, 0.085, 0.167), (-0.05, 0.137), 0.046),
]
BOWL = (0.30, 0.085)  # x, y of its axis
HOLE, RIM, LOW, HIGH = 0.026, 0.115, 0.235, 0.295  # radii and heights of the bowl
SLEEVE = 0.030  # length of the tube below its hole
TRAY = (-0.30, 0.045, 0.0), (0.02, 0.125, 0.10)  # two corners
PINS = [(x, z) for z, shift in ((0.105, 0.0), (0.075, 0.021)) for x in
        np.arange(-0.27 + shift, -0.06, 0.042)]
PIN = 1  # group, index into Rmesh


def gutter(mesh, start, end, width):
    """Two rectangles along the line from start (x, y, z) to end (x, z), and a wall behind."""
    a, b = np.array(start), np.array([end[0], start[1], end[1]])
    along = b - a
    up = np.array([-along[2], 0, along[0]]) / np.linalg.norm(along) * np.sign(along[0])
    for side in (-1, 1):
        mesh.rectangle(a, along, width * (up + [0, side, 0]) / np.sqrt(2))
    mesh.rectangle(a - [0, 0.026, 0], (0, 0.052, 0), 0.07 * up)


def main():
    """Write the file."""
    mesh = Builder("Marble run: gutters, bowl, pins, tray, in metres.")
    for line in GUTTERS:
        gutter(mesh, *line)
    mesh.cone((*BOWL, LOW), HOLE, (*BOWL, HIGH), RIM, 28)
    mesh.tube((*BOWL, HIGH), (0, 0, 0.02), RIM, 28)
    mesh.tube((*BOWL, LOW), (0, 0, -SLEEVE), HOLE, 28)
    mesh.cup(*TRAY)
    for x, z in PINS:
        mesh.face((x, TRAY[0][1], z), (x, TRAY[1][1], z), group=PIN)
    mesh.write(Path(__file__).with_name("mesh.off"))


if __name__ == "__main__":
    main()

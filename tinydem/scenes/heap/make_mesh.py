#!/usr/bin/env python3
"""Write mesh.off and full.off: a floor between two vertical plates.

    python3 make_mesh.py        # writes beside this file

Lengths are in metres; the grains have a diameter of D.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
from mesh_tools import Builder  # noqa: E402

D = 0.004
FLOOR, PLATE = 0, 1  # groups


def write(name, gap, length, height):
    """The file of that name: plates `gap` apart, floor and plates `length` long, in diameters."""
    mesh = Builder(f"Floor between two plates that are {gap} grain diameters apart, in metres.")
    x, y, z = length * D / 2, gap * D, height * D
    mesh.rectangle((-x, 0, 0), (2 * x, 0, 0), (0, y, 0), FLOOR)
    for at in (0, y):
        mesh.rectangle((-x, at, 0), (2 * x, 0, 0), (0, 0, z), PLATE)
    for at in (-x, x):  # ends, so that nothing rolls off the floor
        mesh.rectangle((at, 0, 0), (0, y, 0), (0, 0, z / 4), PLATE)
    mesh.write(Path(__file__).with_name(name))


if __name__ == "__main__":
    write("mesh.off", gap=5.5, length=64, height=44)
    write("full.off", gap=11, length=280, height=170)

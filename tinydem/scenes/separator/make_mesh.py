#!/usr/bin/env python3
"""Write mesh.off: a funnel, a roof that splits the stream, chutes that merge it, a bin.

    python3 make_mesh.py        # writes mesh.off beside this file

Lengths are in metres. Everything is a rectangle between y = 0 and y = DEPTH, so there are no seams
that a grain could cross.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
from mesh_tools import Builder  # noqa: E402

DEPTH = 0.06
INSIDE, PLATE = 0, 1  # groups: slopes and bin; the two panes in front and behind
SLOPES = [  # (x, z) of the upper and of the lower end, for the side x > 0
    ((0.070, 0.500), (0.015, 0.430)),  # funnel, throat 0.03 wide
    ((0.000, 0.415), (0.055, 0.340)),  # roof that splits the stream; its ridge is at x = 0
    ((0.090, 0.320), (0.028, 0.265)),  # chute back to the middle
]
WALLS = [(0.070, 0.500, 0.560), (0.090, 0.000, 0.440)]  # x, from z, to z, for the side x > 0
TOP = 0.56


def main():
    """Write the file."""
    mesh = Builder("Separator: funnel, roof, chutes, bin, in metres.")
    for side in (-1, 1):
        for (x0, z0), (x1, z1) in SLOPES:
            mesh.rectangle((side * x0, 0, z0), (side * (x1 - x0), 0, z1 - z0), (0, DEPTH, 0),
                           INSIDE)
        for x, z0, z1 in WALLS:
            mesh.rectangle((side * x, 0, z0), (0, DEPTH, 0), (0, 0, z1 - z0), INSIDE)
    wide = WALLS[1][0]
    mesh.rectangle((-wide, 0, 0), (2 * wide, 0, 0), (0, DEPTH, 0), INSIDE)
    for y in (0, DEPTH):
        mesh.rectangle((-wide, y, 0), (2 * wide, 0, 0), (0, 0, TOP), PLATE)
    mesh.write(Path(__file__).with_name("mesh.off"))


if __name__ == "__main__":
    main()

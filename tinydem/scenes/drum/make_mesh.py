#!/usr/bin/env python3
"""Write mesh.off: a drum around the y axis.

    python3 make_mesh.py        # writes mesh.off beside this file

Lengths are in metres. The shell is a prism with so many sides that a grain does not feel its edges.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
from mesh_tools import Builder  # noqa: E402

RADIUS, DEPTH, SIDES = 0.12, 0.032, 60
SHELL, LIDS = 0, 1  # groups


if __name__ == "__main__":
    drum = Builder("Drum around the y axis, in metres.")
    drum.tube((0, 0, 0), (0, DEPTH, 0), RADIUS, SIDES, SHELL)
    for y in (0, DEPTH):
        drum.rectangle((-RADIUS, y, -RADIUS), (2 * RADIUS, 0, 0), (0, 0, 2 * RADIUS), LIDS)
    drum.write(Path(__file__).with_name("mesh.off"))

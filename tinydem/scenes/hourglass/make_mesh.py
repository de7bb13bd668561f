#!/usr/bin/env python3
"""Write mesh.off: an hourglass with a square cross-section and two obstacles in its throat.

    python3 make_mesh.py        # writes mesh.off beside this file

Lengths are in metres. The last number of a face is its index into Rmesh.
"""
from pathlib import Path

WIDE = 0.24    # side of the base and of the top rim
THROAT = 0.10  # side of the throat
HEIGHT = 0.30  # base to rim, the throat is half way up
WALL, SPHERE, BAR = 0, 1, 2  # indices into Rmesh


def square(side, z):
    """The 4 corners (x, y, z) of a square centred on the z axis, anticlockwise from above."""
    h = side / 2
    return [(-h, -h, z), (h, -h, z), (h, h, z), (-h, h, z)]


def walls(wide, throat):
    """Faces of four trapezoids between two squares, given by the indices of their first corners.

    Two triangles are the fewest that make a trapezoid. Both lie in one plane and meet in a single
    diagonal; every trapezoid is cut from the same side, so a quarter turn maps the mesh to itself.
    """
    faces = []
    for k in range(4):
        n = (k + 1) % 4
        faces.append((3, wide + k, wide + n, throat + n, WALL))
        faces.append((3, wide + k, throat + n, throat + k, WALL))
    return faces


def off_text():
    """The mesh as OFF text, with a comment line before each part."""
    vertices = [
        ("base", square(WIDE, 0.0)),
        ("throat", square(THROAT, HEIGHT / 2)),
        ("top rim", square(WIDE, HEIGHT)),
        ("centre of the sphere", [(0.0, 0.0, HEIGHT / 2)]),
        ("ends of the bar", [(-THROAT / 2, 0.0, HEIGHT / 2), (THROAT / 2, 0.0, HEIGHT / 2)]),
    ]
    faces = [
        ("floor: one rectangle", [(4, 0, 1, 2, 3, WALL)]),
        ("lower walls: two triangles per side", walls(wide=0, throat=4)),
        ("upper walls: two triangles per side", walls(wide=8, throat=4)),
        ("sphere in the middle of the throat: one point", [(1, 12, SPHERE)]),
        ("bar across the throat (spherocylinder): one edge", [(2, 13, 14, BAR)]),
    ]
    count = [sum(len(rows) for _, rows in parts) for parts in (vertices, faces)]
    lines = ["OFF", "# Hourglass, written by make_mesh.py. Lengths in metres.",
             "# vertices, faces, edges (not used)", f"{count[0]} {count[1]} 0"]
    for parts in (vertices, faces):
        for name, rows in parts:
            lines.append(f"# {name}")
            lines += [" ".join(f"{value:g}" for value in row) for row in rows]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(__file__).with_name("mesh.off").write_text(off_text())

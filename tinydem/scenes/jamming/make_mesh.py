#!/usr/bin/env python3
"""Write mesh.off and full.off: three layers of funnels in a plane, with ever narrower throats.

    python3 make_mesh.py        # writes beside this file

Everything is made of edges in the plane y = 0, so that discs stay in it. Lengths are in metres; the
discs have a diameter of D.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
from mesh_tools import Builder  # noqa: E402

D = 0.01
THROATS = (10, 8, 6)  # free widths in diameters, from top to bottom
LAYER, SLOPE = 26, 1.2  # height of a layer in diameters; steepness of its funnels
WALL = 0.2  # radius of the edges in diameters, see Rmesh in scene.ini


def write(name, funnels, pitch, top):
    """So many funnels side by side, each `pitch` wide, walls up to `top`, in diameters."""
    mesh = Builder(f"Three layers of {funnels} funnels with throats of 10, 8, 6 diameters, metres.")
    width = funnels * pitch

    def edge(x0, z0, x1, z1):
        mesh.face((x0 * D, 0, z0 * D), (x1 * D, 0, z1 * D))
    edge(-width / 2, 0, width / 2, 0)
    for x in (-width / 2, width / 2):
        edge(x, 0, x, top)
    for layer, throat in enumerate(reversed(THROATS), start=1):
        gap = throat / 2 + WALL  # the edges are round: this leaves the throat free
        for k in range(funnels):
            middle, reach = (k + 0.5) * pitch - width / 2, pitch / 2
            for side in (-1, 1):
                edge(middle + side * gap, layer * LAYER,
                     middle + side * reach, layer * LAYER + SLOPE * (reach - gap))
    mesh.write(Path(__file__).with_name(name))


if __name__ == "__main__":
    write("mesh.off", funnels=2, pitch=26, top=122)
    write("full.off", funnels=4, pitch=30, top=190)

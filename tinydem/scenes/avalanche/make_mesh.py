#!/usr/bin/env python3
"""Write mesh.off: the rough bed of a chute, fixed spheres side by side, and a wall above it.

    python3 make_mesh.py        # writes mesh.off beside this file

Everything lies in the plane y = 0. The chute lies along x; gravity is tilted (g in scene.ini). At
its end the grains fall away for good. Lengths are in metres. The tops of the bed's spheres scatter
around z = 0.
"""
from pathlib import Path

import numpy as np

LENGTH = 1.05
RADIUS = 0.003  # of the spheres of the bed: Rmesh
SCATTER = 0.0015  # of their heights
PITCH = (0.006, 0.0072)  # least and largest distance of neighbours along x
WALL = 0.15  # height of the wall at x = 0
SEED = 1


def off_text():
    """The bed as OFF text: one point per sphere, an edge for the wall."""
    random = np.random.default_rng(SEED)
    x = np.cumsum(random.uniform(*PITCH, int(LENGTH / np.mean(PITCH))))
    z = -RADIUS - random.uniform(0, SCATTER, len(x))
    lines = ["OFF", "# A rough bed, written by make_mesh.py. Lengths in metres.",
             f"{len(x) + 2} {len(x) + 1} 0", f"0 0 {-RADIUS}", f"0 0 {WALL}"]
    lines += [f"{a:.5g} 0 {b:.5g}" for a, b in zip(x, z)]
    lines += ["2 0 1 0"] + [f"1 {k + 2} 0" for k in range(len(x))]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(__file__).with_name("mesh.off").write_text(off_text())

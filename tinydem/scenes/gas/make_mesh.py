#!/usr/bin/env python3
"""Write mesh.off, a closed box, and particles.csv, a gas at equilibrium in it.

    python3 make_mesh.py [SEED]      # writes both beside this file; default seed 1

Lengths are in metres. The walls have radius 0: the inside of the box is [0, SIDE]^3.
"""
import sys
from pathlib import Path

import numpy as np

SIDE = 0.2
RADIUS = 0.0045
NUMBER = 1000
SPEED = 0.1  # root of the mean square of one component of the velocity [m/s]
SQUARES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def off_text():
    """The box as OFF text: six squares."""
    corners = [(SIDE * (k & 1), SIDE * (k >> 1 & 1), SIDE * (k >> 2)) for k in range(8)]
    lines = ["OFF", "# A closed box, written by make_mesh.py. Lengths in metres.", "8 6 0"]
    lines += [" ".join(f"{value:g}" for value in corner) for corner in corners]
    lines += ["4 " + " ".join(map(str, square)) + " 0" for square in SQUARES]
    return "\n".join(lines) + "\n"


def places(random):
    """Centres (NUMBER, 3) of spheres that do not touch each other or a wall, at random."""
    centres = np.empty((0, 3))
    while len(centres) < NUMBER:
        new = random.uniform(RADIUS, SIDE - RADIUS, 3)
        if np.all(np.sum((centres - new)**2, axis=1) > (2.001 * RADIUS)**2):
            centres = np.vstack([centres, new])
    return centres


def csv_text(seed):
    """The gas as a particle file: Maxwell's distribution, no momentum."""
    random = np.random.default_rng(seed)
    x, v = places(random), random.normal(0, SPEED, (NUMBER, 3))
    v -= v.mean(axis=0)
    lines = ["x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"]
    lines += [",".join(f"{value:.6g}" for value in (*a, RADIUS, *b)) + ",1,0,0,0,0,0,0"
              for a, b in zip(x, v)]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(__file__).with_name("mesh.off").write_text(off_text())
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    Path(__file__).with_name("particles.csv").write_text(csv_text(number))

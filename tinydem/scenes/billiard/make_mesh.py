#!/usr/bin/env python3
"""Write mesh.off, a table, and particles.csv, a ring of cut shots and one ball that only slides.

    python3 make_mesh.py        # writes both beside this file

Lengths are in metres. Each cue ball is about to hit an object ball: the line of centres points
outwards, the cue ball moves at the cut angle to it. Without friction the object ball would leave
along the line of centres. All balls start without spin, at the height at which the table carries
them (Hertz).
"""
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
RADIUS, DENSITY, YOUNG, POISSON, GRAVITY = 0.028, 1700.0, 5e9, 0.3, 9.81  # as in scene.ini
TABLE = 1.0     # half a side
RING = 0.25     # distance of the object balls from the centre
GAP = 1e-5      # between the balls at the start
SPEED = 1.0     # of the cue balls
CUTS = [5, 10, 15, 20, 25, 30, 35, 40, 50, 60]  # cut angles [degrees]


def overlap():
    """Overlap of a ball at rest with the table: its weight is 4/3 (2 E*) sqrt(R) delta^(3/2)."""
    weight = 4 / 3 * np.pi * RADIUS**3 * DENSITY * GRAVITY
    stiffness = YOUNG / (1 - POISSON**2)  # 2 E*: the table does not give way
    return (0.75 * weight / (stiffness * np.sqrt(RADIUS)))**(2 / 3)


def balls():
    """Rows x, y, vx, vy: the sliding ball, then object ball and cue ball of each shot."""
    yield -0.4, -0.9, SPEED, 0.0
    for k, cut in enumerate(np.radians(CUTS)):
        angle = 2 * np.pi * (k + 0.5) / len(CUTS)
        n = np.array([np.cos(angle), np.sin(angle)])  # line of centres
        t = np.array([-n[1], n[0]])
        yield *(RING * n), 0.0, 0.0
        yield *((RING - 2 * RADIUS - GAP) * n), *(SPEED * (np.cos(cut) * n + np.sin(cut) * t))


def csv_text():
    """All balls as a particle file."""
    z = RADIUS - overlap()
    lines = ["x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"]
    lines += [f"{x:.15g},{y:.15g},{z:.15g},{RADIUS:g},{vx:.15g},{vy:.15g},0,1,0,0,0,0,0,0"
              for x, y, vx, vy in balls()]
    return "\n".join(lines) + "\n"


def off_text():
    """The table as OFF text: one square at z = 0."""
    a = TABLE
    return ("OFF\n# A table, written by make_mesh.py. Lengths in metres.\n4 1 0\n"
            f"{-a} {-a} 0\n{a} {-a} 0\n{a} {a} 0\n{-a} {a} 0\n4 0 1 2 3 0\n")


if __name__ == "__main__":
    (HERE / "mesh.off").write_text(off_text())
    (HERE / "particles.csv").write_text(csv_text())

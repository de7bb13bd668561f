#!/usr/bin/env python3
"""Write particles.csv: rows of equal spheres that just touch, and a striker for each row.

    python3 make_mesh.py        # writes particles.csv beside this file

There is no mesh. Lengths are in metres. Each row lies on a line parallel to x; the rows never meet.
"""
from pathlib import Path

RADIUS = 0.01
RESTING = 60  # spheres that wait in each row
SPACING = 0.05  # between the rows
SPEEDS = [0.5, 0.2, 0.08, 0.03, 0.012]  # of the strikers [m/s], top row first


def csv_text():
    """All rows as a particle file. A striker touches its row from the start."""
    lines = ["x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"]
    for row, speed in enumerate(SPEEDS):
        for k in range(RESTING + 1):
            x, v = 2 * RADIUS * (k - 1), speed if k == 0 else 0
            lines.append(f"{x:.6g},{-SPACING * row:.6g},0,{RADIUS:g},{v:g},0,0,1,0,0,0,0,0,0")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(__file__).with_name("particles.csv").write_text(csv_text())

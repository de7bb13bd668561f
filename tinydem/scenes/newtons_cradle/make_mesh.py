#!/usr/bin/env python3
"""Write particles.csv: four rows of equal spheres, a striker or several at the left of each.

    python3 make_mesh.py        # writes particles.csv beside this file

There is no mesh. Lengths are in metres. Each row lies on a line parallel to x; the rows never meet.
"""
from pathlib import Path

RADIUS = 0.01
SPEED = 1.0     # of the strikers [m/s]
RESTING = 5     # spheres that wait in each row
FLIGHT = 0.01   # free flight of the strikers before they hit
SPACING = 0.04  # between the rows
ROWS = [(1, 4e-4), (1, 0.0), (2, 0.0), (3, 0.0)]  # strikers, gap between the resting spheres


def row(y, strikers, gap):
    """(x, y, v) of the spheres of a row, from left to right; strikers touch each other."""
    spheres = [(-FLIGHT - 2 * RADIUS * (strikers - k), y, SPEED) for k in range(strikers)]
    return spheres + [((2 * RADIUS + gap) * k, y, 0.0) for k in range(RESTING)]


def csv_text():
    """All rows as a particle file."""
    lines = ["x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"]
    for k, (strikers, gap) in enumerate(ROWS):
        for x, y, v in row(-SPACING * k, strikers, gap):
            lines.append(f"{x:.6g},{y:.6g},0,{RADIUS:g},{v:g},0,0,1,0,0,0,0,0,0")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    Path(__file__).with_name("particles.csv").write_text(csv_text())

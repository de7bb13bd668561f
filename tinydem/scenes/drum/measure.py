#!/usr/bin/env python3
"""The dynamic angle of repose in a rotating drum against its speed, and how fast it mixes.

    measure.py OUTPUT [OUTPUT ...]     one point per run; ./dem run drum --series
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import packing  # noqa: E402
import result  # noqa: E402
from frames import columns, fail, read_motion  # noqa: E402

START = 0.4  # revolutions until the flow is steady
BLOCKS = 5  # the error is that of the means of so many parts of the run


def follow(run):
    """Turns (n,), angles (n,) [deg] of the surface, Lacey's mixing index (n,) of the frames."""
    speed = next(np.linalg.norm(m[2][3:]) for m in read_motion(run.scene["motion"]))
    reach = 0.6 * max(np.abs(e.corners[:, 0]).max() for e in run.mesh)
    dye, rows = packing.Dye(("x", 0.0)), []
    for number, frame in run.frames():
        side = dye.value(frame)
        if len(frame) < run.scene["Nmax"]:
            continue
        angle, _ = packing.surface_slope(frame["x"], frame["z"], frame["R"], reach)
        x = columns(frame, "x,z")
        low, high = x.min(axis=0), x.max(axis=0)
        cells = np.maximum(((high - low) / (6 * run.scene["Rmax"])).astype(int), 1)
        mixed = packing.lacey(*packing.shares(x, side, low, high, cells))
        rows.append((run.time(number) * speed / (2 * np.pi), abs(angle), mixed))
    if not rows:
        fail(f"{run.folder}: not all grains were there; try: a larger --Nframes")
    return speed, np.array(rows).T


def main():
    """Angle against speed, mixing against revolutions."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    fig, ax = result.figure(1, 2)
    for color, (speed, rows) in zip(result.COLORS, sorted(map(follow, runs), key=lambda f: f[0])):
        turns, angles, mixed = rows
        steady = angles[turns > START]
        if len(steady) < 2 * BLOCKS:
            print(f"{speed:g} rad/s: too short, {turns[-1]:.2f} turns; try a larger --Nframes")
            continue
        value, error = result.mean_error([b.mean() for b in np.array_split(steady, BLOCKS)])
        report.add(f"angle of the surface at {speed:g} rad/s", value, error, "deg",
                   "grows with the speed")
        ax[0].errorbar(speed, value, error, fmt="o", color=color, capsize=2, markerfacecolor="w")
        report.add(f"mixing index after {turns[-1]:.2f} turns at {speed:g} rad/s",
                   mixed[-5:].mean(), mixed[-5:].std(ddof=1) / np.sqrt(5), "", "tends to 1")
        ax[1].plot(turns, mixed, color=color, label=f"{speed:g} rad/s")
    if ax[1].lines:
        ax[1].legend()
    result.label(ax[0], "angular velocity / (rad/s)", "angle / degrees", "dynamic angle of repose")
    result.label(ax[1], "revolutions", "mixing index", "mixing of the two halves")
    report.save(fig)


if __name__ == "__main__":
    main()

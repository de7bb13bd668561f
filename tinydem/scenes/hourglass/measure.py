#!/usr/bin/env python3
"""Does the flow through the throat stop, when, and how many particles have passed by then?

    measure.py OUTPUT [OUTPUT ...]     statistics over the seeds of all runs
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import packing  # noqa: E402
import result  # noqa: E402

THROAT, FLOOR, RIM = 0.15, 0.0, 0.30  # heights [m]
QUIET = 0.5  # without a passage for so long [s], the flow has stopped


def counts(run):
    """Times (n,) [s] of the frames, particles below the throat and in the upper half (n,)."""
    rows = []
    for number, frame in run.frames():
        z = frame["z"]
        inside = (z > FLOOR) & (z < RIM + 0.15) & (np.abs(frame["x"]) < 0.2) & \
            (np.abs(frame["y"]) < 0.2)
        rows.append((run.time(number), (inside & (z < THROAT - 0.02)).sum(),
                     (inside & (z >= THROAT - 0.02)).sum()))
    return np.array(rows).T


def main():
    """One line per run in the picture, one number for all."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    fig, ax = result.figure(1, 1, width=4.6, height=3.0)
    stops, passed = [], []
    for color, run in zip(np.resize(result.COLORS, len(runs)), runs):
        times, below, above = counts(run)
        stop = packing.arrest(times, below, above, QUIET)
        ax.plot(times, below, color=color)
        if np.isfinite(stop):
            ax.plot(stop, below[-1], "s", color=color)
        stops.append(stop)
        passed.append(below[-1])
    stopped = np.isfinite(stops)
    report.add("share of runs that are arrested", *result.share_error(stopped.sum(), len(runs)), "",
               f"chance decides; {len(runs)} runs")
    if stopped.any():
        report.add("time of arrest", *result.mean_error(np.array(stops)[stopped]), "s")
        report.add("passed when arrested", *result.mean_error(np.array(passed)[stopped]),
                   "particles", "of 1000")
    report.add("passed at the end, all runs", *result.mean_error(passed), "particles", "of 1000")
    result.label(ax, "time / s", "particles below the throat",
                 "a line per run; squares: the flow has stopped")
    report.save(fig)


if __name__ == "__main__":
    main()

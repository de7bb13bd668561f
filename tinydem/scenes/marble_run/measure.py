#!/usr/bin/env python3
"""How long the marbles need, and how their energy is shared between moving and turning.

    measure.py OUTPUT [OUTPUT ...]     marbles of all runs are put together
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import result  # noqa: E402
from frames import columns, speed  # noqa: E402

TRAY = 0.12  # below this height [m] a marble has arrived
FIRST = (-0.05, 0.10, 0.55)  # x from, to [m], and lowest z: the part of the first gutter to look at
ROLLING = 4 / 9  # of the kinetic energy is rotation: contacts at 45 degrees, so v = w R / sqrt(2)


def follow(run):
    """Start and arrival times (marbles,) [s], nan if it did not arrive; rotational shares (n,)."""
    starts, arrivals, shares = np.full(0, np.nan), np.full(0, np.nan), []
    for number, frame in run.frames():
        t = run.time(number)
        new = len(frame) - len(starts)
        starts = np.append(starts, np.full(new, t))
        arrivals = np.append(arrivals, np.full(new, np.nan))
        there = (frame["z"] < TRAY) & (frame["z"] > 0)
        arrivals[np.flatnonzero(there & np.isnan(arrivals))] = t
        rolls = (frame["x"] > FIRST[0]) & (frame["x"] < FIRST[1]) & (frame["z"] > FIRST[2])
        spin = 0.4 * (frame["R"]**2) * (columns(frame, "wx,wy,wz")**2).sum(axis=1)
        shares += list((spin / (spin + speed(frame)**2))[rolls])
    return starts, arrivals, np.array(shares), frame


def main():
    """Numbers of all runs, histogram of the times."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    parts = [follow(run) for run in runs]
    starts, arrivals, shares = (np.concatenate([p[k] for p in parts]) for k in range(3))
    lost = sum((p[3]["z"] < 0).sum() for p in parts)
    times = (arrivals - starts)[np.isfinite(arrivals)]
    report.add("marbles in the tray", *result.share_error(len(times), len(starts)),
               f"of {len(starts)}", "1")
    report.add("marbles that fell beside it", lost, unit=f"of {len(starts)}", expected="0")
    report.add("time for the run", *result.mean_error(times), "s")
    report.add("scatter of the time", times.std(ddof=1),
               times.std(ddof=1) / np.sqrt(2 * len(times)), "s", "the bowl and the pins are chaotic")
    report.add("rotational share of the kinetic energy in the first gutter",
               *result.mean_error(shares), "", f"4/9 = {ROLLING:.4f} when rolling")
    fig, ax = result.figure(1, 2)
    ax[0].hist(times, bins=15, color=result.GRAINS, edgecolor="w")
    result.label(ax[0], "time from start to tray / s", "marbles", "no two take the same time")
    ax[1].hist(shares, bins=30, color=result.COLORS[5], edgecolor="w")
    ax[1].axvline(ROLLING, color="k", linewidth=1, label="rolling: 4/9")
    ax[1].legend(loc="upper left")
    result.label(ax[1], "rotational share of the energy", "observations", "first gutter")
    report.save(fig)


if __name__ == "__main__":
    main()

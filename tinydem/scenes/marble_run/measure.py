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
SLOPE = 0.04 / 0.34  # of the first gutter


def rolling_share(scene):
    """Rotational share of the kinetic energy of a marble that rolls in a gutter.

    Contacts at 45 degrees: v = w r / sqrt(2), so 0.4 / (0.4 + 0.5 (r / R)^2), 4/9 for hard marbles.
    The lever arm is r = R - delta / 2, Eq. (29), with Hertz' overlap delta under the weight.
    """
    R = (scene["Rmin"] + scene["Rmax"]) / 2
    weight = 4 / 3 * np.pi * R**3 * scene["rho"] * np.linalg.norm(scene["g"])
    load = weight / np.hypot(1, SLOPE) / np.sqrt(2)
    stiffness = 4 / 3 * scene["E"] / (1 - scene["nu"]**2) * np.sqrt(R)  # a wall counts twice
    lever = 1 - (load / stiffness)**(2 / 3) / (2 * R)
    return 0.4 / (0.4 + 0.5 * lever**2)


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
    if len(times) > 1:
        report.add("time for the run", *result.mean_error(times), "s")
        report.add("scatter of the time", times.std(ddof=1),
                   times.std(ddof=1) / np.sqrt(2 * len(times)), "s",
                   "large: the bowl and the pins are chaotic")
    if len(shares):
        report.add("rotational share of the kinetic energy in the first gutter",
                   *result.mean_error(shares), "", f"{rolling_share(runs[0].scene):.6f}, rolling")
    fig, ax = result.figure(1, 2)
    ax[0].hist(times, bins=15, color=result.GRAINS, edgecolor="w")
    result.label(ax[0], "time from start to tray / s", "marbles", "no two take the same time")
    draw_speeds(ax[1], runs[0])
    report.save(fig)


def draw_speeds(ax, run):
    """Speed against spin of all marbles in some frames, and lines for those that roll."""
    frames = [frame for _, frame in run.frames(every=12) if len(frame)] or [run.frame()]
    spin = np.concatenate([np.linalg.norm(columns(f, "wx,wy,wz"), axis=1) * f["R"] for f in frames])
    fast = np.concatenate([speed(f) for f in frames])
    ax.plot(spin, fast, ".", color=result.COLORS[5], markersize=2.5)
    top = np.array([0, spin.max(initial=0.1)])
    ax.plot(top, top / np.sqrt(2), color="k", linewidth=0.9, label="rolls in a gutter")
    ax.plot(top, top, color=result.COLORS[1], linewidth=0.9, label="rolls on a plane")
    ax.set(xlim=(0, None), ylim=(0, 1.1 * fast.max(initial=0.1)))
    ax.legend(loc="upper left")
    result.label(ax, "spin x radius / (m/s)", "speed / (m/s)", "who rolls, who slips or flies?")


if __name__ == "__main__":
    main()

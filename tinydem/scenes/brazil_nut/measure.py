#!/usr/bin/env python3
"""How fast the large balls rise through the vibrated beads.

    measure.py OUTPUT [OUTPUT ...]     balls of all runs are put together
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import packing  # noqa: E402
import result  # noqa: E402
from frames import fail, read_motion  # noqa: E402

TOP = 0.75  # share of the height of the bed at which a ball counts as up
SETTLED = 10  # cycles until all beads have fallen in


def history(run):
    """Cycles (n,), tops of the large balls (n, balls) and of the bed (n,) above the base [m]."""
    frequency = next(m[2][3] for m in read_motion(run.scene["motion"]) if m[1] == "vibrate")
    cycles, balls, beds = [], [], []
    for number, frame in run.frames():
        large = frame["R"] > 1.5 * frame["R"].min()
        if large.all() or not large.any():
            continue  # nothing has been thrown in yet
        cycles.append(run.time(number) * frequency)
        balls.append(frame["z"][large] + frame["R"][large])
        beds.append(np.quantile(frame["z"][~large], 0.98))
    if not cycles or cycles[-1] <= SETTLED:
        fail(f"{run.folder}: ends before the beads have settled; try: a larger --Nframes")
    return np.array(cycles), np.array(balls), np.array(beds)


def main():
    """Heights against cycles, cycles until the balls are up."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    fig, ax = result.figure(1, 1, width=4.6, height=3.0)
    risen, final = [], []
    for run in runs:
        cycles, balls, beds = history(run)
        share = balls / beds[:, None]
        first = np.argmax(cycles > SETTLED)
        risen += [packing.rise(cycles[first:], share[first:, k], TOP)
                  for k in range(share.shape[1])]
        final += list(share[-1])
        if run is runs[0]:
            ax.plot(cycles, 100 * beds, color="0.3", label="top of the bed")
            for k, height in enumerate(balls.T):
                ax.plot(cycles, 100 * height, color=result.COLORS[0], alpha=0.45, linewidth=0.9,
                        label="tops of the large balls" if k == 0 else None)
            ax.plot(cycles, 100 * balls.mean(axis=1), color=result.COLORS[1], label="their mean")
    risen = np.array(risen)
    up = np.isfinite(risen)
    report.add(f"share of large balls that rose above {TOP:g} of the bed",
               *result.share_error(up.sum(), len(up)), f"of {len(up)}", "1 in the paper")
    if up.any():
        report.add("cycles until they were there", *result.mean_error(risen[up]), "",
                   "175 in the paper, with ten times larger balls")
    report.add("top of the balls / top of the bed at the end", *result.mean_error(final), "", "1")
    ax.set_ylim(0, 190 * np.median(beds))
    ax.legend(loc="upper left")
    result.label(ax, "cycles", "height above the base / cm", "large balls rise")
    report.save(fig)


if __name__ == "__main__":
    main()

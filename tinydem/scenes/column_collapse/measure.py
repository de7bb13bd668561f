#!/usr/bin/env python3
"""Runout of collapsed columns against their aspect ratio: measure.py OUTPUT [OUTPUT ...]"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402

SECTORS = 10  # of the deposit, for the error


def column(frame):
    """Radius and height [L] of a column at rest: with the grains that touch the tube, the top."""
    reach = np.hypot(frame["x"], frame["y"]) + frame["R"]
    return np.quantile(reach, 0.99), np.quantile(frame["z"] + frame["R"], 0.995)


def front(frame, r0, d, part=1.0):
    """Runout [L] of a deposit, and the centres r and heights h (bins,) [L] of its profile.

    part: the share of the circle that frame covers.
    """
    edges = d * np.arange(0, int(8 * r0 / d))
    r, h = (edges[1:] + edges[:-1]) / 2, flow.height_profile(frame, edges) / part
    return flow.runout(r, h, 0.75 * d, 0.6 * h[1:5].mean())[0], r, h


def deposit(run):
    """Aspect ratio, (r_end - r_0)/r_0 with its error, centres r and heights h (bins,) [r_0].

    Error: jackknife over sectors, each left out in turn, because they collapse side by side.
    """
    first, last = run.frame(0), run.frame()
    r0, height = column(first)
    d = 2 * first["R"].mean()
    end, r, h = front(last, r0, d)
    sector = np.floor((np.arctan2(last["y"], last["x"]) / (2 * np.pi) + 0.5) * SECTORS)
    without = [front(last[sector != k], r0, d, 1 - 1 / SECTORS)[0] for k in range(SECTORS)]
    error = np.sqrt((SECTORS - 1) * np.var(without))
    return height / r0, end / r0 - 1, error / r0, r / r0, h / r0


def draw(measured):
    """The figure; measured: as deposit() gives it, by aspect ratio."""
    fig, (left, right) = result.figure(1, 2)
    for k, (a, spread, _, r, h) in enumerate(measured):
        left.plot(r, h, "o-", markersize=2.5, linewidth=0.8, color=result.COLORS[k % 7],
                  label=f"a = {a:.2f}")
        left.plot([1 + spread], [0], "^", color=result.COLORS[k % 7], clip_on=False, zorder=3)
    left.set(xlim=(0, 5), ylim=(0, None))
    left.legend()
    result.label(left, "radius / $r_0$", "height of the deposit / $r_0$", "triangles: runout")
    a, spread, error = np.array([one[:3] for one in measured]).T
    x = np.linspace(0.05, max(a.max() * 1.1, 2), 300)
    right.plot(x, flow.lube_runout(x), "k", linewidth=1, label="Lube et al. 2004")
    right.errorbar(a, spread, error, fmt="o", capsize=2, color=result.COLORS[1],
                   markerfacecolor="w", label="program")
    right.set(xlim=(0, None), ylim=(0, None))
    right.legend()
    result.label(right, "aspect ratio a", "(r$_{end}$ - r$_0$) / r$_0$")
    return fig


def main(runs, where):
    """Measure runs, write to the folder where."""
    report = result.Report(where)
    measured = sorted((deposit(run) for run in runs), key=lambda one: one[0])
    for a, spread, error, *_ in measured:
        report.add(f"(r_end - r_0)/r_0 for a = {a:.2f}", spread, error,
                   expected=f"{flow.lube_runout(a):.2f}, Lube et al.")
    a, spread, error = np.array([one[:3] for one in measured]).T
    if len(measured) > 1:
        report.add("runout / law, all columns", *result.mean_error(spread / flow.lube_runout(a)),
                   expected="1 for many grains across")
    for who, name, power in ((a < 1.5, "low", "1"), (a > 1.5, "tall", "1/2")):
        if who.sum() > 1:  # two points: the exponent and its error from theirs
            x, y, dy = np.log(a[who]), np.log(spread[who]), (error / spread)[who]
            report.add(f"exponent for {name} columns", (y[-1] - y[0]) / (x[-1] - x[0]),
                       np.hypot(dy[-1], dy[0]) / (x[-1] - x[0]), expected=f"{power}, Lube et al.")
    report.save(draw(measured))


if __name__ == "__main__":
    main(*result.arguments(__doc__))

#!/usr/bin/env python3
"""Compare the speeds after the knock with an ODE of the Hertz chain: measure.py OUTPUT"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402


def rows_of(frame):
    """Indices of the spheres of each row, from left to right; the top row first."""
    return [np.flatnonzero(frame["y"] == y) for y in np.unique(frame["y"])[::-1]]


def draw(ax, v0, v, exact):
    """Speeds of a row: v0 before, v after, exact: after, by the ODE, (n,) [m/s]."""
    balls = np.arange(len(v)) - np.count_nonzero(v0)  # ball 0 is the first that waited
    for who, color, name in ((v0 > 0, result.COLORS[1], "striker"),
                             (v0 == 0, result.COLORS[0], "waited")):
        ax.bar(balls[who], v[who] / v0[0], 0.7, color=color, alpha=0.8, label=name)
    ax.plot(balls, exact / v0[0], "k_", markersize=9, label="ODE of the chain")
    ax.set(ylim=(-0.25, 1.75), xticks=balls)


def main(run, where):
    """Measure a run, write to the folder where."""
    report = result.Report(where)
    start, end = run.frame(0), run.frame()
    rows = rows_of(start)
    fig, axes = result.figure(1, len(rows), width=2.0)
    time = np.array([run.time(max(run.files))])
    for number, (row, ax) in enumerate(zip(rows, axes), start=1):
        v0, v = start["vx"][row], end["vx"][row]
        exact = flow.hertz_chain(start["x"][row], v0, start["R"][row], run.scene, time)[1][0]
        drift = abs((v @ v) / (v0 @ v0) - 1)  # of the energy: all balls have the same mass
        report.add(f"row {number}, last ball / striker", v[-1] / v0[0], v[-1] / v0[0] * drift,
                   expected=f"{exact[-1] / v0[0]:.7f}, ODE of the Hertz chain")
        report.add(f"row {number}, largest difference to the ODE",
                   np.abs(v - exact).max() / v0[0], expected="0, falls as dt^2")
        draw(ax, v0, v, exact)
        apart = start["x"][row[-1]] - start["x"][row[-2]] > 2.001 * start["R"][0]
        result.label(ax, "ball", "final speed / speed of the strikers" if number == 1 else "",
                     f"row {number}: {np.count_nonzero(v0)} in, "
                     f"{'apart' if apart else 'touching'}")
    axes[1].legend(loc="upper left")
    report.add("relative change of the momentum", end["vx"].sum() / start["vx"].sum() - 1,
               expected="0 up to rounding")
    off_line = max(np.abs(end[axis] - start[axis]).max() for axis in "yz")
    report.add("way off the line", off_line, unit="m", expected="0 to the last bit")
    report.save(fig)


if __name__ == "__main__":
    outputs, folder = result.arguments(__doc__)
    main(outputs[0], folder)

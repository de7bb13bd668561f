#!/usr/bin/env python3
"""Compare the speeds after the knock with an ODE of the Hertz chain: measure.py OUTPUT"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
import flow  # noqa: E402
from frames import read_run  # noqa: E402


def rows_of(frame):
    """Indices of the spheres of each row, from left to right; the top row first."""
    return [np.flatnonzero(frame["y"] == y) for y in np.unique(frame["y"])[::-1]]


def main(folder):
    """Measure the run in a folder."""
    run = read_run(folder)
    start, end = run.frame(0), run.frame()
    rows = rows_of(start)
    fig, axes = flow.figure(1, len(rows), width=2.2)
    values = []
    for number, (row, ax) in enumerate(zip(rows, axes)):
        v0, v = start["vx"][row], end["vx"][row]
        _, expected = flow.hertz_chain(start["x"][row], v0, start["R"][row], run.scene,
                                       np.array([run.time(max(run.files))]))
        name = f"row {number + 1}, speed of the last ball / speed of the strikers"
        drift = abs((v @ v) / (v0 @ v0) - 1)  # relative error of the energy: all balls are equal
        values.append(flow.Value(name, v[-1] / v0[0], v[-1] / v0[0] * drift, "",
                                 f"{expected[-1, -1] / v0[0]:.7f}, ODE of the Hertz chain"))
        balls = np.arange(len(row)) - np.count_nonzero(v0)  # ball 0 is the first that waited
        ax.bar(balls, v / v0[0], color=["#d1495b" if s else "#00429d" for s in v0], width=0.7,
               alpha=0.75, label="program")
        ax.plot(balls, expected[-1] / v0[0], "k_", markersize=9, label="ODE of Hertz chain")
        flow.label(ax, "ball", "final / striking speed" if number == 0 else "",
                   f"row {number + 1}: {np.count_nonzero(v0)} in")
        ax.set_ylim(-0.25, 1.3)
        error = np.abs(v - expected[-1]).max() / v0[0]
        values.append(flow.Value(f"row {number + 1}, largest difference to the ODE", error, 0, "",
                                 "0, of second order in dt"))
    momentum = end["vx"].sum() / start["vx"].sum() - 1
    off_line = max(np.abs(end["y"] - start["y"]).max(), np.abs(end["z"] - start["z"]).max())
    values += [flow.Value("relative change of the momentum", momentum, 1e-15, "", "0"),
               flow.Value("way off the line", off_line, 0, "m", "0 to the last bit")]
    axes[1].legend(loc="upper left")
    flow.report(folder, values)
    flow.save(fig, folder)


if __name__ == "__main__":
    main(sys.argv[1])

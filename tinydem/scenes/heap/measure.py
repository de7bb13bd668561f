#!/usr/bin/env python3
"""The angle of repose of a heap, and how much its grains still move.

    measure.py OUTPUT [OUTPUT ...]     runs with the same scheme and time step are averaged
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import packing  # noqa: E402
import result  # noqa: E402
from frames import speed  # noqa: E402

PAPER = 49  # degrees, with plates 11 diameters apart and 100 000 grains


def kind(run):
    """A name of the scheme and of the time step in units of the default, Eq. (50)."""
    s = run.scene
    default = s["Rmin"] * np.sqrt(s["rho"] * (1 - s["nu"]**2) / s["E"])
    return f"{s['scheme']}, dt = {s['dt'] / default:.3g} dt0"


def settled(frame):
    """The grains of a frame that lie on the floor or on others (z > 0 catches what escaped)."""
    return frame[(frame["z"] > 0) & (speed(frame) < 0.05)]


def computing_time(run):
    """Seconds that the run took, from the updates per second in its log."""
    log = run.log[1:]
    return (log["N"] * run.scene["Nsteps"] / np.maximum(log["updates_per_second"], 1)).sum()


def main():
    """Measure every run; average those of a kind."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    fig, ax = result.figure(1, 2, width=3.9)
    kinds = {}
    for run in runs:
        kinds.setdefault(kind(run), []).append(run)
    for color, (name, group) in zip(result.COLORS, kinds.items()):
        angles, motion, spent = [], [], []
        for run in group:
            grains = settled(run.frame())
            pair, errors, lines = packing.angle_of_repose(grains["x"], grains["z"], grains["R"])
            angles += list(zip(pair, errors))
            motion.append(np.sqrt((speed(grains)**2).mean()))
            spent.append(computing_time(run))
        values, errors = np.array(angles).T
        angle = values.mean()  # flanks are independent: their scatter is the error
        error = max(values.std(ddof=1), errors.mean()) / np.sqrt(len(values))
        slope = np.tan(np.radians(angle))
        report.add(f"angle of repose ({name})", angle, error, "deg", f"{PAPER} in the paper")
        report.add(f"effective friction ({name})", slope, np.radians(error) * (1 + slope**2), "",
                   "1.15 in the paper, far below mus = mur = 3")
        report.add(f"rms speed at the end ({name})", np.mean(motion), unit="m/s", expected="0")
        report.add(f"wall time ({name})", *result.mean_error(spent), "s")
        x, z = packing.surface(grains["x"], grains["z"], grains["R"], 3 * grains["R"].mean())
        ax[0].plot(x, z, ".", color=color, markersize=3, label=name)
        for line in lines:
            ax[0].plot(*line, color=color)
        log = group[-1].log
        ax[1].semilogy(log["t"], np.maximum(log["kinetic"] + log["rotational"], 1e-16),
                       color=color, label=name)
    ax[0].set_aspect("equal")
    ax[0].locator_params(axis="x", nbins=6)
    result.label(ax[0], "x / m", "surface / m", "profile and fit")
    result.label(ax[1], "time / s", "kinetic energy / J", "grains come to rest")
    ax[1].legend(loc="lower left")
    report.save(fig)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Discharge of a silo, a constant rate, and its power of the orifice: measure.py OUTPUT [..]"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402
from frames import fail  # noqa: E402

SETTLED = 0.4  # when the loose start has fallen together [s]
HALF_EMPTY = 0.6  # share of the grains that have left at the end of the measurement


def orifice(run):
    """Width [L] between the rounded ends of the two halves of the floor, the lowest edges."""
    bottom = min(e.corners[:, 2].min() for e in run.mesh)
    floor = [e for e in run.mesh if np.all(e.corners[:, 2] == bottom)]
    if len(floor) != 2:
        fail(f"{run.folder}/mesh.off: a floor of two edges is needed, found {len(floor)}; try: "
             "make_mesh.py")
    left, right = sorted(floor, key=lambda e: e.corners[:, 0].max())
    return right.corners[:, 0].min() - left.corners[:, 0].max() - left.radius - right.radius


def discharge(run):
    """t (frames,) [T], grains that have left (frames,), in areas of a mean grain, and their total.

    Areas count, not numbers: in two dimensions they are the mass.
    """
    first = run.frame(0)
    area = (first["R"] / first["R"].mean())**2
    left = [area[frame["z"] < 0].sum() for _, frame in run.frames()]
    return np.array([run.time(n) for n in run.files]), np.array(left), area.sum()


def measure_one(run):
    """t, left, who is in the window of constant head (frames,), rate and its error [1/T]."""
    t, left, total = discharge(run)
    window = (t > SETTLED) & (left < HALF_EMPTY * total)
    if left[-1] - left[len(t) * 3 // 4] < 5 and left[-1] < HALF_EMPTY * total:
        print(f"note: {run.folder} is clogged by an arch; it is left out", file=sys.stderr)
        return t, left, window, np.nan, np.nan
    return t, left, window, *flow.discharge_rate(t[window], left[window])


def compare(report, runs, widths, rate, error):
    """Report the fit of Beverloo's law over orifices (runs,) in mean grain diameters.

    The errors of the rates are rough, each from a few blocks: all get their mean relative error.
    """
    error = rate * np.sqrt(np.mean((error / rate)**2))
    C, k, dC, dk, chi2 = flow.beverloo_fit(widths, rate, error)
    d, g = 2 * runs[0].frame(0)["R"].mean(), np.linalg.norm(runs[0].scene["g"])
    unit = 0.82 * 4 / np.pi * np.sqrt(g / d)  # [1/T]; 0.82: share of the area in a dense layer
    power, power_error = flow.beverloo_exponent(widths, rate, error, 1)
    report.add("exponent n of the rate, W ~ (D - d)^n", power, power_error,
               expected="3/2 in two dimensions, Beverloo")
    report.add("k of W = C (D - k d)^(3/2)", k, dk, expected="1 to 2, Beverloo: 1.4 for sand")
    report.add("C / (density sqrt(g))", C / unit, dC / unit, expected="about 1")
    report.add("chi^2 per degree of freedom", chi2, expected="about 1")
    return C, k


def draw(measured, widths, law):
    """The figure; measured: of each run as measure_one() gives it; law: C, k or None."""
    fig, (left, right) = result.figure(1, 2)
    for k, (t, out, window, rate, _) in enumerate(measured):
        left.plot(t, out, ".", color=result.COLORS[k % 7], markersize=3,
                  label=f"D = {widths[k]:.0f} d")
        middle = window.nonzero()[0]
        if len(middle) and np.isfinite(rate):
            line = out[middle].mean() + rate * (t - t[middle].mean())
            left.plot(t[middle], line[middle], "k", linewidth=1)
    left.legend()
    result.label(left, "time / s", "grains that have left", "black: constant rate")
    rate, error = np.array([one[3:] for one in measured]).T
    right.errorbar(widths, rate**(2 / 3), 2 / 3 * rate**(-1 / 3) * error, fmt="o", capsize=2,
                   color=result.COLORS[0], markerfacecolor="w", label="program")
    if law:
        x = np.array([law[1], max(widths)])
        right.plot(x, law[0]**(2 / 3) * (x - law[1]), "k", linewidth=1, label="Beverloo, power 3/2")
    right.set(xlim=(0, None), ylim=(0, None))
    right.legend()
    result.label(right, "orifice D / mean diameter d", r"(grains per second)$^{2/3}$")
    return fig


def main(runs, where):
    """Measure runs, write to the folder where."""
    report, measured = result.Report(where), [measure_one(run) for run in runs]
    widths = np.array([orifice(run) / (2 * run.frame(0)["R"].mean()) for run in runs])
    rate, error = np.array([one[3:] for one in measured]).T
    for width, (t, left, window, W, dW) in zip(widths, measured):
        report.add(f"rate for D = {width:.2f} d", W, dW, "grains/s")
        half = np.array_split(np.flatnonzero(window), 2)
        if len(half[1]) > 7 and np.isfinite(W):
            early, late = (flow.discharge_rate(t[part], left[part], 3) for part in half)
            report.add(f"late / early rate for D = {width:.2f} d", late[0] / early[0],
                       late[0] / early[0] * np.hypot(late[1] / late[0], early[1] / early[0]),
                       expected="1; water would slow down as the square root of its height")
    good = np.isfinite(rate)
    law = compare(report, runs, widths[good], rate[good], error[good]) if good.sum() > 2 else None
    report.save(draw(measured, widths, law))


if __name__ == "__main__":
    main(*result.arguments(__doc__))

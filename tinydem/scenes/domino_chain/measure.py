#!/usr/bin/env python3
"""Speed and width of the solitary waves against Nesterenko's theory: measure.py OUTPUT"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402

FROM, TO = 20, 50  # spheres of a row, counted from its striker, at which the wave has its shape


def measure_row(t, v, scene):
    """What is known of a row: times t (times,) and velocities v (times, n) as they came, then peak
    speed of a sphere, speed of the wave and its error [L/T], width [diameters], speed in theory."""
    diameter = 2 * scene["Rmax"]
    passing, top = flow.peaks(t, v[:, FROM:TO])
    line = flow.line_fit(passing, diameter * np.arange(FROM, TO))
    width = flow.width_at_half(t, v[:, (FROM + TO) // 2]) * line.b / diameter
    return t, v, top.mean(), line.b, line.db, width, flow.nesterenko_speed(top.mean(), scene)


def draw(rows, exact, diameter):
    """The figure; rows: as measure_row() gives them, exact: a row of the ODE."""
    top, speed, theory = np.array([(row[2], row[3], row[6]) for row in rows]).T
    fig, (left, right) = result.figure(1, 2)
    points = {"color": result.COLORS[0], "marker": "o", "markerfacecolor": "w", "linestyle": "none"}
    left.loglog(top, theory, "k", linewidth=1, label="long-wave theory, power 1/5")
    left.loglog(top, speed, **points, label="program")
    result.label(left, "largest speed of a sphere / (m/s)", "speed of the wave / (m/s)")
    ticks = [14, 16, 20, 24, 28]
    left.set_yticks(ticks, [str(tick) for tick in ticks])
    left.minorticks_off()
    left.legend()
    middle = (FROM + TO) // 2
    for (t, v, peak, V, *_), look in ((rows[0], {**points, "label": "program"}),
                                      (exact, {"color": result.COLORS[1], "label": "ODE"})):
        place = (t - flow.peaks(t, v[:, [middle]])[0]) * V / diameter
        right.plot(place, v[:, middle] / peak, **look)
    x = np.linspace(-2.48, 2.48, 200)  # half of 5 pi/sqrt(10)
    right.plot(x, np.cos(x * np.sqrt(10) / 5)**4, "k", linewidth=1, label="long-wave theory")
    right.set_xlim(-3, 5.5)
    result.label(right, "place behind the peak / diameters", "speed / largest speed")
    right.legend(loc="upper right")
    return fig


def main(run, where):
    """Measure a run, write to the folder where."""
    first = run.frame(0)
    t = np.array([run.time(number) for number in run.files])
    v = np.array([frame["vx"] for _, frame in run.frames()])
    indices = [np.flatnonzero(first["y"] == y) for y in np.unique(first["y"])[::-1]]
    rows = [measure_row(t, v[:, row], run.scene) for row in indices]
    start = first[indices[0]]
    chain = flow.hertz_chain(start["x"], start["vx"], start["R"], run.scene, t)
    exact = measure_row(t, chain[1], run.scene)
    top, V, dV, width, theory = np.array([row[2:] for row in rows]).T
    share = top / [v[0, row[0]] for row in indices]
    law = flow.power_fit(top, V, dV)
    report = result.Report(where)
    report.add("exponent of the speed of the wave against that of the spheres", law.b, law.db,
               expected="1/5, Nesterenko")
    report.add("speed of the wave / long-wave theory", *result.mean_error(V / theory),
               expected=f"{exact[3] / exact[6]:.5f}, ODE of the Hertz chain")
    report.add("width at half height", *result.mean_error(width), "diameters",
               f"{exact[5]:.4f}, ODE; {flow.NESTERENKO_WIDTH:.4f}, long-wave theory")
    report.add("largest speed of a sphere / speed of the striker", *result.mean_error(share),
               expected=f"{exact[2] / start['vx'][0]:.5f}, ODE")
    report.save(draw(rows, exact, 2 * start["R"][0]))


if __name__ == "__main__":
    outputs, folder = result.arguments(__doc__)
    main(outputs[0], folder)

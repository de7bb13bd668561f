#!/usr/bin/env python3
"""Speed and width of the solitary waves against Nesterenko's theory: measure.py OUTPUT"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
import flow  # noqa: E402
from frames import read_run  # noqa: E402

FROM, TO = 20, 50  # spheres of a row, counted from its striker, at which the wave has its shape


def measure_row(t, v, scene):
    """What is known of a row: times t (times,) and velocities v (times, n) as they came, then peak
    speed of a sphere, speed of the wave and its error [L/T], width [diameters], speed in theory."""
    diameter = 2 * scene["Rmax"]
    passing, top = flow.peaks(t, v[:, FROM:TO])
    line = flow.line_fit(passing, diameter * np.arange(FROM, TO))
    width = flow.width_at_half(t, v[:, (FROM + TO) // 2]) * line.b / diameter
    return t, v, top.mean(), line.b, line.db, width, flow.nesterenko_speed(top.mean(), scene)


def draw(folder, rows, exact, diameter):
    """result.png; rows: tuples (t, v (times, n), *measure_row()), exact: one more of the ODE."""
    top, speed, theory = np.array([(row[2], row[3], row[6]) for row in rows]).T
    fig, (left, right) = flow.figure(1, 2)
    left.loglog(top, theory, **flow.LAW, label="long-wave theory, power 1/5")
    left.loglog(top, speed, **flow.points(0), label="program")
    flow.label(left, "largest speed of a sphere / (m/s)", "speed of the wave / (m/s)")
    left.legend()
    for (t, v, peak, V, _, _, _), look, name in ((rows[0], flow.points(0), "program"), (
            exact, {"color": flow.COLORS[1]}, "ODE of the Hertz chain")):
        middle = (FROM + TO) // 2
        place = (t - flow.peaks(t, v[:, [middle]])[0]) * V / diameter
        right.plot(place, v[:, middle] / peak, **look, label=name)
    x = np.linspace(-2.5, 2.5, 200)
    right.plot(x, np.cos(x * np.sqrt(10) / 5)**4, **flow.LAW, label="long-wave theory")
    right.set_xlim(-4, 4)
    flow.label(right, "place behind the peak / diameters", "speed / largest speed")
    right.legend(loc="upper left")
    flow.save(fig, folder)


def main(folder):
    """Measure the run in a folder."""
    run = read_run(folder)
    first = run.frame(0)
    t = np.array([run.time(number) for number in run.files])
    v = np.array([frame["vx"] for _, frame in run.frames()])
    indices = [np.flatnonzero(first["y"] == y) for y in np.unique(first["y"])[::-1]]
    rows = [measure_row(t, v[:, row], run.scene) for row in indices]
    start = first[indices[0]]
    exact = measure_row(t, flow.hertz_chain(start["x"], start["vx"], start["R"], run.scene, t)[1],
                        run.scene)
    top, V, dV, width, theory = np.array([row[2:] for row in rows]).T
    share = top / [v[0, row[0]] for row in indices]
    law = flow.power_fit(top, V, dV)

    def scatter(quantity, values, unit, expected):
        return flow.Value(quantity, np.mean(values), np.std(values, ddof=1), unit, expected)

    flow.report(folder, [
        flow.Value("exponent of the wave speed against the speed of the spheres", law.b, law.db, "",
                   "1/5, Nesterenko"),
        scatter("wave speed / long-wave theory", V / theory, "",
                f"{exact[3] / exact[6]:.5f}, ODE of the Hertz chain"),
        scatter("width at half height", width, "diameters",
                f"{exact[5]:.4f}, ODE; {flow.NESTERENKO_WIDTH:.4f}, long-wave theory"),
        scatter("largest speed of a sphere / speed of the striker", share, "",
                f"{exact[2] / start['vx'][0]:.5f}, ODE")])
    draw(folder, rows, exact, 2 * start["R"][0])


if __name__ == "__main__":
    main(sys.argv[1])

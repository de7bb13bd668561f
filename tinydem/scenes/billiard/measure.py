#!/usr/bin/env python3
"""From sliding to rolling, and the throw of cut shots: measure.py OUTPUT"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402
from frames import columns  # noqa: E402


def shots(first, after):
    """Cut angle, throw angle [rad] of the shots and indices of their object balls, each (shots,).

    first, after: frames before and after the collisions. Ball 0 slides alone; then object ball and
    cue ball take turns.
    """
    objects = np.arange(1, len(first), 2)
    line = columns(first[objects], "x,y") - columns(first[objects + 1], "x,y")

    def angle(frame, who):
        """From the line of centres to the velocity."""
        v = columns(frame[who], "vx,vy")
        return np.arctan2(line[:, 0] * v[:, 1] - line[:, 1] * v[:, 0], np.sum(line * v, axis=1))
    return angle(first, objects + 1), angle(after, objects), objects


def draw(time, speed, share, cut, throw, scene, theory):
    """The figure: speed (frames,) of ball 0 over time, throw over cut angle [rad]."""
    fig, (left, right) = result.figure(1, 2)
    slide = speed[0] - scene["mus"] * np.linalg.norm(scene["g"]) * time
    left.plot(time, np.maximum(slide, share * speed[0]), "k", linewidth=1,
              label="closed form: slide, then roll")
    left.plot(time[::3], speed[::3], "o", color=result.COLORS[0], markerfacecolor="w",
              label="ball 0")
    left.set(ylim=(0.6, 1.05), xlim=(0, 0.6))
    left.legend()
    result.label(left, "time / s", "speed / (m/s)", "from sliding to rolling")
    fine = np.linspace(0.0, np.radians(65), 200)
    slip, stick = theory(fine), flow.sticking_throw(fine, scene)
    right.plot(np.degrees(fine), np.degrees(slip), "k", linewidth=1, label="slides: closed form")
    right.plot(np.degrees(fine), np.degrees(stick), "--", color="0.4", label="sticks: hard balls")
    right.plot(np.degrees(cut), np.degrees(throw), "o", color=result.COLORS[1],
               markerfacecolor="w", label="object balls")
    right.set(ylim=(0, 8))
    right.legend(loc="lower right")
    result.label(right, "cut angle / degrees", "throw angle / degrees", "throw of a cut shot")
    return fig


def main(run, where):
    """Measure a run, write to the folder where."""
    numbers = list(run.files)
    time = np.array([run.time(number) for number in numbers])
    first, after, end = run.frame(numbers[0]), run.frame(numbers[1]), run.frame()
    v = np.array([np.hypot(f["vx"], f["vy"]) for _, f in run.frames()])  # (frames, balls)
    radius, overlap = first["R"][0], first["R"][0] - first["z"][0]
    share = flow.rolling_share(radius, overlap)
    cut, throw, objects = shots(first, after)
    speed = v[0, objects + 1].mean()

    def theory(angle):
        return flow.sliding_throw(angle, speed, radius, run.scene)
    report = result.Report(where)
    report.add("ball 0, speed of rolling / speed of the start", v[-1, 0] / v[0, 0],
               np.ptp(v[-10:, 0]) / v[0, 0], expected=f"{share:.6f}, hard table 5/7 = 0.714286")
    middle = flow.hertz_duration(speed * np.cos(cut), radius, run.scene) / 2  # of the collision
    brake = (v[1] - v[2])[objects] / run.interval  # while they still slide
    hit = v[1, objects] + brake * (run.interval - middle)
    report.add("object balls, speed of rolling / speed after the collision",
               *result.mean_error(v[-1, objects] / hit), expected=f"{share:.6f}")
    slides = np.tan(cut) > 3.5 * run.scene["mus"] * (1 + run.scene["en"])
    stick = flow.sticking_throw(cut, run.scene)
    for k, angle in enumerate(np.degrees(cut)):
        expected = f"{np.degrees(theory(cut)[k]):.3f}, slides" if slides[k] else \
            f"{np.degrees(stick[k]):.3f} for hard balls that stick"
        report.add(f"throw angle at a cut of {angle:.0f} degrees", np.degrees(throw[k]),
                   unit="degrees", expected=expected)
    report.add("throw - closed form, mean of the cuts that slide",
               *result.mean_error(np.degrees(throw - theory(cut))[slides]), "degrees",
               f"0; atan(mu_s) is {np.degrees(np.arctan(run.scene['mus'])):.3f}")
    report.save(draw(time, v[:, 0], share, cut, throw, run.scene, theory))


if __name__ == "__main__":
    outputs, folder = result.arguments(__doc__)
    main(outputs[0], folder)

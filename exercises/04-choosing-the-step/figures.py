"""Draws step.png: python3 exercises/04-choosing-the-step/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "verification")]
import numpy as np  # noqa: E402
import style  # noqa: E402
from reference import HERTZ, rms_error  # noqa: E402


def impact(steps, en=0.5):
    """Times and overlaps of the model impact, in units of the elastic contact time and overlap."""
    damping = np.sqrt(5 / (1 + (np.pi / np.log(en)) ** 2))
    dt, v = HERTZ * 1.25 ** 0.4 / steps, 1.0
    line = [(0.0, 0.0), (1 / steps, dt)]
    while line[-1][1] > 0:
        t, delta = line[-1]
        v -= dt * (delta ** 1.5 + damping * delta ** 0.25 * v)
        line.append((t + 1 / steps, delta + dt * v))
    return np.array(line).T * np.array([[1], [1.25 ** -0.4]])


def overlaps(ax):
    ax.plot(*impact(5000), **style.LINE["reference"], label="5000 steps")
    for k, n in enumerate((12, 4)):
        ax.plot(*impact(n), **style.cycle(k), label=f"{n} steps")
    ax.set(xlim=(-0.03, 1.55), ylim=(-0.25, 1.35))
    style.label(ax, "time / elastic contact time", r"overlap / elastic overlap",
                "an impact, $e_n$ = 0.5")
    ax.legend(loc="upper right")


def work(ax):
    steps = np.unique(np.round(np.geomspace(4, 400, 22)))
    for k, en in enumerate((0.3, 0.5, 0.7, 0.9)):
        ax.loglog(steps, [rms_error(en, n) for n in steps], **style.cycle(k),
                  label=f"$e_n$ = {en:g}")
    ax.axvline(12.33, color="0.45", linewidth=0.9, linestyle=(0, (3, 2)))
    ax.text(13.2, 5e-5, "default step at\n10 % indentation", fontsize=7, color="0.35")
    ax.set_ylim(3e-5, 0.1)
    style.label(ax, "steps per contact (work)", "RMS error of $e_n$", "speed against error")
    ax.legend()


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(7.4, 2.8))
    overlaps(axes[0])
    work(axes[1])
    fig.savefig(HERE / "step.png", metadata={"Software": None})

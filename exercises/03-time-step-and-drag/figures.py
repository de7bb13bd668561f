"""Draws steps.png: python3 exercises/03-time-step-and-drag/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402


def oscillate(h, steps, new_velocity):
    """x and v of a mass on a spring, m = k = 1; the position moves with the new or old velocity."""
    x, v, line = 1.0, 0.0, [(1.0, 0.0)]
    for _ in range(steps):
        w = v - h * x
        x, v = x + h * (w if new_velocity else v), w
        line.append((x, v))
    return np.array(line).T


def fall(h, T):
    """Times and speeds of a fall with g = c = 1, in steps h."""
    t, v = np.arange(0, T + h / 2, h), [0.0]
    for _ in t[1:]:
        v.append(v[-1] + h * (1 - v[-1]))
    return t, np.array(v)


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(7.4, 2.9), width_ratios=(1, 1.35))
    angle = np.linspace(0, 2 * np.pi, 200)
    axes[0].plot(np.cos(angle), np.sin(angle), **style.LINE["reference"], label="exact")
    small = {"markersize": 2.6, "linewidth": 0.8}
    axes[0].plot(*oscillate(0.2, 62, True),
                 **{**style.LINE["semi-implicit Euler"], **small}, label="new velocity")
    axes[0].plot(*oscillate(0.2, 62, False),
                 **{**style.LINE["explicit Euler"], **small}, label="old velocity")
    axes[0].set(xlim=(-4.3, 4.3), ylim=(-4.3, 5.6), aspect="equal")
    style.label(axes[0], "$x$", "$v$", r"two periods, $\omega \Delta t$ = 0.2")
    axes[0].legend(loc="upper center", ncols=1, fontsize=7)
    t = np.linspace(0, 6, 200)
    axes[1].plot(t, 1 - np.exp(-t), **style.LINE["reference"], label="exact")
    for k, h in enumerate((0.25, 1.0, 1.6)):
        axes[1].plot(*fall(h, 6), **style.cycle(k), label=rf"$c\,\Delta t$ = {h:g}")
    axes[1].set(xlim=(0, 6), ylim=(0, 1.75))
    style.label(axes[1], "$c\\, t$", "speed / terminal speed", "a fall in a fluid")
    axes[1].legend(loc="lower right")
    fig.savefig(HERE / "steps.png", metadata={"Software": None})

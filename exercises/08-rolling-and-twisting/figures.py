"""Draws rolling.png: python3 exercises/08-rolling-and-twisting/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402
from matplotlib.patches import Arc, Circle  # noqa: E402

arrow = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "linewidth": 1.4}


def pressure(ax):
    """A sphere that rolls to the right: the pressure is higher in front."""
    ax.add_patch(Circle((0, 1), 1, facecolor=style.COLORS[0], alpha=0.13, edgecolor="none"))
    ax.add_patch(Circle((0, 1), 1, fill=False, edgecolor=style.COLORS[0], linewidth=1.3))
    ax.plot([-1.5, 1.7], [0.06, 0.06], color="0.0", linewidth=1.2)
    ax.annotate("", (0, -0.05), (0, 1), arrowprops={**arrow, "color": "0.35"})
    ax.text(-0.08, 0.62, r"$m\vec{g}$", ha="right", fontsize=9.5, color="0.35")
    ax.plot(0, 1, "o", color="0.0", markersize=3)
    x = np.linspace(-0.45, 0.45, 10)
    size = 1.5 * np.sqrt(np.maximum(0, 1 - (x / 0.5) ** 2)) * (0.35 + 0.55 * (x + 0.5))
    for a, s in zip(x, size):
        ax.annotate("", (a, 0.06), (a, 0.02 - s), arrowprops={
            **arrow, "color": style.COLORS[1], "linewidth": 0.8, "mutation_scale": 5})
    ax.annotate("", (0.3, 0.95), (0.3, 0.08),
                arrowprops={**arrow, "color": style.COLORS[1], "linewidth": 2})
    ax.text(0.38, 0.7, r"$\vec{f}_n$", color=style.COLORS[1], fontsize=10)
    ax.text(0.62, -0.52, "pressure,\nhigher in front", color=style.COLORS[1], fontsize=8,
            va="center")
    ax.annotate("", (0.3, 0.26), (0, 0.26), arrowprops={**arrow, "arrowstyle": "<->",
                                                         "linewidth": 0.8})
    ax.text(0.78, 0.3, r"$\leq\mu_r R^*$", fontsize=8.5, va="center")
    ax.add_patch(Arc((0, 1), 1.5, 1.5, theta1=40, theta2=140, color="0.35", linewidth=1.4))
    ax.annotate("", (0.63, 1.42), (0.57, 1.49), arrowprops={**arrow, "color": "0.35"})
    ax.text(0, 1.5, r"$\vec{\omega}$", fontsize=10, color="0.35", ha="center")
    ax.annotate("", (1.75, 1), (1.1, 1), arrowprops={**arrow, "color": "0.35"})
    ax.text(1.4, 1.08, r"$\vec{v}$", fontsize=10, color="0.35", ha="center")
    ax.set(xlim=(-1.5, 2.0), ylim=(-1.05, 2.1), aspect="equal")
    ax.set_title("why rolling costs energy", loc="left")
    ax.axis("off")


def spin_down(ax):
    """The two parts of a spin; both fall linearly."""
    t = np.linspace(0, 2, 200)
    for k, (slope, text) in enumerate(((1.2, r"rolling, $\mu_r = 1.2\,\mu_s$"),
                                     (2 / 3, r"twisting, $\mu_t = \frac{2}{3}\,\mu_s$"))):
        ax.plot(t, np.maximum(0, 1 - slope * t), **style.cycle(k, marker=False), label=text)
    ax.set_ylim(-0.05, 1.1)
    style.label(ax, r"$t\;/\;(2 R\,\omega_0 / 5 \mu_s g)$", r"part of $\omega$ / at the start",
                "a sphere spins on ice")
    ax.legend(loc="upper right")


def incline(ax):
    """Acceleration over the slope, for two coefficients."""
    slope = np.linspace(0, 0.8, 400)
    sin, cos = slope / np.hypot(1, slope), 1 / np.hypot(1, slope)
    for k, mur in enumerate((0.0, 0.2, 0.4)):
        ax.plot(slope, np.maximum(0, 5 / 7 * (sin - mur * cos)), **style.cycle(k, marker=False),
                label=rf"$\mu_r = {mur:g}$")
    style.label(ax, r"slope $\tan\theta$", r"acceleration / $g$", "it stays, or rolls down")
    ax.legend(loc="upper left")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 3, figsize=(8.6, 2.6), width_ratios=(1.2, 1, 1))
    pressure(axes[0])
    spin_down(axes[1])
    incline(axes[2])
    fig.savefig(HERE / "rolling.png", metadata={"Software": None})

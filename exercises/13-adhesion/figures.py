"""Draws adhesion.png: python3 exercises/13-adhesion/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402

arrow = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "linewidth": 1.4}


def law(ax):
    """Force over overlap, in units of the pull-off force and of the overlap at rest."""
    d = np.linspace(0, 1.9, 200)
    ax.plot([-0.6, 0], [0, 0], **style.cycle(0, marker=False))
    ax.plot(d, d ** 1.5 - 1, **style.cycle(0, marker=False), label="with adhesion, (A1)")
    ax.plot([0, 0], [0, -1], color=style.COLORS[0], linewidth=0.8, linestyle=(0, (2, 2)))
    ax.plot(d, d ** 1.5, **style.cycle(1, marker=False), label="Hertz, Eq. (5)")
    ax.plot([1], [0], "o", color="black", markersize=4)
    ax.annotate("at rest", (1, 0), (1.15, -0.62), fontsize=8,
                arrowprops={"arrowstyle": "-", "linewidth": 0.6})
    ax.annotate("pull-off", (0, -1), (-0.62, -0.72), fontsize=8,
                arrowprops={"arrowstyle": "-", "linewidth": 0.6})
    ax.set(xlim=(-0.7, 1.9), ylim=(-1.3, 2.4))
    style.label(ax, r"overlap $\delta/\delta_0$", r"force / $4\pi\gamma R^*$", "at rest, no dashpot")
    ax.legend(loc="upper left")


def energy(ax):
    """The well, Eq. (A4)."""
    d = np.linspace(0, 2.4, 200)
    ax.plot([-0.6, 0], [0, 0], **style.cycle(0, marker=False))
    ax.plot(d, 0.4 * d ** 2.5 - d, **style.cycle(0, marker=False), label="with adhesion, (A4)")
    ax.plot(d, 0.4 * d ** 2.5, **style.cycle(1, marker=False), label=r"$\frac{2}{5} k_n\delta^2$")
    ax.plot([1], [-0.6], "o", color="black", markersize=4)
    ax.set(xlim=(-0.7, 2.4), ylim=(-0.9, 1.9))
    style.label(ax, r"overlap $\delta/\delta_0$", r"energy / $4\pi\gamma R^*\delta_0$", "a well")
    ax.legend(loc="upper left")


def spheres(ax):
    """A sphere that hangs from a ceiling, and one that sticks to a wall."""
    ax.fill_between([-0.4, 2.5], 2.0, 2.25, color="0.85", linewidth=0)
    ax.fill_between([4.0, 4.25], -1.6, 2.25, color="0.85", linewidth=0)
    ax.plot([-0.4, 2.5], [2.0, 2.0], color="0.4", linewidth=0.8)
    ax.plot([4.0, 4.0], [-1.6, 2.25], color="0.4", linewidth=0.8)
    for x, y in (1.0, 1.05), (3.05, 0.2):
        ax.add_patch(style.plt.Circle((x, y), 1, facecolor="0.96", edgecolor="0.2"))
        ax.annotate("", (x, y - 1.3), (x, y), arrowprops={**arrow, "color": style.COLORS[1]})
        ax.text(x - 0.12, y - 0.75, "$m g$", color=style.COLORS[1], ha="right", fontsize=9)
    ax.annotate("", (1.0, 3.35), (1.0, 2.05), arrowprops={**arrow, "color": style.COLORS[0]})
    ax.text(1.15, 2.75, r"at most $4\pi\gamma R$", color=style.COLORS[0], fontsize=8.5)
    ax.annotate("", (4.0, 1.5), (4.0, 0.2), arrowprops={**arrow, "color": style.COLORS[0]})
    ax.text(4.4, 0.75, "at most\n" + r"$\mu_s\, 4\pi\gamma R$", color=style.COLORS[0], fontsize=8.5)
    ax.set(xlim=(-0.5, 6.0), ylim=(-1.7, 3.6), aspect="equal", title="ceiling and wall")
    ax.axis("off")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 3, figsize=(8.6, 2.6), width_ratios=(1, 1, 1.15))
    law(axes[0])
    energy(axes[1])
    spheres(axes[2])
    fig.savefig(HERE / "adhesion.png", metadata={"Software": None})

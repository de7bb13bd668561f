"""Draws overlap.png: python3 exercises/01-hertz-force/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402
from matplotlib.patches import Circle  # noqa: E402


def arrow(ax, start, end, text, at, color="0.0", both=False, **more):
    """An arrow with a label."""
    look = {"arrowstyle": "<|-|>" if both else "-|>", "color": color, "shrinkA": 0, "shrinkB": 0,
            "linewidth": 1.3, **more}
    ax.annotate("", end, start, arrowprops=look)
    ax.text(*at, text, color=color, ha="center", va="center", fontsize=9.5)


def geometry(ax):
    """Two spheres that overlap, with the names of the equations."""
    Ri, Rj, delta = 1.0, 1.4, 0.28
    xj, xi = np.array([0.0, 0.0]), np.array([Ri + Rj - delta, 0.0])
    for x, R, color in ((xi, Ri, style.COLORS[0]), (xj, Rj, style.COLORS[1])):
        ax.add_patch(Circle(x, R, facecolor=color, alpha=0.15, edgecolor="none"))
        ax.add_patch(Circle(x, R, fill=False, edgecolor=color, linewidth=1.3))
        ax.plot(*x, "o", color=color, markersize=3)
    ax.text(xi[0] - 0.04, -0.3, "$i$", fontsize=11, color=style.COLORS[0])
    ax.text(-0.22, -0.1, "$j$", fontsize=11, color=style.COLORS[1])
    for x, R, angle, name in ((xi, Ri, 55, "$R_i$"), (xj, Rj, 125, "$R_j$")):
        u = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        side = np.array([-u[1], u[0]]) * (0.17 if angle > 90 else -0.17)
        arrow(ax, x, x + R * u, name, x + 0.6 * R * u + side, linewidth=0.9)
    arrow(ax, xj, xi, r"$\vec{d} = \vec{x}_i - \vec{x}_j$", (0.5, -0.24))
    arrow(ax, xi, xi + [1.75, 0], r"$\vec{f}_n = k_n \delta\, \hat{n}$", (xi[0] + 1.55, 0.24),
          style.COLORS[2], linewidth=2)
    left, right = xi[0] - Ri, xj[0] + Rj
    for x in left, right:
        ax.plot([x, x], [0.06, 1.52], color="0.5", linewidth=0.7, linestyle=(0, (3, 2)))
    arrow(ax, (left, 1.46), (right, 1.46), r"$\delta$", ((left + right) / 2, 1.66), both=True,
          mutation_scale=6, linewidth=0.9)
    ax.set(xlim=(-1.5, 4.2), ylim=(-1.55, 1.9), aspect="equal")
    ax.axis("off")


def law(ax):
    """Force over overlap: Hertz against a linear spring."""
    u = np.logspace(-5, 0, 50)
    ax.loglog(u, u ** 1.5, **style.cycle(0, marker=False), label=r"Hertz, $f \sim \delta^{3/2}$")
    ax.loglog(u, u, **style.cycle(1, marker=False), label=r"linear spring, $f \sim \delta$")
    ax.plot([1e-4, 1e-2, 1e-2], [1e-6, 1e-6, 1e-3], color="0.45", linewidth=0.8)
    ax.text(1e-3, 4e-7, "2", ha="center", va="center", color="0.35", fontsize=8)
    ax.text(1.6e-2, 3e-5, "3", ha="center", va="center", color="0.35", fontsize=8)
    ax.set_ylim(1e-8, 3)
    style.label(ax, r"overlap $\delta$ / $\delta_1$", "force / force at $\\delta_1$")
    ax.legend()


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(7.4, 2.7), width_ratios=(1.55, 1))
    geometry(axes[0])
    law(axes[1])
    fig.savefig(HERE / "overlap.png", metadata={"Software": None})

"""Draws contact.png: python3 exercises/05-contact-velocity/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402
from matplotlib.patches import Arc, Circle  # noqa: E402

BLUE, RED, GREEN = style.COLORS[:3]


def sphere(ax, x, R, color, name=""):
    """A sphere with its name."""
    ax.add_patch(Circle(x, R, facecolor=color, alpha=0.13, edgecolor="none"))
    ax.add_patch(Circle(x, R, fill=False, edgecolor=color, linewidth=1.2))
    ax.plot(*x, "o", color=color, markersize=3)
    ax.text(x[0], x[1] + 0.12, name, color=color, ha="center", fontsize=10)


def arrow(ax, start, end, color="0.0", both=False):
    look = {"arrowstyle": "<|-|>" if both else "-|>", "shrinkA": 0, "shrinkB": 0,
            "linewidth": 1.3, "color": color, "mutation_scale": 9}
    ax.annotate("", end, start, arrowprops=look)


def spin(ax, x, R, color, left=True):
    """An arrow that turns about x, to the left or to the right."""
    ax.add_patch(Arc(x, 2 * R, 2 * R, theta1=35, theta2=145, color=color, linewidth=1.3))
    a = np.radians(145 if left else 35)
    way = np.array([-np.sin(a), np.cos(a)]) * (1 if left else -1)
    tip = np.add(x, R * np.array([np.cos(a), np.sin(a)]))
    arrow(ax, tip - 0.02 * way, tip + 0.12 * way, color)


def geometry(ax):
    """The contact point between the surfaces, the arms, and the velocities of the two surfaces."""
    Rj, Ri, delta = 1.3, 0.95, 0.36
    xi, rj = np.array([Ri + Rj - delta, 0]), Rj - delta / 2
    sphere(ax, (0, 0), Rj, RED, "$j$")
    sphere(ax, xi, Ri, BLUE, "$i$")
    for x in xi[0] - Ri, Rj:
        ax.plot([x, x], [-1.05, 0.75], color="0.5", linewidth=0.7, linestyle=(0, (3, 2)))
    arrow(ax, (xi[0] - Ri, 0.7), (Rj, 0.7), both=True)
    ax.text(rj, 0.8, r"$\delta$", ha="center", fontsize=9.5)
    for a, b, name in ((0, rj, "$r_j$"), (rj, xi[0], "$r_i$")):
        arrow(ax, (a, -0.18), (b, -0.18), both=True)
        ax.text((a + b) / 2, -0.42, name, ha="center", fontsize=9.5)
    ax.plot([0, xi[0]], [0, 0], color="0.5", linewidth=0.7)
    ax.plot(rj, 0, "o", color="0", markersize=4)
    arrow(ax, xi, xi + [1.35, 0], GREEN)
    ax.text(xi[0] + 1.2, 0.14, r"$\hat{n}$", color=GREEN, fontsize=10, ha="center")
    ax.set(xlim=(-1.4, 3.4), ylim=(-1.4, 1.4), aspect="equal", title="arms")
    ax.axis("off")


def gears(ax):
    """Opposite spins: the surfaces go the same way."""
    sphere(ax, (0, 0), 1.2, RED, "$j$")
    sphere(ax, (1.9, 0), 0.7, BLUE, "$i$")
    spin(ax, (0, 0), 0.85, RED)
    spin(ax, (1.9, 0), 0.45, BLUE, left=False)
    arrow(ax, (1.14, 0), (1.14, 0.75), RED)
    arrow(ax, (1.26, 0), (1.26, 0.75), BLUE)
    ax.set(xlim=(-1.4, 2.8), ylim=(-1.4, 1.4), aspect="equal", title="gears: no sliding")
    ax.axis("off")


def rolling(ax):
    """The lowest point of a rolling sphere rests."""
    ax.axhline(0, color=RED, linewidth=1.5)
    sphere(ax, (0, 1), 1, BLUE)
    for y in 0.5, 1.0, 1.5, 2.0:
        arrow(ax, (0, y), (0.75 * y, y), BLUE)
    ax.plot(0, 0, "o", color="0", markersize=4)
    ax.text(0.82, 0.93, r"$\vec{v}_i$", color=BLUE, fontsize=9.5)
    ax.set(xlim=(-1.4, 1.9), ylim=(-0.35, 2.45), aspect="equal", title="rolling: no sliding")
    ax.axis("off")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 3, figsize=(8.6, 2.3), width_ratios=(1.7, 1.5, 1.2))
    geometry(axes[0])
    gears(axes[1])
    rolling(axes[2])
    fig.savefig(HERE / "contact.png", metadata={"Software": None})

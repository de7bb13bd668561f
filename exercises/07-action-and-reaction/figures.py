"""Draws levers.png: python3 exercises/07-action-and-reaction/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import style  # noqa: E402
from matplotlib.patches import Arc, Circle  # noqa: E402

I, J, FORCE = style.COLORS[0], style.COLORS[1], style.COLORS[2]


def arrow(ax, start, end, text, at, color="0.0", **more):
    """An arrow with a label."""
    look = {"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 0, "linewidth": 1.3,
            **more}
    ax.annotate("", end, start, arrowprops=look)
    ax.text(*at, text, color=color, ha="center", va="center", fontsize=9.5)


def turn(ax, x, radius, clockwise, text, at, color):
    """A bent arrow about x, from below over the top, or the other way round."""
    ax.add_patch(Arc(x, 2 * radius, 2 * radius, theta1=25, theta2=155, color=color, linewidth=2))
    side = 1 if clockwise else -1
    c, s = 0.906 * radius, 0.423 * radius  # the end of the arc
    ax.annotate("", (x[0] + side * (c + 0.035), x[1] + s - 0.09), (x[0] + side * c, x[1] + s),
                arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": 2, "shrinkA": 0,
                            "shrinkB": 0})
    ax.text(*at, text, color=color, ha="center", va="center", fontsize=9.5)


def spheres(ax, title):
    """Sphere j on the left, i on the right; their centres."""
    xj, xi = (0.0, 0.0), (2.3, 0.0)
    for x, R, color, name in ((xi, 1.0, I, "$i$"), (xj, 1.4, J, "$j$")):
        ax.add_patch(Circle(x, R, facecolor=color, alpha=0.13, edgecolor="none"))
        ax.add_patch(Circle(x, R, fill=False, edgecolor=color, linewidth=1.3))
        ax.plot(*x, "o", color=color, markersize=3)
        ax.text(x[0], x[1] - 1.12 * R + 0.42, name, color=color, fontsize=11, ha="center")
    ax.set(xlim=(-1.6, 3.5), ylim=(-1.6, 1.75), aspect="equal")
    ax.set_title(title, loc="left")
    ax.axis("off")
    return xi, xj


def sliding(ax):
    """The two sliding forces at the contact point, and what they turn."""
    xi, xj = spheres(ax, "sliding: opposite forces, equal directions of turning")
    p = (1.35, 0.0)
    for x, text in (xi, "$r_i$"), (xj, "$r_j$"):
        ax.plot([x[0], p[0]], [0, 0], color="0.4", linewidth=0.9)
        ax.text((x[0] + p[0]) / 2, -0.16, text, ha="center", va="center", fontsize=9.5)
    arrow(ax, p, (p[0], 1.05), r"$\vec{f}_s$", (p[0] + 0.22, 1.05), FORCE, linewidth=2)
    arrow(ax, p, (p[0], -1.05), r"$-\vec{f}_s$", (p[0] - 0.28, -1.12), FORCE, linewidth=2)
    turn(ax, xi, 0.55, True, r"$r_i\,\vec{f}_s\!\times\!\hat{n}$", (xi[0] + 0.1, 0.76), I)
    turn(ax, xj, 0.75, True, r"$r_j\,\vec{f}_s\!\times\!\hat{n}$", (xj[0] - 0.1, 0.97), J)


def rolling(ax):
    """The couple of rolling friction."""
    xi, xj = spheres(ax, "rolling: a couple, opposite torques")
    arrow(ax, (1.35, 0), (1.95, 0), r"$\hat{n}$", (1.72, 0.2))
    turn(ax, xi, 0.55, True, r"$R^*\,\hat{n}\!\times\!\vec{f}_r$", (xi[0] + 0.1, 0.76), I)
    turn(ax, xj, 0.75, False, r"$-R^*\,\hat{n}\!\times\!\vec{f}_r$", (xj[0], 0.97), J)


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(7.4, 2.65))
    sliding(axes[0])
    rolling(axes[1])
    fig.savefig(HERE / "levers.png", metadata={"Software": None})

"""Draws box.png: python3 exercises/14-periodic-box/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import style  # noqa: E402

L, R = 4.0, 0.55
SPHERES = [(0.45, 1.6), (3.45, 1.35), (1.7, 0.65), (2.5, 2.95), (1.3, 3.7), (2.25, 1.8)]


def circle(ax, x, y, **more):
    ax.add_patch(style.plt.Circle((x, y), R, **{"facecolor": "0.94", "edgecolor": "0.3", **more}))


def copies(ax):
    """The box, its copies, and a distance that is not the shortest."""
    for a in -1, 0, 1:
        for b in -1, 0, 1:
            ax.add_patch(style.plt.Rectangle((a * L, b * L), L, L, fill=False, linewidth=0.6,
                                             edgecolor="0.6"))
            for k, (x, y) in enumerate(SPHERES):
                color = style.COLORS[k] if k < 2 else "0.3"
                circle(ax, x + a * L, y + b * L, edgecolor=color, alpha=1 if a == b == 0 else 0.45,
                       facecolor=color if k < 2 else "0.94")
    ax.add_patch(style.plt.Rectangle((0, 0), L, L, fill=False, linewidth=1.8))
    (x, y), (u, v) = SPHERES[:2]
    ax.plot([x, u], [y, v], color="0.2", linestyle=(0, (2, 2)), linewidth=1)
    ax.plot([u, x + L], [v, y], color="black", linewidth=2)
    ax.text(x, y, "i", ha="center", va="center", color="white", fontsize=9)
    ax.text(u, v, "j", ha="center", va="center", color="white", fontsize=9)
    ax.set(xlim=(-2.3, 6.3), ylim=(-1.6, 5.6), aspect="equal", title="a box and its copies")
    ax.axis("off")


def search(ax):
    """The search box of a sphere at the edge, and where it asks."""
    ax.add_patch(style.plt.Rectangle((0, 0), L, L, fill=False, linewidth=1.8))
    for k, (x, y) in enumerate(SPHERES):
        circle(ax, x, y, facecolor=style.COLORS[k] if k < 2 else "0.94",
               edgecolor=style.COLORS[k] if k < 2 else "0.3")
    x, y = SPHERES[0]
    circle(ax, x + L, y, facecolor="none", edgecolor=style.COLORS[0], linestyle=(0, (2, 2)))
    for shift, line in (0, "-"), (L, (0, (4, 2))):
        ax.add_patch(style.plt.Rectangle((x - 0.75 + shift, y - 0.75), 1.5, 1.5, fill=False,
                                         edgecolor=style.COLORS[2], linewidth=1.6, linestyle=line))
    ax.annotate("", (x + L - 0.8, y + 1.0), (x + 0.75, y + 1.0),
                arrowprops={"arrowstyle": "-|>", "color": style.COLORS[2], "shrinkA": 0,
                            "shrinkB": 0})
    ax.text(2.0, y + 1.12, "$L_x$", color=style.COLORS[2], ha="center", fontsize=9)
    ax.text(x, y, "i", ha="center", va="center", color="white", fontsize=9)
    ax.text(*SPHERES[1], "j", ha="center", va="center", color="white", fontsize=9)
    ax.set(xlim=(-0.8, 5.3), ylim=(-0.3, 4.5), aspect="equal", title="who is near i?")
    ax.axis("off")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(7.2, 3.0), width_ratios=(1.35, 1))
    copies(axes[0])
    search(axes[1])
    fig.savefig(HERE / "box.png", metadata={"Software": None})

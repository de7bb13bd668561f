"""Draws cells.png: python3 exercises/11-finding-neighbours/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402
from matplotlib.patches import Circle, Rectangle  # noqa: E402


def neighbourhood(ax):
    """A sphere, its cell and the cells around it (a plane)."""
    random = np.random.default_rng(4)
    centres = []
    while len(centres) < 44:
        x = random.uniform(-2.4, 2.4, 2)
        if all(np.linalg.norm(x - y) > 0.62 for y in centres):
            centres.append(x)
    centres = np.array(centres)
    me = int(np.argmin(np.linalg.norm(centres - (0.32, 0.4), axis=1)))
    cell = np.floor(centres).astype(int)
    near = np.abs(cell - cell[me]).max(axis=1) <= 1
    ax.add_patch(Rectangle(cell[me] - 1, 3, 3, color=style.COLORS[4], alpha=0.22, linewidth=0))
    for k in range(-3, 4):
        ax.plot([k, k], [-3, 3], color="0.75", linewidth=0.7, zorder=1)
        ax.plot([-3, 3], [k, k], color="0.75", linewidth=0.7, zorder=1)
    for k, x in enumerate(centres):
        touch = np.linalg.norm(x - centres[me]) < 1
        color = style.COLORS[0] if k == me else style.COLORS[1] if touch else \
            "0.35" if near[k] else "0.8"
        ax.add_patch(Circle(x, 0.5, fill=k == me, facecolor=color, alpha=0.25, linewidth=0))
        ax.add_patch(Circle(x, 0.5, fill=False, edgecolor=color, linewidth=1.6 if touch else 0.8,
                            zorder=3 if touch else 2))
        ax.plot(*x, ".", color=color, markersize=3)
    for k in range(-3, 3):
        ax.text(k + 0.5, -3.3, f"{k}", ha="center", va="center", fontsize=7.5)
        ax.text(-3.3, k + 0.5, f"{k}", ha="center", va="center", fontsize=7.5)
    ax.set(xlim=(-3.5, 3.05), ylim=(-3.6, 3.05), aspect="equal")
    ax.set_title("who can touch the blue one?", loc="left")
    ax.axis("off")


def rounding(ax):
    """The cells that floor and a conversion to int make of a line."""
    for row, (name, function) in enumerate((("int(x)", np.trunc), ("floor(x)", np.floor))):
        for low in np.arange(-3, 3):
            index = int(function(low + 0.5))
            color = style.COLORS[index % 2 * 5]
            ax.add_patch(Rectangle((low, row), 1, 0.5, facecolor=color, alpha=0.35, linewidth=0))
            ax.text(low + 0.5, row + 0.25, f"{index}".replace("-", "−"), ha="center", va="center",
                    fontsize=9)
        ax.text(-3, row + 0.6, name, fontsize=8.5, family="monospace")
    ax.annotate("", (3.2, -0.2), (-3.2, -0.2), arrowprops={"arrowstyle": "-|>", "linewidth": 1})
    for k in range(-3, 4):
        ax.plot([k, k], [-0.26, -0.14], color="0.0", linewidth=0.9)
        ax.text(k, -0.45, f"{k}".replace("-", "−"), ha="center", fontsize=7.5)
    ax.text(3.25, -0.75, "x / size", ha="right", fontsize=7.5)
    ax.set(xlim=(-3.3, 3.3), ylim=(-0.8, 2.1))
    ax.set_title("the cell at 0", loc="left")
    ax.axis("off")


def tests(x, axes):
    """Pairs of points in the unit cells along `axes` and the cells next to them."""
    cells, count = {}, 0
    for p in np.floor(x).astype(int)[:, :axes]:
        around = np.array(np.meshgrid(*[(-1, 0, 1)] * axes)).reshape(axes, -1).T
        count += sum(cells.get(tuple(p + d), 0) for d in around)
        cells[tuple(p)] = cells.get(tuple(p), 0) + 1
    return count


def cost(ax):
    """Tests over the number of spheres, counted."""
    numbers = np.array([250, 500, 1000, 2000, 4000, 8000])
    random = np.random.default_rng(1)
    crowds = [random.uniform(-0.5, 0.5, (n, 3)) * (n / 0.955) ** (1 / 3) for n in numbers]
    ax.loglog(numbers, numbers * (numbers - 1) / 2, **style.cycle(1), label="everybody: $N^2$")
    ax.loglog(numbers, [tests(x, 2) for x in crowds], **style.cycle(2), label="columns: $N^{4/3}$")
    ax.loglog(numbers, [tests(x, 3) for x in crowds], **style.cycle(0), label="cells: $N$")
    ax.set_xticks(numbers[::2], [str(n) for n in numbers[::2]])
    ax.tick_params(axis="x", which="minor", bottom=False)
    style.label(ax, "spheres $N$", "tests", "cost")
    ax.legend(loc="upper left")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 3, figsize=(8.6, 2.7), width_ratios=(1.05, 1, 1.05))
    neighbourhood(axes[0])
    rounding(axes[1])
    cost(axes[2])
    fig.savefig(HERE / "cells.png", metadata={"Software": None})

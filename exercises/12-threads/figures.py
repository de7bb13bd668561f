"""Draws slabs.png: python3 exercises/12-threads/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402

arrow = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "linewidth": 1.3}


def packing(ax):
    """Spheres in three slabs; pairs inside one and across two."""
    random = np.random.default_rng(4)
    where = [(c + 0.5 * (r % 2) + 0.06 * random.standard_normal(), 0.87 * r)
             for c in range(6) for r in range(3)]
    for k, (x, y) in enumerate(where):
        slab = k // 6
        ax.add_patch(style.plt.Circle((x, y), 0.5, facecolor=style.COLORS[slab], alpha=0.25,
                                      edgecolor="0.3"))
        for m, (u, v) in enumerate(where[:k]):
            if np.hypot(x - u, y - v) < 1.12:
                across = m // 6 != slab
                ax.plot([x, u], [y, v], color=style.COLORS[1] if across else "0.3",
                        linewidth=1.8 if across else 0.9)
    for slab in range(3):
        ax.text(2 * slab + 0.75, -0.85, f"slab {slab}", color=style.COLORS[slab], ha="center",
                fontsize=8.5)
    ax.set(xlim=(-0.6, 6.1), ylim=(-1.1, 2.5), aspect="equal", title="pairs: inside, across slabs")
    ax.axis("off")


def phases(ax):
    """Two phases with a fence, for three slabs and two threads."""
    rows = {"thread 0": 1, "thread 1": 0}
    blocks = [("thread 0", 0, 1.9, 0, "slab 0: pairs"), ("thread 1", 0, 1.75, 1, "slab 1: pairs"),
              ("thread 0", 1.95, 1.9, 2, "slab 2: pairs"),
              ("thread 0", 4.1, 1.1, 0, "slab 0"), ("thread 1", 4.1, 1.1, 1, "slab 1"),
              ("thread 0", 5.25, 1.1, 2, "slab 2")]
    for thread, start, length, slab, name in blocks:
        ax.barh(rows[thread], length, left=start, height=0.6, color=style.COLORS[slab], alpha=0.3,
                edgecolor="0.3")
        ax.text(start + length / 2, rows[thread], name, ha="center", va="center", fontsize=7.5)
    for x in 3.95, 6.45:
        ax.plot([x, x], [-0.45, 1.45], color="black", linewidth=1.6)
    ax.text(3.95, 1.55, "fence", ha="center", fontsize=8)
    ax.text(1.9, -0.75, "add own, write down the rest", ha="center", fontsize=8)
    ax.text(5.25, -0.75, "add what was written down", ha="center", fontsize=8)
    ax.set(yticks=list(rows.values()), yticklabels=rows, xticks=[], xlim=(-0.05, 6.6),
           ylim=(-1, 1.9), title="two phases")
    ax.set_xlabel("time")
    ax.grid(False)


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(8.6, 2.4), width_ratios=(1, 1.25))
    packing(axes[0])
    phases(axes[1])
    fig.savefig(HERE / "slabs.png", metadata={"Software": None})

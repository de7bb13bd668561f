"""Draws tests.png: python3 exercises/15-write-the-tests/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402


def matrix(ax):
    """Which test notices which broken solver."""
    tests = ["free fall", "collision", "restitution", "5/7", "gears"]
    solvers = ["right", "Eq. (45)", "R*", "$c_n$", "Eq. (55)", "Eq. (26)", "Eq. (60)"]
    fails = {(0, 1), (1, 2), (1, 1), (2, 3), (3, 4), (4, 5), (3, 5)}
    for t in range(len(tests)):
        for s in range(len(solvers)):
            bad = (t, s) in fails
            ax.add_patch(style.plt.Rectangle((s, -t), 0.9, 0.9, linewidth=0,
                                             facecolor=style.COLORS[1] if bad else "0.9"))
            ax.text(s + 0.45, 0.43 - t, "fails" if bad else "", ha="center", va="center",
                    fontsize=6.5, color="white")
        ax.text(-0.15, 0.43 - t, tests[t], ha="right", va="center", fontsize=8)
    for s, name in enumerate(solvers):
        ax.text(s + 0.45, 1.05, name, ha="center", fontsize=8)
    ax.annotate("no test notices it: a hole", (6.45, -4.1), (3.6, -4.95), fontsize=8,
                arrowprops={"arrowstyle": "-|>", "linewidth": 0.8})
    ax.set(xlim=(-1.9, 7), ylim=(-5.3, 1.7), title="tests and broken solvers")
    ax.axis("off")


def tolerance(ax):
    """Results of right and of broken solvers, and tolerances that tell them apart."""
    random = np.random.default_rng(2)
    ax.axvspan(-0.35, 0.35, color=style.COLORS[2], alpha=0.2, linewidth=0)
    ax.plot(0.1 * random.standard_normal(9), random.uniform(0.45, 0.95, 9), "o",
            color=style.COLORS[0], markersize=4.5, label="right, rounded differently")
    ax.plot([-1.6, 1.05, 2.3], [0.5, 0.6, 0.35], "X", color=style.COLORS[1], markersize=7,
            label="broken")
    for width, name, y in (0.06, "too tight", 1.08), (0.35, "good", 1.3), (2.6, "too wide", 1.52):
        ax.annotate("", (width, y), (-width, y), annotation_clip=False,
                    arrowprops={"arrowstyle": "|-|", "shrinkA": 0, "shrinkB": 0,
                                "mutation_scale": 3})
        ax.text(max(width, 0.1) + 0.12, y, name, va="center", fontsize=8)
    ax.set(xlim=(-3.4, 3.9), ylim=(0, 1.75), yticks=[], xticks=[0], xticklabels=["expected"],
           title="a tolerance")
    ax.legend(loc="lower left", fontsize=7)
    ax.grid(False)


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(8.6, 2.8), width_ratios=(1.35, 1))
    matrix(axes[0])
    tolerance(axes[1])
    fig.savefig(HERE / "tests.png", metadata={"Software": None})

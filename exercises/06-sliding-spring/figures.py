"""Draws spring.png: python3 exercises/06-sliding-spring/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402

arrow = {"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0, "linewidth": 1.4}


def turning(ax):
    """A spring that is laid down into the new tangent plane and keeps its length."""
    a = np.radians(28)
    for angle, color, name in (0, "0.6", "old plane"), (a, "0.0", "plane now"):
        t = np.array([np.cos(angle), np.sin(angle)])
        ax.plot(*np.transpose([-0.45 * t, 1.5 * t]), color=color, linewidth=0.9)
        ax.text(*(1.55 * t), name, color=color, fontsize=7.5, va="center")
    n, t, u = (-np.sin(a), np.cos(a)), np.array([np.cos(a), np.sin(a)]), np.array([1.2, 0])
    flat = (u @ t) * t
    ax.annotate("", np.multiply(0.9, n), (0, 0), arrowprops={**arrow, "color": style.COLORS[2]})
    ax.text(-0.62, 0.75, r"$\hat{n}$", color=style.COLORS[2], fontsize=10)
    ax.annotate("", u, (0, 0), arrowprops={**arrow, "color": style.COLORS[1]})
    ax.text(0.62, -0.2, r"$\vec{u}_s$ before", color=style.COLORS[1], fontsize=8.5, ha="center")
    ax.annotate("", np.linalg.norm(u) * t, (0, 0),
                arrowprops={**arrow, "color": style.COLORS[0]})
    ax.text(0.45, 0.62, r"$\vec{u}_s$ after", color=style.COLORS[0], fontsize=8.5, ha="center",
            rotation=28)
    ax.plot(*np.transpose([u, flat]), color="0.45", linewidth=0.8, linestyle=(0, (3, 2)))
    arc = np.linspace(0, a, 30)
    ax.plot(1.2 * np.cos(arc), 1.2 * np.sin(arc), color="0.45", linewidth=0.7)
    ax.set(xlim=(-0.8, 2.25), ylim=(-0.5, 1.25), aspect="equal", title="Eq. (52)")
    ax.axis("off")


def there_and_back(ax):
    """Force over displacement: to the right, to the left, to the right again."""
    x = np.concatenate([np.linspace(0, 3, 60), np.linspace(3, -1, 80), np.linspace(-1, 2, 60)])
    for k, reset in enumerate((True, False)):
        u, forces, last = 0.0, [], 0.0
        for now in x:
            u, last = u + now - last, now
            f = np.clip(-u, -1, 1)
            u = -f if reset else u
            forces.append(f)
        ax.plot(x, forces, **style.cycle(k, marker=False),
                label="with Eq. (55)" if reset else "spring not shortened")
    ax.set_ylim(-1.3, 2.2)
    style.label(ax, r"displacement / ($\mu_s f_n/k_s$)", r"$f_s$ / ($\mu_s f_n$)", "stick and slip")
    ax.legend(loc="upper right")


def slide_to_roll(ax):
    """Velocity and surface velocity of a sphere that is thrown along a plane."""
    t = np.linspace(0, 2, 100)
    ax.plot(t, np.maximum(1 - 2 / 7 * t, 5 / 7), **style.cycle(0, marker=False), label="$v$")
    ax.plot(t, np.minimum(5 / 7 * t, 5 / 7), **style.cycle(1, marker=False), label=r"$R\,\omega$")
    ax.text(1.95, 0.77, "5/7", ha="right", fontsize=8.5)
    ax.set_ylim(0, 1.1)
    style.label(ax, r"$t\;/\;(2 v_0 / 7 \mu_s g)$", "speed / $v_0$", "slide, then roll")
    ax.legend(loc="lower right")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 3, figsize=(8.6, 2.6), width_ratios=(1.25, 1, 1))
    turning(axes[0])
    there_and_back(axes[1])
    slide_to_roll(axes[2])
    fig.savefig(HERE / "spring.png", metadata={"Software": None})

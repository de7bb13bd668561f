"""Draws sides.png: python3 exercises/09-quaternions/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402


def product(p, q):
    """Eq. (49)."""
    v = p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])
    return np.array([p[0] * q[0] - p[1:] @ q[1:], *v])


def rotation(h):
    """The quaternion (cos |h|, sin |h| h/|h|)."""
    angle = np.linalg.norm(h)
    return np.array([np.cos(angle), *(np.sinc(angle / np.pi) * np.asarray(h))])


def body(q):
    """The three axes of a body, as rows, in the laboratory."""
    back = q * [1, -1, -1, -1]
    return [product(product(q, np.array([0, *e])), back)[1:] for e in np.eye(3)]


def flat(a):
    """A place in space on the paper: x to the lower left, y to the right, z up."""
    return np.array([a[1] - 0.5 * a[0], a[2] - 0.42 * a[0]])


def triad(ax, at, axes, title):
    """A box with its three axes, at a place on the paper."""
    for k in range(3):
        ax.plot(*zip(at, at + 0.9 * flat(np.eye(3)[k])), color="0.8", linewidth=0.8, zorder=0)
    for axis, color, name in zip(axes, style.COLORS, "xyz"):
        end = at + 0.8 * flat(axis)
        ax.annotate("", end, at, arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": 2.2,
                                             "shrinkA": 0, "shrinkB": 0})
        ax.text(*(at + 1.02 * flat(axis)), name, color=color, ha="center", va="center", fontsize=10)
    ax.text(at[0], at[1] - 1.5, title, ha="center", va="center", fontsize=8.5)


def tumble(n, order):
    """Orientation at T = 2 after n steps of a body whose axis moves; order: of the factors."""
    w, alpha, q = np.array([1.0, 0, 0]), np.array([0, 1.2, 0.6]), np.array([1.0, 0, 0, 0])
    dt = 2.0 / n
    for _ in range(n):
        phi, theta = rotation(dt / 2 * w), rotation(dt * dt / 4 * alpha)
        q = order(q, phi, theta)
        w = w + dt * alpha
    return q


def left(q, phi, theta):
    return product(theta, product(phi, q))


def right(q, phi, theta):
    return product(product(q, phi), theta)


def without(q, phi, theta):
    return product(phi, q)


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 2, figsize=(7.4, 2.7), width_ratios=(1.55, 1))
    x, y = rotation([np.pi / 4, 0, 0]), rotation([0, np.pi / 4, 0])
    start = np.array([1.0, 0, 0, 0])
    triad(axes[0], np.array([0.0, 0]), body(start), "at first")
    triad(axes[0], np.array([2.5, 0]), body(product(y, x)), "left: $q_y q_x$")
    triad(axes[0], np.array([5.2, 0]), body(product(x, y)), "right: $q_x q_y$")
    axes[0].set(xlim=(-0.9, 6.5), ylim=(-1.75, 1.35), aspect="equal")
    axes[0].set_title("a quarter turn about x, then one about y", loc="left")
    axes[0].axis("off")
    steps = np.array([5, 10, 20, 40, 80, 160])
    exact = tumble(20000, left)
    for k, (way, name) in enumerate(((right, "on the right"), (without, r"left, no $\theta$"),
                                     (left, r"left: $\theta\,\varphi\,q$"))):
        ends = [tumble(n, way) for n in steps]
        errors = [min(np.linalg.norm(q - exact), np.linalg.norm(q + exact)) for q in ends]
        axes[1].loglog(2 / steps, errors, **style.cycle(2 - k), label=name)
    axes[1].set_ylim(1e-6, 3)
    style.label(axes[1], r"step $\Delta t$", "error of the orientation", "an axis that moves")
    axes[1].legend(loc="lower right")
    fig.savefig(HERE / "sides.png", metadata={"Software": None})

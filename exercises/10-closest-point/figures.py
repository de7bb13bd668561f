"""Draws regions.png: python3 exercises/10-closest-point/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402

FACE, EDGE, CORNER = "#ffffff", style.COLORS[5], style.COLORS[4]


def on_edge(p, a, b):
    e = b - a
    s = np.clip((p - a) @ e / (e @ e), 0, 1)
    return a + s[..., None] * e


def cross(u, v):
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def closest(p, corners):
    """Closest points of a polygon (corners anticlockwise) in the plane, for points p (..., 2)."""
    around = list(zip(corners, np.roll(corners, -1, axis=0)))
    feet = np.array([on_edge(p, a, b) for a, b in around])
    best = np.argmin(np.linalg.norm(p - feet, axis=-1), axis=0)
    q = np.take_along_axis(feet, best[None, ..., None], axis=0)[0]
    within = np.all([cross(b - a, p - a) >= 0 for a, b in around], axis=0)
    return np.where(within[..., None], p, q), within


def regions(ax, corners, names, points, title):
    """Colours of the regions, and the way from some points to their closest points."""
    x, y = np.meshgrid(np.linspace(-1.6, 3.0, 500), np.linspace(-1.25, 2.35, 400))
    p = np.stack([x, y], axis=-1)
    q, within = closest(p, corners)
    corner = np.any([np.linalg.norm(q - c, axis=-1) < 1e-9 for c in corners], axis=0)
    kind = np.where(within, 0, np.where(corner, 2, 1))
    ax.contourf(x, y, kind, levels=[-0.5, 0.5, 1.5, 2.5], colors=[FACE, EDGE, CORNER], alpha=0.35)
    ax.plot(*np.vstack([corners, corners[:1]]).T, color="0.0", linewidth=1.6)
    for c, name, shift in zip(corners, *names):
        ax.text(*(c + shift), name, fontsize=10, ha="center", va="center", style="italic")
    for point in np.array(points):
        foot, _ = closest(point[None], corners)
        ax.plot(*np.vstack([point, foot]).T, color=style.COLORS[1], linewidth=1.1)
        ax.plot(*point, "o", color=style.COLORS[1], markersize=4)
        ax.plot(*foot[0], "o", markerfacecolor="white", color=style.COLORS[1], markersize=4)
    ax.set(xlim=(-1.6, 3.0), ylim=(-1.25, 2.35), aspect="equal")
    ax.set_title(title, loc="left")
    ax.axis("off")


if __name__ == "__main__":
    fig, axes = style.plt.subplots(1, 3, figsize=(8.6, 2.5))
    regions(axes[0], np.array([[0, 0], [1.5, 0.0], [0.4, 1.2]]),
            ("abc", np.array([[-0.16, -0.14], [0.18, -0.14], [0, 0.2]])),
            [(0.6, -0.7), (-0.8, 0.9), (-0.7, -0.6), (0.2, 2.0), (2.4, -0.1), (1.7, 1.3)],
            "triangle: seven regions")
    regions(axes[1], np.array([[0, 0], [1.1, 0.0], [2.2, 0.75]]),
            ("abc", np.array([[-0.14, -0.16], [0.0, -0.2], [0.2, 0.1]])),
            [(0.4, 1.5), (1.9, -0.4)], "obtuse: careful")
    axes[1].plot([-1.6, 3.0], [0, 0], color="0.4", linewidth=0.9, linestyle=(0, (4, 3)))
    regions(axes[2], np.array([[0, 0], [1.5, 0.0], [1.5, 1.0], [0, 1.0]]),
            ("abcd", np.array([[-0.16, -0.14], [0.18, -0.14], [0.18, 0.16], [-0.16, 0.16]])),
            [(0.7, -0.7), (-0.8, 1.7), (2.4, 0.6), (2.2, -0.7)], "rectangle: nine")
    fig.savefig(HERE / "regions.png", metadata={"Software": None})

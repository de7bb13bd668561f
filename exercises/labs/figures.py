"""Draws the pictures of the lab sheets: python3 exercises/labs/figures.py"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "verification"))
import numpy as np  # noqa: E402
import style  # noqa: E402
from matplotlib.patches import Arc, Circle, Polygon, Rectangle  # noqa: E402

BLUE, RED, GREEN = style.COLORS[:3]
GRAIN = {"facecolor": "#f5b229", "edgecolor": "0.35", "linewidth": 0.5}
WALL = {"color": "0.25", "linewidth": 2.2, "solid_capstyle": "round"}


def arrow(ax, start, end, text="", at=(0, 0), color="0.0", both=False):
    """An arrow with a label at an absolute place."""
    ax.annotate("", end, start, arrowprops={
        "arrowstyle": "<|-|>" if both else "-|>", "color": color, "shrinkA": 0, "shrinkB": 0,
        "linewidth": 1.2})
    if text:
        ax.text(*at, text, color=color, ha="center", va="center", fontsize=9)


def bare(ax, x, y, title):
    """A panel without axes."""
    ax.set(xlim=x, ylim=y, aspect="equal")
    ax.axis("off")
    ax.set_title(title, loc="left")


def save(fig, name):
    fig.savefig(HERE / name, metadata={"Software": None})
    style.plt.close(fig)


def block(ax):
    """A block on a slope and its forces."""
    t = np.radians(24)
    along, up = np.array([np.cos(t), np.sin(t)]), np.array([-np.sin(t), np.cos(t)])
    foot = np.array([0.0, 0.0])
    ax.add_patch(Polygon([foot, 6 * along, [6 * along[0], 0]], facecolor="0.9", edgecolor="0.25"))
    low = foot + 2.9 * along
    ax.add_patch(Polygon([low, low + 1.5 * along, low + 1.5 * along + up, low + up],
                         facecolor="#f5b229", edgecolor="0.35"))
    middle = low + 0.75 * along + 0.5 * up
    arrow(ax, middle, middle + [0, -2.2], r"$m\,\mathbf{g}$", middle + [0.5, -2.0])
    arrow(ax, low + 0.75 * along, low + 0.75 * along + 2.2 * up, "normal force",
          low + 0.75 * along + 2.55 * up + [-0.3, 0], BLUE)
    arrow(ax, low + 1.5 * along, low + 3.0 * along, r"friction $\leq \mu_s \times$ normal force",
          low + 3.0 * along + [0.1, 0.75], RED)
    ax.add_patch(Arc(foot, 3.2, 3.2, theta1=0, theta2=24, edgecolor="0.0"))
    ax.text(1.95, 0.35, r"$\theta$", fontsize=11)
    bare(ax, (-0.5, 8.3), (-0.7, 5.6), "a block begins to slide at tan θ = μ$_s$")


def heap(ax):
    """A heap from the side with its angle."""
    foot, top = 10.6, 5.0
    for row in range(9):
        for x in np.arange(-11, 11.1, 1.0):
            place = np.array([x + 0.5 * (row % 2), 0.5 + 0.87 * row])
            if abs(place[0]) / foot + (place[1] + 0.55) / top < 1:
                ax.add_patch(Circle(place, 0.48, **GRAIN))
    for x, z in ((0.1, 5.6), (-0.2, 6.9), (0.0, 8.4)):
        ax.add_patch(Circle((x, z), 0.48, **GRAIN))
    ax.plot([-12, 12], [0, 0], **WALL)
    x = np.array([1.3, foot])
    ax.plot(x, top * (1 - x / foot), color=RED, linewidth=1.6)
    ax.add_patch(Arc((foot, 0), 6, 6, theta1=154.7, theta2=180, edgecolor="0.0"))
    ax.text(6.6, 0.35, r"$\theta$", fontsize=11, bbox={"facecolor": "w", "edgecolor": "none",
                                                       "alpha": 0.8, "pad": 0.6})
    ax.text(6.0, 3.4, "fitted flank", color=RED, fontsize=8.5)
    bare(ax, (-12, 12), (-1, 9.2), "a heap: which slope is the last that stands?")


def silo(ax):
    """The bottom of a silo."""
    random = np.random.default_rng(5)
    for x in (-1, 1):
        ax.plot([x * 9, x * 9, x * 3.2], [9, 0, 0], **WALL)
    places = []
    for _ in range(20000):
        p = np.array([random.uniform(-8.4, 8.4), random.uniform(0.55, 8.6)])
        if all(np.hypot(*(p - q)) > 0.93 for q in places):
            places.append(p)
    for p in places + [np.array(q) for q in ((-1.9, -0.7), (-0.4, -1.4), (1.3, -0.6), (0.6, -2.6),
                                             (-1.2, -3.0))]:
        ax.add_patch(Circle(p, 0.47, **GRAIN))
    arrow(ax, (-3.2, -4.1), (3.2, -4.1), "D", (0, -4.75), BLUE, True)
    for x in (-3.2, 3.2):
        ax.plot([x, x], [-0.2, -4.5], color=BLUE, linewidth=0.7, linestyle=(0, (3, 2)))
    ax.add_patch(Arc((0, 0), 6.4, 6.4, theta1=0, theta2=180, edgecolor=RED, linewidth=1.8))
    ax.text(3.4, -1.5, "below the red line\ngrains fall freely", color=RED, fontsize=8, va="center")
    bare(ax, (-9.5, 10.5), (-5.3, 9.2), "the last diameters decide")


def power(ax):
    """Two powers with logarithmic axes, and how an exponent is read off."""
    x = np.array([1.0, 10.0])
    for p, color, name in ((1.0, style.COLORS[6], "1"), (2.0, BLUE, "2")):
        ax.loglog(x, x ** p, color=color, label=f"$y = x^{name}$")
    ax.plot([2, 6, 6], [4, 4, 36], color=RED, linewidth=1.1)
    ax.text(3.6, 4.6, r"$\ln(x_2/x_1)$", color=RED, fontsize=8, ha="center")
    ax.text(6.3, 11, r"$\ln(y_2/y_1)$", color=RED, fontsize=8)
    ax.set(xlim=(1, 12), ylim=(1, 130))
    ax.legend(loc="upper left")
    style.label(ax, "x, for example D - d", "y, for example a rate",
                "the exponent is the quotient")


def arch(ax):
    """An arch of discs over a throat."""
    places = [np.array([3.02, 0.34])]
    for t in np.radians(np.arange(5, 181, 0.1)):  # touching discs on an ellipse
        p = np.array([3.05 * np.cos(t), 2.45 * np.sin(t)])
        if np.hypot(*(p - places[-1])) >= 1 and p[1] >= 0.2:
            places.append(p)
    places.reverse()
    random, above = np.random.default_rng(4), []
    for _ in range(4000):
        p = np.array([random.uniform(-5, 5), random.uniform(0.5, 4.2)])
        if (p[0] / 3.05) ** 2 + (p[1] / 2.45) ** 2 > 1 and p[1] > 1.23 * abs(p[0]) - 3.4 and all(
                np.hypot(*(p - q)) > 1 for q in places + above):
            above.append(p)
    for p in above:
        ax.add_patch(Circle(p, 0.5, facecolor="0.86", edgecolor="0.5", linewidth=0.5))
    for p in places:
        ax.add_patch(Circle(p, 0.5, facecolor=RED, alpha=0.85, edgecolor="0.3", linewidth=0.5))
        ax.plot(*p, "o", color="w", markersize=2.2)
    for side in (-1, 1):
        ax.plot([side * 3.0, side * 5.4], [-0.6, 2.36], **WALL)
    left, right, top = places[0][0], places[-1][0], max(p[1] for p in places)
    low = min(p[1] for p in places)
    ax.add_patch(Rectangle((left, low), right - left, top - low, fill=False, linewidth=0.9,
                           edgecolor=BLUE, linestyle=(0, (4, 2))))
    arrow(ax, (left, -1.0), (right, -1.0), "span", (0, -1.4), BLUE, True)
    arrow(ax, (0.2, low), (0.2, top), "height", (0.95, 1.2), BLUE, True)
    for x in (left, right):
        ax.plot([x, x], [low, -1.1], color=BLUE, linewidth=0.7, linestyle=(0, (3, 2)))
    bare(ax, (-5.4, 5.4), (-1.8, 4.8), "an arch, seen from below (red)")


def chance(ax):
    """The error of a share against the number of trials."""
    n = np.arange(2, 101)
    for p, k in ((0.5, 0), (0.2, 1)):
        ax.loglog(n, np.sqrt(p * (1 - p) / n), **style.cycle(k, marker=False),
                  label=f"share {p:g}")
    ax.set(xlim=(2, 100), ylim=(0.02, 0.5), xticks=[2, 4, 8, 16, 32, 64],
           yticks=[0.02, 0.05, 0.1, 0.2, 0.4])
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_formatter(style.plt.ScalarFormatter())
        axis.set_minor_formatter(style.plt.NullFormatter())
    ax.legend()
    style.label(ax, "independent throats", "error of the share", "four times as many: half of it")


def nuts(ax):
    """Large balls below small beads."""
    random = np.random.default_rng(3)
    balls = [np.array([x, 4.0]) for x in (-10.5, 0, 10.5)]
    places = []
    for _ in range(20000):
        p = np.array([random.uniform(-15, 15), random.uniform(1, 21)])
        if all(np.hypot(*(p - b)) > 5 for b in balls) and all(
                np.hypot(*(p - q)) > 1.98 for q in places):
            places.append(p)
    for b in balls:
        ax.add_patch(Circle(b, 4, facecolor=BLUE, edgecolor="0.2", alpha=0.85))
    for p in places:
        ax.add_patch(Circle(p, 1, **GRAIN))
    for x in (-16.2, 16.2):
        ax.plot([x, x], [-3, 26], **WALL)
    ax.plot([-16, 16], [0, 0], color=RED, linewidth=3)
    arrow(ax, (19, 0), (19, 4), "A", (21, 2), RED)
    ax.plot([16.5, 32], [15.75, 15.75], color="0.2", linewidth=0.9, linestyle=(0, (3, 2)))
    ax.text(17.2, 17.0, "3/4 of the bed:\na ball is up when its\ntop is above", fontsize=7.5,
            va="bottom")
    bare(ax, (-18, 36), (-5, 28), "large balls on a base that vibrates")


def base(ax):
    """Height of the base over two cycles, and the flight that it starts."""
    t = np.linspace(0, 2, 400)
    for k, A in enumerate((4, 5, 6.25)):
        ax.plot(t, A * np.sin(2 * np.pi * t), **style.cycle(k, marker=False), label=f"A = {A:g} mm")
    w, g = 2 * np.pi * 13.651, 9810.0  # 1/s, mm/s^2
    start = np.arcsin(g / (5 * w ** 2)) / w
    z, v = 5 * np.sin(w * start), 5 * w * np.cos(w * start)
    s = np.linspace(0, 0.085, 200)
    flight = z + v * s - g / 2 * s ** 2
    up = flight >= 5 * np.sin(w * (start + s)) - 1e-9
    end = np.argmin(up) if not up.all() else len(s)
    ax.plot((start + s[:end]) * 13.651, flight[:end], color="0.0", linewidth=1.0,
            label="a bead thrown at 5 mm")
    ax.set(xlim=(0, 2), ylim=(-8, 17))
    ax.legend(loc="upper right")
    style.label(ax, "cycles", "height / mm", "a bead alone flies about a cycle")


def pair(name, left, right, ratios=(1, 1)):
    fig, axes = style.plt.subplots(1, 2, figsize=(7.4, 2.8), width_ratios=ratios)
    left(axes[0])
    right(axes[1])
    save(fig, name)


if __name__ == "__main__":
    pair("repose/heap.png", block, heap, (1, 1.25))
    pair("discharge/silo.png", silo, power)
    pair("arches/arch.png", arch, chance, (1.2, 1))
    pair("brazil_nut/nuts.png", nuts, base, (1.2, 1))

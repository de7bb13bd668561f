"""The look of every figure: sizes, fonts, and lines that differ in grey as well as in colour.

    fig, ax = style.figure(1, 2)                      # rows, columns
    ax[0].plot(x, y, **style.LINE["consistent"])
    style.label(ax[0], "impact angle / deg", "rebound angle / deg")
    style.save(fig, out, "08_oblique")                # .svg and .png
"""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)
import numpy as np  # noqa: E402

PANEL = (3.35, 2.65)  # inches, one panel
plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 8.5, "mathtext.fontset": "dejavusans",
    "axes.titlesize": 9, "axes.labelsize": 8.5, "legend.fontsize": 7.5, "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5, "lines.linewidth": 1.4, "lines.markersize": 4.2,
    "axes.linewidth": 0.7, "axes.grid": True, "grid.color": "0.88", "grid.linewidth": 0.5,
    "axes.axisbelow": True, "legend.frameon": True, "legend.framealpha": 0.9,
    "legend.edgecolor": "0.8", "legend.fancybox": False, "legend.handlelength": 2.6,
    "svg.fonttype": "path", "svg.hashsalt": "tinydem", "savefig.dpi": 170,
    "figure.constrained_layout.use": True,
})

# Colours of different lightness (dark to light), each with its own dash and marker.
COLORS = ["#00429d", "#d1495b", "#3d8f5f", "#8a5fb0", "#e39a1f", "#4fb3d9", "#7a7a7a"]
DASHES = ["-", (0, (5, 2)), (0, (1.2, 1.4)), (0, (6, 1.5, 1.2, 1.5)), (0, (8, 2)),
          (0, (3, 1, 1, 1, 1, 1)), "-"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]


def cycle(k, marker=True, **more):
    """Line k of a family."""
    k %= len(COLORS)
    line = {"color": COLORS[k], "linestyle": DASHES[k]}
    if marker:
        line.update(marker=MARKERS[k], markerfacecolor="white", markeredgewidth=1.0)
    return {**line, **more}


#: The same thing looks the same in every figure. Add `label=...`, or override anything:
#: `**{**style.LINE["paper"], "linestyle": "none"}`.
LINE = {
    "reference": {"color": "0.0", "linestyle": "-", "linewidth": 1.0, "zorder": 1.5},
    "alternative": {"color": "0.45", "linestyle": (0, (2, 1.5)), "linewidth": 1.2, "zorder": 1.4},
    "published": {"color": "0.0", "linestyle": "none", "marker": "x", "markersize": 5.5},
    "consistent": cycle(0), "paper": cycle(1), "velocity Verlet": cycle(2), "RK4": cycle(3),
    "explicit Euler": cycle(4), "semi-implicit Euler": cycle(0),
    "float": cycle(5), "double": cycle(0), "long double": cycle(6),
}


def figure(rows=1, columns=1, width=PANEL[0], height=PANEL[1]):
    """A figure of panels; axes as from plt.subplots (a single one for 1 x 1)."""
    return plt.subplots(rows, columns, figsize=(columns * width, rows * height))


def label(ax, x, y, title=None):
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if title:
        ax.set_title(title, loc="left")


def save(fig, out, name):
    """out/name.svg and .png, the same bytes for the same data."""
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    fig.savefig(out / f"{name}.svg", metadata={"Date": None})
    fig.savefig(out / f"{name}.png", metadata={"Software": None})
    plt.close(fig)


def read(path):
    """A CSV file as {column: array}; columns of words are arrays of words."""
    lines = Path(path).read_text().splitlines()
    columns = {}
    for name, values in zip(lines[0].split(","), zip(*(line.split(",") for line in lines[1:]))):
        try:
            columns[name] = np.array([float(v) for v in values])
        except ValueError:
            columns[name] = np.array(values)
    return columns


def where(table, **conditions):
    """The rows of a table in which columns have these values: where(t, method="paper")."""
    keep = np.ones(len(next(iter(table.values()))), bool)
    for column, value in conditions.items():
        keep &= table[column] == value
    return {name: values[keep] for name, values in table.items()}


def ideal(ax, order, x, y, factor=8.0):
    """A grey line of slope -order (error over evaluations) from (x, y), with its order below."""
    ax.plot([x, x * factor], [y, y * factor ** -order], color="0.45", linewidth=0.9, zorder=1)
    ax.annotate(f"order {order:g}", (x * factor, y * factor ** -order), xytext=(0, -2),
                textcoords="offset points", fontsize=7, color="0.35", ha="center", va="top")


def work_precision(ax, path, orders=(1,), title="work and precision"):
    """Draws a case's work.csv: error over evaluations of the force, one line per method."""
    work = read(path)
    for method in dict.fromkeys(work["method"]):
        rows = where(work, method=method)
        sort = np.argsort(rows["force_evaluations"])
        ax.loglog(rows["force_evaluations"][sort], rows["error"][sort],
                  **LINE.get(method, cycle(5)), label=method)
    x, y = work["force_evaluations"], work["error"]
    good = np.isfinite(y) & (y > 0)
    for k, order in enumerate(orders):  # below and left of all points
        start = x[good].min() * 1.5
        below = np.min(y[good] * (x[good] / start) ** order)
        ideal(ax, order, start, below / 2.5 ** (1 + k))
    label(ax, "force evaluations", "error", title)
    ax.legend()

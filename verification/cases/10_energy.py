"""Figures of case 10: maps of the energy after an impact, and the worst case over the step."""
import numpy as np
from matplotlib.colors import BoundaryNorm, ListedColormap

import style

LEVELS = [0, 0.6, 0.8, 0.95, 1.0001, 1.01, 1.1, 1.5, 4]
COLORS = ["#ffffff", "#eef3f8", "#dce7f1", "#c9d9e8", "#f2b8a0", "#e0765c", "#b5383a", "#5c0f1f"]


def draw(data, out):
    table = style.where(style.read(data / "map.csv"), mu_r=0)
    fig, axes = style.figure(2, 3, width=2.75, height=2.4)
    for row, scheme in enumerate(["consistent", "paper"]):
        for column, divisor in enumerate([1, 2, 10]):
            mesh = draw_map(axes[row][column],
                            style.where(table, scheme=scheme, divisor=divisor))
            step = r"$\Delta t_0$" + (f"/{divisor}" if divisor > 1 else "")
            style.label(axes[row][column], "impact angle (deg)", r"$\mu_s$ (–)",
                        f"{scheme}, {step}")
    bar = fig.colorbar(mesh, ax=axes, shrink=0.9, ticks=LEVELS)
    bar.set_label("energy after / before (worst $e_n$ and phase)")
    bar.ax.set_yticklabels([f"{level:g}" if level != 1.0001 else "1" for level in LEVELS])
    style.save(fig, out, "10_energy")
    draw_worst(style.read(data / "map.csv"), out)


def draw_map(ax, part):
    angles, mus = np.unique(part["angle_deg"]), np.unique(part["mu"])
    worst = np.zeros((len(mus), len(angles)))
    for angle, mu, ratio in zip(part["angle_deg"], part["mu"], part["energy_ratio"]):
        i, j = np.searchsorted(mus, mu), np.searchsorted(angles, angle)
        worst[i, j] = max(worst[i, j], ratio)
    half = (angles[1] - angles[0]) / 2
    edges = np.append(angles - half, angles[-1] + half)
    colors = ListedColormap(COLORS)
    mesh = ax.pcolormesh(edges, np.arange(len(mus) + 1), worst, cmap=colors,
                         norm=BoundaryNorm(LEVELS, len(COLORS)), rasterized=True)
    ax.set_yticks(np.arange(len(mus)) + 0.5, [f"{mu:g}" for mu in mus])
    ax.set_xlim(0, 90)
    ax.grid(False)
    return mesh


def worst(table, column, **conditions):
    part = style.where(table, **conditions)
    values = np.unique(part[column])
    return values, np.array([part["energy_ratio"][part[column] == v].max() for v in values])


def draw_worst(table, out):
    fig, axes = style.figure(1, 2)
    for scheme in ["paper", "consistent"]:
        for mu_r, line in [(0, {}), (0.3, {"linestyle": ":", "markerfacecolor": "0.7"})]:
            x, y = worst(table, "divisor", scheme=scheme, mu_r=mu_r)
            axes[0].plot(x, y, **{**style.LINE[scheme], **line},
                         label=f"{scheme}, $\\mu_r$ = {mu_r:g}")
        for divisor, line in [(1, {}), (100, {"linestyle": ":", "markerfacecolor": "0.7"})]:
            x, y = worst(table, "e_n", scheme=scheme, mu_r=0, divisor=divisor)
            step = r"$\Delta t_0$" + (f"/{divisor}" if divisor > 1 else "")
            axes[1].plot(x, y, **{**style.LINE[scheme], **line}, label=f"{scheme}, {step}")
    axes[0].set_xscale("log")
    for ax in axes:
        ax.axhline(1, color="0.2", linewidth=0.8, linestyle=":")
        ax.set_yscale("log")
        ax.set_yticks([1, 1.2, 1.5, 2, 3], ["1", "1.2", "1.5", "2", "3"])
        ax.set_yticks([], minor=True)
        ax.set_ylim(0.9, 4.2)
    style.label(axes[0], r"$\Delta t_0/\Delta t$", "largest energy after / before")
    style.label(axes[1], "$e_n$", "largest energy after / before", "$\\mu_r$ = 0")
    axes[0].legend(loc="upper right")
    axes[1].legend(loc="upper left", ncol=2, columnspacing=0.8, handlelength=2.2)
    axes[1].set_ylim(0.9, 6)
    style.save(fig, out, "10_energy_step")

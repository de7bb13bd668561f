"""The largest stable step, restitution over the step, and every other case against its tolerance."""
import tomllib
from pathlib import Path

import numpy as np
import style


def draw(data, out):
    fig, ax = style.figure(1, 3, height=3.4)
    draw_limit(ax[0], style.read(data / "steps.csv"))
    draw_rebound(ax[1], style.read(data / "head_on.csv"))
    draw_table(ax[2], style.read(data / "metrics.csv"))
    style.save(fig, out, "26_hard_cases")


def draw_limit(ax, rows):
    for k, mu in enumerate(np.unique(rows["mu"])):
        one = style.where(rows, mu=mu)
        ax.plot(one["en"], one["formula"], color=style.COLORS[k], linestyle=style.DASHES[k],
                linewidth=1)
        ax.plot(one["en"], one["limit"], label=rf"$\mu$ = {mu:g}",
                **style.cycle(k, linestyle="none"))
    ax.axhline(1, color="0", linewidth=0.8)
    ax.set_ylim(0, 7.4)
    style.label(ax, "coefficient of restitution $e_n$", "largest stable step / step of Eq. (50)",
                "27 spheres fall into a box; lines: fit")
    ax.legend(loc="upper left", ncols=3, fontsize=6.5)


def draw_rebound(ax, rows):
    for k, en in enumerate(np.unique(rows["en"])):
        one = style.where(rows, en=en)
        ax.fill_between(one["dt_over_eq50"], one["smallest"], one["largest"], alpha=0.3,
                        color=style.COLORS[k], linewidth=0)
        ax.axhline(en, color=style.COLORS[k], linewidth=0.8, linestyle=style.DASHES[k])
        ax.annotate(f"{en:g}", (1, en), xytext=(-3, 1), textcoords="offset points", fontsize=6.5,
                    ha="right", va="center")
    ax.set_ylim(-0.1, 1.6)
    ax.set_xlim(0.5, 6)
    style.label(ax, "step / step of Eq. (50)", "rebound / impact",
                "head-on at 1 m/s, all phases of a step")


def draw_table(ax, metrics):
    table = tomllib.loads(Path(__file__).with_suffix(".toml").read_text())["case"][0]["metric"]
    value = dict(zip(metrics["name"], metrics["value"]))
    shown = [m for m in table if m.get("kind", "below") == "below" and m["tolerance"] < 0.5][::-1]
    for k, m in enumerate(shown):
        size = max(value[m["name"]], 1e-17)
        ax.plot([1e-17, size], [k, k], color="0.75", linewidth=1.2)
        ax.plot(size, k, **style.cycle(0, linestyle="none"))
        ax.plot(max(m["tolerance"], 1e-17), k, color=style.COLORS[1], marker="|", markersize=8)
    ax.set_xscale("log")
    ax.set_xlim(0.6e-17, 1)
    ax.set_yticks(range(len(shown)), [m["name"] for m in shown], fontsize=6)
    style.label(ax, "error (zero at the left edge)", "", "measured; bar: tolerance")

"""Tangential restitution of the dashpot in three readings, its distance from e_n, and c_s/c_n."""
import numpy as np

import style

READING = {1.0: "translation, f = 1", 2.5: "rotation, f = 5/2", 3.5: "free, f = 7/2"}


def draw(data, out):
    fig, ax = style.figure(1, 3, width=2.75)
    table, ratio = style.read(data / "matching.csv"), style.read(data / "ratio.csv")
    ax[0].plot([0, 1], [0, 1], **style.LINE["alternative"], label=r"claim $e_s = e_n$")
    for k, (f, name) in enumerate(READING.items()):
        rows = style.where(table, nu=0.3, reading=f)
        ax[0].plot(rows["e_n"], rows["e_s_exact"], color="0", linewidth=0.9)
        ax[0].plot(rows["e_n"], rows["e_s"], **{**style.cycle(k), "linestyle": "none"}, label=name)
    ax[0].set_ylim(0, 1.55)
    style.label(ax[0], r"parameter $e_n$", r"$e_s$ of the dashpot",
                r"$\nu$ = 0.3; lines: $e_n^{\,p}$")
    ax[0].legend(loc="upper left")
    for k, nu in enumerate(sorted(set(table["nu"]))):
        rows = style.where(table, nu=nu, reading=2.5)
        ax[1].plot(rows["e_n"], rows["e_s"] - rows["e_n"], markevery=2, **style.cycle(k),
                   label=rf"$\nu$ = {nu:.3g}")
    style.label(ax[1], r"parameter $e_n$", r"$e_s - e_n$", "rotation only, f = 5/2")
    ax[1].set_ylim(-0.08, 0.11)
    ax[1].legend(loc="upper center", ncol=2)
    ax[2].axhspan(0.18, 0.26, color="0.9", label="range in the paper")
    ax[2].plot(ratio["nu"], ratio["cs_cn_exact"], **style.LINE["reference"], label="Eq. (25)")
    ax[2].plot(ratio["nu"], ratio["cs_cn"], **{**style.LINE["consistent"], "linestyle": "none"},
               markevery=10, label="solver")
    ax[2].set_ylim(0.12, 0.27)
    ax[2].set_xticks(np.arange(-1, 0.6, 0.5))
    style.label(ax[2], r"Poisson's ratio $\nu$", r"$c_s / c_n$", "two equal particles")
    ax[2].legend(loc="lower left")
    style.save(fig, out, "06_tangential_dashpot")

"""Ways down, where the sphere leaves over the step, work against precision."""
import numpy as np
import style


def draw(data, out):
    tracks, published = style.read(data / "tracks.csv"), style.read(data / "published.csv")
    fig, ax = style.figure(1, 3, height=2.8)
    for k, ratio in enumerate(np.unique(tracks["ratio"])):
        one = style.where(tracks, ratio=ratio, scheme="consistent")
        ax[0].semilogy(1e3 * one["t_s"], one["theta_exact_deg"], color=style.COLORS[k],
                       linewidth=1, linestyle=style.DASHES[k])
        ax[0].semilogy(1e3 * one["t_s"], one["theta_deg"], linestyle="none", markersize=3.5,
                       marker=style.MARKERS[k], color=style.COLORS[k], markerfacecolor="white",
                       label=f"R/r = {ratio:g}")
    style.label(ax[0], "time / ms", "angle from the top / deg",
                r"$\mu_s$ = 0.15; lines: rigid, GSL")
    ax[0].legend(loc="upper left")
    for k, ratio in enumerate(np.unique(published["ratio"])):
        one = style.where(published, ratio=ratio, scheme="consistent")
        printed = style.where(published, ratio=ratio, scheme="paper")
        ax[1].semilogx(one["dt_over_eq50"], one["leaves_deg"], **style.cycle(k),
                       label=f"R/r = {ratio:g}")
        ax[1].semilogx(printed["dt_over_eq50"], printed["leaves_deg"], linestyle="none", marker="x",
                       color="0.2", markersize=4, zorder=4, label="paper" if k == 3 else None)
        ax[1].axhline(one["leaves_rigid_deg"][0], color=style.COLORS[k], linewidth=0.7,
                      linestyle=":")
    ax[1].set_ylim(40, 190)
    ax[1].set_yticks([60, 90, 120, 150, 180])
    style.label(ax[1], "time step / step of Eq. (50)", "leaves at / deg (180: circles)",
                r"$\mu_s$ = 0.5; dotted: rigid")
    ax[1].legend(loc="center left", fontsize=6.5, bbox_to_anchor=(0, 0.66))
    style.work_precision(ax[2], data / "work.csv", title="angle on the way, R/r = 5 (rad)")
    ax[2].set_ylim(1e-5, 3e-2)
    style.save(fig, out, "21_size_ratio")

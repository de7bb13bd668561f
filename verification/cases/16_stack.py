"""Overlaps of towers, two spheres in a press, work against precision."""
import numpy as np
import style


def draw(data, out):
    rows, press = style.read(data / "overlaps.csv"), style.read(data / "press.csv")
    curve = style.read(data / "press_exact.csv")
    fig, ax = style.figure(1, 3)
    for k, n in enumerate(np.unique(rows["spheres"])[:0:-1]):
        one = style.where(rows, spheres=n)
        ax[0].loglog(one["contact"] + 1, 1e6 * one["overlap_exact_m"], color="0", linewidth=0.7)
        ax[0].loglog(one["contact"] + 1, 1e6 * one["overlap_m"], linestyle="none", markersize=3,
                     marker=style.MARKERS[k], color=style.COLORS[k], label=f"{n:g}",
                     markerfacecolor="white")
    style.label(ax[0], "contact, 1 at the plate", "overlap / µm",
                "towers of spheres; lines: closed form")
    ax[0].set_xlim(0.8, 900)
    ax[0].legend(title="spheres", loc="upper right", fontsize=6.5, title_fontsize=6.5)
    for k, en in enumerate((1, 0.5)):
        exact, one = style.where(curve, en=en), style.where(press, en=en)
        ax[1].plot(1e3 * exact["t_s"], 1e6 * exact["lower_m"], color=style.COLORS[k],
                   linewidth=0.9, linestyle=style.DASHES[k], label=f"$e_n$ = {en:g}, GSL")
        t = 1e3 * one["t_s"]
        ax[1].plot(t, 1e6 * one["lower_m"], linestyle="none", color=style.COLORS[k],
                   marker=style.MARKERS[k], markersize=3, markerfacecolor="white",
                   label=f"$e_n$ = {en:g}, solver")
    style.label(ax[1], "time / ms", "height of the lower sphere / µm",
                "in a press, 0.74 steps of Eq. (50)")
    ax[1].set_xlim(0, 6)
    low, high = ax[1].get_ylim()
    ax[1].set_ylim(low, high + 0.35 * (high - low))
    ax[1].legend(ncols=2, fontsize=6.5, loc="upper center")
    style.work_precision(ax[2], data / "work.csv", title="press, $e_n$ = 0.5")
    style.save(fig, out, "16_stack")

"""Heights over time, and work against precision of four methods."""
import style


def draw(data, out):
    track, exact = style.read(data / "track.csv"), style.read(data / "bounces.csv")
    fig, ax = style.figure(1, 3)
    panels = ((ax[0], 2, "twice the step of Eq. (50)"), (ax[1], 1, "step of Eq. (50)"))
    for a, step, title in panels:
        for k, en in enumerate((1, 0.9, 0.7, 0.5)):
            one = style.where(track, en=en, dt_over_eq50=step)
            tops = style.where(exact, en=en)
            a.plot(one["t_s"], one["height_m"], linewidth=1, color=style.COLORS[k],
                   linestyle=style.DASHES[k], label=f"$e_n$ = {en:g}")
            a.plot(tops["t_apex_s"], tops["apex_m"], linestyle="none", marker=style.MARKERS[k],
                   color=style.COLORS[k], markerfacecolor="white", zorder=3)
        a.set_xlim(0, 2.2)
        a.set_ylim(0.05, 0.68)
        style.label(a, "time / s", "height of the centre / m", f"{title}; marks: GSL")
        a.legend(ncols=4, loc="upper center", fontsize=6, handlelength=2, columnspacing=0.8)
    style.work_precision(ax[2], data / "work.csv", title="apex heights, $e_n$ = 0.7")
    style.save(fig, out, "17_bounce")

"""Deflection under load, what is left of a kick, the printed twist, and work against precision."""
import numpy as np
import style


def draw(data, out):
    load, kicks = style.read(data / "deflection.csv"), style.read(data / "kicks.csv")
    track = style.read(data / "track.csv")
    fig, ax = style.figure(2, 2)
    a = ax[0][0]
    a.plot(load["angle_deg"], 1e6 * load["shift_exact_m"], label="closed form",
           **style.LINE["reference"])
    a.plot(load["angle_deg"], 1e6 * load["shift_m"], label="centre",
           **style.cycle(0, linestyle="none"))
    a.plot(load["angle_deg"], 1e6 * load["spring_s_m"], label="sliding spring",
           **style.cycle(2, linestyle="none"))
    a.plot(load["angle_deg"], 1e6 * load["spring_r_m"], label="rolling spring",
           **style.cycle(4, linestyle="none"))
    style.label(a, "angle of the plate / deg", "displacement / µm", "at rest under load")
    a.legend()
    a = ax[0][1]
    for scheme in ("paper", "consistent"):
        one = style.where(track, scheme=scheme)
        keep = one["t_s"] < 0.06
        a.plot(1e3 * one["t_s"][keep], 1e3 * one["turn_rad"][keep], label=scheme,
               **{**style.LINE[scheme], "marker": None, "linewidth": 0.9})
    style.label(a, "time / ms", "twist angle / mrad", "after a kick, step of Eq. (50)")
    a.legend()
    a = ax[1][0]
    for k, mode in enumerate(("slide and roll", "roll", "twist")):
        for scheme in ("consistent", "paper"):
            one = style.where(kicks, scheme=scheme, mode=mode)
            line = style.cycle(k, linestyle="-" if scheme == "consistent" else ":")
            a.loglog(one["dt_over_eq50"], np.maximum(one["speed_left_m_s"], 1e-17), **line,
                     label=f"{mode}, {scheme}")
    a.axhline(1e-4, color="0.45", linewidth=0.9)
    a.text(0.03, 1.8e-4, "kick", color="0.35", fontsize=7, transform=a.get_yaxis_transform())
    style.label(a, "time step / step of Eq. (50)", "speed left after 1 s / (m/s)",
                "a kick in each mode")
    a.legend(fontsize=6.5, loc="upper left", bbox_to_anchor=(0, 0.83))
    style.work_precision(ax[1][1], data / "work.csv", title="a plate tilted at once, 16 moments")
    style.save(fig, out, "15_rest")

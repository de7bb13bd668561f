"""Accelerations over the angle, thresholds, and the error over the time step."""
import numpy as np
import style


def draw(data, out):
    rows, steps = style.read(data / "accelerations.csv"), style.read(data / "work.csv")
    fig, ax = style.figure(1, 3)
    for k, mur in enumerate(np.unique(rows["mu_r"])):
        one = style.where(rows, mu_r=mur, scheme="consistent")
        ax[0].plot(one["angle_deg"], one["a_exact_m_s2"], color=style.COLORS[k], linewidth=1)
        ax[0].plot(one["angle_deg"], one["a_m_s2"], linestyle="none", marker=style.MARKERS[k],
                   color=style.COLORS[k], markerfacecolor="white",
                   label=rf"$\mu_r$ = {mur:g}")
    style.label(ax[0], "angle of the incline / deg", "acceleration / (m/s²)",
                r"$\mu_s$ = 0.3; lines: closed form")
    ax[0].legend(loc="upper left")
    for scheme, marker in (("consistent", "o"), ("paper", "s")):
        one = style.where(rows, scheme=scheme)
        error = np.maximum(abs(one["a_m_s2"] - one["a_exact_m_s2"]) / 9.81, 1e-16)
        ax[1].semilogy(one["angle_deg"], error, label=scheme,
                       **{**style.LINE[scheme], "linestyle": "none"})
    style.label(ax[1], "angle of the incline / deg", "error of the acceleration / g",
                r"step of Eq. (50), all $\mu_r$")
    ax[1].legend(loc="center right")
    for scheme in ("consistent", "paper"):
        one = style.where(steps, method=scheme)
        ax[2].loglog(one["dt_over_eq50"], one["error"], **style.LINE[scheme], label=scheme)
    style.label(ax[2], "time step / step of Eq. (50)", "error of the accelerations / g",
                "rest, roll and slip")
    ax[2].legend(loc="center left")
    style.save(fig, out, "14_incline")

"""Speed over time, speed and angle of repose over the step, speed over the wall time."""
import numpy as np
import style


def draw(data, out):
    heap, history = style.read(data / "heap.csv"), style.read(data / "history.csv")
    fig, ax = style.figure(2, 2)
    for scheme in ("consistent", "paper"):
        one, run = style.where(history, scheme=scheme), style.where(heap, scheme=scheme)
        line = {**style.LINE[scheme], "marker": None}
        dots = {**style.LINE[scheme], "linestyle": "none", "label": scheme}
        ax[0][0].semilogy(one["t_s"], one["v_rms_m_s"], **line, label=scheme)
        fine = run["v_rms_m_s"] < 50  # the others exploded
        ax[0][1].loglog(run["dt_over_eq50"], np.clip(run["v_rms_m_s"], 1e-8, 10), **dots)
        ax[1][0].semilogx(run["dt_over_eq50"][fine], run["angle_deg"][fine], **dots)
        ax[1][1].loglog(run["wall_time_s"][fine], np.maximum(run["v_rms_m_s"][fine], 1e-8), **dots)
        ax[1][1].xaxis.set_minor_formatter("")  # labels between the decades would overlap
    ax[0][1].axhline(1e-3, color="0.45", linewidth=0.9)
    ax[0][1].text(0.26, 1.4e-3, "counts as rest", fontsize=7, color="0.35")
    style.label(ax[0][0], "time / s", "speed, RMS / (m/s)", "96 spheres, step of Eq. (50)")
    style.label(ax[0][1], "time step / step of Eq. (50)", "speed after 2.5 s / (m/s)",
                "at the top edge: exploded")
    style.label(ax[1][0], "time step / step of Eq. (50)", "angle of repose / deg",
                "one mark per seed")
    style.label(ax[1][1], "wall time / s", "speed after 2.5 s / (m/s)", "speed against cost")
    for a in ax.flat:
        a.legend(loc="best")
    ax[0][1].legend(loc="upper left")
    for a in (ax[0][1], ax[1][0]):
        a.set_xticks([0.25, 0.5, 1, 2, 4], ["1/4", "1/2", "1", "2", "4"], minor=False)
        a.minorticks_off()
    ax[1][0].legend(loc="lower left")
    style.save(fig, out, "22_pile")

"""Down a slope of many elements, and a shallow furrow."""
import numpy as np
import style


def draw(data, out):
    slope, furrow = style.read(data / "slope.csv"), style.read(data / "furrow.csv")
    fig, ax = style.figure(1, 3)
    one = style.where(slope, surface="one rectangle")
    for k, motion in enumerate(dict.fromkeys(slope["motion"])):
        single = style.where(one, motion=motion)
        wild = style.where(slope, motion=motion, surface="wild triangles")
        every = max(1, len(wild["t_s"]) // 12)
        for a, column in ((ax[0], "v_m_s"), (ax[1], "f_over_weight")):
            a.plot(single["t_s"], single[column], **style.LINE["reference"])
            a.plot(wild["t_s"], wild[column], markevery=every, label=motion,
                   **style.cycle(k, linestyle="none"))
    style.label(ax[0], "time / s", "velocity / (m/s)",
                "down 20 degrees; line: one rectangle")
    style.label(ax[1], "time / s", "friction / weight", "marks: triangles of all shapes")
    ax[1].set_ylim(0, None)
    ax[0].legend(loc="upper left")
    for k, degrees in enumerate(np.unique(furrow["degrees"])):
        part = style.where(furrow, degrees=degrees)
        ax[2].plot(part["s_over_R"], part["force"], label=f"{degrees:g} degrees",
                   **style.cycle(k, marker=False))
    style.label(ax[2], "way from the middle of the furrow / R", "upward force / that of one face",
                "a shallow furrow, overlap 0.001 R")
    ax[2].legend(loc="upper right")
    style.save(fig, out, "23_seams")

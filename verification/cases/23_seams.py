"""The bump at rest, on the way, and the speed that it costs."""
import numpy as np
import style


def draw(data, out):
    profile, way = style.read(data / "profile.csv"), style.read(data / "roll.csv")
    loss = style.read(data / "loss.csv")
    fig, ax = style.figure(1, 3)
    ax[0].plot(1e3 * profile["s_m"], profile["lift_over_overlap"], **style.LINE["reference"])
    style.label(ax[0], "distance from the seam / mm", "lift / static overlap",
                "equilibrium, closed form")
    for k, mesh in enumerate(("one rectangle", "rectangles", "triangles")):
        one = style.where(way, mesh=mesh, v0_m_s=0.1)
        ax[1].plot(1e3 * one["x_m"], one["lift_over_overlap"], **style.cycle(k, marker=False),
                   label=mesh)
        sum_ = style.where(loss, mesh=mesh, scheme="consistent")
        ax[2].loglog(sum_["v0_m_s"], np.maximum(1 - sum_["speed_left"], 1e-4), **style.cycle(k),
                     label=mesh)
    ax[1].set_xlim(50, 120)
    ax[1].set_ylim(-0.15, 0.8)
    style.label(ax[1], "way / mm", "lift / static overlap", "rolling at 0.1 m/s")
    ax[1].legend(loc="upper center", ncols=3, fontsize=6, handlelength=1.8, columnspacing=0.8)
    style.label(ax[2], "initial speed / (m/s)", "share of the speed lost in 0.2 m",
                "ten squares (lowest: zero)")
    ax[2].legend(loc="lower left", bbox_to_anchor=(0, 0.08))
    style.save(fig, out, "23_seams")

"""A collision with one neighbour list and with a new one in every step."""
import style


def draw(data, out):
    track = style.read(data / "track.csv")
    fig, ax = style.figure(1, 2)
    for a, contact in zip(ax, ("two spheres", "sphere and plate")):
        one = style.where(track, contact=contact, scheme="consistent")
        t, new = 1e3 * one["t_s"], slice(None, None, 8)
        a.plot(t, one["vx_m_s"], **style.cycle(0, marker=False), label="$v_x$, one list")
        a.plot(t[new], one["vx_split_m_s"][new], **style.cycle(0, linestyle="none"),
               label="$v_x$, a list per step")
        a.plot(t, 0.005 * one["wz_1_s"], **style.cycle(1, marker=False),
               label=r"$R \omega_z$, one list")
        a.plot(t[new], 0.005 * one["wz_split_1_s"][new], **style.cycle(1, linestyle="none"),
               label=r"$R \omega_z$, a list per step")
        low, high = a.get_ylim()
        a.set_ylim(low, high + 0.45 * (high - low))
        style.label(a, "time / ms", "velocity / (m/s)", contact)
        a.legend(ncols=2, loc="upper center", fontsize=6.5)
    style.save(fig, out, "24_rebuild")

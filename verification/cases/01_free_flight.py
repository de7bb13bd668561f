"""Approach to the terminal velocity, decay of the spin, and the error over the number of steps."""
import style

C = 45.0  # 1/s, drag coefficient of Eq. (3) for the sphere of this case


def draw(data, out):
    fig, ax = style.figure(1, 3, width=2.75)
    table = style.read(data / "fall.csv")
    steps = sorted(set(table["h_c"]), reverse=True)
    exact = style.where(table, h_c=steps[-1])
    for k, (column, reference, size) in enumerate(
            (("vz_m_s", "vz_exact_m_s", 9.81 / C), ("wy_1_s", "wy_exact_1_s", 70.0))):
        ax[k].plot(exact["t_s"] * C, exact[reference] / size, **style.LINE["reference"],
                   label="exponential")
        for n, step in enumerate(steps):
            rows = style.where(table, h_c=step)
            keep = rows["t_s"] * C < (4 if k == 0 else 2)
            ax[k].plot(rows["t_s"][keep] * C, rows[column][keep] / size,
                       markevery=1 if n < 2 else 4,
                       **{**style.cycle(n), "linestyle": ":" if n == 0 else "none"},
                       label=rf"$c\,\Delta t$ = {step:.2g}")
    style.label(ax[0], r"time $c\,t$", r"velocity $v_z / v_\infty$", "fall in glycerine")
    style.label(ax[1], r"time $c\,t$", r"spin $\omega_y / |\omega_y(0)|$", r"$\gamma = 10c/3$")
    ax[0].legend(loc="upper right")
    style.work_precision(ax[2], data / "work.csv", title="order 1")
    style.save(fig, out, "01_free_flight")

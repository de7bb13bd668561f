"""Figure of case 25: vibrating plate, take-off, belt, turntable, co-rotating sphere, work."""
import numpy as np
import style


def draw(data, out):
    fig, axes = style.figure(2, 3)
    draw_overlap(axes[0][0], style.read(data / "vibration.csv"))
    draw_takeoff(axes[0][1], style.read(data / "takeoff.csv"),
                 style.read(data / "delay.csv"))
    draw_belt(axes[0][2], style.read(data / "belt.csv"))
    draw_circles(axes[1][0], style.read(data / "circles.csv"))
    draw_carried(axes[1][1], style.read(data / "carried.csv"))
    draw_work(axes[1][2], style.read(data / "work.csv"), style.read(data / "steps.csv"))
    style.save(fig, out, "25_moving_mesh")


def points(k, **more):
    """Markers of family k without a line."""
    return style.cycle(k, linestyle="none", **more)


def draw_overlap(ax, rows):
    for k, gamma in enumerate(np.unique(rows["gamma"])):
        one = style.where(rows, gamma=gamma)
        ax.plot(one["phase"] / np.pi, one["quasi_static"], **style.LINE["reference"])
        ax.plot(one["phase"] / np.pi, one["overlap"], markevery=12, label=f"{gamma:g}", **points(k))
    ax.set_ylim(-0.25, 2.2)
    style.label(ax, r"phase $\omega t/\pi$", r"overlap $\delta/\delta_0$",
                "on a vibrating plate; lines: stiff contact")
    ax.legend(title=r"$\Gamma = A\omega^2/g$", ncol=2, loc="upper left", title_fontsize=7.5)


def draw_takeoff(ax, rows, late):
    gamma = np.linspace(1, 5.2, 300)
    ax.plot(gamma, np.degrees(np.arcsin(1 / gamma)), **style.LINE["reference"],
            label=r"$\sin\varphi = 1/\Gamma$")
    for k, E in enumerate(np.unique(rows["E_Pa"])):
        one = style.where(rows, E_Pa=E)
        line = style.where(late, E_Pa=E)
        ax.plot(line["gamma"], np.degrees(line["phase"]), color=style.COLORS[k],
                linestyle=style.DASHES[1], linewidth=1)
        ax.plot(one["gamma"], np.degrees(one["phase"]), **points(k),
                label=f"$E = 10^{{{round(np.log10(E))}}}$")
    style.label(ax, r"$\Gamma$", r"phase of take-off $\varphi$ (degrees)",
                "above 1 g; dashed: $+\\, C\\omega T$")
    ax.legend(loc="upper right")


def draw_belt(ax, rows):
    for k, mur in enumerate(np.unique(rows["mu_r"])):
        one = style.where(rows, mu_r=mur)
        ax.plot(one["time_s"], one["closed_m_per_s"], **style.LINE["reference"])
        ax.plot(one["time_s"], one["v_m_per_s"], markevery=max(1, len(one["time_s"]) // 14),
                label=rf"$\mu_r$ = {mur:g}", **points(k))
    ax.axhline(2 / 7, **style.LINE["alternative"])
    ax.annotate(r"$2V/7$", (0.4, 0.22), fontsize=7.5)
    style.label(ax, "time (s)", "velocity (m/s)", r"on a belt of $V$ = 1 m/s, $\mu_s$ = 0.3")
    ax.legend(loc="lower right")


def draw_circles(ax, rows):
    for k, W in enumerate(np.unique(rows["W_per_s"])[::-1]):
        one = style.where(rows, W_per_s=W)
        ax.plot(one["exact_x_m"], one["exact_y_m"], **style.LINE["reference"])
        ax.plot(one["x_m"], one["y_m"], markevery=3, label=f"$W$ = {W:+g}/s", **points(k))
    ax.plot(0, 0, color="0.0", marker="+", markersize=8)
    ax.annotate("axis", (0, 0), xytext=(4, 4), textcoords="offset points", fontsize=7.5)
    ax.plot(rows["x_m"][0], rows["y_m"][0], color="0.0", marker="o", markersize=3.5)
    ax.annotate("start", (rows["x_m"][0], rows["y_m"][0]), xytext=(6, -3),
                textcoords="offset points", fontsize=7.5)
    ax.set_aspect("equal", adjustable="datalim")
    style.label(ax, "x (m)", "y (m)", "rolling on a turntable, seen at rest")
    ax.set_ylim(-0.11, 0.17)
    ax.legend(loc="upper center", ncol=2)


def draw_carried(ax, rows):
    for k, divisor in enumerate(np.unique(rows["divisor"])):
        one = style.where(rows, divisor=divisor)
        one = {name: values[1:] for name, values in one.items()}  # from the first quarter turn on
        ax.semilogy(one["turns"], one["closed"], **style.LINE["reference"])
        step = f"/{divisor:g}" if divisor > 1 else ""
        name = (f"{1 / divisor:g} " if divisor < 1 else "") + rf"$\Delta t_0${step}"
        ax.semilogy(one["turns"], one["lag"], markevery=4, label=name, **points(k))
    ax.set_ylim(3e-8, 1e-3)
    style.label(ax, "turns", "angle behind the table (rad)",
                "at rest on the table; lines: closed form")
    ax.legend(loc="lower right", ncol=2)


def draw_work(ax, work, steps):
    for method in ["consistent", "paper"]:
        one = style.where(work, method=method)
        ax.loglog(one["force_evaluations"], one["error"], **style.LINE[method],
                  label=f"turntable, {method}")
    ax.loglog(steps["force_evaluations"], steps["error"], **style.cycle(2),
              label="vibrating plate")
    style.ideal(ax, 1, 2.5e4, 6e-6)
    style.ideal(ax, 2, 2.5e4, 2e-8)
    ax.set_ylim(2e-11, 0.3)
    style.label(ax, "force evaluations", "largest error", "work and precision")
    ax.legend(loc="upper right")

"""Figure of case 9: impulse of friction over e_n and over the step; energy; work and precision."""
import style


def draw(data, out):
    fig, axes = style.figure(2, 2)
    draw_impulse(axes[0][0], style.read(data / "impulse.csv"))
    steps = style.read(data / "steps.csv")
    draw_ratio(axes[0][1], style.where(steps, angle_deg=70))
    draw_energy(axes[1][0], style.where(steps, angle_deg=85))
    style.work_precision(axes[1][1], data / "work.csv", orders=(),
                         title="70 deg, $\\mu$ = 0.1, $e_n$ = 0.5")
    axes[1][1].legend(loc="lower left")
    axes[1][1].set_ylim(1e-8, 5)
    style.ideal(axes[1][1], 1, 200, 0.02)
    axes[1][1].set_ylabel("rms error of the impulse")
    style.save(fig, out, "09_gross_sliding")


def draw_impulse(ax, table):
    closed = style.where(table, method="consistent", divisor=1)
    ax.plot(closed["e_n"], closed["closed_form"], **style.LINE["reference"],
            label=r"$1 + 2e_c - e_n$")
    ax.plot(closed["e_n"], 1 + closed["e_n"], **style.LINE["alternative"],
            label=r"rigid bodies, $1 + e_n$")
    for scheme, divisor in [("consistent", 1), ("paper", 1), ("paper", 100)]:
        rows = style.where(table, method=scheme, divisor=divisor)
        line = {**style.LINE[scheme], "linestyle": "none"}
        if divisor > 1:
            line["marker"] = "x"
        step = r"$\Delta t_0$" + (f"/{divisor}" if divisor > 1 else "")
        ax.plot(rows["e_n"], rows["dv_x_over_mu_v_n"], **line, label=f"{scheme}, {step}")
    style.label(ax, "$e_n$", r"impulse of friction / ($\mu m v_n$)", "80 deg, $\\mu$ = 0.2")
    ax.set_ylim(-5.6, 2.4)
    ax.legend(loc="lower center")


def draw_ratio(ax, table):
    for scheme in ["paper", "consistent"]:
        rows = style.where(table, method=scheme)
        ax.plot(rows["divisor"], rows["mean"], **style.LINE[scheme], label=scheme + ", mean")
        ax.fill_between(rows["divisor"], rows["low"], rows["high"], alpha=0.2, linewidth=0,
                        color=style.LINE[scheme]["color"])
    ax.axhline(1, **style.LINE["reference"])
    ax.set_xscale("log")
    style.label(ax, r"$\Delta t_0/\Delta t$", "impulse / closed form",
                "70 deg, $\\mu$ = 0.1, $e_n$ = 0.5; band: phases")
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 0.2))


def draw_energy(ax, table):
    for scheme in ["paper", "consistent"]:
        rows = style.where(table, method=scheme)
        ax.plot(rows["divisor"], rows["energy_ratio"], **style.LINE[scheme], label=scheme)
    ax.axhline(1, color="0.2", linewidth=0.8, linestyle=":")
    ax.set_xscale("log")
    ax.set_ylim(0.8, 1.2)
    style.label(ax, r"$\Delta t_0/\Delta t$", "energy after / before (worst phase)",
                "85 deg, $\\mu$ = 0.5, $e_n$ = 0.5")
    ax.legend(loc="center right")

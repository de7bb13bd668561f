"""Figure of case 4: restitution, tangential restitution and spin over the angle, the plateau."""
import style


def draw(data, out):
    fig, axes = style.figure(2, 3, width=2.75, height=2.5)
    draw_restitution(axes[0][0], style.read(data / "test3.csv"))
    four, five = style.read(data / "test4.csv"), style.read(data / "test5.csv")
    published = style.read(data / "published.csv")
    draw_curves(axes[0][1], four, "angle_deg", "e_t", published)
    style.label(axes[0][1], "impact angle (deg)", r"$e_t = v_x^{out}/v_x^{in}$ (–)",
                "test 4: tangential restitution")
    axes[0][1].set_ylim(0.05, 1.06)
    axes[0][1].legend(loc="lower right")
    draw_curves(axes[0][2], four, "angle_deg", "spin_per_s", published)
    style.label(axes[0][2], "impact angle (deg)", "spin (1/s)", "test 4: spin")
    draw_curves(axes[1][0], five, "v_t_over_mu_v_n", "spin")
    axes[1][0].axhline(5, color="0.3", linestyle=":", linewidth=1)
    axes[1][0].annotate("published plateau 5.0", (11.3, 5.35), fontsize=7, ha="right")
    style.label(axes[1][0], r"$v_t/(\mu v_n)$", r"spin $R\omega/(\mu v_n)$", "test 5: spin")
    axes[1][0].set_ylim(-0.3, 6.6)
    draw_curves(axes[1][1], five, "v_t_over_mu_v_n", "surface_out")
    style.label(axes[1][1], r"$v_t/(\mu v_n)$", r"surface velocity after / ($\mu v_n$)",
                "test 5: surface velocity")
    style.work_precision(axes[1][2], data / "work.csv", orders=(), title="test 4")
    style.ideal(axes[1][2], 1, 300, 3e-4)
    axes[1][2].set_ylim(1e-8, 0.2)
    axes[1][2].set_ylabel("rms error of the rebound (of $v$)")
    axes[1][2].legend(loc="lower left")
    style.save(fig, out, "04_chung_ooi")


def draw_restitution(ax, table):
    ax.plot([0, 1], [0, 1], **style.LINE["reference"], label="$e_n$")
    for scheme, divisor in [("paper", 1), ("consistent", 1)]:
        for material, fill in [("oxide", "white"), ("iron", "0.6")]:
            rows = style.where(table, method=scheme, divisor=divisor, material=material)
            line = {**style.LINE[scheme], "linestyle": "none", "markerfacecolor": fill}
            if scheme == "paper":
                line.update(markersize=7)
            ax.plot(rows["e_n"], rows["measured"], **line, label=f"{material}, {scheme}")
    style.label(ax, "$e_n$ (–)", "velocity ratio after impact (–)", "test 3")
    ax.set_ylim(-0.05, 1.95)
    ax.legend(loc="upper left")


def draw_curves(ax, table, x, y, published=None):
    reference = style.where(table, method="reference")
    ax.plot(reference[x], reference[y], **style.LINE["reference"], label="reference (GSL)")
    for scheme, divisor in [("paper", 1), ("paper", 64), ("consistent", 1)]:
        rows = style.where(table, method=scheme, divisor=divisor)
        line = {**style.LINE[scheme], "linestyle": "none", "markersize": 3.6}
        if divisor > 1:
            line.update(markerfacecolor=line["color"], markersize=3)
        step = r"$\Delta t_0$" + (f"/{divisor}" if divisor > 1 else "")
        ax.plot(rows[x], rows[y], **line, label=f"{scheme}, {step}")
    if published:
        ax.plot(published[x], published[y], **{**style.LINE["published"], "markersize": 6.5},
                label="Chung & Ooi 2011")

"""Figure of case 13: slide to roll, decelerations, what the printed update loses, work."""
import style


def draw(data, out):
    tracks, closed = style.read(data / "tracks.csv"), style.read(data / "closed.csv")
    fig, axes = style.figure(2, 2)
    draw_transition(axes[0][0], style.where(tracks, motion="transition"), closed)
    draw_decay(axes[0][1], tracks)
    draw_deviation(axes[1][0], style.read(data / "steps.csv"))
    style.work_precision(axes[1][1], data / "work.csv", orders=(), title="from sliding to rolling")
    style.ideal(axes[1][1], 1, 1500, 5e-5)
    axes[1][1].set_ylabel("rms error of the velocity (m/s)")
    style.save(fig, out, "13_rolling")


def draw_transition(ax, tracks, closed):
    ax.plot(closed["time_s"], closed["v_m_per_s"], **style.LINE["reference"], label="closed form")
    ax.plot(closed["time_s"], closed["surface_m_per_s"], **style.LINE["reference"])
    for scheme in ["paper", "consistent"]:
        rows = style.where(tracks, method=scheme)
        line = {**style.LINE[scheme], "linestyle": "none"}
        offset = 0 if scheme == "paper" else 5
        for column in ["v_m_per_s", "surface_m_per_s"]:
            ax.plot(rows["time_s"][offset::10], rows[column][offset::10], **line,
                    label=scheme if column[0] == "v" else None)
    ax.annotate(r"velocity $v$", (0.02, 0.98), fontsize=7.5)
    ax.annotate(r"spin $R\omega$", (0.03, 0.12), fontsize=7.5)
    style.label(ax, "time (s)", "velocity (m/s)", "from sliding to rolling, $\\mu_s$ = 0.3")
    ax.legend(loc="lower right")


def draw_decay(ax, tracks):
    columns = {"roll": ("v_m_per_s", "rolling, $v$"),
               "spin": ("surface_m_per_s", "spin, no $\\mu_s$"),
               "twist": ("wz_per_s", "twisting")}
    for k, (motion, (column, name)) in enumerate(columns.items()):
        for scheme in ["consistent", "paper"]:
            rows = style.where(tracks, motion=motion, method=scheme)
            line = style.cycle(k)
            line["markevery"] = (0, 25) if scheme == "consistent" else (12, 25)
            if scheme == "paper":
                line["markerfacecolor"] = line["color"]
            ax.plot(rows["time_s"], rows[column] / rows[column][0], **line,
                    label=name if scheme == "consistent" else None)
    style.label(ax, "time (s)", "velocity / initial velocity", "$\\Delta t_0$; filled: paper")
    ax.set_ylim(-0.15, 1.45)
    ax.legend(loc="upper right")


def draw_deviation(ax, steps):
    for k, motion in enumerate(["roll", "spin", "twist", "slide"]):
        rows = style.where(steps, motion=motion, method="paper")
        ax.loglog(rows["divisor"], rows["deviation"], **{**style.cycle(k), "linestyle": "none"},
                  label=f"paper, {motion}")
        if motion != "roll":
            ax.loglog(rows["divisor"], rows["predicted"], color=style.cycle(k)["color"],
                      linewidth=0.9)
        rows = style.where(steps, motion=motion, method="consistent")
        filled = {**style.cycle(k), "linestyle": "none"}
        filled["markerfacecolor"] = filled["color"]
        ax.loglog(rows["divisor"], rows["deviation"].clip(1e-13), **filled)
    ax.annotate("filled: consistent", (1.1, 1e-10), fontsize=7.5)
    ax.set_ylim(2e-14, 1e4)
    ax.set_yticks([1e-13, 1e-10, 1e-7, 1e-4, 1e-1])
    style.label(ax, r"$\Delta t_0/\Delta t$", "relative deviation of the deceleration",
                "lines: predicted for paper")
    ax.legend(loc="upper right", ncol=2)

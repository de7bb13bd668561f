"""Restitution over e_n, its independence of everything else, and what an error costs."""
import style


def draw(data, out):
    fig, axes = style.figure(2, 3, width=2.75)
    curve(axes[0, 0], axes[0, 1], style.read(data / "restitution.csv"))
    speed(axes[0, 2], style.read(data / "variations.csv"))
    partners(axes[1, 0], style.read(data / "variations.csv"))
    style.work_precision(axes[1, 1], data / "work.csv", (1,), r"cost, $e_n = 0.5$")
    axes[1, 1].set_ylabel(r"RMS error of $e\,/\,e_n$")
    precision(axes[1, 2], data)
    style.save(fig, out, "02_restitution")


def curve(ax, deviation, t):
    ax.plot(t["e_n"], t["e_n"], **style.LINE["reference"], label=r"$e = e_n$")
    ax.plot(t["e_n"], t["clipped"], **style.LINE["alternative"], label="force clipped at 0")
    ax.plot(t["e_n"], t["small_step"], **{**style.LINE["consistent"], "linestyle": "none"},
            label="solver")
    style.label(ax, r"parameter $e_n$", r"restitution $e$", "closed form")
    ax.legend()
    deviation.fill_between(t["e_n"], t["eq50_low"] - t["e_n"], t["eq50_high"] - t["e_n"],
                           color="0.8", label=r"$\Delta t$ of Eq. (50), all phases")
    deviation.plot(t["e_n"], t["small_step"] - t["e_n"], **style.LINE["consistent"],
                   label=r"$\Delta t/64$")
    style.label(deviation, r"parameter $e_n$", r"$e - e_n$", "discretization error")
    deviation.set_ylim(-0.045, 0.02)
    deviation.legend(loc="lower right")


def speed(ax, table):
    for k, en in enumerate((0.3, 0.6, 0.9)):
        rows = style.where(table, group="speed", e_n=en)
        ax.semilogx(rows["value"], 1e4 * (rows["e"] - en), **style.cycle(k), label=f"$e_n$ = {en}")
    style.label(ax, "impact speed / (m/s)", r"$10^4\,(e - e_n)$", r"speed, $\Delta t/64$")
    ax.set_ylim(-3.5, 3)
    ax.legend(loc="upper left", ncol=2)


def partners(ax, table):
    places = [("size ratio", 2, "ratio 2"), ("size ratio", 5, "ratio 5"),
              ("size ratio", 20, "ratio 20"), ("wall", 0, "wall"), ("material", 0, "glass"),
              ("material", 1, "rubber"), ("material", 2, "steel"), ("material", 3, "auxetic")]
    for k, en in enumerate((0.3, 0.6, 0.9)):
        values = [style.where(table, group=g, value=v, e_n=en)["e"][0] for g, v, _ in places]
        ax.plot([1e4 * (v - en) for v in values], **{**style.cycle(k), "linestyle": "none"})
    ax.set_xticks(range(len(places)), [name for _, _, name in places], rotation=50, ha="right")
    ax.set_ylim(-3.5, 3)
    style.label(ax, "", r"$10^4\,(e - e_n)$", r"partner and material, $\Delta t/64$")


def precision(ax, data):
    for name, folder in (("float", "float"), ("double", "."), ("long double", "long_double")):
        if (data / folder / "precision.csv").exists():
            rows = style.read(data / folder / "precision.csv")
            ax.loglog(rows["dt_over_eq50"], rows["error"], **style.LINE[name], label=name)
    x = [0.003, 0.3]
    ax.plot(x, [2e-4 * (v / 0.3) ** 2.5 * 3 for v in x], color="0.45", linewidth=0.9)
    ax.annotate("order 2.5", (0.007, 4e-8), fontsize=7, color="0.35", ha="right")
    style.label(ax, r"step / step of Eq. (50)", "RMS error of $e$", r"precision, $e_n = 1$")
    ax.legend(loc="lower right")

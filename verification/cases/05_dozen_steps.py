"""Default steps in a collision: over e_n, over the indentation, and the cost of its duration."""
import style


def draw(data, out):
    fig, ax = style.figure(1, 3, width=2.75)
    table = style.read(data / "steps.csv")
    for panel, fixed, column in ((ax[0], {"indentation": 0.1}, "e_n"),
                                 (ax[1], {"e_n": 0.5}, "indentation")):
        panel.axhline(12, **style.LINE["alternative"], label="a dozen")
        for k, partner in enumerate(("equal", "five times larger", "wall")):
            rows = style.where(table, partner=partner, **fixed)
            factor = 100 if column == "indentation" else 1
            panel.plot(factor * rows[column], rows["steps_exact"], color="0", linewidth=1,
                       label="quadrature" if k == 0 else None)
            panel.plot(factor * rows[column], rows["steps"],
                       **{**style.cycle(k), "linestyle": "none"},
                       label=partner.replace("five times", "5 ×"))
    ax[0].set_ylim(5, 27)
    ax[0].legend(loc="upper right", ncol=2, columnspacing=0.8, handlelength=1.8)
    ax[1].set_xscale("log")
    ax[1].set_xticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
    ax[1].minorticks_off()
    ax[1].set_ylim(0, 27)
    style.label(ax[0], r"parameter $e_n$", "steps of Eq. (50)", r"indentation $\delta/2R^*$ = 10 %")
    style.label(ax[1], r"indentation $\delta/2R^*$ / %", "steps of Eq. (50)", r"$e_n$ = 0.5")
    style.work_precision(ax[2], data / "work.csv", (1,), r"duration, $e_n$ = 0.5, 10 %")
    style.save(fig, out, "05_dozen_steps")

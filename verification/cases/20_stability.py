"""Largest stable step over e_n: theory as lines, onset measured with the solver as marks."""
import style


def draw(data, out):
    theory, measured = style.read(data / "theory.csv"), style.read(data / "measured.csv")
    modes = ("normal", "sliding", "rolling", "twisting", "sliding and rolling")
    fig, ax = style.figure(1, 2, height=3.1)
    for a, scheme in zip(ax, ("consistent", "paper")):
        for k, mode in enumerate(modes):
            line = style.where(theory, mode=mode, scheme=scheme)
            mark = style.where(measured, mode=mode, scheme=scheme)
            a.semilogy(line["en"], line["dt_over_eq50"], color=style.COLORS[k], linewidth=1.1,
                       linestyle=style.DASHES[k])
            a.semilogy(mark["en"], mark["dt_over_eq50"], label=mode,
                       **{**style.cycle(k), "linestyle": "none"})
        a.axhline(1, color="0", linewidth=0.8)
        a.set_ylim(0.03, 40)
        style.label(a, "coefficient of restitution $e_n$", "largest stable step / step of Eq. (50)",
                    scheme)
    ax[0].text(0.02, 1.08, "step of Eq. (50)", fontsize=7)
    ax[0].legend(loc="lower left", ncols=2, fontsize=7)
    style.save(fig, out, "20_stability")

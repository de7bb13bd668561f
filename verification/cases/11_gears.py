"""Figure of case 11: friction over overlap, spins through an impact, springs that turn along."""
import numpy as np

import style

FLOOR = 1e-17


def draw(data, out):
    table = style.read(data / "overlaps.csv")
    fig, axes = style.figure(1, 3, width=2.9)
    for k, motion in enumerate(["wheels that rub", "meshed gears", "one body"]):
        for scheme in ["consistent", "paper"]:
            rows = style.where(table, motion=motion, scheme=scheme)
            if len(rows["overlap_over_R"]) == 0:
                continue
            line = style.cycle(k)
            line["markevery"] = (0, 4) if scheme == "consistent" else (2, 4)
            if scheme == "paper":
                line["markerfacecolor"] = line["color"]
            axes[0].loglog(rows["overlap_over_R"], np.maximum(rows["friction_felt"], FLOOR),
                           **line, label=f"{motion}, {scheme}")
    axes[0].set_ylim(1e-18, 1e2)
    axes[0].set_yticks([FLOOR, 1e-12, 1e-8, 1e-4, 1],
                       ["0", "$10^{-12}$", "$10^{-8}$", "$10^{-4}$", "1"])
    style.label(axes[0], r"overlap $\delta/R$",
                r"change of spin / of velocity, $R\Delta\omega/\Delta v$", "one step")
    axes[0].legend(loc="center")
    impact = style.read(data / "impact.csv")
    for scheme in ["consistent", "paper"]:
        rows = style.where(impact, scheme=scheme)
        line = {**style.LINE[scheme], "markevery": 6}
        axes[1].plot(1e3 * rows["time_s"], 1e16 * rows["spin_change"], **line, label=scheme)
    style.label(axes[1], "time (ms)", r"change of spin ($10^{-16}$)",
                "impact of meshed gears of one size")
    axes[1].legend()
    springs = style.where(style.read(data / "springs.csv"), scheme="consistent")
    for k, name in enumerate(["sliding", "rolling"]):
        axes[2].plot(springs["lean_deg"], 1e16 * springs[name], **style.cycle(k), label=name)
    style.label(axes[2], "lean of the spring before (deg)", r"error of force, torque ($10^{-16}$)",
                "springs that turn along")
    axes[2].legend()
    style.save(fig, out, "11_gears")

"""Figures of case 8: rebound over angle, error over work, energy over the phase of a step."""
import numpy as np

import style

MATERIALS = [(1.0, 0.0), (0.5, 0.0), (0.5, 0.3)]


def draw(data, out):
    sweep = style.read(data / "sweep.csv")
    fig, axes = style.figure(2, 3, width=2.75, height=2.5)
    for column, (en, mur) in enumerate(MATERIALS):
        part = style.where(sweep, e_n=en, mu_r=mur)
        for row, name in enumerate(["rebound", "spin"]):
            draw_sweep(axes[row][column], part, name)
        title = f"$e_n$ = {en:g}, $\\mu_s$ = 0.3, $\\mu_r$ = {mur:g}"
        style.label(axes[0][column], "impact angle (deg)", "rebound angle (deg)", title)
        style.label(axes[1][column], "impact angle (deg)", r"spin $R\omega/v$ (–)")
    axes[0][0].legend()
    style.save(fig, out, "08_oblique")
    draw_convergence(data, out)
    draw_energy(data, out)


def draw_sweep(ax, part, name):
    reference = style.where(part, method="reference")
    unit = "_deg" if name == "rebound" else ""
    ax.plot(reference["angle_deg"], reference[name + unit], **style.LINE["reference"],
            label="reference (GSL)")
    for scheme in ["paper", "consistent"]:
        for divisor, label in [(1, r"$\Delta t_0$"), (64, r"$\Delta t_0/64$")]:
            rows = style.where(part, method=scheme, divisor=divisor)
            line = {**style.LINE[scheme], "linestyle": "none", "markersize": 4.2}
            if divisor == 64:
                if scheme == "consistent":
                    continue
                line.update(marker="x", markersize=4)
            ax.plot(rows["angle_deg"], rows[name + unit], **line, label=f"{scheme}, {label}")
            if divisor == 1:
                low, high = (rows[f"{name}_{end}{unit}"] for end in ["low", "high"])
                ax.vlines(rows["angle_deg"], low, high, color=style.LINE[scheme]["color"],
                          linewidth=0.8)


def draw_convergence(data, out):
    table = style.read(data / "convergence.csv")
    fig, axes = style.figure(1, 3, width=2.75, height=2.7)
    for ax, (en, mur) in zip(axes, MATERIALS):
        part = style.where(table, e_n=en, mu_r=mur)
        for method in dict.fromkeys(part["method"]):
            rows = style.where(part, method=method)
            ax.loglog(rows["force_evaluations"], rows["error"], **style.LINE[method], label=method)
        ax.set_ylim(1e-5, 0.6)
        style.label(ax, "force evaluations per impact", "rms error of the rebound (of $v$)",
                    f"$e_n$ = {en:g}, $\\mu_s$ = 0.3, $\\mu_r$ = {mur:g}")
    style.ideal(axes[0], 1, 15, 3e-4)
    axes[2].legend(loc="lower left")
    style.save(fig, out, "08_oblique_work")


def draw_energy(data, out):
    table = style.read(data / "energy.csv")
    fig, axes = style.figure(1, 2)
    names = [["paper: sliding only", "paper: rolling too", "paper: R = 5 Rmin",
              "consistent: sliding only"],
             ["paper: sliding only at 3 m/s", "consistent: sliding only at 3 m/s"]]
    for ax, rows, title in zip(axes, names, ["62 deg, 1 m/s", "45 deg, 3 m/s"]):
        for k, name in enumerate(rows):
            part = style.where(table, name=name)
            line = {**style.cycle(k, marker=False)}
            if name.startswith("consistent"):
                line = {**style.LINE["consistent"], "marker": ""}
            elif k == 0:
                line = {**style.LINE["paper"], "marker": ""}
            else:
                line = style.cycle(k + 1, marker=False)
            label = name.replace(" at 3 m/s", "").replace("Rmin", "$R_{min}$")
            ax.plot(part["phase"], part["energy_ratio"], **line, label=label)
        ax.axhline(1, color="0.2", linewidth=0.8, linestyle=":")
        ax.set_xlim(0, 1)
        ax.set_ylim(0, np.ceil(style.where(table, name=rows[0])["energy_ratio"].max() + 0.8))
        style.label(ax, "part of a step before the sphere touches", "energy after / before",
                    f"$e_n$ = 1, $\\mu_s$ = 1, $\\Delta t_0$, {title}")
        ax.legend(loc="upper left")
    style.save(fig, out, "08_oblique_energy")

"""One-step form, energy of a bouncing sphere, a chain and a gas, and the cost of an error."""
import numpy as np

import style

NAMES = {"solver": "solver", "semi-implicit Euler": "solver", "velocity Verlet": "velocity Verlet",
         "explicit Euler": "explicit Euler"}
LINE = {**style.LINE, "solver": style.LINE["consistent"]}


def draw(data, out):
    fig, ax = style.figure(2, 3, width=2.75)
    form(ax[0, 0], style.read(data / "one_step.csv"))
    bounce(ax[0, 1], style.read(data / "bounce.csv"))
    style.work_precision(ax[0, 2], data / "work.csv", (2.5,), "bouncing sphere")
    ax[0, 2].set_ylabel("RMS of energy change")
    ax[0, 2].set_ylim(1e-8, 1e6)
    ax[0, 2].legend(loc="upper right", ncol=2, columnspacing=0.8, handlelength=2)
    for k, step in enumerate((1, 0.0625)):
        chain(ax[1, k], style.where(style.read(data / "chain.csv"), dt_over_eq50=step), step)
    gas(ax[1, 2], style.read(data / "gas.csv"))
    style.save(fig, out, "07_symplectic")


def form(ax, table):
    for method in ("solver", "velocity Verlet", "explicit Euler"):
        rows = style.where(table, method=method)
        ax.loglog(rows["dt_over_eq50"], rows["defect"], **LINE[method], label=method)
    ax.set_ylim(1e-12, 1e4)
    ax.set_xticks([0.25, 0.5, 1, 2], ["0.25", "0.5", "1", "2"])
    ax.minorticks_off()
    style.label(ax, "step / step of Eq. (50)", r"$\max|J^T\Omega J - \Omega|$",
                "one step of a chain")
    ax.legend(loc="upper left")


def bounce(ax, table):
    ours = "semi-implicit Euler"
    for k, (method, step) in enumerate((("explicit Euler", 0.0625), ("explicit Euler", 0.25),
                                        ("velocity Verlet", 1), (ours, 1), (ours, 0.25),
                                        (ours, 0.0625))):
        rows = style.where(table, method=method, dt_over_eq50=step)
        size = r"$\Delta t$" if step == 1 else rf"$\Delta t/{1 / step:.0f}$"
        ax.loglog(rows["bounce"], np.abs(rows["energy_change"]), label=f"{NAMES[method]}, {size}",
                  **style.cycle(k, marker=False))
    ax.set_ylim(1e-10, 1e7)
    style.label(ax, "bounce", "relative change of energy", "sphere on a plate")
    ax.legend(loc="upper left", ncol=2, columnspacing=0.7, handlelength=1.7, fontsize=6)


def chain(ax, table, step):
    size = 1 if step == 1 else 1e4
    for method in ("velocity Verlet", "solver"):
        rows = style.where(table, method=method)
        ax.plot(rows["time_s"], size * rows["energy_change"],
                **{**LINE[method], "marker": None, "linewidth": 0.8}, label=method)
    style.label(ax, "time / s", "change of energy" + (r" / $10^{-4}$" if step < 1 else ""),
                "three spheres, " + (r"$\Delta t$" if step == 1 else r"$\Delta t/16$"))
    low, high = ax.get_ylim()
    ax.set_ylim(low, high + 0.35 * (high - low))
    ax.legend(loc="upper left")


def gas(ax, table):
    for k, (step, column, name) in enumerate((
            (1, "unsynchronized", r"$\Delta t$, as summary() says"),
            (1, "energy_change", r"$\Delta t$"), (0.25, "energy_change", r"$\Delta t/4$"))):
        rows = style.where(table, dt_over_eq50=step)
        ax.plot(rows["time_s"], 1e3 * rows[column], **{**style.cycle((4, 0, 2)[k]), "markevery": 4},
                label=name)
    low, high = ax.get_ylim()
    ax.set_ylim(low, high + 0.45 * (high - low))
    style.label(ax, "time / s", r"change of energy / $10^{-3}$", "gas of 216 spheres in a box")
    ax.legend(loc="upper left")

"""Force over time in units of Hertz' solution, published peaks, and the cost of an error."""
import numpy as np

import style


def draw(data, out):
    fig, ax = style.figure(1, 3, width=2.75)
    table, peaks = style.read(data / "history.csv"), style.read(data / "peaks.csv")
    tests = list(dict.fromkeys(table["test"]))
    names = ("glass", "limestone", "Al, wall", "Mg, wall")
    for k, test in enumerate(tests):
        rows = style.where(table, test=test)
        ax[0].plot(rows["t_s"] / rows["duration_s"], rows["force_N"] / rows["force_max_N"],
                   markevery=(k, 4), **{**style.cycle(k), "linestyle": "none"}, label=names[k])
    ax[0].plot(*hertz(), **style.LINE["reference"], label="Hertz")
    style.label(ax[0], r"time / $t_c$", r"force / $F_{\max}$", "one curve for all impacts")
    ax[0].set_ylim(0, 1.65)
    ax[0].legend(loc="upper center", ncol=2, columnspacing=1)
    for k, (quantity, name) in enumerate((("force", "force"), ("overlap", "overlap"),
                                          ("duration", "duration"))):
        for source, line in (("published", style.LINE["published"]), ("solver", style.cycle(0))):
            values = style.where(peaks, source=source)[f"{quantity}_error"]
            x = np.arange(len(values)) * 0.15 + k - 0.225
            ax[1].semilogy(x[values > 0], values[values > 0], **{**line, "linestyle": "none"},
                           label=source if k == 0 else None)
    ax[1].set_xticks(range(3), ["force", "overlap", "duration"])
    ax[1].set_ylim(1e-8, 1e-3)
    style.label(ax[1], "peak of the four tests", "relative distance to Hertz",
                r"solver at $\Delta t/64$")
    ax[1].legend(loc="upper right")
    style.work_precision(ax[2], data / "work.csv", (2,), "duration, glass")
    style.save(fig, out, "03_hertz_impact")


def hertz():
    """Force over time of the elastic impact, by quadrature of dt = d(delta)/v."""
    x = np.sin(np.linspace(0, np.pi / 2, 4001)) ** 2  # overlap / largest overlap
    middle = (x[1:] + x[:-1]) / 2
    t = np.concatenate(([0], np.cumsum(np.diff(x) / np.sqrt(1 - middle ** 2.5))))
    t /= 2 * t[-1]
    return np.concatenate((t, 1 - t[::-1])), np.concatenate((x, x[::-1])) ** 1.5

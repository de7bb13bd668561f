"""The reach of the neighbour list: chosen by the solver against values held by hand."""
import numpy as np

import style
from machinery import NOTE, SMOOTH, cell, spread

TITLE = "The automatic neighbour list"
TEXT = """The solver widens or narrows the reach of its list (`Simulation::horizon`) after every
list so that building and idle pairs cost the same. Here the horizon is put back to a fixed
value before every step instead; sorting then changes it by a tenth up or down, and the value
drawn is the mean of those used. Three scenes of 2000 spheres, one thread: a gas (5 % by volume,
elastic, no friction, no gravity), a packing that runs out of a square hole in the floor, the
settled packing. Stepping one by one costs nothing: the row *automatic, step by step*."""
HELD = (0.3, 0.6, 1.2, 2.5, 5, 10, 20)
SCENES = {"gas": ("gas", {"mesh": "closed", "en": 1, **SMOOTH, "g": "0,0,0"}),
          "flow": ("packing", {"mesh": "hopper"}), "packing": ("packing", {})}


def measure(bench, lmp):
    n = 200 if bench.smoke else 2000
    steps = {"steps": 20, "warm": 20} if bench.smoke else {"steps": 800, "warm": 400}
    rows = []
    for scene, (kind, settings) in SCENES.items():
        still = settings if kind == "gas" else {}
        path = bench.state(kind, n, still)
        options = {"automatic": {}, "automatic, step by step": {"horizon": 0},
                   **{f"{h:g}": {"horizon": h} for h in HELD}}
        results = bench.interleave({
            name: (lambda more=more: bench.time(path, **{**settings, **steps, **more}))
            for name, more in options.items()}, bench.repeats * (1 if bench.smoke else 2))
        rows += [{"scene": scene, "kind": name, **r, "spread": spread(r)}
                 for name, r in results.items()]
    return {"rows": rows}


def of_scene(data, scene):
    rows = [r for r in data["rows"] if r["scene"] == scene]
    return rows[:2], rows[2:]


def tables(data):
    lines = []
    for scene in SCENES:
        (auto, single), held = of_scene(data, scene)
        best = min(held, key=lambda r: r["floor"])
        lines.append([scene, cell(auto), cell(single), f"{auto['horizon']:.2g}",
                      f"{auto['rebuilds']:.0f}", cell(best), f"{best['horizon']:.2g}",
                      f"{best['rebuilds']:.0f}", f"{100 * (auto['floor'] / best['floor'] - 1):+.1f} %"])
    return [{"title": "Automatic reach against the best of seven held ones",
             "head": ["scene", "automatic, ns", "automatic, step by step, ns",
                      "its horizon at the end", "its lists per 1000 steps", "best held, ns",
                      "its horizon", "its lists per 1000 steps", "automatic against best"],
             "rows": lines, "note": NOTE}]


def draw(data, folder):
    fig, axes = style.figure(1, 3, 2.6, 2.5)
    for ax, scene in zip(axes, SCENES):
        (auto, _), held = of_scene(data, scene)
        held = sorted(held, key=lambda r: r["horizon"])
        y = np.array([r["floor"] for r in held])
        error = [0 * y, [r["time"] for r in held] - y]
        ax.errorbar([r["horizon"] for r in held], y, error, capsize=2, label="held",
                    **style.cycle(0))
        ax.axhline(auto["floor"], color=style.COLORS[1], linestyle="--", label="automatic")
        ax.plot([auto["horizon"]], [auto["floor"]], **{**style.cycle(1), "linestyle": "none"})
        ax.set_xscale("log")
        ax.set_ylim(0, None)
        style.label(ax, "horizon", "time / ns" if scene == "gas" else "", scene)
    axes[0].legend()
    style.save(fig, folder, "bench_horizon")
    return [("bench_horizon", "Time per particle and step over the reach of the list.")]

"""Time per particle and step of a dense packing over the number of particles, and LAMMPS on it."""
import math

import numpy as np

import style
from lammps_runs import write_data
from machinery import MATERIAL, read_state, spread

TITLE = "Dense packings, and LAMMPS on the same particles"
TEXT = """Spheres fall from a loose lattice into a box with a floor and four side walls
(rectangles, edge about N^(1/3)) and settle until their kinetic energy is below 10⁻³ Σ m g R:
the packing still creeps, so that lists are rebuilt. From 10⁵ on, copies of a smaller settled
packing, every other one mirrored, are put side by side and stacked and settle again (the table
says how far). Full model: Hertz-Mindlin, sliding, rolling and twisting friction, orientations.
Poly: radii evenly spread from 3.5 to 7 mm, otherwise all are 5 mm. Wide: nine copies side by
side, three by three, as high as one: more particles, but no more contacts each (without LAMMPS,
which would need 13 GB). LAMMPS gets the same
positions, radii, velocities and step, the same normal and sliding law, and its `sds` rolling
and twisting; its skin and `newton` are the best of those tried at each N. LAMMPS' time is its
own "Loop time", its clock for the blocks of the second table is the `cpu` of its thermo lines."""
SKINS = (0.1, 0.25, 0.5, 1.0, 1.5, 2.0)  # of the mean radius
#: Steps timed and steps before: the reach of the solver's list needs some lists to find its value.
STEPS = {1000: (2000, 400), 10_000: (400, 400), 100_000: (100, 300), 1_000_000: (60, 300),
         3_000_000: (25, 50), 9_000_000: (25, 50)}


def sizes(bench):
    if bench.smoke:
        return [("packing", 200), ("poly", 200), ("wide", 1800)]
    some = [("packing", 1000), ("packing", 10_000), ("packing", 100_000), ("poly", 10_000)]
    return some + bench.large * [("poly", 100_000), ("packing", 1_000_000),
                                 ("packing", 3_000_000), ("wide", 9_000_000)]


def settled(bench, kind, n):
    """The settled state; from 10^5 on, copies of a smaller one that settle again."""
    if kind == "wide":
        return bench.state(kind, n, {"across": 3}, block=settled(bench, "packing", n // 9))
    if n < 100_000:
        return bench.state(kind, n)
    block = settled(bench, kind, 10_000 if n == 100_000 else 100_000)
    return bench.state(kind, n, most=5000 if n == 100_000 else 20_000, block=block)


def geometry(state):
    """What LAMMPS must know besides particles: box, mean radius, default step, number."""
    radii = state["particles"][:, 3]
    dt = state["Rmin"] * math.sqrt(MATERIAL["rho"] * (1 - MATERIAL["nu"] ** 2) / MATERIAL["E"])
    return {"L": state["L"], "R": float(radii.mean()), "dt": dt, "N": len(radii)}


def prepare(bench, path):
    """Writes LAMMPS' data file for a state, once; its geometry and the name of the file."""
    state, data = read_state(path), path.with_suffix(".data")
    if not data.exists():
        write_data(state, data, MATERIAL["rho"])
    return geometry(state), data


def tune(bench, lmp, data, box, start=None):
    """The best skin and `newton` of LAMMPS for a state, by runs of its own; start: a former
    result, of which only the next smaller and larger skins are tried."""
    steps = {"steps": STEPS.get(box["N"], (40, 10))[0] // (4 if box["N"] > 100_000 else 1),
             "warm": 10}
    skins, switches = SKINS, ("off", "on")
    if start:
        k = SKINS.index(start["skin"])
        skins, switches = SKINS[max(0, k - 1):k + 2], (start["newton"],)
    jobs = {(s, w): (lambda s=s, w=w: lmp.run(data, MATERIAL, box, skin=s, newton=w,
                                             wrap=bench.wrap, **steps))
            for s in skins for w in switches}
    tried = bench.interleave(jobs, 1 if bench.smoke else 3 if box["N"] <= 100_000 else 2)
    skin, newton = min(tried, key=lambda key: tried[key]["floor"])
    return {"skin": skin, "newton": newton}


def compare(bench, lmp, kind, n, best):
    """All of one state: both codes, one and two threads or ranks, in turn."""
    path = settled(bench, kind, n)
    state = read_state(path)
    steps, warm = STEPS.get(n, (40, 10))
    jobs = {f"ours{t}": (lambda t=t: bench.time(path, threads=t, steps=steps, warm=warm))
            for t in (1, 2)}
    if kind == "wide":
        best = None
    elif lmp.here:
        box, data = prepare(bench, path)
        best = tune(bench, lmp, data, box, best if n >= 100_000 or kind == "poly" else None)
        for ranks in (1, 2):
            if lmp.launcher(ranks) is not None:
                jobs[f"lammps{ranks}"] = lambda ranks=ranks: lmp.run(
                    data, MATERIAL, box, ranks=ranks, steps=steps, warm=warm, wrap=bench.wrap,
                    **best)
    repeats = min(bench.repeats, 3) if n > 100_000 else bench.repeats * (3 if n <= 10_000 else 1)
    results = bench.interleave(jobs, repeats)
    row = {"state": kind, "N": n, "settling": state["steps"], "unrest": state["unrest"],
           "steps": steps, **(best or {})}
    for key, result in results.items():
        row.update({f"{key}_{name}": value for name, value in result.items()})
        row[f"{key}_spread"] = spread(result)
    return row, best


def measure(bench, lmp):
    rows, best = [], None
    for kind, n in sizes(bench):
        row, found = compare(bench, lmp, kind, n, best)
        best = found if kind == "packing" else best
        rows.append(row)
    return {"rows": rows, "lammps": lmp.version() if lmp.here else None}


def exponent(rows, key, contacts=False, value="time"):
    """p in (time of a step) ~ N^p, least squares in the logarithms, over the packings; contacts:
    the same with the number of contacts in place of N, since deep packings have more of them;
    value: "time" (the median) or "floor" (every block of steps at its lowest)."""
    some = [r for r in rows if r["state"] == "packing" and f"{key}_time" in r]
    if len(some) < 2:
        return float("nan")
    n = np.array([r["N"] for r in some], float)
    step = n * np.array([r[f"{key}_{value}"] for r in some])
    if contacts:
        n *= [r["ours1_contacts"] for r in some]
    return float(np.polyfit(np.log(n), np.log(step), 1)[0])


def median(row, key):
    """A median and its spread; a dash where there is none."""
    if f"{key}_time" not in row:
        return "–"
    return f"{row[f'{key}_time']:.0f} ± {100 * row[f'{key}_spread']:.0f} %"


def floor(row, key):
    return f"{row[f'{key}_floor']:.1f}" if f"{key}_floor" in row else "–"


def ratio(row, n, value="time"):
    if f"lammps{n}_time" not in row:
        return "–"
    return f"{row[f'lammps{n}_{value}'] / row[f'ours{n}_{value}']:.2f}"


def tables(data):
    rows = data["rows"]
    keys = ("ours1", "ours2", "lammps1", "lammps2")
    names = dict(zip(keys, ("1 thread", "2 threads", "LAMMPS 1 rank", "2 ranks")))
    timed = [k for k in keys if f"{k}_time" in rows[0]]

    def exponents(value="time"):
        each, contacts = ([exponent(rows, k, over, value) for k in timed]
                          for over in (False, True))
        return (", ".join(f"{names[k]} {p:.2f}" for k, p in zip(timed, each)) +
                "; over the number of contacts: " + ", ".join(f"{p:.2f}" for p in contacts) + ".")

    times = {"title": "ns per particle and step (median ± half the range)",
             "head": ["state", "N", "1 thread", "2 threads", "LAMMPS, 1 rank", "LAMMPS, 2 ranks",
                      "LAMMPS / ours, 1", "LAMMPS / ours, 2"],
             "rows": [[r["state"], f"{r['N']:,}".replace(",", " "), *(median(r, k) for k in keys),
                       ratio(r, 1), ratio(r, 2)] for r in rows],
             "note": f"Exponent p of (time of a step) ~ N^p over the packings: {exponents()}" + (
                     f" LAMMPS {data['lammps']}." if data["lammps"] else
                     " LAMMPS is not installed: `./dem bench --lammps` installs it.")}
    low = {"title": "The same runs, undisturbed: every block of steps at the lowest of its "
                    "repetitions, added up",
           "head": times["head"],
           "rows": [[*line[:2], *(floor(r, k) for k in keys), ratio(r, 1, "floor"),
                     ratio(r, 2, "floor")] for r, line in zip(rows, times["rows"])],
           "note": f"Exponents: {exponents('floor')}"}
    more = {"title": "The same runs: how much there was to do",
            "head": ["state", "N", "settled in steps", "kinetic energy / Σ m g R",
                     "contacts per particle", "pairs per particle", "lists per 1000 steps",
                     "updates/s, 1 thread", "updates/s, 2 threads", "LAMMPS: skin / R, newton",
                     "LAMMPS: lists per 1000 steps"],
            "rows": [[r["state"], f"{r['N']:,}".replace(",", " "), f"{r['settling']:.0f}" +
                      (" (side by side)" if r["state"] == "wide" else
                       " (stacked)" if r["N"] >= 100_000 else ""),
                      f"{r['unrest']:.1e}", f"{r['ours1_contacts']:.2f}",
                      f"{r['ours1_pairs']:.2f}", f"{r['ours1_rebuilds']:.0f}",
                      f"{1e9 / r['ours1_floor']:.2e}", f"{1e9 / r['ours2_floor']:.2e}",
                      f"{r['skin']}, {r['newton']}" if "skin" in r else "–",
                      f"{r['lammps1_rebuilds']:.0f}" if "lammps1_rebuilds" in r else "–"]
                     for r in rows],
            "note": "A contact or pair of two particles counts once (across the border of two "
                    "slabs of the solver a pair stands in both lists)."}
    return [times, low, more]


def draw(data, folder):
    fig, ax = style.figure(1, 1, 4.6, 3.1)
    names = {"ours1": "TinyDEM, 1 thread", "ours2": "TinyDEM, 2 threads",
             "lammps1": "LAMMPS, 1 rank", "lammps2": "LAMMPS, 2 ranks"}
    for k, (key, name) in enumerate(names.items()):
        rows = [r for r in data["rows"] if r["state"] == "packing" and f"{key}_time" in r]
        if not rows:
            continue
        y = np.array([r[f"{key}_floor"] for r in rows])
        error = [0 * y, [r[f"{key}_time"] for r in rows] - y]
        ax.errorbar([r["N"] for r in rows], y, error, capsize=2, label=name, **style.cycle(k))
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.yaxis.set_major_formatter(lambda y, _: f"{y:g}")
    ax.yaxis.set_minor_formatter(lambda y, _: f"{y:g}" if f"{y:e}"[0] in "25" else "")
    style.label(ax, "particles", "time per particle and step / ns", "settled packing")
    ax.set_ylim(top=2.5 * ax.get_ylim()[1])  # room for the legend
    ax.legend(ncol=2)
    style.save(fig, folder, "bench_scaling")
    return [("bench_scaling", "Time per particle and step, undisturbed; bars: up to the median.")]

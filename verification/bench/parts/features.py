"""Price list: what each feature adds to the time of a step, on the same packing."""
import style
from machinery import MATERIAL, NOTE, SMOOTH, cell, spread

TITLE = "What a feature costs"
TEXT = """The settled packing of 10⁴ spheres again, loaded anew for every repetition and timed
for 20 steps, so that all rows have the same contacts whatever the law; building lists is left
out. One thread. A mode of friction that a scene does not use is compiled out; rolling brings
the code of twisting along. Without friction nothing makes a particle spin, so the spins of the
packing are taken away; the second row keeps them, and turns. The last column is the time against
the full model (sliding, rolling, twisting, orientations, resting walls)."""
NONE = {**SMOOTH, "orientation": "off"}
FULL = "full model"
SCENES = {
    "no friction": {**SMOOTH, "spins": "off"},
    "no friction, particles spin": SMOOTH,
    "sliding": {**NONE, "mus": 0.3},
    "sliding, twisting": {**NONE, "mus": 0.3, "mut": 0.2},
    "sliding, rolling": {**NONE, "mus": 0.3, "mur": 0.3},
    "sliding, rolling, twisting": {"orientation": "off"},
    FULL: {},
    "full, and drag": {"eta": 1e-3},
    "full, scheme paper": {"scheme": "paper"},
    "full, without walls": {"mesh": "none"},
    "full, single precision": {"program": "bench_float"},
}
#: A resting floor made to vibrate by a micrometre, where the solver has the parameter.
MOTION = {"full, floor vibrates": {"motion": "0 vibrate 0,0,1e-6 50"}}


def jobs(bench):
    n = 200 if bench.smoke else 10_000
    short = {"steps": 20, "warm": 5, "lists": "off", "repeats": 2 if bench.smoke else 7}
    scenes = {**SCENES, **(MOTION if bench.knows("motion") else {})}
    packing = bench.state("packing", n)
    flat = bench.state("monolayer", n, {"mesh": "slot"}, most=8000)
    made = {name: (lambda change=change: bench.time(packing, **{**short, **change}))
            for name, change in scenes.items()}
    made["monolayer (2D), full model"] = lambda: bench.time(flat, **{**short, "mesh": "slot"})
    return made


def measure(bench, lmp):
    results = bench.interleave(jobs(bench), bench.repeats * (1 if bench.smoke else 3))
    full = results[FULL]["floor"]
    rows = [{"feature": name, **r, "relative": r["floor"] / full, "spread": spread(r)}
            for name, r in results.items()]
    return {"rows": rows, "motion": bench.knows("motion")}


def tables(data):
    return [{"title": "ns per particle and step, 10⁴ spheres, one thread",
             "head": ["", "ns", "ns per contact", "contacts per particle", "against full"],
             "rows": [[r["feature"], cell(r),
                       f"{r['floor'] / r['contacts']:.0f}", f"{r['contacts']:.2f}",
                       f"{r['relative']:.2f}"] for r in data["rows"]],
             "note": NOTE + ("" if data["motion"] else
                             " Moving meshes: this solver has no parameter `motion`.")}]


def draw(data, folder):
    fig, ax = style.figure(1, 1, 4.8, 3.0)
    rows = data["rows"][::-1]
    y = [r["floor"] for r in rows]
    error = [[0] * len(rows), [r["time"] - r["floor"] for r in rows]]
    ax.barh([r["feature"] for r in rows], y, xerr=error, color=style.COLORS[5], capsize=2,
            error_kw={"linewidth": 0.8})
    ax.grid(False, axis="y")
    style.label(ax, "time per particle and step / ns", "")
    style.save(fig, folder, "bench_features")
    return [("bench_features", "Time of a step by feature; undisturbed; lines: up to the median.")]

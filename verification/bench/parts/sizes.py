"""Spheres of very different sizes against spheres of one size."""
import style
from machinery import NOTE, cell, read_state, spread

TITLE = "Size ratio 10"
TEXT = """Three settled packings in a box, full model, one thread: 30 000 equal spheres; 30 000
small ones and 7 of ten times their radius; 10 000 with radii from 1 to 10 mm, as many by volume
in every octave (number ~ R⁻⁴). Contacts per particle differ, so the fair figure is the time per
contact."""


def scenes(bench):
    if bench.smoke:
        return {"equal": ("packing", 200), "7 large": ("ratio", 2000), "broad": ("broad", 200)}
    return {"equal": ("packing", 30_000), "7 large, ten times the radius": ("ratio", 30_000),
            "1 to 10 mm": ("broad", 10_000)}


def measure(bench, lmp):
    files = {name: bench.state(*what, most=6000) for name, what in scenes(bench).items()}
    results = bench.interleave({
        name: (lambda path=path: bench.time(path, steps=20 if bench.smoke else 200, warm=20))
        for name, path in files.items()}, bench.repeats)
    rows = []
    for name, r in results.items():
        state = read_state(files[name])
        rows.append({"sizes": name, "N": len(state["particles"]), **r, "spread": spread(r),
                     "settled_unrest": state["unrest"], "per_contact": r["floor"] / r["contacts"]})
    return {"rows": rows}


def tables(data):
    equal = data["rows"][0]["per_contact"]
    return [{"title": "Packings of spheres of different sizes, one thread",
             "head": ["radii", "N", "ns per particle and step", "contacts per particle",
                      "pairs per particle", "ns per contact", "per contact against equal",
                      "lists per 1000 steps", "kinetic energy / Σ m g R"],
             "rows": [[r["sizes"], f"{r['N']:,}".replace(",", " "),
                       cell(r), f"{r['contacts']:.2f}",
                       f"{r['pairs']:.2f}", f"{r['per_contact']:.0f}",
                       f"{r['per_contact'] / equal:.2f}", f"{r['rebuilds']:.0f}",
                       f"{r['settled_unrest']:.1e}"] for r in data["rows"]],
             "note": NOTE}]


def draw(data, folder):
    fig, ax = style.figure(1, 1, 4.6, 2.0)
    rows = data["rows"][::-1]
    ax.barh([r["sizes"] for r in rows], [r["per_contact"] for r in rows], color=style.COLORS[5])
    ax.grid(False, axis="y")
    style.label(ax, "time per contact and step / ns", "")
    style.save(fig, folder, "bench_sizes")
    return [("bench_sizes", "Time per contact for spheres of different sizes.")]

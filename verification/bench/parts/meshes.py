"""Many mesh elements: far away, and as a finely cut floor."""
import style
from machinery import NOTE, cell, spread

TITLE = "Many mesh elements"
TEXT = """The packing of 10⁴ spheres in its box of five rectangles; the same with 100 352
triangles far out of reach; the same with its floor cut into 100 352 triangles (edge a fifth of
a radius), so that a sphere on the floor touches several at once. One thread."""
KINDS = {"five rectangles": "box", "and 100 352 triangles far away": "far",
         "floor of 100 352 triangles": "fine"}


def measure(bench, lmp):
    path = bench.state("packing", 200 if bench.smoke else 10_000)
    steps = {"steps": 10, "warm": 5} if bench.smoke else {"steps": 300, "warm": 50}
    results = bench.interleave({name: (lambda kind=kind: bench.time(path, mesh=kind, **steps))
                                for name, kind in KINDS.items()},
                               bench.repeats)
    return {"rows": [{"mesh": name, **r, "spread": spread(r)} for name, r in results.items()]}


def tables(data):
    first = data["rows"][0]["floor"]
    return [{"title": "10⁴ spheres in a box, one thread",
             "head": ["mesh", "ns per particle and step", "against five rectangles",
                      "contacts per particle", "with the mesh", "pairs per particle",
                      "ns per contact"],
             "rows": [[r["mesh"], cell(r), f"{r['floor'] / first:.2f}", f"{r['contacts']:.2f}",
                       f"{r['wall_contacts']:.2f}", f"{r['pairs']:.2f}",
                       f"{r['floor'] / r['contacts']:.0f}"] for r in data["rows"]],
             "note": NOTE}]


def draw(data, folder):
    fig, ax = style.figure(1, 1, 4.8, 2.0)
    rows = data["rows"][::-1]
    ax.barh([r["mesh"] for r in rows], [r["floor"] for r in rows], color=style.COLORS[5])
    ax.grid(False, axis="y")
    style.label(ax, "time per particle and step / ns", "")
    style.save(fig, folder, "bench_meshes")
    return [("bench_meshes", "Time of a step with many mesh elements.")]

"""Bytes per particle: peak of a process that loads a packing and runs some steps."""
import os
from pathlib import Path

import style
from machinery import MATERIAL, SMOOTH
from parts.scaling import prepare, settled

TITLE = "Memory"
TEXT = """A fresh process loads the packing, runs 300 steps and builds two more lists. Peak:
the most resident memory it ever had, less that of the process before it loaded anything, per
particle. Resident: what it holds at the end. LAMMPS: the difference of the peaks of two
packings over the difference in particles."""
VARIANTS = {"full model": {}, "orientations off": {"orientation": "off"},
            "no friction": SMOOTH, "full model, float": {"float": True}}


def lammps_peak(lmp, data, box):
    """Peak of LAMMPS for one packing [bytes]."""
    lmp.run(data, MATERIAL, box, steps=5, warm=5)
    return lmp.peak


def measure(bench, lmp):
    n, small = (3000, 200) if bench.smoke else (100_000, 1000)
    rows = []
    if not Path("/proc/self/status").exists():
        return {"rows": rows}
    path = settled(bench, "packing", n)
    for name, change in VARIANTS.items():
        change = dict(change)
        program = "bench_float" if change.pop("float", False) else "bench"
        if not os.access(bench.build / program, os.X_OK):
            continue
        words = bench.words({**MATERIAL, **change, "steps": 20 if bench.smoke else 300})
        rows.append({"variant": name, "N": n,
                     **bench.call("memory", path, *words, program=program)})
    if lmp.here:
        peaks = []
        for size in (n, small):
            box, data = prepare(bench, settled(bench, "packing", size))
            peaks.append(lammps_peak(lmp, data, box))
        rows.append({"variant": "LAMMPS, full model", "N": n,
                     "peak": (peaks[0] - peaks[1]) / (n - small)})
    return {"rows": rows}


def tables(data):
    if not data["rows"]:
        return [{"title": "Not measured: this needs /proc, as on Linux", "head": [], "rows": []}]

    def cell(row, name):
        return f"{row[name]:.0f}" if name in row else "–"
    names = ("peak", "peak_loading", "resident", "grain", "springs", "pair")
    return [{"title": f"Bytes per particle, packing of {data['rows'][0]['N']:,}".replace(",", " "),
             "head": ["", "peak", "peak while loading", "resident at the end", "one particle",
                      "springs of one contact", "one pair"],
             "rows": [[r["variant"], *(cell(r, name) for name in names)] for r in data["rows"]],
             "note": "The last three columns are sizes of structs."}]


def draw(data, folder):
    if not data["rows"]:
        return []
    fig, ax = style.figure(1, 1, 4.6, 2.2)
    rows = data["rows"][::-1]
    ax.barh([r["variant"] for r in rows], [r["peak"] for r in rows], color=style.COLORS[5],
            label="peak")
    some = [r for r in rows if "resident" in r]
    ax.barh([r["variant"] for r in some], [r["resident"] for r in some], height=0.4,
            color=style.COLORS[0], label="at the end")
    style.label(ax, "bytes per particle", "")
    ax.set_xlim(0, 1.3 * max(r["peak"] for r in rows))
    ax.legend(loc="lower right")
    ax.grid(False, axis="y")
    style.save(fig, folder, "bench_memory")
    return [("bench_memory", "Resident memory per particle.")]

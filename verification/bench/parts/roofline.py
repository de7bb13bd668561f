"""How far from what the machine can do: arithmetic and traffic of a step against their limits."""
import numpy as np

import style
from machinery import highest, spread
from parts.scaling import settled

TITLE = "Roofline"
TEXT = """The arithmetic of one contact is counted by running the solver's own law with a number
type that counts; that of a moved particle with a transcription that must give the solver's
bits. Traffic is what the two phases of a step read and write if nothing of the first phase is
still in a cache in the second: 4 structs of a particle, 2 of each pair, 2 of the springs of
each contact. The machine's limits are measured by the bench itself: bandwidth of a = b + s c
(in memory, and in 512 kB), additions and multiplications in independent vector instructions
without fused multiply-add, divisions, square roots. One division or root costs as much as the
table says, so the ceiling for the law's mix is lower than that for additions and
multiplications. One thread."""
KINDS = ("plain", "divisions", "roots")


def measure(bench, lmp):
    sizes = (200,) if bench.smoke else (1000, 10_000, 100_000) + bench.large * (1_000_000,)
    steps = {1000: 1500, 10_000: 200, 100_000: 40}
    counts = bench.call(program="bench_count")
    short = ["short"] if bench.smoke else []
    limits = bench.interleave({
        f"{t}": (lambda t=t: bench.call(*short, threads=t, program="bench_machine",
                                        wrap=bench.wrap)) for t in (1, 2)},
        bench.repeats, highest)
    times = bench.interleave({
        n: (lambda n=n: bench.time(settled(bench, "packing", n), steps=steps.get(n, 20), warm=20))
        for n in sizes}, bench.repeats)
    rows = [{"N": n, **r, "spread": spread(r), **work(r, counts)} for n, r in times.items()]
    return {"rows": rows, "counts": counts, "limits": limits}


def work(r, counts):
    """Operations and bytes per particle and step: {plain, divisions, roots, bytes}."""
    total = {k: r["contacts"] * counts[f"contact_{k}"] + r["pairs"] * counts[f"pair_{k}"]
             + counts[f"motion_{k}"] for k in KINDS}
    return {**total, "bytes": 4 * counts["grain"] + 2 * r["pairs"] * counts["pair"]
            + 2 * r["contacts"] * counts["springs"]}


def shortest(row, limits):
    """Time of the arithmetic, if all units were always busy, one after the other [ns]."""
    return 1e9 * sum(row[k] / limits[k] for k in KINDS)


def tables(data):
    c, one, two = data["counts"], data["limits"]["1"], data["limits"]["2"]
    kinds = [("a contact, full model", "contact"), ("a contact with sliding only", "sliding"),
             ("a contact without friction", "frictionless"), ("a pair that is tested", "pair"),
             ("a particle that is moved", "motion")]
    limits = [("bandwidth, memory [GB/s]", "bandwidth_memory"),
              ("bandwidth, 512 kB [GB/s]", "bandwidth_cache"),
              ("additions and multiplications [10⁹/s]", "plain"),
              ("divisions [10⁹/s]", "divisions"), ("square roots [10⁹/s]", "roots")]
    return [
        {"title": "Arithmetic of the law, counted",
         "head": ["", "+ − ×", "÷", "√", "comparisons"],
         "rows": [[name, *(f"{c[f'{k}_{w}']:.0f}" for w in (*KINDS, "comparisons"))]
                  for name, k in kinds],
         "note": f"A particle is {c['grain']:.0f} bytes, a pair {c['pair']:.0f}, the springs of a "
                 f"contact {c['springs']:.0f}."},
        {"title": "Limits of this machine, measured", "head": ["", "1 thread", "2 threads"],
         "rows": [[name, f"{one[k] / 1e9:.2f}", f"{two[k] / 1e9:.2f}"] for name, k in limits]},
        {"title": "A step of a settled packing against them, one thread",
         "head": ["N", "ns per particle", "10⁹ operations/s", "bytes", "operations per byte",
                  "arithmetic alone, ns", "traffic from memory alone, ns", "share of the larger"],
         "rows": [[f"{r['N']:,}".replace(",", " "), f"{r['floor']:.0f}",
                   f"{operations(r) / r['floor']:.2f}", f"{r['bytes']:.0f}",
                   f"{operations(r) / r['bytes']:.2f}", f"{shortest(r, one):.0f}",
                   f"{1e9 * r['bytes'] / one['bandwidth_memory']:.0f}",
                   f"{100 * bound(r, one) / r['floor']:.0f} %"] for r in data["rows"]],
         "note": "Operations: + − × ÷ √ alike. Small packings stay in a cache, where memory sets "
                 "no limit; there the share refers to memory all the same if that is the larger."}]


def bound(row, limits):
    return max(shortest(row, limits), 1e9 * row["bytes"] / limits["bandwidth_memory"])


def operations(row):
    return sum(row[k] for k in KINDS)


def draw(data, folder):
    fig, ax = style.figure(1, 1, 4.8, 3.3)
    one, rows = data["limits"]["1"], data["rows"]
    x = np.geomspace(0.05, 100, 200)
    for k, (key, name) in enumerate((("bandwidth_memory", "memory"),
                                     ("bandwidth_cache", "512 kB (cache)"))):
        ax.loglog(x, np.minimum(x * one[key], one["plain"]) / 1e9, label=f"roof: {name}",
                  **style.cycle(k, marker=False))
    mix = operations(rows[-1]) / shortest(rows[-1], one)
    ax.axhline(mix, color="0.4", linewidth=1, linestyle=(0, (2, 1.5)),
               label="the law's mix with ÷ and √")
    for k, r in enumerate(rows):
        ax.loglog([operations(r) / r["bytes"]], [operations(r) / r["floor"]], linestyle="none",
                  color=style.COLORS[2 + k], marker=style.MARKERS[k], label=f"N = {r['N']:g}")
    style.label(ax, "operations per byte", "10⁹ operations per second", "one thread")
    ax.legend(loc="lower right", fontsize=6.5)
    ax.set_xlim(0.05, 100)
    ax.set_ylim(0.3, 2 * one["plain"] / 1e9)
    style.save(fig, folder, "bench_roofline")
    return [("bench_roofline", "Roofline: what memory and arithmetic allow, and what a step does.")]

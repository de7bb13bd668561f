"""What accuracy costs: error of oblique impacts over the processor time of a simulated second."""
import subprocess

import numpy as np

import style
from machinery import MATERIAL, read_state
from parts.scaling import geometry, prepare

TITLE = "Speed against error"
TEXT = """Case 08 of the verification: a sphere hits a plate at 1 m/s between 5 and 85 degrees
(full model, e_n = 0.5); the rms error of the rebound against an event-driven reference, as a
share of the impact speed, over the step in units of Eq. (50). The price of a step is that of
one particle in the settled packing of 10⁴ spheres, measured here in turn, so that a second
simulated with a thousandth of error has a price in processor time. LAMMPS' price of a step
stands beside as a scale; its error is not measured here (its velocity Verlet and lever arms
differ, its spring is advanced before the force as in *consistent*)."""
SCHEMES = ("consistent", "paper")


def impacts(bench):
    """Work of case 08, measured if it is missing: {method, dt_over_eq50, error, ...}. In a smoke
    run nothing: those impacts are a test of their own."""
    out = bench.states / "08_oblique"
    if bench.smoke:
        empty = np.array([])
        return {"method": np.array([], str), "dt_over_eq50": empty, "error": empty}
    if not (out / "work.csv").exists():
        subprocess.run([bench.build.parent / "08_oblique", out], check=True, capture_output=True)
    return style.read(out / "work.csv")


def measure(bench, lmp):
    path = bench.state("packing", 200 if bench.smoke else 10_000)
    steps = {"steps": 10, "warm": 5} if bench.smoke else {"steps": 150, "warm": 50}
    jobs = {scheme: (lambda scheme=scheme: bench.time(path, scheme=scheme, **steps))
            for scheme in SCHEMES}
    if lmp.here:
        box, data = prepare(bench, path)
        jobs["LAMMPS"] = lambda: lmp.run(data, MATERIAL, box, skin=0.5, wrap=bench.wrap, **steps)
    price = {k: r["floor"] for k, r in bench.interleave(jobs, bench.repeats).items()}
    dt0, work, rows = geometry(read_state(path))["dt"], impacts(bench), []
    for scheme in SCHEMES:
        some = style.where(work, method=scheme)
        rows += [{"scheme": scheme, "step": float(h), "error": float(e),
                  "cpu_ms": 1e-6 * price[scheme] / (h * dt0)}
                 for h, e in sorted(zip(some["dt_over_eq50"], some["error"]), reverse=True)]
    return {"rows": rows, "price": price, "dt": dt0}


def tables(data):
    steps = sorted({r["step"] for r in data["rows"]}, reverse=True)
    def find(scheme, step):
        return next((r for r in data["rows"] if r["scheme"] == scheme and r["step"] == step), None)
    lines = []
    for step in steps:
        cells = [f"{step:.3g}"]
        for scheme in SCHEMES:
            r = find(scheme, step)
            cells += [f"{100 * r['error']:.2g} %", f"{r['cpu_ms']:.2g}"] if r else ["–", "–"]
        lines.append(cells)
    prices = ", ".join(f"{k} {v:.0f} ns" for k, v in data["price"].items())
    return [{"title": "Error of the rebound, and processor time per particle and simulated second",
             "head": ["step / Eq. (50)", "consistent: error", "ms", "paper: error", "ms"],
             "rows": lines, "note": f"Price of a step and particle: {prices}; "
                                    f"step of Eq. (50) for R = 5 mm: {1e6 * data['dt']:.0f} µs."}]


def draw(data, folder):
    fig, ax = style.figure(1, 1, 4.6, 3.1)
    for scheme in SCHEMES:
        rows = [r for r in data["rows"] if r["scheme"] == scheme]
        ax.loglog([r["cpu_ms"] for r in rows], [100 * r["error"] for r in rows],
                  **style.LINE[scheme], label=scheme)
    if "LAMMPS" in data["price"]:
        ax.axvline(1e-6 * data["price"]["LAMMPS"] / data["dt"], color="0.4", linewidth=1,
                   linestyle=(0, (2, 1.5)), label="LAMMPS at the step of Eq. (50)")
    style.label(ax, "processor time per particle and simulated second / ms",
                "rms error of the rebound / %", "oblique impacts")
    ax.legend()
    style.save(fig, folder, "bench_accuracy")
    return [("bench_accuracy", "Error of oblique impacts over what it costs.")]

#!/usr/bin/env python3
"""The cooling of a granular gas against Haff's law: measure.py OUTPUT [OUTPUT ...]"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402


def cooling(run):
    """Times [T] and energies [ML^2/T^2] of the frames, kinetic and elastic (in the contacts)."""
    log = run.log
    return log["t"], log["kinetic"] + log["elastic"]


def theory(run, energy):
    """tau [T] by kinetic theory: all, of the pairs alone, of the walls alone."""
    first = run.frame(0)
    side = max(e.corners.max() for e in run.mesh) - min(e.corners.min() for e in run.mesh)
    return flow.haff_time(run.scene, first["R"][0], len(first), side, energy)


def draw(runs, expected):
    """The figure; expected: tau of each run by theory."""
    fig, (left, right) = result.figure(1, 2)
    for k, run in enumerate(runs):
        t, energy = cooling(run)
        tau = expected[k]
        left.loglog(t[1:] / tau, energy[1:] / energy[0], ".", color=result.COLORS[k % 7],
                    label="program" if k == 0 else None)
        right.plot(t / tau, np.sqrt(energy[0] / energy) - 1, ".", color=result.COLORS[k % 7])
    x = np.geomspace(t[1] / tau, t[-1] / tau, 100)
    left.loglog(x, 1 / (1 + x)**2, "k", linewidth=1, label=r"Haff: $(1 + t/\tau)^{-2}$")
    right.plot([0, x[-1]], [0, x[-1]], "k", linewidth=1)
    left.legend()
    result.label(left, r"time / $\tau$ of kinetic theory", r"energy / $E_0$")
    result.label(right, r"time / $\tau$ of kinetic theory", r"$\sqrt{E_0/E} - 1$")
    return fig


def main(runs, where):
    """Measure runs, write to the folder where."""
    report = result.Report(where)
    ratios, expected = [], []
    for run in runs:
        t, energy = cooling(run)
        tau, error = flow.haff_fit(t, energy)
        all_, pairs, walls = theory(run, energy[0])
        name = f" of {run.folder.name}" if len(runs) > 1 else ""
        report.add(f"tau{name}", tau, error, "s",
                   f"{all_:.4f}, kinetic theory; pairs alone {pairs:.3f}, walls alone {walls:.3f}")
        power, power_error = flow.haff_exponent(t, energy, tau)
        report.add(f"exponent of the decay{name}", power, power_error, expected="2, Haff")
        ratios.append(tau / all_)
        expected.append(all_)
    if len(runs) > 1:
        report.add("tau / theory, all runs", *result.mean_error(ratios), expected="1")
    report.add("energy gained in any frame, largest share",
               max(np.diff(energy).max() / energy[0], 0), expected="0: it only falls")
    report.save(draw(runs, expected))


if __name__ == "__main__":
    main(*result.arguments(__doc__))

#!/usr/bin/env python3
"""Speed profile of the flow down a rough chute against Bagnold's: measure.py OUTPUT [..]"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import flow  # noqa: E402
import result  # noqa: E402
from frames import columns, fail  # noqa: E402

STEADY = 1.7  # from when the flow has filled the chute [s]
REACH = (0.35, 0.85)  # the part of the chute that is measured, along x [m]
BASE, TOP = 1.0, 0.8  # of the fit: above so many diameters, below this share of the depth


def collect(run):
    """Grains of the steady flow: x, z, R, vx (n, 4), frame of each (n,), number of frames."""
    grains, owner = [], []
    for number, frame in run.frames():
        if run.time(number) >= STEADY:
            here = (frame["x"] > REACH[0]) & (frame["x"] < REACH[1]) & (frame["z"] > 0)
            grains.append(columns(frame[here], "x,z,R,vx"))
            owner.append(np.full(len(grains[-1]), len(grains) - 1))
    if len(grains) < 8 or len(grains[0]) < 100:
        fail(f"{run.folder}: {len(grains)} frames of a steady flow after {STEADY} s; try: more "
             "Nframes, or a steeper g")
    return np.vstack(grains), np.concatenate(owner), len(grains)


def profile(grains, owner, frames, d, blocks=5):
    """Centres z, mean speed, its error and packing (bins,) of layers one diameter d thick.

    The error comes from the means of blocks of frames.
    """
    edges = d * np.arange(0, 20)
    block = owner * blocks // frames
    v = np.array([flow.binned(grains[block == k, 1], grains[block == k, 3], edges)[0]
                  for k in range(blocks)])
    area = np.histogram(grains[:, 1], edges, weights=np.pi * grains[:, 2]**2)[0]
    packing = area / (frames * d * (REACH[1] - REACH[0]))
    good = np.isfinite(v).all(axis=0) & (packing > 0.05)
    z = (edges[1:] + edges[:-1]) / 2
    return z[good], v.mean(axis=0)[good], v.std(axis=0, ddof=1)[good] / blocks**0.5, packing[good]


def depth(z, packing, d):
    """Height [L] of the surface: a flow of this depth with the packing of the middle layers has as
    many grains as there are."""
    inner = np.median(packing[2:len(packing) // 2 + 2])
    return packing.sum() * d / inner


def draw(z, v, dv, packing, h, d, best):
    """The figure: speed and packing over height, with the fit and Bagnold's exponent."""
    fig, (left, right) = result.figure(1, 2)
    fine = np.linspace(0, h, 200)
    left.errorbar(v, z / d, xerr=dv, fmt="o", color=result.COLORS[0], markerfacecolor="w",
                  label="program")
    left.plot(flow.bagnold(fine, h, *best), fine / d, color=result.COLORS[1],
              label=f"exponent {best[2]:.2f}, fitted")
    fit = (z > BASE * d) & (z < TOP * h)
    shape = flow.bagnold(z[fit], h, 0, 1)
    line = flow.line_fit(shape, v[fit], dv[fit])
    left.plot(flow.bagnold(fine, h, line.a, line.b), fine / d, "k--", linewidth=1,
              label="exponent 3/2, Bagnold")
    left.axhspan(BASE, TOP * h / d, color="0.95", zorder=0)
    left.legend()
    result.label(left, "speed along the chute / (m/s)", "height / diameters", "grey: of the fit")
    right.plot(packing, z / d, "o-", color=result.COLORS[2], markerfacecolor="w")
    right.axhline(h / d, color="k", linewidth=1)
    right.set(xlim=(0, 1))
    result.label(right, "share of the area", "height / diameters", "line: depth of the flow")
    return fig


def measure_one(run):
    """Of a run: exponent and its error, depth [d], mean speed and its error, late / early and
    second / first half of the reach; and what draw() needs."""
    grains, owner, frames = collect(run)
    d = 2 * grains[:, 2].mean()
    z, v, dv, packing = profile(grains, owner, frames, d)
    h = depth(z, packing, d)
    fit = (z > BASE * d) & (z < TOP * h)
    best, error = flow.bagnold_fit(z[fit], v[fit], dv[fit], h)
    late, far = owner >= frames // 2, grains[:, 0] > np.mean(REACH)
    means = [grains[owner == k, 3].mean() for k in range(frames)]
    steady, developed = (grains[who, 3].mean() / grains[~who, 3].mean() for who in (late, far))
    return (best[2], error[2], h / d, *flow.block_mean(means), steady, developed), (
        z, v, dv, packing, h, d, best)


def main(runs, where):
    """Measure runs, write to the folder where; the figure shows the first."""
    report = result.Report(where)
    measured = [measure_one(run) for run in runs]
    for run, (numbers, _) in zip(runs, measured):
        exponent, error, deep, speed, speed_error, steady, developed = numbers
        name = f", {run.folder.name}" if len(runs) > 1 else ""
        g = run.scene["g"]
        report.add(f"slope of the chute{name}", np.degrees(np.arctan2(g[0], -g[2])), unit="degrees")
        report.add(f"depth of the flow{name}", deep, unit="diameters")
        report.add(f"exponent n of v = v_0 + A (1 - (1 - z/h)^n){name}", exponent, error,
                   expected="3/2, Bagnold; 1 would be a constant rate of shear")
        report.add(f"mean speed{name}", speed, speed_error, "m/s")
        report.add(f"mean speed, late / early{name}", steady, expected="1, steady")
        report.add(f"mean speed, second / first half of the reach{name}", developed,
                   expected="1, fully developed")
    if len(runs) > 1:
        report.add("exponent n, all runs", *result.mean_error([one[0][0] for one in measured]),
                   expected="3/2, Bagnold")
    report.save(draw(*measured[0][1]))


if __name__ == "__main__":
    main(*result.arguments(__doc__))

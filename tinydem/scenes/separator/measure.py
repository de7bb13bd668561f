#!/usr/bin/env python3
"""How evenly the stream is split, and how well the two halves are mixed in the bed.

    measure.py OUTPUT [OUTPUT ...]     each run counts as one observation
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import packing  # noqa: E402
import result  # noqa: E402
from frames import columns, fail, speed  # noqa: E402

GATE, BED, HALF = 0.38, 0.24, 0.09  # heights of the gate and of the bin's rim, half its width [m]
LEFT, RIGHT = "#f5b229", "#215f9f"  # the two dyes, as in the pictures


def final_bed(run):
    """Places (n, 3) and dye (n,) of the grains at rest in the bin, and how many went right."""
    dye = packing.Dye(("x", 0.0), ("z", GATE))
    for _, frame in run.frames():
        side = dye.value(frame)
    bed = (frame["z"] < BED) & (side < 2) & (speed(frame) < 0.1)
    if bed.sum() < 50:
        fail(f"{run.folder}: hardly a grain has reached the bin; try: a larger --Nframes")
    return columns(frame, "x,y,z")[bed], side[bed], (side == 1).sum(), (side < 2).sum()


def main():
    """Pattern of one run, numbers of all."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    beds = [final_bed(run) for run in runs]
    right, all_of = sum(bed[2] for bed in beds), sum(bed[3] for bed in beds)
    report.add("share of the stream that went right", *result.share_error(right, all_of), "",
               "0.5; runs differ by more than the counting error")
    mixing, thrown = [], []
    for run, (x, side, _, _) in zip(runs, beds):
        mixing.append(packing.lacey(*cell_counts(x, side, run)))
        thrown.append(np.mean((side == 1) == (x[:, 0] < 0)))
    scatter = np.nan if len(runs) > 1 else np.std(bootstrap(beds[0], runs[0]), ddof=1)
    value, error = result.mean_error(mixing)
    report.add("mixing index of Lacey, cells of 4 diameters", value,
               error if len(runs) > 1 else scatter, "", "between 0 (unmixed) and 1 (random)")
    value, error = result.mean_error(thrown)
    if len(runs) == 1:
        error = result.share_error(value * len(beds[0][0]), len(beds[0][0]))[1]
    report.add("share of grains that crossed to the other half", value, error, "", "0.5 if random")
    report.save(draw(*beds[0][:2]))


def cell_counts(x, side, run):
    """Grains and grains from the right in cells of four diameters: two arrays (cells,)."""
    low, high = x.min(axis=0), x.max(axis=0)
    shape = np.maximum(((high - low) / (8 * run.scene["Rmax"])).astype(int), 1)
    return [a.ravel() for a in packing.shares(x, side, low, high, shape)]


def bootstrap(bed, run, times=20):
    """Mixing indices of cells drawn at random, with repetition: how much one bed tells."""
    counts, reds = cell_counts(*bed[:2], run)
    random = np.random.default_rng(1)
    picks = (random.integers(0, len(counts), len(counts)) for _ in range(times))
    return [packing.lacey(counts[pick], reds[pick]) for pick in picks]


def draw(x, side):
    """The dispersion pattern: a map of the share of the right dye, and its profile across."""
    fig, ax = result.figure(1, 2, width=3.7)
    edges = np.linspace(-HALF, HALF, 25), np.arange(0, x[:, 2].max(), 0.0075)
    counts = np.histogram2d(x[:, 0], x[:, 2], edges)[0]
    blue = np.histogram2d(x[side == 1, 0], x[side == 1, 2], edges)[0]
    share = np.where(counts > 3, blue / np.maximum(counts, 1), np.nan)
    colors = result.plt.matplotlib.colors.LinearSegmentedColormap.from_list("", [LEFT, "w", RIGHT])
    image = ax[0].pcolormesh(100 * edges[0], 100 * edges[1], share.T, cmap=colors, vmin=0, vmax=1)
    fig.colorbar(image, ax=ax[0], label="share of grains from the right")
    ax[0].set_aspect("equal")
    result.label(ax[0], "x / cm", "z / cm", "dispersion pattern in the bed")
    n, b = counts.sum(axis=1), blue.sum(axis=1)
    value, error = result.share_error(b, np.maximum(n, 1))
    middle = (edges[0][1:] + edges[0][:-1]) / 2
    ax[1].errorbar(100 * middle[n > 0], value[n > 0], error[n > 0], fmt="o", color=RIGHT, capsize=2,
                   markerfacecolor="w")
    ax[1].axhline(0.5, color="0.3", linewidth=0.8)
    ax[1].set_ylim(0, 1)
    result.label(ax[1], "x / cm", "share from the right", "across the bed")
    return fig


if __name__ == "__main__":
    main()

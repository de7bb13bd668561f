#!/usr/bin/env python3
"""Which throats are bridged at the end, and the shape of the arches.

    measure.py OUTPUT [OUTPUT ...]     arches of all runs are put together
"""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # tinydem/
import packing  # noqa: E402
import result  # noqa: E402
from frames import speed  # noqa: E402

REST = 0.02  # m/s, slower grains count as resting
ABOVE = 12  # so many diameters above a throat its arch is looked for


def throats(run):
    """(middle x, height z, free width) [m] of every throat of the mesh, from the bottom up."""
    edges = [e for e in run.mesh if abs(np.subtract(*e.corners)[[0, 2]]).min() > 0]
    lips = sorted(tuple(e.corners[e.corners[:, 2].argmin()][[2, 0]]) for e in edges)
    radius = 2 * run.mesh[0].radius
    return [((a[1] + b[1]) / 2, a[0], b[1] - a[1] - radius) for a, b in zip(lips[::2], lips[1::2])]


def bridge(frame, middle, height, width):
    """Indices of the resting discs that bridge a throat; none if it is open, or filled from below.
    """
    d = 2 * frame["R"].max()
    below = np.abs(frame["z"] - height + 3 * d) < 2 * d
    if (below & (np.abs(frame["x"] - middle) < width / 2)).sum() > 2:
        return np.zeros(0, int)
    near = (frame["z"] > height - d) & (frame["z"] < height + ABOVE * d) & (speed(frame) < REST)
    near &= np.abs(frame["x"] - middle) < width + ABOVE * d
    index = np.flatnonzero(near)
    chain = packing.arch(frame["x"][index], frame["z"][index], frame["R"][index], middle, width)
    return index[chain]


def main():
    """Arches of all runs; the picture shows those of the first."""
    runs, where = result.arguments(__doc__)
    report = result.Report(where)
    fig, ax = result.figure(1, 2, width=3.9, height=3.9)
    found = {}  # free width in diameters: shapes of arches, None for an open throat
    for run in runs:
        frame = run.frame()
        d = 2 * run.scene["Rmax"]
        for middle, height, width in throats(run):
            chain = bridge(frame, middle, height, width)
            shape = packing.arch_shape(frame["x"], frame["z"], frame["R"], chain)
            shapes = found.setdefault(round(width / d), [])
            above = (frame["z"] > height) & (np.abs(frame["x"] - middle) < width)
            if len(chain) > 2:
                shapes.append(np.array(shape) / [d, d, 1])
            elif not above.any():  # all has passed; a throat that is filled from below is left out
                shapes.append(None)
            if run is runs[0]:
                draw(ax[0], frame, chain)
    for width, shapes in sorted(found.items(), reverse=True):
        arches = [s for s in shapes if s is not None]
        if shapes:
            report.add(f"throats of {width} diameters that are bridged",
                       *result.share_error(len(arches), len(shapes)), f"of {len(shapes)}")
        if arches:
            report.add(f"span of their arches ({width})",
                       *result.mean_error([s[0] for s in arches]), "d", f"{width} or more")
    arches = np.array([s for shapes in found.values() for s in shapes if s is not None])
    if len(arches):
        report.add("aspect ratio (height / half span)", *result.mean_error(arches[:, 2]), "",
                   f"about 1; {len(arches)} arches")
        ax[1].plot(arches[:, 0] / 2, arches[:, 1], "o", color=result.COLORS[1], markerfacecolor="w")
        top = 1.1 * max(arches[:, 0].max() / 2, arches[:, 1].max())
        ax[1].plot([0, top], [0, top], color="0.3", linewidth=0.9, label="aspect ratio 1")
        ax[1].set(xlim=(0, top), ylim=(0, top), aspect="equal")
        ax[1].legend(loc="upper left")
    result.label(ax[1], "half span / diameters", "height / diameters", "shape of the arches")
    report.save(fig)


def draw(ax, frame, chain):
    """The discs, in cm, and an arch in red."""
    points = result.plt.matplotlib.collections.EllipseCollection
    size = 200 * frame["R"]
    if not ax.collections:
        ax.add_collection(points(size, size, np.zeros(len(size)), units="xy", facecolor="0.82",
                                 edgecolor="none", transOffset=ax.transData,
                                 offsets=100 * np.column_stack([frame["x"], frame["z"]])))
        ax.set(aspect="equal", xlim=100 * np.array([frame["x"].min(), frame["x"].max()]),
               ylim=(0, 100 * frame["z"].max() + 1))
        result.label(ax, "x / cm", "z / cm", "arches at the end")
    chosen = frame[chain]
    size = 200 * chosen["R"]
    ax.add_collection(points(size, size, np.zeros(len(size)), units="xy", edgecolor="none",
                             facecolor=result.COLORS[1], transOffset=ax.transData,
                             offsets=100 * np.column_stack([chosen["x"], chosen["z"]])))


if __name__ == "__main__":
    main()

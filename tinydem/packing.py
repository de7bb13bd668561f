"""Measure packings: heaps, arches, mixtures, blocked throats, contacts.

Arrays: x (N, 3) places [L], R (N,) radii [L]. Every function works on plain arrays, so that it can
be tested on data with known answers (tests/test_packing.py).
"""
import numpy as np


# ----------------------------------------------------------------------------------- contacts

def pairs(x, R, gap=0.0):
    """Indices i < j (n,), (n,) of spheres whose surfaces are closer than `gap` [L].

    Cells of the largest diameter, as wide as two touching spheres can be apart: exact.
    """
    x, R = np.asarray(x, float), np.asarray(R, float)
    if len(x) < 2:
        return np.zeros(0, int), np.zeros(0, int)
    width = 2 * R.max() + max(gap, 0.0)
    cell = np.floor((x - x.min(axis=0)) / width).astype(np.int64) + 1
    size = cell.max(axis=0) + 2
    key = (cell[:, 0] * size[1] + cell[:, 1]) * size[2] + cell[:, 2]
    order = np.argsort(key, kind="stable")
    sorted_key, found = key[order], []
    for dx in (-1, 0, 1):
        for dy in (-1, 0, 1):
            for dz in (-1, 0, 1):
                other = key + (dx * size[1] + dy) * size[2] + dz
                first = np.searchsorted(sorted_key, other, "left")
                count = np.searchsorted(sorted_key, other, "right") - first
                i = np.repeat(np.arange(len(x)), count)
                j = order[np.repeat(first - np.cumsum(count) + count, count) + np.arange(len(i))]
                near = (i < j)
                i, j = i[near], j[near]
                near = ((x[i] - x[j])**2).sum(axis=1) < (R[i] + R[j] + gap)**2
                found.append(np.stack([i[near], j[near]]))
    i, j = np.concatenate(found, axis=1)
    order = np.lexsort((j, i))
    return i[order], j[order]


def coordination(x, R, gap=0.0):
    """Number of other spheres (N,) that each sphere touches; its mean is called Z."""
    i, j = pairs(x, R, gap)
    return np.bincount(np.concatenate([i, j]), minlength=len(x))


def packing_fraction(x, R, low, high, cells=48):
    """Share of the box low..high (3,) [L] that is inside of spheres.

    Counts the midpoints of cells^3 small cells, so spheres that the box cuts count with what is
    inside. The error is about 0.001 when a sphere is 20 small cells wide, up to 0.01 if the spheres
    are a lattice in step with the cells. Overlaps count once.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    step = (high - low) / cells
    axes = [low[k] + step[k] * (np.arange(cells) + 0.5) for k in range(3)]
    full = np.zeros((cells,) * 3, bool)
    for centre, radius in zip(np.asarray(x), np.asarray(R)):
        first = np.clip(((centre - radius - low) / step).astype(int), 0, cells)
        last = np.clip(((centre + radius - low) / step).astype(int) + 1, 0, cells)
        if (first >= last).any():
            continue
        d = [(axes[k][first[k]:last[k]] - centre[k])**2 for k in range(3)]
        inside = d[0][:, None, None] + d[1][None, :, None] + d[2][None, None, :] < radius**2
        full[tuple(slice(a, b) for a, b in zip(first, last))] |= inside
    return full.mean()


# -------------------------------------------------------------------------------------- heaps

def surface(across, height, R, width):
    """Profile of a heap: middles (b,) of bins of `width` [L], top (b,) of the highest sphere there.

    Bins without a sphere are left out. across, height (N,): horizontal and vertical places [L].
    """
    low = across.min()
    index = np.floor((across - low) / width).astype(int)
    top = np.full(index.max() + 1, -np.inf)
    np.maximum.at(top, index, height + R)
    full = np.isfinite(top)
    return low + width * (np.flatnonzero(full) + 0.5), top[full]


def line_fit(x, y):
    """Slope, intercept and the standard error of the slope of a straight line through points."""
    if len(x) < 3:
        return np.nan, np.nan, np.nan
    dx = x - x.mean()
    slope = (dx * y).sum() / (dx * dx).sum()
    rest = y - y.mean() - slope * dx
    error = np.sqrt((rest * rest).sum() / (len(x) - 2) / (dx * dx).sum())
    return slope, y.mean() - slope * x.mean(), error


def angle_of_repose(across, height, R, window=(0.15, 0.85)):
    """Slopes of the two flanks of a heap and what was fitted.

    across, height (N,) [L]: places of the grains at rest; window: the part of the height that is
    fitted, without the rounded top and the foot. Returns angles (2,) [deg], left and right, their
    errors (2,) [deg] from the scatter of the profile, and lines: a list of two (x (b,), fitted z
    (b,)). Bins are 1.5 mean diameters wide; their tops stand on average below the true surface by
    the same amount everywhere, which does not change the slope.
    """
    x, z = surface(across, height, R, 3 * np.mean(R))
    # The summit is a plateau of noise: its middle, weighted by height.
    high = z > 0.9 * z.max()
    summit = np.average(x[high], weights=z[high])
    angles, errors, lines = [], [], []
    for side in (-1, 1):
        flank = (side * (x - summit) > 0) & (z > window[0] * z.max()) & (z < window[1] * z.max())
        slope, shift, error = line_fit(x[flank], z[flank])
        angles.append(np.degrees(np.arctan(abs(slope))))
        errors.append(np.degrees(error / (1 + slope**2)))
        lines.append((x[flank], slope * x[flank] + shift))
    return np.array(angles), np.array(errors), lines


def surface_slope(across, height, R, reach):
    """Angle [deg] and its error of one inclined surface, from bins with |across| < reach [L]."""
    x, z = surface(across, height, R, 3 * np.mean(R))
    middle = np.abs(x) < reach
    slope, _, error = line_fit(x[middle], z[middle])
    return np.degrees(np.arctan(slope)), np.degrees(error / (1 + slope**2))


# ------------------------------------------------------------------------------------ throats

def arrest(times, passed, waiting, quiet):
    """When the flow through a throat stopped for good, nan if it did not.

    times (n,) [T], passed (n,): grains below the throat, waiting (n,): grains above it. Arrested:
    at the end some still wait and none has passed for the last `quiet` [T]. The answer is the time
    of the first frame at which the last of them was through.
    """
    times, passed = np.asarray(times), np.asarray(passed)
    last = int(np.argmax(passed == passed[-1]))
    stopped = waiting[-1] > 0 and times[-1] - times[last] >= quiet
    return times[last] if stopped else np.nan


def arch(across, height, R, middle, width):
    """The grains that bridge a throat in a plane, seen from below.

    across, height, R (N,) [L]: discs above the throat, which is `width` wide around `middle`.
    Going over it from left to right, from the middle of one foot to that of the other, which rest
    on the lips of the throat, the lowest disc above every point belongs to the arch.
    Returns their indices from left to right; empty if something gapes wider than a diameter.
    """
    if not len(across):
        return np.zeros(0, int)
    samples = middle + (width + 2 * R.max()) * (np.arange(400) + 0.5 - 200) / 400
    chord = R[:, None]**2 - (samples - across[:, None])**2
    bottom = np.where(chord >= 0, height[:, None] - np.sqrt(np.maximum(chord, 0)), np.inf)
    lowest = np.where(np.isfinite(bottom.min(axis=0)), bottom.argmin(axis=0), -1)
    chain = [k for n, k in enumerate(lowest) if k >= 0 and k not in lowest[:n]]
    gaps = [np.hypot(across[a] - across[b], height[a] - height[b]) - R[a] - R[b]
            for a, b in zip(chain, chain[1:])]
    return np.array(chain if not gaps or max(gaps) < 2 * R.max() else [], int)


def arch_shape(across, height, R, chain):
    """Span and height [L] of an arch, and its aspect ratio height / (span / 2).

    Both are those of the rectangle around the centres of the discs of the chain: a half
    circle has the aspect ratio 1.
    """
    if len(chain) < 3:
        return np.nan, np.nan, np.nan
    span, rise = np.ptp(across[chain]), np.ptp(height[chain])
    return span, rise, rise / (span / 2)


# ----------------------------------------------------------------------------------- mixtures

class Dye:
    """Side of a plane on which grains start or, if a gate is given, fall through that level."""

    def __init__(self, plane, gate=None):
        """plane, gate: (column, level [L])."""
        self.plane, self.gate, self.side = plane, gate, np.zeros(0)

    def value(self, frame):
        """0 below and 1 above the plane, 2 not yet there; (N,) for the next frame in time."""
        self.side = np.append(self.side, np.full(len(frame) - len(self.side), 2.0))
        there = self.side == 2
        if self.gate:
            there &= frame[self.gate[0]] < self.gate[1]
        self.side[there] = frame[self.plane[0]][there] > self.plane[1]
        return self.side.copy()


def shares(x, red, low, high, shape):
    """Grains and red ones in the cells of a grid: counts and reds, each an array of that shape.

    x (N, d) places [L] in d dimensions, red (N,) of 0 and 1, box low..high (d,), shape (d,).
    """
    box = list(zip(low, high))
    count = np.histogramdd(x, shape, box)[0]
    return count, np.histogramdd(x[np.asarray(red) > 0], shape, box)[0]


def lacey(counts, reds, least=5):
    """Lacey's mixing index of cells with so many grains and reds: 0 unmixed, 1 random.

    M = (S0 - S) / (S0 - Sr) with the variance S of the share of red grains over the cells, S0 = p
    (1 - p) of the unmixed and Sr = S0 / n of the random mixture, n: mean number of grains in a cell
    (harmonic, so that M = 1 for a random mixture in cells of unequal filling). Cells with fewer
    than `least` grains are left out. P. M. C. Lacey, J. Appl. Chem. 4 (1954) 257.
    """
    counts, reds = np.ravel(counts), np.ravel(reds)
    used = counts >= least
    counts, reds = counts[used], reds[used]
    p = reds.sum() / counts.sum()
    unmixed = p * (1 - p)
    if len(counts) < 2 or unmixed == 0:
        return np.nan
    weights = counts / counts.sum()
    variance = (weights * (reds / counts - p)**2).sum()
    random = unmixed * (len(counts) - 1) / counts.sum()
    return (unmixed - variance) / (unmixed - random)


# ------------------------------------------------------------------------------- large grains

def rise(cycles, height, top):
    """Cycles after which a mean height (n,) first exceeds `top` [L], interpolated; nan if never."""
    above = np.flatnonzero(height > top)
    if not len(above):
        return np.nan
    k = above[0]
    if k == 0:
        return cycles[0]
    part = (top - height[k - 1]) / (height[k] - height[k - 1])
    return cycles[k - 1] + part * (cycles[k] - cycles[k - 1])

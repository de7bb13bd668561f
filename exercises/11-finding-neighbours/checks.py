"""Exercise 11: finding neighbours."""
import math

from grader.course import check, number

TITLE = "Finding neighbours"
LEVEL = "**"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"cell_of": ("x y z size", "i j k"), "touching_pairs": ("", "")}
LIMITS = {"cpu": 1}  # a right answer needs 0.05 s, everybody against everybody 0.2 s
FINE = 2 ** 20  # coordinates are multiples of 1/FINE: all distances are exact, also after a shift


def grid(a):
    return round(a * FINE) / FINE


def scatter(ask, count, small=1.0, share=0.5, middle=(0.0, 0.0, 0.0)):
    """Spheres (x, y, z, R) at random in a cube, overlapping, with R between `small` and 1.

    share: of the volume that they would fill without overlaps; middle: of the cube.
    """
    radii = [grid(ask.uniform(small, 1)) for _ in range(count)]
    volume = sum(4 / 3 * math.pi * R * R * R for R in radii) / share
    low, high = 1.0, 1e3
    for _ in range(60):  # the edge of the cube, by halving: the same bits everywhere
        edge = (low + high) / 2
        low, high = (low, edge) if edge * edge * edge > volume else (edge, high)
    return [(*(grid(m + ask.uniform(-0.5, 0.5) * low) for m in middle), R) for R in radii]


def flat(spheres):
    return tuple(a for s in spheres for a in s)


def find(ask, spheres):
    """Asks for the pairs of some spheres: tests, looks, list of pairs."""
    numbers = ask.call("touching_pairs", [flat(spheres)])[0]
    pairs = [(int(i), int(j)) for i, j in zip(numbers[2::2], numbers[3::2])]
    return numbers[0], numbers[1], pairs


def in_words(spheres, pairs):
    """The first pair of a set, as text."""
    i, j = min(pairs)
    inside = 0 <= i < len(spheres) and 0 <= j < len(spheres)
    return f"({i}, {j})" + (f": {number(spheres[i])} and {number(spheres[j])}" if inside else "")


def compare(ask, spheres, got, want):
    """An outcome: how many pairs are missing, too many, or not in their order."""
    have, right = set(got), set(want)
    doubled = len(got) - len(have)
    swapped = {(i, j) for i, j in have - right if (j, i) in right}
    missing, more = {p for p in right - have if p[::-1] not in have}, have - right - swapped
    at, cause = "", ""
    if missing:
        at = f"missing: (x, y, z, R) of {in_words(spheres, missing)}"
    elif more:
        at = f"too many: (x, y, z, R) of {in_words(spheres, more)}"
        cause = "only pairs for which touch() is true, and no sphere with itself" if all(
            i == j for i, j in more) else "only pairs for which touch() is true"
    elif swapped or doubled:
        cause = "every pair once, with the smaller number first"
    bad = len(missing) + len(more) + len(swapped) + doubled
    return ask.outcome(bad and math.inf, f"{len(got)} pairs: {len(missing)} missing, {len(more)} "
                       f"too many, {doubled} doubled, {len(swapped)} as (j, i)",
                       f"{len(want)} pairs", at, cause)


def against_everybody(ask, spheres):
    """An outcome: the pairs of the answer and those of the reference."""
    numbers = ask.reference("touching_pairs", [flat(spheres)])[0]
    want = [(int(i), int(j)) for i, j in zip(numbers[::2], numbers[1::2])]
    return compare(ask, spheres, find(ask, spheres)[2], want)


@check("contract", 5, "Eq. (7)", sharp=True,
       cause="a list may be empty; a cell may hold many spheres, also at the very same place; a "
             "row of spheres has no height")
def few(ask):
    """No sphere, one, two, five at the same place, a row, a plane"""
    x, y, z = (grid(ask.uniform(-9, 9)) for _ in range(3))
    row = [(x + 1.5 * k, y, z, 1.0) for k in range(12)]
    plane = [(x, y + 1.5 * (k % 5), z + 1.5 * (k // 5), 1.0) for k in range(25)]
    return [against_everybody(ask, s) for s in (
        [], [(x, y, z, 1.0)], [(x, y, z, 1.0), (x, y + 1.75, z, 1.0)],
        [(x, y, z, 1.0), (x, y + 2.0, z, 1.0)], [(x, y, z, 0.5)] * 5, row, plane)]


@check("contract", 5, "memory for the spheres, not for the space", sharp=True,
       cause="an array for all cells between the outermost spheres; store only cells that hold "
             "one: a std::map, a sorted list, a table of buckets")
def escaped(ask):
    """A crowd, and two spheres that have flown a hundred thousand cells away"""
    far = tuple(ask.sign() * grid(ask.uniform(1.9e5, 2.1e5)) for _ in range(3))
    crowd = scatter(ask, 300)
    return against_everybody(ask, crowd + [(*far, 1.0), (far[0], far[1] + 1.5, far[2], 1.0)])


@check("pointwise", 8, "x in [i size, (i + 1) size)", sharp=True,
       cause="a conversion to int cuts towards zero: -0.3 becomes 0, but belongs into cell -1; "
             "std::floor always goes down")
def cells(ask):
    """The cell of a point: positive and negative coordinates, and points on the faces of cells"""
    rows = []
    for _ in range(40):
        size = grid(ask.log_uniform(1e-2, 10))
        rows.append((*(size * ask.uniform(-5, 5) for _ in range(3)), size))
    for k in range(-4, 5):  # on a face; sizes that can be multiplied and divided exactly
        rows += [(0.25 * k, 0.25 * k + 0.125, 0.25 * -k, 0.25), (8.0 * k, 0.0, 8.0 * k + 1, 8.0)]
    return ask.compare("cell_of", rows)


@check("pointwise", 14, "Eq. (7)", sharp=True,
       cause="cells of 2 R; each sphere against its own cell and all 26 around it, also those "
             "across the corners")
def pairs(ask):
    """Equal spheres around the origin: the same pairs as with everybody against everybody"""
    return [against_everybody(ask, scatter(ask, 150)) for _ in range(3)]


@check("pointwise", 13, "Eq. (7)", sharp=True,
       cause="the largest sphere decides: two of these touch from 2 R_max; cells of any other size "
             "miss some")
def sizes(ask):
    """Spheres of which the largest is five times the smallest, far from the origin"""
    outcomes = []
    for sign in -1.0, 1.0:
        middle = tuple(sign * ask.uniform(50, 100) for _ in range(3))
        spheres = scatter(ask, 400, 0.2, 0.5, middle)
        # Two large ones that just touch, apart from the rest; a small one comes first.
        a = tuple(grid(m + sign * 30) for m in middle)
        spheres[0] = (*spheres[0][:3], 0.2)
        spheres += [(*a, 1.0), (a[0], a[1], a[2] + 1.984375, 1.0)]
        outcomes.append(against_everybody(ask, spheres))
    return outcomes


def same_pairs(ask, spheres, moved, name=lambda i: i):
    """An outcome: the pairs of `spheres`, and those of the same spheres moved or renamed."""
    want = [tuple(sorted((name(i), name(j)))) for i, j in find(ask, spheres)[2]]
    if len(want) < len(spheres) / 2:
        return ask.outcome(math.inf, f"{len(want)} pairs of {len(spheres)} spheres",
                           "one or more for each sphere")
    outcome = compare(ask, moved, find(ask, moved)[2], want)
    outcome.measured += " afterwards"
    outcome.expected += " before"
    return outcome


@check("invariants", 8, "x -> x + a", sharp=True,
       cause="some pairs are missing, depending on where the faces of the cells happen to be: a "
             "neighbour cell was forgotten, or cells are too small")
def shift(ask):
    """Move everything: the same pairs"""
    outcomes = []
    for _ in range(3):
        spheres = scatter(ask, 250, 0.5)
        a = [grid(ask.uniform(-20, 20)) for _ in range(3)]
        moved = [(*(c + d for c, d in zip(s, a)), s[3]) for s in spheres]
        outcomes.append(same_pairs(ask, spheres, moved))
    return outcomes


@check("invariants", 8, "x, y, z exchanged and mirrored", sharp=True,
       cause="a direction in which cells are forgotten; the loops over the neighbours must treat "
             "all axes and both signs alike")
def turn(ask):
    """Turn and mirror everything: the same pairs"""
    outcomes = []
    for axes in (1, 2, 0), (2, 0, 1), (0, 2, 1):
        signs = [ask.sign() for _ in axes]
        spheres = scatter(ask, 250, 0.5)
        moved = [(*(g * s[k] for g, k in zip(signs, axes)), s[3]) for s in spheres]
        outcomes.append(same_pairs(ask, spheres, moved))
    return outcomes


@check("invariants", 9, "names exchanged", sharp=True,
       cause="the result depends on the order of the list: half of the neighbour cells is enough "
             "only if each pair of cells is met from one side; and i < j")
def renumber(ask):
    """Shuffle the list: the same pairs, under their new numbers"""
    outcomes = []
    for _ in range(3):
        spheres, new = scatter(ask, 250, 0.25), list(range(250))
        ask.random.shuffle(new)
        moved = [None] * 250
        for old, place in enumerate(new):
            moved[place] = spheres[old]
        outcomes.append(same_pairs(ask, spheres, moved, new.__getitem__))
    return outcomes


# In 27 cells of 2 R, each with 0.955 centres at this density, a sphere has 26 others, and each
# pair is tested once: 13, or 26 when both ask. A few less in a small crowd: it has more surface.
MOST_TESTS, MOST_LOOKS = 40, 200


@check("convergence", 15, "tests ~ N^1", sharp=True,
       cause="exponent 2: everybody against everybody; 4/3: cells along two axes only; 5/3: along "
             "one")
def cost(ask):
    """From 500 to 4000 spheres: tests and looks grow like N, and touch() alone makes the tests"""
    counts, tests, looks = [500, 1000, 2000, 4000], [], []
    crowds = [scatter(ask, n) for n in counts]
    want = ask.reference("summary", [flat(s) for s in crowds])
    for n, spheres, (right, total) in zip(counts, crowds, want):
        t, seen, found = find(ask, spheres)
        if len(found) != right or sum((i + 1) * (j + 1) for i, j in found) != total:
            return ask.outcome(math.inf, f"{len(found)} pairs of {n} spheres, or others",
                               f"{right:g} pairs", cause="the pairs are not the right ones")
        if t < 1.2 * right:
            return ask.outcome(math.inf, f"{t:g} tests for {right:g} pairs", "some more tests",
                               cause="distances that the answer has calculated itself; ask touch()")
        tests.append(t), looks.append(seen)
    exponents = [math.log(max(c[-1], 1) / max(c[0], 1)) / math.log(8) for c in (tests, looks)]
    each = tests[-1] / counts[-1], looks[-1] / counts[-1]
    good = max(exponents) < 1.2 and each[0] <= MOST_TESTS and each[1] <= MOST_LOOKS
    return ask.outcome(0 if good else math.inf,
                       f"{each[0]:.3g} tests and {each[1]:.3g} looks per sphere, exponents "
                       f"{exponents[0]:.2f}, {exponents[1]:.2f}",
                       f"at most {MOST_TESTS} and {MOST_LOOKS}, exponents up to 1.2",
                       f"{counts[-1]} spheres", "cells that are too large" if
                       max(exponents) < 1.2 else "")


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    crowds = [scatter(ask, 60, 0.5) for _ in range(3)]
    first = [find(ask, s)[2] for s in crowds]
    again = [find(ask, s)[2] for s in crowds[::-1]][::-1]
    ask.fresh()
    anew = [find(ask, s)[2] for s in crowds for _ in (0, 1)][::2]
    outcomes = [ask.same_bits("cell_of", [(*s[:3], 0.7) for s in crowds[0]])]
    for a, b, c in zip(first, again, anew):
        if not a:
            outcomes.append(ask.outcome(math.inf, "no pairs", "pairs",
                                        cause="touching_pairs does nothing yet"))
        elif not a == b == c:
            outcomes.append(ask.outcome(
                math.inf, f"{len(a)} pairs once, {len(b)} and {len(c)} later", "the same list",
                cause="a static or global variable"))
    return outcomes

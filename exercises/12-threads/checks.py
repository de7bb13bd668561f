"""Exercise 12: threads without races."""
import math
import os

from grader.course import Lost, check

TITLE, LEVEL = "Threads without races", "***"
#: threads, order (0: at the same time), spheres, R, E*, centres, pairs: see checks.cpp.
FUNCTIONS = {name: ("", "") for name in ("watched", "unwatched", "report", "seconds")}
LIMITS = {"cpu": 8, "memory": 4096, "wall": 15}


def packing(ask, side):
    """side^3 spheres, a little off a lattice, layer by layer: (spheres, R, E*, centres, pairs)."""
    R, spacing = 0.01, 0.0196
    x = [tuple(spacing * (c + 0.03 * ask.uniform(-1, 1))
               for c in (k // side ** 2, k // side % side, k % side)) for k in range(side ** 3)]
    pairs = []
    for k in range(side ** 3):
        for step, room in ((1, k % side), (side, k // side % side), (side ** 2, k // side ** 2)):
            if room < side - 1:
                pairs += [k, k + step]
    return (side ** 3, R, 5e5, *(c for a in x for c in a), *pairs)


def rows_of(spheres, settings):
    """A row for each (threads, order)."""
    return [(float(t), float(o), *map(float, spheres)) for t, o in settings]


def compare(ask, rows, name="watched"):
    """Worst error of a sum, relative to the largest force."""
    want = ask.reference("sums", rows[:1])[0]
    size = max(map(abs, want), default=0.0) or 1.0
    worst = ask.outcome(0)
    for row in rows:
        got = ask.call(name, [row])[0]
        errors = [abs(a - b) / size for a, b in zip(got, want)]
        k = max(range(len(errors)), key=errors.__getitem__, default=0)
        if errors and not errors[k] <= worst.error:
            worst = ask.outcome(errors[k], f"{got[k]:.8g}", f"{want[k]:.8g}",
                                f"component {'xyz'[k % 3]} of sphere {k // 3} of {len(want) // 3}, "
                                f"{row[0]:g} threads")
    return worst


# Tolerances: rounding. The formula is the one of the reference, only the order of a sum is not: 2e-16.
@check("contract", 10, "", sharp=True, tol=1e-15, unit="N",
       cause="a division by a number of spheres or threads that may be 0, or a share that is empty")
def few(ask):
    """No sphere, no pair, one pair; more threads than spheres"""
    two = (2, 0.01, 5e5, 0, 0, 0, 0.019, 0.001, 0, 0, 1)
    outcomes = [compare(ask, rows_of(two, [(t, o)])) for t in (1, 2, 8, 33) for o in (0, 5)]
    outcomes += [compare(ask, rows_of((0, 0.01, 5e5), [(t, 0)])) for t in (1, 8)]
    outcomes += [compare(ask, rows_of((3, 0.01, 5e5, *range(9)), [(t, 0)])) for t in (1, 2, 8)]
    return outcomes


@check("pointwise", 15, "Eqs. (1), (56)", tol=1e-15, unit="N",
       cause="the force of a pair belongs to i, its opposite to j")
def one_thread(ask):
    """The sums of a packing, by a team of one"""
    return compare(ask, rows_of(packing(ask, 6), [(1, 0)]))


@check("pointwise", 20, "Eqs. (1), (56)", tol=1e-15, unit="N",
       cause="a share of the pairs that nobody, or two threads, looked after")
def every_team(ask):
    """The sums by teams of 2, 3, 5, 8 and 16, at the same time and one after the other"""
    spheres = packing(ask, 6)
    return compare(ask, rows_of(spheres, [(t, o) for t in (2, 3, 5, 8, 16) for o in (0, t)]))


@check("invariants", 15, "", sharp=True,
       cause="the j of a pair may be in another thread's share: store its force, add it in a second "
             "team()")
def one_writer(ask):
    """In one team(), a sphere gets forces from one thread only"""
    spheres = packing(ask, 8)
    added = 0
    for row in rows_of(spheres, [(t, o) for t in (2, 3, 8) for o in (0, 3)]):
        clashes, sphere, first, second, _, _, all_added, _ = ask.call("report", [row])[0]
        added += all_added
        if clashes:
            return ask.outcome(math.inf, f"threads {first:g} and {second:g} add to sphere "
                               f"{sphere:g}, and {clashes - 1:g} more such cases", "none",
                               f"{row[0]:g} threads; with a lock the numbers are safe, but not "
                               "their order")
    return ask.outcome(0 if added else math.inf, "no force is added", "all of them")


@check("invariants", 10, "Eq. (56)", tol=5e-16, unit="(of the sum of sizes)",
       cause="a reaction is lost, or comes twice")
def momentum(ask):
    """All forces together are zero: to every action its reaction, for 1 and for 8 threads"""
    worst = ask.outcome(0)
    for row in rows_of(packing(ask, 7), [(1, 0), (8, 0), (8, 11)]):
        f = ask.call("watched", [row])[0]
        size = sum(map(abs, f))
        error = max(abs(sum(f[k::3])) for k in range(3)) / size if size else math.inf
        if not error <= worst.error:
            worst = ask.outcome(error, f"{error:.3g}", "0", f"{row[0]:g} threads")
    return worst


@check("convergence", 15, "", sharp=True,
       cause="all threads do the same, or one does it all: each needs its own share of the pairs, and "
             "of the spheres when they are summed up")
def shared(ask):
    """The busiest of n threads has 1/n of the forces to compute and of the sums to do"""
    spheres = packing(ask, 12)
    pairs = (len(spheres) - 3 - 3 * spheres[0]) // 2
    table = [ask.call("report", [row])[0][4:]
             for row in rows_of(spheres, [(t, 0) for t in (1, 2, 4, 8)])]
    speed_up(ask)
    for column, what in (1, "forces computed"), (3, "forces added"):
        busiest = [line[column] for line in table]
        slope = math.log(busiest[3] / busiest[0]) / math.log(8) if min(busiest) > 0 else 0.0
        if not -1.1 < slope < -0.85:
            return ask.outcome(math.inf, f"{what} by the busiest of 1, 2, 4, 8 threads: "
                               f"{', '.join(f'{b:g}' for b in busiest)}; exponent {slope:.2f}",
                               "exponent -1 (-1.1 to -0.85)")
    most = max(line[0] for line in table)
    return ask.outcome(0 if most <= 2 * pairs else math.inf,
                       f"{most:g} forces computed for {pairs} pairs", "each once, or twice")


def speed_up(ask):
    """Reports how much faster two threads are than one; not graded."""
    try:
        spheres = packing(ask, 30)
        one, two = (min(ask.call("seconds", [row])[0]) for row in rows_of(spheres, [(1, 0), (2, 0)]))
        ask.note(f"speed-up (not graded): {spheres[0]} spheres in {1e3 * one:.2g} ms by one "
                 f"thread, {1e3 * two:.2g} ms by two: {one / two:.2f} times as fast, on a machine "
                 f"with {os.cpu_count()} cores")
    except Lost:
        pass


@check("clean", 10, "", sharp=True,
       cause="the order in which a sphere gets its forces depends on the threads: cut the work into "
             "pieces whose number does not, or let each sphere collect its forces")
def same_bits(ask):
    """The same bits by 1, 2, 3 and 8 threads, in any order, time after time"""
    spheres, first = packing(ask, 7), None
    settings = [(1, 0), (2, 0), (3, 0), (8, 0)] + [(t, o) for t in (2, 3, 8) for o in (1, 2, 9)]
    for name in "watched", "unwatched", "unwatched":
        for row in rows_of(spheres, settings):
            got = ask.call(name, [row])[0]
            first = first or got
            if got != first:
                k = next(k for k in range(len(got)) if got[k] != first[k])
                return ask.outcome(math.inf, f"{got[k]:.17g} N", f"{first[k]:.17g} N, as with 1 "
                                   "thread", f"component {'xyz'[k % 3]} of sphere {k // 3}, "
                                   f"{row[0]:g} threads, "
                                   + ("in a drawn order" if row[1] else "at the same time"))
        ask.fresh()
    return ask.outcome(0 if any(first) else math.inf, "no forces", "forces")

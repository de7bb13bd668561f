"""Exercise 05: velocity at the contact point."""
import math

from grader.course import check, number
from grader.vec import add, cross, dot, norm, scale, sub

TITLE = "Velocity at the contact point"
LEVEL = "**"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"contact_velocity": (
    "xi yi zi Ri vxi vyi vzi wxi wyi wzi xj yj zj Rj vxj vyj vzj wxj wyj wzj",
    "ri rj vn vsx vsy vsz")}
ZERO = (0.0, 0.0, 0.0)
ARMS, VN, VS = slice(0, 2), slice(2, 3), slice(3, 6)


def vector(ask, size):
    return scale(size * ask.uniform(0.3, 1), ask.direction())


def pair(ask, spin=True, wall=False):
    """Two spheres that overlap by 5 to 30 % of the smaller radius, of sizes that differ."""
    Ri = ask.log_uniform(1e-3, 0.1)
    Rj = Ri * (ask.uniform(1.3, 4) if ask.sign() > 0 else 1 / ask.uniform(1.3, 4))
    distance = Ri + Rj - ask.uniform(0.05, 0.3) * min(Ri, Rj)
    n, xj = ask.direction(), vector(ask, 0.3)
    v = ask.log_uniform(0.1, 10)
    turn = [vector(ask, v / r) if spin else ZERO for r in (Ri, Rj)]
    row = (*add(xj, scale(distance, n)), Ri, *vector(ask, v), *turn[0],
           *xj, Rj, *vector(ask, v), *turn[1])
    return moving(row, vj=ZERO, wj=ZERO) if wall else row


def moving(row, vi=None, wi=None, vj=None, wj=None):
    """The same spheres with other velocities."""
    parts = [vi or row[4:7], wi or row[7:10], vj or row[14:17], wj or row[17:20]]
    return (*row[:4], *parts[0], *parts[1], *row[10:14], *parts[2], *parts[3])


def line(row):
    """The unit vector from j to i, and the distance."""
    d = sub(row[0:3], row[10:13])
    return scale(1 / norm(d), d), norm(d)


def speed(row):
    """A size of velocities, to which errors are compared."""
    return sum(norm(row[k:k + 3]) * f for k, f in ((4, 1), (14, 1), (7, row[3]), (17, row[13])))


# Tolerances: rounding errors, 1e-15 for any way to write the formulas; n loses a digit or two.
@check("contract", 10, "Eqs. (27), (28)", tol=1e-12, sharp=True,
       cause="v_s is what is left of v without its part along n: v - v_n n, with a unit vector n")
def tangential(ask):
    """The sliding velocity is perpendicular to n, and zero for a central impact without spin"""
    rows = [pair(ask) for _ in range(30)]
    outcomes, slides = [], 0
    for row, m in zip(rows, ask.call("contact_velocity", rows)):
        n, _ = line(row)
        error = abs(dot(m[VS], n)) / speed(row)
        slides += norm(m[VS]) > 0.01 * speed(row)
        outcomes.append(ask.outcome(error, f"v_s.n = {dot(m[VS], n):.3g} m/s", "0 m/s",
                                    ask.inputs("contact_velocity", row)))
    central = []
    for row in rows:
        n, _ = line(row)
        vi, vj = scale(-norm(row[4:7]), n), scale(norm(row[14:17]), n)
        central.append(moving(row, vi, ZERO, vj, ZERO))
    for row, m in zip(central, ask.call("contact_velocity", central)):
        outcomes.append(ask.outcome(norm(m[VS]) / speed(row), f"|v_s| = {norm(m[VS]):.3g} m/s",
                                    "0 m/s", "a central impact without spin"))
    if not slides > 20:
        outcomes.append(ask.outcome(math.inf, "no sliding", "v_s that is not zero, in general"))
    return outcomes


@check("pointwise", 10, "Eqs. (7), (29), (30)", tol=1e-12, unit="m",
       cause="r = R - delta/2 for both spheres; together they are as long as d")
def lever_arms(ask):
    """Distances of the contact point from the two centres"""
    return ask.compare("contact_velocity", [pair(ask) for _ in range(40)], part=ARMS)


@check("pointwise", 10, "Eqs. (26)-(28) without spin", tol=1e-12, unit="m/s",
       cause="v = v_i - v_j; v_n = v . n is negative while the spheres approach")
def without_spin(ask):
    """Normal and sliding velocity of spheres that do not rotate"""
    rows = [pair(ask, spin=False) for _ in range(40)]
    want = ask.reference("contact_velocity", rows)
    return [ask.compare("contact_velocity", rows, want, part=VN, ratios={
                -1: "the sign: n points from j to i, and v_n is v . n"}),
            ask.compare("contact_velocity", rows, want, part=VS, ratios={
                -1: "the sign: v is that of i relative to j"})]


@check("pointwise", 15, "Eq. (26), with a plus", tol=1e-12, unit="m/s",
       cause="the rotation adds n x (r_i w_i + r_j w_j): both spins, with their own arms")
def with_spin(ask):
    """Normal and sliding velocity when both spheres rotate"""
    rows = [pair(ask) for _ in range(40)]
    want = ask.reference("contact_velocity", rows)
    return [ask.compare("contact_velocity", rows, want, part=p) for p in (VN, VS)]


def stands_still(ask, rows, at, part=slice(2, 6)):
    """Outcomes: nothing of v_n and v_s may be left; a sphere alone with its spin must slide."""
    outcomes = []
    for row, m in zip(rows, ask.call("contact_velocity", rows)):
        outcomes.append(ask.outcome(norm(m[part]) / speed(row), f"{norm(m[part]):.4g}", "0", at))
    alone = [moving(row, ZERO, cross(line(row)[0], ask.direction()), ZERO, ZERO) for row in rows]
    for row, m in zip(alone, ask.call("contact_velocity", alone)):
        if not norm(m[VS]) > 0.5 * row[3] * norm(row[7:10]):
            outcomes.append(ask.outcome(math.inf, f"|v_s| = {norm(m[VS]):.3g}", "about R w",
                                        "only i moves: it rotates about an axis across n"))
    return outcomes


@check("invariants", 8, "v = V + W x x, w = W for both", tol=1e-12, unit="m/s",
       cause="the arms: r_i + r_j must be |d|, so r = R - delta/2 and not R; or the sign of the "
             "spin in Eq. (26)")
def turning_together(ask):
    """Two spheres that turn like one rigid body do not slide at their contact"""
    rows = []
    for _ in range(30):
        row = pair(ask)
        V, W = vector(ask, 1), vector(ask, 20)
        rows.append(moving(row, add(V, cross(W, row[0:3])), W, add(V, cross(W, row[10:13])), W))
    return stands_still(ask, rows, "both fly and turn as one body")


@check("invariants", 5, "r_i w_i + r_j w_j = 0", tol=1e-12, unit="m/s",
       cause="the sign between the spins: the surfaces at the contact go the same way when the "
             "spins are opposite; Eq. (26) has a plus")
def gears(ask):
    """Two gears that mesh, at fixed places: opposite spins, no sliding"""
    rows = [pair(ask) for _ in range(30)]
    turned = [moving(row, ZERO, scale(arms[1], w), ZERO, scale(-arms[0], w))
              for row, arms, w in ((row, arms, scale(1 / row[3] / row[13], row[7:10]))
                                   for row, arms in zip(rows, ask.reference("arms", rows)))]
    return stands_still(ask, turned, "w_j = -w_i r_i/r_j")


@check("invariants", 5, "v = r_i w x n", tol=1e-12, unit="m/s",
       cause="the order of the factors: n x w is not w x n; or R_i where r_i belongs")
def rolling(ask):
    """A sphere that rolls on a wall without slip, in any direction, does not slide"""
    rows = [pair(ask, wall=True) for _ in range(30)]
    rolls = []
    for row, arms in zip(rows, ask.reference("arms", rows)):
        n, w = line(row)[0], row[7:10]
        rolls.append(moving(row, scale(arms[0], cross(w, n)), w))
    return stands_still(ask, rolls, "v_i = r_i w_i x n, the wall at rest")


def turned(a, v):
    """The vector v, rotated by the quaternion a (4 numbers, norm 1)."""
    t = scale(2, cross(a[1:], v))
    return add(add(v, scale(a[0], t)), cross(a[1:], t))


@check("invariants", 7, "any observer sees the same contact", tol=1e-12, unit="m/s",
       cause="absolute velocities or positions are in the result, or i and j are not treated alike")
def observers(ask):
    """Seen from a train, from a tilted head, and with i and j swapped: the same contact"""
    rows = [pair(ask) for _ in range(20)]
    base = ask.call("contact_velocity", rows)
    outcomes = []

    def compare(view, others, expected):
        for row, m, want in zip(rows, ask.call("contact_velocity", others), expected):
            outcomes.append(ask.outcome(norm(sub(m[2:], want)) / speed(row),
                                        f"v_n = {m[2]:.5g}, v_s = {number(m[VS])}",
                                        f"{want[0]:.5g}, {number(want[1:])}", view))
    V, x0 = vector(ask, 5), vector(ask, 0.5)
    compare("a train, and another origin", [
        (*add(r[0:3], x0), r[3], *add(r[4:7], V), *r[7:10], *add(r[10:13], x0), r[13],
         *add(r[14:17], V), *r[17:20]) for r in rows], [m[2:] for m in base])
    a = scale(1 / math.sqrt(2), ask.direction())
    a = (1 / math.sqrt(2), *a)
    compare("a rotated frame", [
        tuple(c for k in (0, 10) for part in (turned(a, r[k:k + 3]), (r[k + 3],),
                                              turned(a, r[k + 4:k + 7]), turned(a, r[k + 7:k + 10]))
              for c in part) for r in rows], [(m[2], *turned(a, m[VS])) for m in base])
    compare("i and j swapped", [r[10:] + r[:10] for r in rows],
            [(m[2], *scale(-1, m[VS])) for m in base])
    if not any(norm(m[2:]) for m in base):
        return ask.outcome(math.inf, "no motion at all", "v_n and v_s")
    return outcomes


def carried(row, start, mark, h):
    """Where a mark on a body is a time h later. start: 0 for i, 10 for j; mark: its place now."""
    x, v, w = row[start:start + 3], row[start + 4:start + 7], row[start + 7:start + 10]
    angle, arm = norm(w) * h, sub(mark, x)
    axis = scale(1 / norm(w), w)
    across = cross(axis, arm)
    arm = add(add(scale(math.cos(angle), arm), scale(math.sin(angle), across)),
              scale((1 - math.cos(angle)) * dot(axis, arm), axis))
    return add(add(x, scale(h, v)), arm)


@check("convergence", 15, "v = d/dt of the distance of two marks", sharp=True,
       cause="v_n and v_s together are not the velocity with which two marks at the contact point "
             "part: see the checks lever_arms, without_spin, with_spin")
def marks(ask):
    """Two marks, painted where the spheres touch, part with v_n n + v_s: error of order 1 in h"""
    rows = [pair(ask) for _ in range(20)]
    arms, results = ask.reference("arms", rows), ask.call("contact_velocity", rows)
    errors = []
    for power in range(4):
        squares = []
        for row, (ri, _), m in zip(rows, arms, results):
            n = line(row)[0]
            mark, h = sub(row[0:3], scale(ri, n)), 0.01 * 0.25 ** power * row[3] / speed(row)
            parted = scale(1 / h, sub(carried(row, 0, mark, h), carried(row, 10, mark, h)))
            difference = sub(parted, add(scale(m[2], n), m[VS]))
            squares.append((norm(difference) / speed(row)) ** 2)
        errors.append(math.sqrt(sum(squares) / len(squares)))
    slope = math.log(errors[0] / errors[3]) / math.log(64) if min(errors) > 0 else 0.0
    text = ", ".join(f"{x:.2g}" for x in errors)
    return ask.outcome(0 if 0.95 < slope < 1.05 else math.inf,
                       f"differences {text} for h, h/4, h/16, h/64: order {slope:.2f}",
                       "order 1 (0.95 to 1.05)")


@check("clean", 10, "a function of its arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    return ask.same_bits("contact_velocity", [pair(ask) for _ in range(40)])

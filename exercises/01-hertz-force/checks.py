"""Exercise 01: the Hertz force."""
import math

from grader.course import check, number
from grader.vec import add, dot, norm, scale, sub

TITLE = "The Hertz force"
LEVEL = "*"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"hertz_force": ("x_i y_i z_i R_i E_i nu_i x_j y_j z_j R_j E_j nu_j", "f_x f_y f_z")}


def sphere(ask, R=None, E=None, nu=None):
    """Radius, modulus, Poisson's ratio: drawn unless given."""
    return (R or ask.log_uniform(1e-3, 0.1), E or ask.log_uniform(1e5, 1e9),
            nu if nu is not None else ask.uniform(-0.2, 0.5))


def pair(ask, overlap, i, j):
    """Two spheres (R, E, nu) anywhere, turned anyhow, that overlap by `overlap`."""
    xj = scale(ask.uniform(0, 1), ask.direction())
    xi = add(xj, scale(i[0] + j[0] - overlap, ask.direction()))
    return (*xi, *i, *xj, *j)


def swapped(row):
    return row[6:] + row[:6]


def line_of_centres(row):
    """The unit vector from j to i."""
    d = sub(row[0:3], row[6:9])
    return scale(1 / norm(d), d)


@check("contract", 10, "Eq. (7)", sharp=True,
       cause="the force must be 0 unless R_i + R_j > d; what is left is the square root of a "
             "negative number, or a force that attracts")
def no_force_apart(ask):
    """Spheres that do not overlap exert no force; spheres that do, a finite one that is not 0"""
    i, j = sphere(ask), sphere(ask)
    gaps = [ask.log_uniform(1e-6, 10) * (i[0] + j[0]) for _ in range(20)]
    apart = [pair(ask, -gap, i, j) for gap in gaps]
    touching = [pair(ask, ask.log_uniform(1e-6, 0.3) * i[0], i, j) for _ in range(20)]
    zero = ask.call("hertz_force", apart, any_value=True)
    force = ask.call("hertz_force", touching)
    for row, gap, f in zip(apart, gaps, zero):
        if any(c != 0 for c in f):  # true for nan as well
            return ask.outcome(math.inf, number(f), "(0, 0, 0)",
                               f"a gap of {gap:.3g} = d - R_i - R_j")
    for row, f in zip(touching, force):
        if norm(f) == 0:
            return ask.outcome(math.inf, number(f), "a force", ask.inputs("hertz_force", row),
                               "the function returns no force for spheres that overlap")
    return ask.outcome(0)


FACTORS = {0.5: "2/3 where Eq. (12) has 4/3, or a factor 2 in Eq. (15)",
           2: "E* = E/(1 - nu^2): Eq. (15) has two terms, one for each sphere",
           math.sqrt(2): "R where Eq. (14) has R*: for equal spheres R* = R/2",
           2 * math.sqrt(2): "E* and R* of one sphere only, Eqs. (15) and (17)",
           -1: "the direction: n points from j to i, Eqs. (8), (9)"}


@check("pointwise", 15, "Eqs. (5), (7)-(10), (12), (14), (15), (17)", tol=1e-9, unit="N",
       cause="a factor of Eq. (12), or the power of delta: kn grows as delta^(1/2), the force as "
             "delta^(3/2)")
def equal_spheres(ask):
    """The force between two equal spheres, overlaps from 1e-5 R to 0.3 R"""
    i = sphere(ask)
    rows = [pair(ask, i[0] * ask.log_uniform(1e-5, 0.3), i, i) for _ in range(40)]
    return ask.compare("hertz_force", rows, ratios=FACTORS)


@check("pointwise", 20, "Eqs. (15), (17)", tol=1e-9, unit="N",
       cause="the two spheres differ in radius and material: E* and R* take both of them, as "
             "reciprocals")
def unequal_spheres(ask):
    """The force between spheres of different size, modulus and Poisson's ratio"""
    rows = []
    for _ in range(40):
        i, j = sphere(ask), sphere(ask)
        rows.append(pair(ask, min(i[0], j[0]) * ask.log_uniform(1e-5, 0.3), i, j))
    return ask.compare("hertz_force", rows, ratios=FACTORS)


@check("invariants", 10, "Eqs. (5), (9), (10)", sharp=True,
       cause="the direction: d = x_i - x_j, Eq. (8); the force on i points away from j")
def repulsion(ask):
    """The force pushes i away from j, along the line of centres"""
    i, j = sphere(ask), sphere(ask)
    rows = [pair(ask, ask.log_uniform(1e-4, 0.3) * min(i[0], j[0]), i, j) for _ in range(30)]
    for row, f in zip(rows, ask.call("hertz_force", rows)):
        n = line_of_centres(row)
        along, across = dot(f, n), norm(sub(f, scale(dot(f, n), n)))
        if not (along > 0 and across <= 1e-9 * along):
            return ask.outcome(math.inf, f"{along:.3g} N along n, {across:.3g} N across",
                               "a positive force along n, nothing across",
                               ask.inputs("hertz_force", row))
    return ask.outcome(0)


@check("invariants", 5, "Newton's third law", tol=1e-12,
       cause="the function treats i and j differently: one radius, one modulus, or one of them "
             "twice")
def action_and_reaction(ask):
    """The force on i from j is the opposite of the force on j from i"""
    rows = []
    for _ in range(30):
        i, j = sphere(ask), sphere(ask)
        rows.append(pair(ask, ask.log_uniform(1e-3, 0.3) * min(i[0], j[0]), i, j))
    forces = ask.call("hertz_force", rows + [swapped(row) for row in rows])
    sums = [norm(add(f, g)) / max(norm(f), norm(g), 1e-300) for f, g in
            zip(forces, forces[len(rows):])]
    if not any(norm(f) for f in forces):
        return ask.outcome(math.inf, "no force at all", "two opposite forces")
    k = sums.index(max(sums))
    return ask.outcome(sums[k], f"|f_ij + f_ji| = {sums[k]:.3g} |f|", "0",
                       ask.inputs("hertz_force", rows[k]))


def impact(ask, v, m, i, steps):
    """A sphere of mass m meets its fixed twin at speed v; (rebound speed, largest overlap).

    Leapfrog with `steps` steps in the time 4 x (compression / speed), from a small gap.
    """
    deepest = ask.reference("compression", [(v, m, *i)])[0][0]
    dt, gap, reach = 4 * deepest / (v * steps), 0.2 * deepest, 0.0
    x, speed = 2 * i[0] + gap, -v
    for _ in range(2 * steps):
        x += dt / 2 * speed
        f = ask.call("hertz_force", [(x, 0, 0, *i, 0, 0, 0, *i)])[0][0]
        speed += dt * f / m
        x += dt / 2 * speed
        reach = max(reach, 2 * i[0] - x)
        if x > 2 * i[0] + gap:
            break
    return speed, reach, deepest


@check("invariants", 10, "energy: m v^2/2 = 8/15 E* R*^(1/2) delta^(5/2)", tol=1e-4,
       cause="the work done while the spheres approach must come back while they part, and fix the "
             "largest overlap: a wrong factor, or a force that acts when the spheres are apart")
def elastic_impact(ask):
    """A sphere that hits its fixed twin: compressed as deep as energy says, and returns as fast"""
    i, v, m = sphere(ask, nu=0.4), ask.log_uniform(0.05, 0.5), ask.log_uniform(1e-3, 1)
    stiff = 1e4 * m * v * v / (i[0] * i[0] * i[0])  # keeps the overlap below 5 % of the radius
    i = (i[0], max(i[1], stiff), i[2])
    speed, reach, deepest = impact(ask, v, m, i, 400)
    at = f"R = {i[0]:.3g}, E = {i[1]:.3g}, nu = {i[2]:.3g}, m = {m:.3g}, v = {v:.3g}"
    return [ask.outcome(abs(speed / v - 1), f"returns with {speed / v:.5g} v", "v", at),
            ask.outcome(abs(reach / deepest - 1), f"compressed by {reach:.5g}",
                        f"{deepest:.5g}", at)]


@check("convergence", 15, "Eqs. (12), (14)", tol=1e-6,
       cause="a = sqrt(R* delta) is missing from kn (slope 1), or delta is in the force once too "
             "often")
def power_law(ask):
    """Slope of log(force) over log(delta), a straight line of slope 3/2, over 5 decades"""
    i, j = sphere(ask), sphere(ask)
    small = min(i[0], j[0])
    overlaps = [small * 10 ** (-5 + k / 4) for k in range(19)]
    rows = [(i[0] + j[0] - u, 0, 0, *i, 0, 0, 0, *j) for u in overlaps]
    forces = [norm(f) for f in ask.call("hertz_force", rows)]
    if min(forces) <= 0:
        return ask.outcome(math.inf, "no force at one of them", "a force at every overlap")
    real = [i[0] + j[0] - row[0] for row in rows]  # the overlap after rounding
    slopes = [math.log(forces[k + 1] / forces[k]) / math.log(real[k + 1] / real[k])
              for k in range(len(rows) - 1)]
    worst = max(slopes, key=lambda s: abs(s - 1.5))
    return ask.outcome(abs(worst - 1.5), f"slope {worst:.6g}", "slope 1.5")


@check("clean", 10, "a function of its arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    i, j = sphere(ask), sphere(ask)
    return ask.same_bits("hertz_force", [pair(ask, ask.uniform(-0.1, 0.3) * i[0], i, j)
                                         for _ in range(50)])

"""Exercise 07: action and reaction."""
import math

from grader.course import check, number
from grader.vec import add, cross, dot, norm, scale, sub

TITLE = "Action and reaction"
LEVEL = "**"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"both_sides": ("n_x n_y n_z r_i r_j R* fn_x fn_y fn_z fs_x fs_y fs_z fr_x fr_y fr_z "
                            "f_t", "f_x f_y f_z t_x t_y t_z f_x f_y f_z t_x t_y t_z"),
             "total": ("", "")}
ZERO = (0.0, 0.0, 0.0)
ON_I, ON_J = slice(0, 6), slice(6, 12)  # force and torque in a result of both_sides


def across(ask, n, size):
    """A vector of a size of the order of `size`, perpendicular to n."""
    v = scale(size * ask.uniform(0.3, 1), ask.direction())
    return sub(v, scale(dot(v, n), n))


def contact(ask, n=None, ri=None, rj=None, size=None):
    """The arguments of both_sides: a contact of unequal spheres with all kinds of friction."""
    n, size = n or ask.direction(), size or ask.log_uniform(1e-3, 1e3)
    ri, rj = ri or ask.log_uniform(1e-3, 0.1), rj or ask.log_uniform(1e-3, 0.1)
    Rstar = ri * rj / (ri + rj) * ask.uniform(1, 1.1)
    return (*n, ri, rj, Rstar, *scale(size * ask.uniform(0.3, 1), n), *across(ask, n, size),
            *across(ask, n, size), ask.sign() * size * ask.uniform(0.3, 1))


def parts(loads):
    """Force on i, torque on i, force on j, torque on j."""
    return loads[0:3], loads[3:6], loads[6:9], loads[9:12]


@check("contract", 10, "Eqs. (1), (2), (31)-(33)", sharp=True,
       cause="the normal force points through the centres and turns nothing; without friction do "
             "not divide by |f_s|; a body without contacts feels nothing")
def frictionless(ask):
    """Without friction: two opposite forces, no torque; without contacts: nothing at all"""
    for row in [contact(ask) for _ in range(20)]:
        smooth = row[:9] + (0.0,) * 7
        fi, ti, fj, tj = parts(ask.call("both_sides", [smooth], any_value=True)[0])
        good = norm(sub(fi, row[6:9])) == 0 == norm(add(fj, row[6:9]))
        if not good or norm(ti) != 0 or norm(tj) != 0:  # true for nan as well
            return ask.outcome(math.inf, f"f = {number(fi)}, t = {number(ti)} on i, "
                               f"f = {number(fj)}, t = {number(tj)} on j",
                               f"+-{number(row[6:9])} and no torque",
                               ask.inputs("both_sides", smooth))
    free = ask.call("total", [(5.0,)])[0]
    if free != (0.0,) * 30:
        return ask.outcome(math.inf, f"{len(free)} numbers {number(free[:6])}",
                           "30 zeros for 5 bodies without a contact")
    return ask.outcome(0)


def compare_side(ask, part, names):
    """Force and torque of one side, each against its own size; two outcomes."""
    rows = [contact(ask) for _ in range(40)]
    want = ask.reference("both_sides", rows)
    outcomes = []
    for k, name in enumerate(names):
        piece = slice(part.start + 3 * k, part.start + 3 * k + 3)
        outcome = ask.compare("both_sides", rows, want, part=piece)
        outcome.measured = f"{name} = {outcome.measured}"
        outcome.expected = f"{name} = {outcome.expected}"
        outcomes.append(outcome)
    return outcomes


# Tolerances: rounding errors of a few sums, below 1e-15 times the largest summand.
@check("pointwise", 12, "Eqs. (1), (2), (31)-(33)", tol=1e-12,
       cause="f = f_n + f_s (f_r and f_t turn, but do not push); torque: r_i f_s x n, R* n x f_r, "
             "f_t R* n")
def on_i(ask):
    """Force and torque on i"""
    return compare_side(ask, ON_I, ("force on i", "torque on i"))


@check("pointwise", 13, "Eqs. (56)-(60)", tol=1e-12,
       cause="forces, rolling and twisting torques are the opposite of those on i; the sliding "
             "torque has the same direction, and is r_j/r_i times as large")
def on_j(ask):
    """Force and torque on j"""
    return compare_side(ask, ON_J, ("force on j", "torque on j"))


def random_list(ask, bodies, contacts):
    """The arguments of total: contacts of any two bodies, with loads of any kind."""
    row = [float(bodies)]
    for _ in range(contacts):
        i, j = ask.random.sample(range(bodies), 2)
        row += [float(i), float(j), *(ask.uniform(-1, 1) for _ in range(12))]
    return tuple(row)


@check("pointwise", 10, "Eqs. (1), (2)", tol=1e-12,
       cause="every contact adds to both of its bodies; add (+=), do not replace what the other "
             "contacts have added before")
def sums(ask):
    """Force and torque on each body from a list of contacts, several for each body"""
    rows = [random_list(ask, 7, 20) for _ in range(10)]
    want, outcomes = ask.reference("total", rows), []
    for row, got, right in zip(rows, ask.call("total", rows), want):
        if len(got) != len(right):
            return ask.outcome(math.inf, f"{len(got) / 6:g} loads", "7 loads for 7 bodies")
        for body in range(7):
            here, number_of = slice(6 * body, 6 * body + 6), sum(
                body in row[k:k + 2] for k in range(1, len(row), 14))
            outcomes.append(ask.outcome(
                norm(sub(got[here], right[here])) / max(norm(right[here]), 1), number(got[here]),
                number(right[here]), f"body {body} of 7, which has {number_of} contacts"))
    return outcomes


class Clump:
    """Spheres that overlap, turn and rub against each other with forces that the grader invents."""

    def __init__(self, ask, n):
        self.R = [ask.uniform(0.5, 1.5) for _ in range(n)]
        self.m = [ask.uniform(0.5, 2) * R * R * R for R in self.R]
        self.I = [0.4 * m * R * R for m, R in zip(self.m, self.R)]
        self.x = [scale(0.5 * n ** (1 / 3) + 0.5, ask.direction()) for _ in range(n)]
        self.v = [scale(0.3, ask.direction()) for _ in range(n)]
        self.w = [scale(0.3, ask.direction()) for _ in range(n)]

    def contacts(self, ask):
        """(i, j, arguments of both_sides) of all pairs that overlap; friction of any size."""
        found = []
        for i, R in enumerate(self.R):
            for j in range(i):
                d = sub(self.x[i], self.x[j])
                delta = R + self.R[j] - norm(d)
                if not 0 < delta < min(R, self.R[j]):
                    continue
                n = scale(1 / norm(d), d)
                found.append((i, j, (*n, R - delta / 2, self.R[j] - delta / 2,
                                     1 / (1 / R + 1 / self.R[j]), *scale(delta, n),
                                     *across(ask, n, 0.2), *across(ask, n, 0.2),
                                     0.2 * ask.uniform(-1, 1))))
        return found

    def step(self, ask, dt):
        """One step with the forces that the answer distributes; the number of contacts."""
        found = self.contacts(ask)
        loads = ask.call("both_sides", [row for _, _, row in found]) if found else []
        row = [float(len(self.R))]
        for (i, j, _), load in zip(found, loads):
            row += [float(i), float(j), *load]
        sums = ask.call("total", [tuple(row)])[0]
        for k in range(len(self.R)):
            f, t = sums[6 * k:6 * k + 3], sums[6 * k + 3:6 * k + 6]
            self.v[k] = add(self.v[k], scale(dt / self.m[k], f))
            self.x[k] = add(self.x[k], scale(dt, self.v[k]))
            self.w[k] = add(self.w[k], scale(dt / self.I[k], t))
        return len(found)

    def momentum(self):
        return [scale(m, v) for m, v in zip(self.m, self.v)]

    def angular_momentum(self):
        """Of the motion of each sphere about the origin, and of its spin."""
        return ([cross(x, p) for x, p in zip(self.x, self.momentum())]
                + [scale(k, w) for k, w in zip(self.I, self.w)])


def total_of(vectors):
    s = ZERO
    for v in vectors:
        s = add(s, v)
    return s


def conserved(ask, quantity, name):
    """A clump of 12 spheres, 40 steps: how much a quantity has changed, over what was exchanged."""
    clump, contacts = Clump(ask, 12), 0
    first = quantity(clump)
    for _ in range(40):
        contacts += clump.step(ask, 0.02)
    last = quantity(clump)
    moved = max(norm(sub(a, b)) for a, b in zip(first, last))
    if contacts < 40 or moved < 1e-3:
        return ask.outcome(math.inf, f"{contacts} contacts, none of which changes the {name}",
                           "an exchange between the spheres")
    change = norm(sub(total_of(last), total_of(first)))
    return ask.outcome(change / moved, f"a change by {change:.3g}, while the spheres exchange "
                       f"{moved:.3g}", "no change")


# 40 steps of 12 spheres: rounding errors add up to some 1e-15 of what is exchanged.
@check("invariants", 5, "Newton's third law, Eqs. (56), (57)", tol=1e-12,
       cause="what i gets, j must give: the opposite of f_n + f_s; and total must add both")
def momentum(ask):
    """The momentum of a clump of spheres that collide and rub does not change"""
    return conserved(ask, Clump.momentum, "momentum")


@check("invariants", 8, "Eqs. (31), (58)-(60)", tol=1e-12,
       cause="the sliding torques: r_i f_s x n on i, r_j f_s x n on j, of the same direction; "
             "rolling and twisting torques are opposite; and total must add both")
def angular_momentum(ask):
    """The angular momentum of the same clump, orbits and spins, does not change"""
    return conserved(ask, Clump.angular_momentum, "angular momentum")


@check("invariants", 6, "power: f_n v_n + f_s v_s + (R*/r) f_r v_r + f_t v_t", tol=1e-12, unit="W",
       cause="a torque with the wrong sign or lever: it drives what friction should stop")
def power(ask):
    """The work on both bodies is that of the forces along the motion at the contact"""
    rows = [contact(ask) for _ in range(40)]
    motions = [(*scale(r[3], ask.direction()), *ask.direction(), *scale(r[4], ask.direction()),
                *ask.direction()) for r in rows]
    want = [w for w, in ask.reference("power", [r + m for r, m in zip(rows, motions)])]
    outcomes = []
    for r, m, w, load in zip(rows, motions, want, ask.call("both_sides", rows)):
        work = [dot(a, b) for a, b in zip(parts(load), (m[0:3], m[3:6], m[6:9], m[9:12]))]
        size = norm(r[6:12]) * (r[3] + r[4])
        outcomes.append(ask.outcome(abs(sum(work) - w) / size, number(sum(work)), number(w),
                                    ask.inputs("both_sides", r)))
    return outcomes


@check("invariants", 6, "Eqs. (56)-(60), names exchanged", tol=1e-12,
       cause="i and j are only names: exchange them, and n and f_s change their sign, f_r and f_t "
             "do not; what acts on j must then come out as what acts on i")
def exchange(ask):
    """The same contact, with the names of i and j exchanged: the same loads"""
    rows = [contact(ask) for _ in range(30)]
    mirrored = [(*scale(-1, r[0:3]), r[4], r[3], r[5], *scale(-1, r[6:12]), *r[12:16])
                for r in rows]
    outcomes = []
    for r, a, b in zip(rows, ask.call("both_sides", rows), ask.call("both_sides", mirrored)):
        for part, other, name in (ON_I, ON_J, "i"), (ON_J, ON_I, "j"):
            error = norm(sub(a[part], b[other])) / max(norm(a[part]), 1e-300)
            if norm(a[part]) == 0:
                return ask.outcome(math.inf, f"nothing acts on {name}", "forces and torques")
            outcomes.append(ask.outcome(
                error, f"{number(a[part])} on {name}, {number(b[other])} when it is called "
                f"{'j' if name == 'i' else 'i'}", "the same", ask.inputs("both_sides", r)))
    return outcomes


@check("convergence", 15, "Eqs. (31), (60) and I = 8/15 pi rho R^5", tol=1e-12,
       cause="the lever of j: its sliding torque is r_j f_s x n. Slope -5: that of i; -6: r_i/r_j "
             "instead of r_j/r_i")
def size_law(ask):
    """Two spheres slide: angular acceleration of j over that of i, against R_j / R_i: slope -4"""
    Ri = ask.log_uniform(1e-3, 0.1)
    sizes = [Ri * 10 ** (k / 4) for k in range(-8, 9)]
    want = [x for x, in ask.reference("spin_ratio", [(Ri, Rj) for Rj in sizes])]
    n = ask.direction()
    fs = across(ask, n, 1)
    rows = [(*n, Ri, Rj, 1 / (1 / Ri + 1 / Rj), *n, *fs, 0, 0, 0, 0.0) for Rj in sizes]
    ratios = []
    for Rj, load in zip(sizes, ask.call("both_sides", rows)):
        _, ti, _, tj = parts(load)
        if dot(ti, ti) == 0 or dot(ti, tj) <= 0:
            return ask.outcome(math.inf, f"t = {number(ti)} on i, {number(tj)} on j",
                               "two torques of the same direction")
        ratios.append(dot(ti, tj) / dot(ti, ti) * (Ri / Rj) ** 5)
    slopes = [math.log(b / a) / math.log(q / p)
              for p, q, a, b in zip(sizes, sizes[1:], ratios, ratios[1:])]
    worst = max(slopes, key=lambda s: abs(s + 4))
    k = len(sizes) // 2  # twins
    return [ask.outcome(abs(worst + 4), f"slope {worst:.6g}", "slope -4"),
            ask.outcome(abs(ratios[k] / want[k] - 1), f"a ratio of {ratios[k]:.6g} for twins",
                        f"{want[k]:.6g}")]


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    return [ask.same_bits("both_sides", [contact(ask) for _ in range(40)]),
            ask.same_bits("total", [random_list(ask, 5, 9) for _ in range(20)])]

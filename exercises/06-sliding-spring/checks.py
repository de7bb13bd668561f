"""Exercise 06: the sliding spring."""
import math

from grader.course import check
from grader.vec import add, cross, dot, norm, scale

TITLE = "The sliding spring"
LEVEL = "**"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"sliding_force": ("ux uy uz nx ny nz vx vy vz fn ks cs mus dt",
                               "fx fy fz ux uy uz")}
ZERO = (0.0, 0.0, 0.0)
F, U = slice(0, 3), slice(3, 6)
OBLIQUE = 26  # impacts in the table of the reference


def plane(ask):
    """Three unit vectors, all perpendicular: the normal first."""
    n = ask.direction()
    while True:
        t = cross(n, ask.direction())
        if norm(t) > 0.3:
            t = scale(1 / norm(t), t)
            return n, t, cross(n, t)


def tangent(ask, frame, size):
    """A vector of this length in the plane."""
    while True:
        a, b = ask.uniform(-1, 1), ask.uniform(-1, 1)
        if 0.1 < a * a + b * b < 1:
            return scale(size / math.sqrt(a * a + b * b), add(scale(a, frame[1]),
                                                              scale(b, frame[2])))


def contacts(ask, count, low, high, turned=0.0):
    """Rows; |trial force| / limit is about low ... high. turned: part of the spring along n."""
    rows = []
    for _ in range(count):
        frame, dt, k, u = plane(ask), ask.log_uniform(1e-5, 1e-2), ask.log_uniform(10, 1e5), \
            ask.log_uniform(1e-6, 1e-3)
        spring = tangent(ask, frame, u)
        v = tangent(ask, frame, ask.uniform(0.1, 1) * u / dt)
        c = ask.uniform(0.1, 1) * k * dt
        trial = norm(add(scale(k, add(spring, scale(dt, v))), scale(c, v)))
        mu = ask.uniform(0.1, 1)
        fn = ask.sign() * trial / (mu * ask.log_uniform(low, high))
        spring = add(spring, scale(ask.sign() * ask.uniform(0.3, 1) * turned * u, frame[0]))
        rows.append((*spring, *frame[0], *v, fn, k, c, mu, dt))
    return rows


@check("contract", 10, "Eqs. (11), (52)", tol=1e-12, sharp=True,
       cause="a division by a length that may be zero in Eq. (52) or (54); or a limit without the "
             "absolute value of f_n")
def limits(ask):
    """Finite for springs of length 0 and along n, without load, without friction; |f| <= mu |fn|"""
    rows = contacts(ask, 12, 0.2, 5) + contacts(ask, 12, 0.2, 5, turned=1)
    special = []
    for r in rows[:8]:
        special += [(*ZERO, *r[3:]), (*r[:6], *ZERO, *r[9:]), (*ZERO, *r[3:6], *ZERO, *r[9:]),
                    (*r[:9], 0.0, *r[10:]), (*r[:12], 0.0, r[13])]
    for axis in (1.0, 0.0, 0.0), (0.0, -1.0, 0.0):  # exactly along n, or turned without remainder
        special.append((*scale(1e-4, axis), *axis, *cross(axis, (0.0, 0.0, 1.0)), *rows[0][9:]))
    moved = 0
    for row, result in zip(rows + special, ask.call("sliding_force", rows + special)):
        f, u, n, limit = result[F], result[U], row[3:6], row[12] * abs(row[9])
        size = max(limit, row[10] * norm(row[0:3]))
        moved += norm(f) > 0
        if not norm(f) <= limit * (1 + 1e-12) + 1e-300:
            return ask.outcome(math.inf, f"|f| = {norm(f):.6g} N",
                               f"at most mu |fn| = {limit:.6g} N", ask.inputs("sliding_force", row))
        across = max(abs(dot(f, n)) / max(size, 1e-300), abs(dot(u, n)) * row[10] /
                     max(size, 1e-300))
        if across > 1e-12:
            return ask.outcome(across, f"f.n = {dot(f, n):.3g} N, u.n = {dot(u, n):.3g} m", "0, 0",
                               ask.inputs("sliding_force", row),
                               "the spring is not turned into the plane before its use, Eq. (52)")
    return ask.outcome(0 if moved > 8 else math.inf, f"{moved} forces that are not zero",
                       "friction in most of the contacts")


# Tolerances: rounding errors, 1e-15 for any way to write the formulas, times a margin for sums.
@check("pointwise", 10, "Eqs. (53), (6)", tol=1e-12,
       cause="below the limit: first u + dt v, then -k u - c v with the new u; the spring stays so")
def stick(ask):
    """Force and spring of a contact that sticks; in some, the motion releases the spring"""
    rows = contacts(ask, 40, 0.05, 0.9)
    for r in contacts(ask, 10, 0.05, 0.9):
        u, k, mu, dt = r[0:3], r[10], r[12], r[13]
        v, c = scale(-0.9 / dt, u), 0.1 * k * dt  # trial force 0.01 k u, of the spring 0.1 k u
        rows.append((*u, *r[3:6], *v, ask.sign() * 0.02 * k * norm(u) / mu, k, c, mu, dt))
    return compare(ask, rows)


@check("pointwise", 15, "Eqs. (11), (54), (55)", tol=1e-12,
       cause="above the limit: the whole force, spring and dashpot, shortened to mu |fn|, and the "
             "spring -f/k")
def slip(ask):
    """Force and spring of a contact that slips, under pressure and under tension"""
    rows = contacts(ask, 40, 1.1, 20)
    return compare(ask, rows)


@check("pointwise", 10, "Eq. (52)", tol=1e-12,
       cause="the part of u along n goes, and the rest becomes as long as u was: before dt v is "
             "added")
def turning(ask):
    """A spring that is not perpendicular to n any more, because the bodies roll over each other"""
    rows = contacts(ask, 40, 0.05, 0.3, turned=1)
    return compare(ask, rows)


def compare(ask, rows):
    """Errors of force and spring; a wrong spring after the right force is named."""
    want = ask.reference("sliding_force", rows)
    force = ask.compare("sliding_force", rows, want, part=F, ratios={
        -1: "the sign: friction acts against the spring and against the velocity, Eq. (6)"})
    spring = ask.compare("sliding_force", rows, want, part=U)
    if force.error <= 1e-12 < spring.error:
        spring.cause = "the force is right; the spring that the next step gets is not"
    force.measured, force.expected = force.measured + " N", force.expected + " N"
    spring.measured, spring.expected = "u = " + spring.measured + " m", spring.expected + " m"
    return [force, spring]


class Slide:
    """Spheres of mass 1 and radius 1 on a plane, side by side: velocity vt, angular velocity w.

    A contact slides with vt + r w, r = 1 - delta/2, Eq. (29), along a direction of its own.
    """

    def __init__(self, ask, speeds, mus):
        self.ask, self.vt, self.mus = ask, list(speeds), list(mus)
        self.w, self.frames = [0.0] * len(mus), [plane(ask) for _ in mus]
        self.springs = [ZERO] * len(mus)

    def step(self, which, r, fn, ks, cs, dt):
        """Friction and one time step for the spheres `which`; the lists belong to them."""
        rows = [(*self.springs[i], *self.frames[i][0],
                 *scale(self.vt[i] + arm * self.w[i], self.frames[i][1]), a, k, c, self.mus[i], h)
                for i, arm, a, k, c, h in zip(which, r, fn, ks, cs, dt)]
        for i, arm, h, result in zip(which, r, dt, self.ask.call("sliding_force", rows)):
            f = dot(result[F], self.frames[i][1])
            self.springs[i] = result[U]
            self.vt[i], self.w[i] = self.vt[i] + h * f, self.w[i] + 2.5 * h * arm * f


# Tolerance: rounding errors of 400 steps.
@check("invariants", 10, "v = v0 - mu g t, then v = 5/7 v0", tol=1e-10, unit="m/s",
       cause="while it slides the force must be mu |fn|; when it rolls, the spring must let go: in "
             "slip it may not grow, and the dashpot must stop its oscillation")
def slide_to_roll(ask):
    """A sphere is thrown along a plane: it slides, slower and slower, and rolls in the end"""
    mus = [ask.uniform(0.1, 0.5) for _ in range(6)]
    v0 = [ask.uniform(0.5, 2) for _ in mus]
    spheres, n = Slide(ask, v0, mus), len(mus)
    dt = [ask.log_uniform(1e-3, 1e-2) for _ in mus]
    weight = [2 * v / (7 * mu * 97.3 * h) for v, mu, h in zip(v0, mus, dt)]  # rolls at 97.3 dt
    k, c = [0.09 * 2 / 7 / (h * h) for h in dt], [0.3 * 2 / 7 / h for h in dt]
    outcomes = []
    for step in range(1, 401):
        spheres.step(range(n), [1.0] * n, weight, k, c, dt)
        if step in (50, 400):
            for mu, v, w, h, got in zip(mus, v0, weight, dt, spheres.vt):
                expected = v - mu * w * step * h if step == 50 else 5 / 7 * v
                outcomes.append(ask.outcome(
                    abs(got / expected - 1), f"{got:.8g}", f"{expected:.8g}",
                    f"{'half' if step == 50 else 'four times'} the time of sliding, "
                    f"v0 = {v:.4g}, mu = {mu:.3g}"))
    return outcomes


def impacts(ask, cases, steps):
    """Spheres of mass 1 and radius 1 that hit a plate with speed 1, in steps of the solver.

    cases: (nu, e_n, mu, sine, cosine); steps: in the duration of an elastic contact. Returns the
    spheres, and for each its normal velocity and the sum of |fn| dt.
    """
    stiffness = ask.reference("stiffness", [()])[0][0]
    laws = ask.reference("law", [c[:2] for c in cases])
    spheres = Slide(ask, [c[3] for c in cases], [c[2] for c in cases])
    vn, push, active = [-c[4] for c in cases], [0.0] * len(cases), list(range(len(cases)))
    scales = ask.reference("duration", [(c[4],) for c in cases])
    dt = [duration / steps for duration, in scales]
    delta = [ask.uniform(0.05, 1) * h * c[4] for h, c in zip(dt, cases)]  # after the first step
    for _ in range(8 * steps):
        lists = r, fn, ks, cs, h = [], [], [], [], []
        for i in active:
            kn = stiffness * math.sqrt(delta[i])
            cn = math.sqrt(laws[i][1] * kn)
            r.append(1 - delta[i] / 2)
            fn.append(kn * delta[i] - cn * vn[i])
            ks.append(laws[i][0] * kn)
            cs.append(laws[i][2] * cn)
            h.append(dt[i])
        spheres.step(active, *lists)
        for i, f in zip(active, fn):
            push[i] += abs(f) * dt[i]
            vn[i] += f * dt[i]
            delta[i] -= vn[i] * dt[i]
        active = [i for i in active if delta[i] > 0]
        if not active:
            break
    return spheres, vn, push


def tilted(tangent_of_angle):
    """Sine and cosine of an angle."""
    hypotenuse = math.sqrt(1 + tangent_of_angle * tangent_of_angle)
    return tangent_of_angle / hypotenuse, 1 / hypotenuse


# Tolerance: rounding errors of 300 steps.
@check("invariants", 7, "m |dv_t| = mu * integral of |fn| dt", tol=1e-11,
       cause="the force is not at its limit in every step, also where fn attracts: the dashpot "
             "belongs into the trial force, but not into the spring of Eq. (55)")
def gross_sliding(ask):
    """Grazing impacts slide from beginning to end: Coulomb's law decides alone"""
    cases = [(0.3, 1.0, ask.uniform(0.15, 0.2), *tilted(ask.uniform(4, 5)))]
    for en in 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3:
        cases.append((0.3, en, ask.uniform(0.05, 0.2), *tilted(ask.uniform(4, 12))))
    spheres, _, push = impacts(ask, cases, 200)
    outcomes = []
    for case, vt, impulse in zip(cases, spheres.vt, push):
        got, want = case[3] - vt, case[2] * impulse
        outcomes.append(ask.outcome(
            abs(got / want - 1), f"v_t falls by {got:.8g} m/s", f"{want:.8g} m/s",
            f"e_n = {case[1]:g}, mu = {case[2]:.3g}, tan(angle) = {case[3] / case[4]:.3g}"))
    return outcomes


ENERGY = 0.01  # the right answer gains up to 0.0012 at 24 steps per contact, less with more


@check("invariants", 8, "kinetic energy, e_n = 1", tol=ENERGY, sharp=True,
       cause="the spring must advance before it is used, in every step, Eq. (53); and a slipping "
             "spring must have the length of the limit, Eq. (55)")
def no_gain(ask):
    """Elastic impacts at any angle, with any friction: never more energy than before"""
    cases = [(ask.uniform(0.2, 0.5), 1.0, ask.log_uniform(0.05, 0.7),
              *tilted(ask.log_uniform(0.1, 10))) for _ in range(200)]
    spheres, vn, _ = impacts(ask, cases, 24)
    ratios = [a * a + b * b + 0.4 * c * c for a, b, c in zip(spheres.vt, vn, spheres.w)]
    k = max(range(len(cases)), key=ratios.__getitem__)
    if min(ratios) > 0.9:
        return ask.outcome(math.inf, "no impact that loses a tenth", "losses, where it slides")
    return ask.outcome(max(0.0, ratios[k] - 1), f"{ratios[k]:.5g} times the energy before",
                       f"at most {1 + ENERGY} times",
                       "nu = {:.3g}, e_n = {:g}, mu = {:.3g}, sine of the angle = {:.3g}".format(
                           *cases[k][:4]))


@check("convergence", 15, "the rebound of the same model, integrated by GSL", sharp=True,
       cause="the rebound does not become the right one with smaller steps: the order of Eqs. (53) "
             "and (6), or the reset of Eq. (55)")
def oblique_impact(ask):
    """Steps per contact from 16 to 256: the error of the rebound falls with order 1"""
    table = ask.reference("rebound", [(float(k),) for k in range(OBLIQUE)])
    errors = []
    for steps in 16, 64, 256:
        cases = [(0.3, *line[:4]) for line in table]
        spheres, _, _ = impacts(ask, cases, steps)
        squares = [(v - line[4]) ** 2 + (w - line[5]) ** 2
                   for v, w, line in zip(spheres.vt, spheres.w, table)]
        errors.append(math.sqrt(sum(squares) / len(squares)))
    slope = math.log(errors[0] / errors[2]) / math.log(16) if min(errors) > 0 else 0.0
    text = ", ".join(f"{x:.2g}" for x in errors)
    good = 0.7 < slope < 1.6 and errors[2] < 0.001
    return ask.outcome(0 if good else math.inf, f"errors {text}: order {slope:.2f}",
                       "order 1 (0.7 to 1.6), and an error below 0.001 in the end")


@check("clean", 10, "a function of its arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    rows = contacts(ask, 40, 0.2, 5, turned=1)
    outcome = ask.same_bits("sliding_force", rows)
    if not any(norm(result[F]) for result in ask.call("sliding_force", rows)):
        return ask.outcome(math.inf, "no force at all", "friction",
                           cause="sliding_force does nothing yet")
    return outcome

"""Exercise 03: semi-implicit Euler and Stokes drag."""
import math

from grader.course import check
from grader.vec import norm, scale, sub

TITLE = "Time step and drag"
LEVEL = "*"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"step": ("x y z vx vy vz wx wy wz fx fy fz tx ty tz R rho eta gx gy gz dt",
                      "x y z vx vy vz wx wy wz")}
ZERO = (0.0, 0.0, 0.0)
X, V, W = slice(0, 3), slice(3, 6), slice(6, 9)


def vector(ask, size):
    return scale(size * ask.uniform(0.2, 1), ask.direction())


def grain(ask):
    """Radius and density."""
    return ask.log_uniform(1e-3, 0.1), ask.log_uniform(100, 1e4)


def row(motion, f=ZERO, t=ZERO, body=(0.01, 1000.0), eta=0.0, g=ZERO, dt=1e-3):
    """The arguments of step(). motion: 9 numbers."""
    return (*motion, *f, *t, *body, eta, *g, dt)


@check("contract", 10, "Eqs. (42)-(46) without forces", tol=1e-14, sharp=True,
       cause="x must move by dt v, and v and w must stay; eta = 0 is a vacuum: do not divide by c")
def free_flight(ask):
    """Without force, gravity and fluid, a sphere flies on; dt = 0 changes nothing"""
    outcomes, rows = [], []
    for _ in range(20):
        motion = (*vector(ask, 1), *vector(ask, 10), *vector(ask, 100))
        rows.append(row(motion, body=grain(ask), dt=ask.sign() * 0.005 + 0.005))  # 0 or 0.01
    for r, after in zip(rows, ask.call("step", rows)):
        expected = tuple(x + r[21] * v for x, v in zip(r[0:3], r[3:6])) + r[3:9]
        for part in X, V, W:
            outcomes.append(ask.outcome(
                norm(sub(after[part], expected[part])) / norm(expected[part]),
                "({:.6g}, {:.6g}, {:.6g})".format(*after[part]),
                "({:.6g}, {:.6g}, {:.6g})".format(*expected[part]), ask.inputs("step", r)))
    return outcomes


def steps_of_all_kinds(ask):
    """Rows with every term of the equations of motion, all of about the same size."""
    rows = []
    for _ in range(40):
        (R, rho), dt = grain(ask), ask.log_uniform(1e-4, 1e-2)
        m = ask.reference("mass", [(R, rho)])[0][0]
        eta = ask.uniform(0.02, 0.2) * rho * R * R / dt  # c dt = 0.1 ... 0.9
        motion = (*vector(ask, dt), *vector(ask, 1), *vector(ask, 1))
        rows.append(row(motion, vector(ask, m / dt), vector(ask, m * R * R / dt), (R, rho), eta,
                        vector(ask, 1 / dt), dt))
    return rows


# Tolerances: rounding errors, 1e-15 for any way to write the formulas, times a margin for sums.
@check("pointwise", 20, "Eqs. (3), (42), (44), (45)", tol=1e-12,
       cause="a term of Eq. (42): f/m, g, -c v with c = 9 eta/(2 rho R^2); or the order of "
             "Eqs. (44), (45)")
def linear_motion(ask):
    """Position and velocity after one step with force, gravity and drag"""
    rows = steps_of_all_kinds(ask)
    want = ask.reference("step", rows)
    velocity = ask.compare("step", rows, want, part=V)
    position = ask.compare("step", rows, want, part=X)
    if velocity.error <= 1e-12:
        position.cause = "the position must move with the new velocity: Eq. (44) before Eq. (45)"
    return [velocity, position]


@check("pointwise", 15, "Eqs. (4), (43), (46)", tol=1e-12, unit="1/s",
       cause="I = 2/5 m R^2 for a solid sphere; gamma = 10/3 c")
def spin(ask):
    """Angular velocity after one step with torque and drag"""
    rows = steps_of_all_kinds(ask)
    return ask.compare("step", rows, part=W)


def repeat(ask, first, count, force=None):
    """The motions of `count` steps, one after the other; force: function of a motion."""
    motion, rest = first[0:9], first[9:]
    for _ in range(count):
        f = force(motion) if force else rest[0:3]
        motion = ask.call("step", [(*motion, *f, *rest[3:])])[0]
        yield motion


@check("invariants", 10, "Eqs. (44), (45) conserve m v^2/2 + k x^2/2 - k dt x v/2", tol=1e-11,
       cause="the position must move with the new velocity, Eq. (45) after Eq. (44): the other "
             "order makes the energy grow in every step; or f is not divided by m")
def energy(ask):
    """A sphere on a spring, 500 steps of a 60th of a period: energy oscillates, but never drifts"""
    R, rho = grain(ask)
    m, dt = ask.reference("mass", [(R, rho)])[0][0], ask.log_uniform(1e-4, 1e-2)
    k = m * (0.1 / dt) ** 2
    first = row((*vector(ask, 1), *vector(ask, 0.1 / dt), *ZERO), body=(R, rho), dt=dt)

    def shadow(s):
        """What semi-implicit Euler conserves exactly instead of the energy."""
        return sum(m * v * v + k * x * x - k * dt * x * v for x, v in zip(s[X], s[V])) / 2

    worst, start, turns = 0.0, shadow(first), 0
    old = first
    for motion in repeat(ask, first, 500, lambda s: scale(-k, s[X])):
        worst = max(worst, abs(shadow(motion) / start - 1))
        turns, old = turns + (old[0] * motion[0] < 0), motion
    if not 15 <= turns <= 17:  # two in each of 500/62.8 periods
        return ask.outcome(math.inf, f"{turns} passages through x = 0", "16")
    return ask.outcome(worst, f"a change by {worst:.3g} of itself", "no change")


@check("invariants", 8, "v = g/c, Eq. (3)", tol=1e-11, unit="m/s",
       cause="gravity, or the rate c = 9 eta/(2 rho R^2), or the sign of the drag")
def terminal_velocity(ask):
    """After a long fall in a fluid, drag balances gravity"""
    outcomes = []
    for _ in range(3):
        (R, rho), dt = grain(ask), ask.log_uniform(1e-4, 1e-2)
        eta = 0.05 * rho * R * R / dt  # c dt = 0.225
        g = vector(ask, 10)
        c = ask.reference("rate", [(R, rho, eta)])[0][0]
        *_, last = repeat(ask, row((*ZERO, *vector(ask, 1), *ZERO), body=(R, rho), eta=eta, g=g,
                                   dt=dt), 200)
        error = norm(sub(last[V], scale(1 / c, g))) * c / norm(g)
        outcomes.append(ask.outcome(error, f"{norm(last[V]):.8g}", f"{norm(g) / c:.8g}",
                                    f"R = {R:.3g}, rho = {rho:.3g}, eta = {eta:.3g}"))
    return outcomes


@check("invariants", 7, "Eqs. (3), (4): v_n = v_0 (1 - c dt)^n, w_n = w_0 (1 - gamma dt)^n",
       tol=1e-11, cause="the factor 10/3 of Eq. (4), or another form of drag than -c v at the old "
                        "velocity")
def decay(ask):
    """Velocity and spin in a fluid decay by the same factor in every step"""
    (R, rho), dt, n = grain(ask), ask.log_uniform(1e-4, 1e-2), 40
    eta = 0.01 * rho * R * R / dt
    c, gamma = ask.reference("rate", [(R, rho, eta)])[0]
    first = row((*ZERO, *vector(ask, 1), *vector(ask, 1)), body=(R, rho), eta=eta, dt=dt)
    *_, last = repeat(ask, first, n)
    outcomes = []
    for part, rate, name in (V, c, "v"), (W, gamma, "w"):
        expected = scale((1 - rate * dt) ** n, first[part])
        outcomes.append(ask.outcome(norm(sub(last[part], expected)) / norm(expected),
                                    f"|{name}| = {norm(last[part]):.8g}",
                                    f"|{name}| = {norm(expected):.8g} after {n} steps"))
    return outcomes


@check("convergence", 15, "v' = g - c v, x' = v", sharp=True,
       cause="with half the step, half the error: if it does not shrink, a term of the equation of "
             "motion is wrong; if it shrinks faster, this is not Eqs. (44), (45)")
def order(ask):
    """A fall in a fluid, steps from T/20 to T/320: the error falls with order 1"""
    (R, rho), T, g = grain(ask), ask.log_uniform(0.1, 10), ask.uniform(5, 15)
    eta, v = 0.3 * rho * R * R / T, ask.uniform(0.5, 2) * g * T
    depth, speed = ask.reference("fall", [(R, rho, eta, g, v, T)])[0]
    errors = []
    for n in 20, 80, 320:
        first = row((*ZERO, 0, 0, -v, *ZERO), body=(R, rho), eta=eta, g=(0, 0, -g), dt=T / n)
        *_, last = repeat(ask, first, n)
        errors.append(abs(-last[2] - depth) / depth + abs(-last[5] - speed) / speed)
    slope = math.log(errors[0] / errors[2]) / math.log(16) if min(errors) > 0 else 0.0
    text = ", ".join(f"{x:.2g}" for x in errors)
    return ask.outcome(0 if 0.9 < slope < 1.1 else math.inf, f"errors {text}: order {slope:.2f}",
                       "order 1 (0.9 to 1.1)")


@check("clean", 10, "a function of its arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    rows = steps_of_all_kinds(ask)
    outcome = ask.same_bits("step", rows)
    if all(after == r[0:9] for r, after in zip(rows, ask.call("step", rows))):
        return ask.outcome(math.inf, "the motion that went in", "another motion",
                           cause="step() does nothing yet")
    return outcome

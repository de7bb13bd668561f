"""Exercise 09: orientations as quaternions."""
import math

from grader.course import check, number
from grader.vec import add, norm, scale, sub

TITLE = "Orientation: quaternions"
LEVEL = "**"
#: Functions of the answer: names of the numbers that go in and that come out.
Q = "q_0 q_1 q_2 q_3"
FUNCTIONS = {"product": ("p_0 p_1 p_2 p_3 " + Q, "s x y z"),
             "rotated": (Q + " a_x a_y a_z", "x y z"),
             "turned": (Q + " w_x w_y w_z alpha_x alpha_y alpha_z dt", "s x y z")}
UNTURNED, ZERO = (1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0)


def unit(ask):
    """A unit quaternion, any orientation."""
    while True:
        q = tuple(ask.uniform(-1, 1) for _ in range(4))
        if 0.1 < norm(q) < 1:
            return scale(1 / norm(q), q)


def vector(ask, size):
    return scale(size * ask.uniform(0.2, 1), ask.direction())


def apart(p, q):
    """The distance of two orientations: q and -q are the same one."""
    return min(norm(sub(p, q)), norm(add(p, q)))


def motion(ask, angle=1.0):
    """The arguments of turned: it turns by about `angle`, w and alpha in any two directions."""
    dt = ask.log_uniform(1e-4, 1)
    return (*unit(ask), *vector(ask, angle / dt), *vector(ask, 2 * angle / (dt * dt)), dt)


@check("contract", 10, "Eqs. (47), (48)", tol=1e-12, sharp=True,
       cause="w/|w| is 0/0 for a body that does not spin, alpha/|alpha| for a steady one; a slow "
             "rotation is a rotation as well")
def at_rest(ask):
    """Bodies without spin, without acceleration, with neither, and spins from 1e-20 to 1e-6"""
    q, w, alpha = unit(ask), vector(ask, 1), vector(ask, 1)
    rows = [(*q, *ZERO, *ZERO, 0.1), (*q, *w, *ZERO, 0.1), (*q, *ZERO, *alpha, 0.1),
            (*q, *w, *alpha, 0.0)]
    slow = [(*UNTURNED, *vector(ask, 10.0 ** -k), *ZERO, 2.0) for k in range(6, 21)]
    outcomes = []
    for row, now in zip(rows, ask.call("turned", rows, any_value=True)):
        still = row[10] == 0 or row[4:10] == ZERO + ZERO
        off = apart(now, q) if still else abs(norm(now) - 1)
        off = off if still or apart(now, q) > 1e-6 else math.inf
        outcomes.append(ask.outcome(off, number(now), f"{number(q)}, unchanged" if still else
                                    "another unit quaternion", ask.inputs("turned", row)))
    for row, now in zip(slow, ask.call("turned", slow, any_value=True)):
        w = row[4:7]  # dt/2 = 1: the vectorial part of a small rotation is w itself
        now = scale(-1.0, now) if now[0] < 0 else now
        outcomes.append(ask.outcome(norm(sub(now[1:], w)) / norm(w), number(now),
                                    f"(1, {number(w)[1:]}", ask.inputs("turned", row)))
    return outcomes


# Tolerances: rounding errors; the solutions have errors of 1e-15.
@check("pointwise", 10, "Eq. (49)", tol=1e-12,
       cause="the scalar part is p q minus the dot product, the vectorial part has + p x q: the "
             "order of the factors matters")
def hamilton(ask):
    """The product of two quaternions of any norm"""
    rows = [(*scale(ask.log_uniform(0.1, 10), unit(ask)), *scale(ask.log_uniform(0.1, 10),
                                                                unit(ask))) for _ in range(40)]
    return ask.compare("product", rows)


@check("pointwise", 10, "a' = q (0, a) q*", tol=1e-12,
       cause="q on the left, its conjugate on the right; the other way round turns backwards")
def rotate(ask):
    """A vector of the body, seen from the laboratory"""
    return ask.compare("rotated", [(*unit(ask), *vector(ask, 10)) for _ in range(40)])


@check("pointwise", 15, "Eqs. (47), (48) [D3]", tol=1e-12,
       cause="half the angle: phi = dt/2 |w|, theta = (dt/2)^2 |alpha|; both factors on the left of "
             "q, phi next to it")
def turn(ask):
    """One step with spin and acceleration in any two directions"""
    rows = [motion(ask, ask.log_uniform(1e-3, 1.5)) for _ in range(40)]
    return [ask.outcome(apart(now, want), number(now), number(want), ask.inputs("turned", row))
            for row, now, want in zip(rows, ask.call("turned", rows),
                                      ask.reference("turned", rows))]


def run(ask, state, w, alpha, dt, steps):
    """Orientations after some steps; state, w, alpha, dt: of bodies side by side."""
    for _ in range(steps):
        state = ask.call("turned", [(*q, *a, *b, h) for q, a, b, h in zip(state, w, alpha, dt)])
        w = [add(a, scale(h, b)) for a, b, h in zip(w, alpha, dt)]  # Eq. (46), afterwards
    return state


def quarter(axis, vector_):
    """A vector after a quarter turn about an axis of the laboratory, 0, 1 or 2: exact."""
    a, b = (axis + 1) % 3, (axis + 2) % 3
    new = list(vector_)
    new[a], new[b] = 0.0 - vector_[b], vector_[a]
    return tuple(new)


@check("invariants", 8, "Eq. (47) [D3]: quarter turns about the axes of the laboratory", tol=1e-10,
       sharp=True, cause="w is given in the frame of the laboratory: the new rotation belongs on "
                         "the left of q, not on its right as for the frame of the body; or rotated() turns "
                         "backwards")
def quarter_turns(ask):
    """A body after two quarter turns about x, then y, ... of the laboratory, 10 steps each"""
    outcomes = []
    for first in range(3):
        for second in {0, 1, 2} - {first}:
            q, axes = [UNTURNED], [tuple(float(k == m) for k in range(3)) for m in range(3)]
            for axis in first, second:
                w = tuple(math.pi / 2 * (k == axis) for k in range(3))
                q = run(ask, q, [w], [ZERO], [0.1], 10)
                axes = [quarter(axis, a) for a in axes]
            rows = [(*q[0], *(float(k == m) for k in range(3))) for m in range(3)]
            for name, got, want in zip("xyz", ask.call("rotated", rows), axes):
                clean = tuple(round(c, 9) + 0.0 for c in got)
                outcomes.append(ask.outcome(
                    norm(sub(got, want)), f"the {name} axis of the body points to {number(clean)}",
                    f"to {number(want)}", f"a quarter turn about {'xyz'[first]}, then one about "
                    f"{'xyz'[second]}"))
    return outcomes


def spinning(ask, count):
    """Angular velocities of about 1/s, for bodies side by side."""
    return [vector(ask, 1.0) for _ in range(count)]


@check("invariants", 5, "|q| = 1", tol=1e-12,
       cause="a rotation has norm 1 only with sine and cosine of the same angle; (1, dt/2 w) has "
             "not, and the product must be Eq. (49)")
def unit_norm(ask):
    """20 tumbling bodies, 100 steps: the norm stays 1"""
    w, alpha = spinning(ask, 20), [vector(ask, 0.2) for _ in range(20)]
    start = [unit(ask) for _ in w]
    end = run(ask, start, w, alpha, [0.1] * 20, 100)
    if min(apart(a, b) for a, b in zip(start, end)) < 1e-6:
        return ask.outcome(math.inf, "a body that has not turned", "bodies that tumble")
    worst = max((abs(norm(q) - 1), norm(q)) for q in end)
    return ask.outcome(worst[0], f"|q| = {worst[1]:.15g}", "|q| = 1")


def far_off(ask, got, want, text):
    """The worst of some orientations; an outcome."""
    k = max(range(len(got)), key=lambda n: apart(got[n], want[n]))
    return ask.outcome(apart(got[k], want[k]), number(got[k]), number(want[k]), text)


@check("invariants", 6, "q = (cos(w t/2), sin(w t/2) w/|w|)", tol=1e-12,
       cause="half the angle of the step, dt |w| / 2: a full turn takes q to -q, two take it back")
def steady_spin(ask):
    """Constant spin, half a radian per step, 50 steps: exact"""
    w, dt = spinning(ask, 20), ask.uniform(0.3, 0.7)
    end = run(ask, [UNTURNED] * 20, w, [ZERO] * 20, [dt] * 20, 50)
    want = ask.reference("spin", [(*a, 50 * dt) for a in w])
    return far_off(ask, end, want, f"dt = {dt:.3g}, 50 steps")


@check("invariants", 6, "angle = w t + alpha t^2/2", tol=1e-12,
       cause="the velocity at the beginning of the step turns by dt w, its change by dt^2/2 alpha: "
             "theta = (dt/2)^2 |alpha| is half of that; use w as it is given, the old one")
def run_up(ask):
    """Constant angular acceleration along the axis, from slow to fast, 50 steps: exact"""
    w, share, dt = spinning(ask, 20), [ask.uniform(0.05, 0.5) for _ in range(20)], 0.1
    alpha = [scale(s, a) for s, a in zip(share, w)]
    end = run(ask, [UNTURNED] * 20, w, alpha, [dt] * 20, 50)
    t = 50 * dt
    want = ask.reference("spin", [(*a, t + s * t * t / 2) for a, s in zip(w, share)])
    return far_off(ask, end, want, f"dt = {dt:g}, 50 steps")


@check("convergence", 15, "Eqs. (47), (48): order 2 when the axis moves", sharp=True,
       cause="no convergence: the new rotation is on the wrong side of q; order 1: alpha is not "
             "used, is used twice, or w is already that of the end of the step")
def order(ask):
    """Bodies whose axis of rotation moves, steps from T/20 to T/80: the error falls with order 2"""
    w, T = spinning(ask, 5), 2.0
    alpha = [vector(ask, 2.0) for _ in w]
    exact = ask.reference("tumble", [(*a, *b, T) for a, b in zip(w, alpha)])
    errors = []
    for n in 20, 40, 80:
        end = run(ask, [UNTURNED] * 5, w, alpha, [T / n] * 5, n)
        errors.append(norm([apart(a, b) for a, b in zip(end, exact)]) / math.sqrt(5))
    slope = math.log(errors[0] / errors[2]) / math.log(4) if min(errors) > 0 else 0.0
    text = ", ".join(f"{x:.2g}" for x in errors)
    good = 1.8 < slope < 2.2 and errors[2] < 1e-2
    return ask.outcome(0 if good else math.inf, f"errors {text}: order {slope:.2f}",
                       "order 2 (1.8 to 2.2), the last error below 0.01")


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    pairs = [(*unit(ask), *unit(ask)) for _ in range(40)]
    rows = [motion(ask) for _ in range(40)]
    outcomes = [ask.same_bits("product", pairs), ask.same_bits("turned", rows)]
    if all(now == p[0:4] for p, now in zip(pairs, ask.call("product", pairs))):
        return ask.outcome(math.inf, "p", "p q", cause="product() does nothing yet")
    return outcomes

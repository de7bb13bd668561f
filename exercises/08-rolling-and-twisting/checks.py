"""Exercise 08: rolling and twisting friction."""
import math

from grader.course import check, number
from grader.vec import add, cross, dot, norm, scale, sub

TITLE = "Rolling and twisting friction"
LEVEL = "**"
CONTACT = "n_x n_y n_z r_i r_j R* f_n k_n c_n k_s c_s"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"relative_spin": (CONTACT + " w_ix w_iy w_iz w_jx w_jy w_jz", "v_rx v_ry v_rz v_t"),
             "resisting_torque": ("u_rx u_ry u_rz u_t " + CONTACT + " v_rx v_ry v_rz v_t mu_s mu_r "
                                  "dt", "t_x t_y t_z u_rx u_ry u_rz u_t")}
LIMITS = {"cpu": 1}  # a right answer needs 0.01 s
ZERO = (0.0, 0.0, 0.0)
T, UR, UT = slice(0, 3), slice(3, 6), 6  # in a result of resisting_torque
N, LOAD, VR, VT = slice(4, 7), 10, slice(15, 18), 18  # in its arguments
HOLDS, YIELDS = (0.05, 0.9), (1.1, 20)  # trial force over limit


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
            return scale(size / math.sqrt(a * a + b * b),
                         add(scale(a, frame[1]), scale(b, frame[2])))


def radii(ask):
    """r_i, r_j, R*: two spheres, or a wall (one in four)."""
    ri, rj = ask.log_uniform(1e-3, 0.1), ask.log_uniform(1e-3, 0.1)
    rj = math.inf if ask.random.random() < 0.25 else rj
    return ri, rj, 1 / (1 / ri + 1 / rj) * ask.uniform(1.02, 1.1)


def spinning(ask):
    """The arguments of relative_spin, any angular velocities."""
    size = ask.log_uniform(0.1, 100)
    w = [scale(size * ask.uniform(0.3, 1), ask.direction()) for _ in range(2)]
    return (*ask.direction(), *radii(ask), 1.0, 1e3, 1.0, 8e2, 0.2, *w[0], *w[1])


def contact(ask, roll=HOLDS, twist=HOLDS, turned=0.0):
    """The arguments of resisting_torque; the trial forces are so many times their limit.

    turned: part of the rolling spring along n, over its length.
    """
    frame, dt = plane(ask), ask.log_uniform(1e-5, 1e-2)
    kn, length = ask.log_uniform(10, 1e5), ask.log_uniform(1e-6, 1e-3)
    ks, cn = kn * ask.uniform(0.6, 0.9), kn * dt * ask.uniform(0.1, 1)
    cs = cn * ask.uniform(0.2, 0.4)
    ur, ut = tangent(ask, frame, length), ask.sign() * ask.uniform(0.5, 1) * length
    vr = tangent(ask, frame, ask.uniform(0.1, 1) * length / dt)
    vt = ask.sign() * ask.uniform(0.1, 0.4) * length / dt
    trial_r = norm(add(scale(kn, add(ur, scale(dt, vr))), scale(cn, vr)))
    trial_t = abs(ks * (ut + dt * vt) + cs * vt)
    mur = ask.uniform(0.1, 1)
    load = trial_r / (mur * ask.log_uniform(*roll))
    mus = 1.5 * trial_t / (load * ask.log_uniform(*twist))
    ur = add(ur, scale(ask.sign() * ask.uniform(0.3, 1) * turned * length, frame[0]))
    return (*ur, ut, *frame[0], *radii(ask), ask.sign() * load, kn, cn, ks, cs, *vr, vt, mus, mur,
            dt)


def every_kind(ask, count):
    """Contacts in which rolling, twisting, both or none are at their limit."""
    return [contact(ask, roll, twist, turned) for turned in (0.0, 1.0) for roll in (HOLDS, YIELDS)
            for twist in (HOLDS, YIELDS) for _ in range(count)]


def split(torque, n):
    """The rolling part of a torque and the twisting part."""
    along = dot(torque, n)
    return sub(torque, scale(along, n)), along


@check("contract", 10, "Eqs. (36), (39)-(41), (52)", tol=1e-12, sharp=True,
       cause="1/(1/r_i + 1/r_j) is right for r_j = infinity, r_i r_j/(r_i + r_j) is not; division "
             "by a length that may be zero; a limit without the absolute value of f_n")
def limits(ask):
    """Finite at walls, for springs of length 0 or along n, without load; never above the limits"""
    wall = [spinning(ask) for _ in range(10)]
    wall = [(*r[:4], math.inf, *r[5:]) for r in wall]
    if not all(norm(v) > 0 for v in ask.call("relative_spin", wall)):
        return ask.outcome(math.inf, "0 m/s", "a rolling and a twisting velocity at a wall")
    rows = every_kind(ask, 2)
    for r in rows[:8]:
        rows += [(*ZERO, 0.0, *r[4:]), (*ZERO, 0.0, *r[4:15], *ZERO, 0.0, *r[19:]),
                 (*r[:10], 0.0, *r[11:]), (*r[:19], 0.0, 0.0, r[21])]
    axis = (0.0, -1.0, 0.0)  # exactly along n
    rows.append((*scale(1e-4, axis), rows[0][3], *axis, *rows[0][7:15], 1.0, 0.0, 0.0,
                 *rows[0][18:]))
    moved = 0
    for row, result in zip(rows, ask.call("resisting_torque", rows)):
        n, load, Rstar = row[N], abs(row[LOAD]), row[9]
        roll, twist = split(result[T], n)
        moved += norm(roll) > 0 and twist != 0
        for name, got, most in (("rolling", norm(roll), Rstar * row[20] * load),
                                ("twisting", abs(twist), Rstar * row[19] * load * 2 / 3)):
            if not got <= most * (1 + 1e-12) + 1e-12 * norm(result[T]):
                return ask.outcome(math.inf, f"{name} torque {got:.6g} N m",
                                   f"at most {most:.6g} N m", ask.inputs("resisting_torque", row))
        if not abs(dot(result[UR], n)) <= 1e-12 * max(norm(row[0:3]), norm(result[UR])):
            return ask.outcome(math.inf, f"u_r.n = {dot(result[UR], n):.3g} m", "0",
                               ask.inputs("resisting_torque", row),
                               "the rolling spring is not turned into the plane, Eq. (52)")
    return ask.outcome(0 if moved > 8 else math.inf, f"{moved} torques with both parts",
                       "friction in most of the contacts")


# Tolerances: rounding errors, below 1e-14 for both solutions, times a margin for sums.
@check("pointwise", 8, "Eqs. (36)-(38)", tol=1e-12, unit="m/s",
       cause="the difference of the angular velocities, and w x n in this order; r belongs to v_r, "
             "R* to v_t")
def rates(ask):
    """Rolling and twisting velocity of two spheres, and of a sphere at a wall"""
    rows = [spinning(ask) for _ in range(40)]
    want = ask.reference("relative_spin", rows)
    return [ask.compare("relative_spin", rows, want, part=part) for part in (slice(0, 3),
                                                                             slice(3, 4))]


def compare_mode(ask, rows, part_of_torque, part_of_springs, name):
    """The part of the torque and the spring of one mode against the reference; outcomes."""
    want, outcomes = ask.reference("resisting_torque", rows), []
    for row, got, right in zip(rows, ask.call("resisting_torque", rows), want):
        (a, b), (p, q) = ([part_of_torque(split(r[T], row[N])), part_of_springs(r)]
                          for r in (got, right))
        force = norm(sub(a, p)) / (norm(p) + 0.01 * norm(got[T]))  # rounding of the other mode
        spring = norm(sub(b, q)) / norm(q)
        at = ask.inputs("resisting_torque", row)
        outcomes.append(ask.outcome(force, f"{name} torque {number(a)} N m",
                                    f"{number(p)} N m", at))
        outcomes.append(ask.outcome(spring, f"u = {number(b)} m", f"{number(q)} m", at,
                                    "the torque is right; the spring that the next step gets is "
                                    "not" if force <= 1e-12 else ""))
    return outcomes


@check("pointwise", 14, "Eqs. (32), (34), (39), (52)-(55)", tol=1e-12,
       cause="k_n, c_n and mu_r |f_n|; the torque is R* n x f_r in this order; the spring turns "
             "at its old length, advanced, and shortened where the force is")
def rolling(ask):
    """The rolling part of the torque and its spring: held, at the limit, and turned"""
    return compare_mode(ask, every_kind(ask, 8), lambda parts: parts[0], lambda r: r[UR], "rolling")


@check("pointwise", 13, "Eqs. (33), (35), (40), (41), (53)-(55)", tol=1e-12,
       cause="k_s, c_s and mu_t |f_n| with mu_t = 2/3 mu_s; a force of either sign has the limit, "
             "and keeps its sign")
def twisting(ask):
    """The twisting part of the torque and its spring: held, and at the limit"""
    return compare_mode(ask, every_kind(ask, 8), lambda parts: (parts[1],), lambda r: (r[UT],),
                        "twisting")


@check("invariants", 5, "Eq. (38)", tol=1e-12, unit="m/s",
       cause="only the difference of the angular velocities counts: two spheres that turn like one "
             "body neither roll nor twist")
def co_rotation(ask):
    """Turn the table on which everything happens: the same rolling and twisting velocity"""
    rows = [spinning(ask) for _ in range(30)]
    extra = [scale(norm(r[11:14]), ask.direction()) for r in rows]
    turned = [(*r[:11], *add(r[11:14], w), *add(r[14:17], w)) for r, w in zip(rows, extra)]
    outcomes = []
    for r, a, b in zip(rows, ask.call("relative_spin", rows), ask.call("relative_spin", turned)):
        if norm(a) == 0:
            return ask.outcome(math.inf, "0", "a motion", ask.inputs("relative_spin", r))
        outcomes.append(ask.outcome(norm(sub(a, b)) / norm(a), number(b), number(a),
                                    ask.inputs("relative_spin", r)))
    return outcomes


def one_step(ask, rows, spins):
    """A step with both functions. rows: arguments of resisting_torque, whose velocities are
    replaced; spins: w_i and w_j of each, 6 numbers."""
    rates_ = ask.call("relative_spin", [(*r[4:15], *w) for r, w in zip(rows, spins)])
    return ask.call("resisting_torque",
                    [(*r[:15], *v, *r[19:]) for r, v in zip(rows, rates_)])


@check("invariants", 5, "Eqs. (58), (59), names exchanged", tol=1e-12, unit="N m",
       cause="i and j are only names: exchange them and n, and the torque on the other body must "
             "be the opposite one, with the same springs; look at the order in the cross products")
def exchange(ask):
    """The same contact, with the names of i and j exchanged: the opposite torque"""
    rows = [r for r in every_kind(ask, 6) if r[8] < math.inf]
    spins = [(*scale(norm(r[VR]) / r[9], ask.direction()),
              *scale(norm(r[VR]) / r[9], ask.direction())) for r in rows]
    mirrored = [(*r[:4], *scale(-1, r[N]), r[8], r[7], *r[9:]) for r in rows]
    swapped = [(*w[3:], *w[:3]) for w in spins]
    outcomes = []
    for r, a, b in zip(rows, one_step(ask, rows, spins), one_step(ask, mirrored, swapped)):
        if norm(a[T]) == 0:
            return ask.outcome(math.inf, "no torque", "friction")
        at = ask.inputs("resisting_torque", r)
        outcomes.append(ask.outcome(norm(add(a[T], b[T])) / norm(a[T]), number(b[T]),
                                    number(scale(-1, a[T])), at))
        outcomes.append(ask.outcome(norm(sub(a[3:], b[3:])) / norm(a[3:]),
                                    f"springs {number(b[3:])}", number(a[3:]), at))
    return outcomes


class OnPlane:
    """Spheres of mass 1 on planes, side by side; a frame (normal and two tangents) for each."""

    def __init__(self, ask, count):
        self.ask, self.frames = ask, [plane(ask) for _ in range(count)]
        self.R = [ask.uniform(0.5, 2) for _ in range(count)]
        self.springs = [(*ZERO, 0.0)] * count

    def torques(self, w, fn, laws, mu, dt):
        """Torques on the spheres. Lists: angular velocities, loads, (kn, cn, ks, cs), (mu_s, mu_r),
        time steps."""
        rows = [(*u, *f[0], R, math.inf, R, load, *law, *ZERO, 0.0, *m, h)
                for u, f, R, load, law, m, h in zip(self.springs, self.frames, self.R, fn, laws, mu,
                                                    dt)]
        results = one_step(self.ask, rows, [(*a, *ZERO) for a in w])
        self.springs = [r[3:] for r in results]
        return [r[T] for r in results]


def stiff(M, dt):
    """Stiffness and damping with which a mass M comes to rest in some 30 steps."""
    return 0.09 * M / (dt * dt), 0.6 * M / dt


# Tolerance: rounding errors of 250 steps.
@check("invariants", 8, "I dw/dt = -mu |f_n| R, then rest", tol=1e-10, unit="1/s",
       cause="at the limit both torques are constant, mu_r |f_n| R* and mu_t |f_n| R*, each by "
             "itself; and the springs must let go when the sphere comes to rest")
def spin_down(ask):
    """A sphere on ice spins about a slanted axis: both parts of its spin fall linearly, to 0"""
    spheres, n = OnPlane(ask, 6), 6
    mu = [(ask.uniform(0.1, 0.5), ask.uniform(0.1, 0.5)) for _ in range(n)]
    dt, fn = [ask.log_uniform(1e-3, 1e-2) for _ in range(n)], [ask.uniform(1, 10) for _ in range(n)]
    laws = [stiff(0.4, h) + stiff(0.4, h) for h in dt]  # I/R^2 = 0.4
    # The change per step; twisting stops after 97.3 steps, rolling after 71.6.
    slow = [(f * m[1] * h / (0.4 * R), f * m[0] * h / (0.6 * R))
            for f, m, h, R in zip(fn, mu, dt, spheres.R)]
    axes = [tangent(ask, f, 1.0) for f in spheres.frames]
    w = [add(scale(71.6 * a, t), scale(97.3 * b, f[0]))
         for (a, b), t, f in zip(slow, axes, spheres.frames)]
    outcomes = []
    for step in range(1, 251):
        torques = spheres.torques(w, fn, laws, mu, dt)
        w = [add(a, scale(h / (0.4 * R * R), t)) for a, h, R, t in zip(w, dt, spheres.R, torques)]
        if step not in (50, 250):
            continue
        for (a, b), t, f, got, m in zip(slow, axes, spheres.frames, w, mu):
            left = [max(0.0, steps - step) for steps in (71.6, 97.3)]
            want = add(scale(left[0] * a, t), scale(left[1] * b, f[0]))
            roll, twist = split(got, f[0])
            outcomes.append(ask.outcome(
                norm(sub(got, want)) / (50 * (a + b)), f"{dot(roll, t):.8g} rolling, {twist:.8g} "
                "twisting", f"{left[0] * a:.8g}, {left[1] * b:.8g}",
                f"{'halfway' if step == 50 else 'long after the end'}, mu_s = {m[0]:.3g}, "
                f"mu_r = {m[1]:.3g}"))
    return outcomes


# Tolerance: rounding errors of 400 steps.
@check("invariants", 7, "tan(angle) <= mu_r, or a = 5/7 g (sin - mu_r cos)", tol=1e-10,
       cause="rolling friction holds the sphere up to tan(angle) = mu_r, with the spring "
             "u = m g sin(angle)/k_n; above, the torque is mu_r f_n R*")
def incline(ask):
    """A sphere on a plane that is tilted slowly: it stays, up to tan(angle) = mu_r, then rolls"""
    shares = (0.5, 0.9, 0.99, 1.01, 1.1, 2.0)
    n, g = len(shares), 9.81
    spheres, mur = OnPlane(ask, n), [ask.uniform(0.1, 0.5) for _ in shares]
    dt = [ask.log_uniform(1e-3, 1e-2) for _ in shares]
    laws = [stiff(1.4, h) + stiff(0.4, h) for h in dt]  # M = m + I/R^2 = 1.4 m
    mu = [(ask.uniform(0.1, 0.5), m) for m in mur]
    x, v, before, axes = [0.0] * n, [0.0] * n, [], [cross(f[0], f[1]) for f in spheres.frames]
    for step in range(1, 401):
        tilt = [s * m * min(1.0, step / 200) for s, m in zip(shares, mur)]
        cos = [1 / math.sqrt(1 + t * t) for t in tilt]
        spins = [scale(a / R, axis) for a, R, axis in zip(v, spheres.R, axes)]
        torques = spheres.torques(spins, [g * c for c in cos], laws, mu, dt)
        for k, (t, c, h) in enumerate(zip(tilt, cos, dt)):  # it rolls without slipping
            v[k] += h / 1.4 * (g * t * c + dot(torques[k], axes[k]) / spheres.R[k])
            x[k] += h * v[k]
        before = list(v) if step == 250 else before
    outcomes = []
    for share, m, h, law, place, a, b, c in zip(shares, mur, dt, laws, x, before, v, cos):
        at = f"mu_r = {m:.3g}, tan(angle) = {share:g} mu_r"
        if share < 1:
            want = g * share * m * c / law[0]
            outcomes.append(ask.outcome(abs(place / want - 1), f"it has rolled {place:.8g} m",
                                        f"{want:.8g} m, and rests", at))
        else:
            want = 5 / 7 * g * (share - 1) * m * c
            got = (b - a) / (150 * h)
            outcomes.append(ask.outcome(abs(got - want) / (g * share * m * c),
                                        f"a = {got:.8g} m/s^2", f"{want:.8g} m/s^2", at))
    return outcomes


LAST_ERROR = 0.022  # with 256 steps; the right answer has 0.005 to 0.010


@check("convergence", 15, "M x'' = F - k x - c x'", sharp=True,
       cause="the motion does not become the right one with smaller steps: k_n, c_n for rolling, "
             "k_s and c_s for twisting; the dashpot; or the levers of Eqs. (32), (33), (36), (37)")
def order(ask):
    """Spheres rock and twist to and fro, held by their springs: the error falls with order 1"""
    n = 8
    spheres, fn, mu = OnPlane(ask, n), [100.0] * n, [(1e3, 1e3)] * n
    laws = []
    for _ in range(n):
        kr = ask.uniform(10, 100)
        kt = kr * ask.uniform(0.2, 0.6)
        laws.append((kr, ask.uniform(0.1, 0.5) * math.sqrt(1.4 * kr),
                     kt, ask.uniform(0.1, 0.5) * math.sqrt(0.4 * kt)))
    F, wt = [ask.uniform(1, 5) for _ in range(n)], [ask.uniform(1, 3) for _ in range(n)]
    spans = [6 * math.sqrt(1.4 / law[0]) for law in laws]
    want = ask.reference("rocking", [(1.4, law[0], law[1], f, 0.0, t)
                                     for law, f, t in zip(laws, F, spans)])
    turn = ask.reference("rocking", [(0.4, law[2], law[3], 0.0, w * R, t)
                                     for law, w, R, t in zip(laws, wt, spheres.R, spans)])
    axes, errors = [cross(f[0], f[1]) for f in spheres.frames], []
    for steps in 16, 64, 256:
        dt = [t / steps for t in spans]
        x, v, w, spheres.springs = [0.0] * n, [0.0] * n, list(wt), [(*ZERO, 0.0)] * n
        for _ in range(steps):
            spins = [add(scale(a / R, axis), scale(b, f[0]))
                     for a, R, axis, b, f in zip(v, spheres.R, axes, w, spheres.frames)]
            for k, t in enumerate(spheres.torques(spins, fn, laws, mu, dt)):
                R, h = spheres.R[k], dt[k]
                v[k] += h / 1.4 * (F[k] + dot(t, axes[k]) / R)  # rolls, pulled by F
                x[k] += h * v[k]
                w[k] += h / (0.4 * R * R) * dot(t, spheres.frames[k][0])
        errors.append(math.sqrt(sum(
            ((a - p[0]) * law[0] / f) ** 2 + ((b * R - q[1]) / (c * R)) ** 2
            for a, p, law, f, b, R, q, c in zip(x, want, laws, F, w, spheres.R, turn, wt)) / n))
    slope = math.log(errors[0] / errors[2]) / math.log(16) if min(errors) > 0 else 0.0
    good = 0.8 < slope < 1.3 and errors[2] < LAST_ERROR
    return ask.outcome(0 if good else math.inf, "errors " + ", ".join(f"{e:.2g}" for e in errors)
                       + f": order {slope:.2f}",
                       f"order 1 (0.8 to 1.3), and an error below {LAST_ERROR} in the end")


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    return [ask.same_bits("relative_spin", [spinning(ask) for _ in range(30)]),
            ask.same_bits("resisting_torque", every_kind(ask, 4))]

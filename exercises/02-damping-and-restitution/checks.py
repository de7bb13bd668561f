"""Exercise 02: damping and restitution."""
import math

from grader.course import check

TITLE = "Damping and restitution"
LEVEL = "*"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"damping_factor": ("e_n", "beta"),
             "damping": ("k_n m_i m_j e_n", "c_n"),
             "normal_force": ("delta v_n k_n c_n", "f_n")}


@check("contract", 10, "Eq. (21)", sharp=True,
       cause="ln 0 = -inf and pi / ln 1 = pi / 0: write Eq. (21) so that both limits come out, or "
             "treat them apart; and test delta before anything else")
def limits(ask):
    """beta(0) = 1, beta(1) = 0, beta falls in between; no force when the spheres are apart"""
    en = [k / 20 for k in range(21)]
    beta = [b for b, in ask.call("damping_factor", [(e,) for e in en], any_value=True)]
    for e, b in zip(en, beta):
        if not 0 <= b <= 1:  # true for nan as well
            return ask.outcome(math.inf, f"beta = {b:.6g}", "0 <= beta <= 1", f"e_n = {e:g}")
    if not (beta[0] == 1 and abs(beta[-1]) < 1e-15):
        return ask.outcome(math.inf, f"beta(0) = {beta[0]:.6g}, beta(1) = {beta[-1]:.6g}",
                           "beta(0) = 1, beta(1) = 0")
    if sorted(beta, reverse=True) != beta:
        return ask.outcome(math.inf, "beta grows somewhere", "less damping for larger e_n")
    rows = [(-ask.log_uniform(1e-9, 1), ask.uniform(-2, 2), ask.log_uniform(1, 1e6),
             ask.log_uniform(1e-3, 10)) for _ in range(20)]
    for row, (f,) in zip(rows, ask.call("normal_force", rows, any_value=True)):
        if f != 0:
            return ask.outcome(math.inf, f"{f:.3g} N", "0 N", ask.inputs("normal_force", row))
    return ask.outcome(0)


# Tolerances of the pointwise checks: the right formula, written in any way, has an error of 1e-15.
@check("pointwise", 10, "Eq. (21)", tol=1e-12,
       cause="Eq. (21): the natural logarithm (std::log), the square, the root of the whole sum")
def beta(ask):
    """The damping factor for e_n from 0.001 to 0.999"""
    return ask.compare("damping_factor", [(ask.uniform(0.001, 0.999),) for _ in range(40)],
                       scale=1e-3)


@check("pointwise", 15, "Eqs. (18), (20)", tol=1e-12, unit="kg/s",
       cause="Eq. (18): sqrt(5 m* k_n) times beta, with m* of both masses, Eq. (20)")
def coefficient(ask):
    """The damping coefficient, for light and heavy partners"""
    rows = [(ask.log_uniform(1, 1e6), ask.log_uniform(1e-4, 1), ask.log_uniform(1e-4, 1),
             ask.uniform(0.05, 0.95)) for _ in range(40)]
    return ask.compare("damping", rows, ratios={
        2 / math.sqrt(5): "the factor 2 of a linear spring; Hertz's force needs sqrt(5), Eq. (18)",
        1 / math.sqrt(5): "the factor sqrt(5) of Eq. (18) is missing",
        math.sqrt(5): "5 outside of the root: it is sqrt(5 m* k_n)"})


@check("pointwise", 10, "Eqs. (5), (10)", tol=1e-12, unit="N",
       cause="f_n = k_n delta - c_n v_n: the spring pushes the spheres apart, the dashpot acts "
             "against the velocity; the sum may be negative")
def force(ask):
    """The normal force, while the spheres approach and while they part"""
    rows = []
    for _ in range(40):
        delta, kn, cn = (ask.log_uniform(*r) for r in ((1e-6, 1e-2), (1, 1e6), (1e-3, 10)))
        share = ask.sign() * ask.log_uniform(0.01, 100)  # damping force / spring force
        rows.append((delta, (1.001 if share == 1 else share) * kn * delta / cn, kn, cn))
    return ask.compare("normal_force", rows)


def cases(ask, en_values):
    """Impacts: (e_n, speed, m_i, m_j, K), where k_n = K sqrt(delta); masses differ up to 1000."""
    return [(en, ask.log_uniform(0.01, 10), ask.log_uniform(1e-3, 1), ask.log_uniform(1e-3, 1),
             ask.log_uniform(1e3, 1e7)) for en in en_values]


def reduced(case):
    """1 / (1/m_i + 1/m_j)"""
    return case[2] * case[3] / (case[2] + case[3])


def accelerations(ask, which, deltas, speeds):
    """d(v_n)/dt of impacts, from the functions of the answer."""
    kn = [case[4] * math.sqrt(delta) for case, delta in zip(which, deltas)]
    cn = ask.call("damping", [(k, c[2], c[3], c[0]) for k, c in zip(kn, which)])
    rows = [(d, v, k, c) for d, v, k, (c,) in zip(deltas, speeds, kn, cn)]
    return [f / reduced(case) for case, (f,) in zip(which, ask.call("normal_force", rows))]


def slopes(ask, which, state):
    """d(y, v_n)/dtau with y = delta^(5/4), dtau = delta^(1/4) dt: smooth, see README.md."""
    deltas = [max(y, 0.0) ** 0.8 for y, _ in state]
    rates = accelerations(ask, which, deltas, [v for _, v in state])
    return [(-1.25 * v, a / delta ** 0.25 if delta > 0 else 0.0)
            for (_, v), a, delta in zip(state, rates, deltas)]


def moved(state, steps, rates):
    return [(y + h * dy, v + h * dv) for (y, v), h, (dy, dv) in zip(state, steps, rates)]


def runge_kutta(ask, which, state, h):
    """A step of the classical method, with a step h of its own for every impact."""
    half = [x / 2 for x in h]
    a = slopes(ask, which, state)
    b = slopes(ask, which, moved(state, half, a))
    c = slopes(ask, which, moved(state, half, b))
    d = slopes(ask, which, moved(state, h, c))
    mean = [tuple((p + 2 * q + 2 * r + s) / 6 for p, q, r, s in zip(*four))
            for four in zip(a, b, c, d)]
    return moved(state, h, mean)


def measured_restitution(ask, impacts, resolution=40):
    """Rebound speed / impact speed of every impact, to 1e-6; None if it does not end."""
    full = [math.pi / (math.sqrt(1.25 * c[4] / reduced(c)) * resolution) for c in impacts]
    deepest = [1.25 * c[1] * h * resolution / math.pi for c, h in zip(impacts, full)]
    state = [(1e-12 * y, -c[1]) for c, y in zip(impacts, deepest)]
    result, active = [None] * len(impacts), list(range(len(impacts)))
    for _ in range(6 * resolution):
        h = []
        for k in active:  # near the end of the contact, steps that land just before it
            y, v = state[k]
            h.append(0.9 * y / (1.25 * v) if 1.25 * v * full[k] > y else full[k])
        new = runge_kutta(ask, [impacts[k] for k in active], [state[k] for k in active], h)
        for k, s in zip(active, new):
            state[k] = s
            if s[1] > 0 and s[0] < 1e-8 * deepest[k]:
                result[k] = s[1] / impacts[k][1]
        active = [k for k in active if result[k] is None and abs(state[k][1]) < 1e3 * impacts[k][1]]
        if not active:
            break
    return result


# Tolerance: the integration above is exact to 2e-6.
@check("invariants", 15, "v_n' = -e_n v_n, with Eqs. (5), (18), (20), (21)", tol=2e-5,
       cause="the impact does not end with the restitution that was asked for: a factor in c_n, or "
             "a force that is not allowed to attract at the end of the contact")
def restitution(ask):
    """Measured restitution = e_n, for every speed, stiffness and ratio of masses"""
    impacts = cases(ask, [0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95, 1.0])
    outcomes = []
    for case, e in zip(impacts, measured_restitution(ask, impacts)):
        at = "e_n = {:g}, v = {:.3g}, m_i = {:.3g}, m_j = {:.3g}, K = {:.3g}".format(*case)
        if e is None:
            return ask.outcome(math.inf, "an impact that does not end", f"e = {case[0]:g}", at)
        outcomes.append(ask.outcome(abs(e - case[0]), f"e = {e:.6g}", f"e = {case[0]:g}", at))
    return outcomes


@check("invariants", 10, "Eq. (5)", sharp=True,
       cause="the sign of the dashpot, or a force that is cut off at 0: at the end of a contact "
             "the dashpot holds the spheres back, which is what makes e equal to e_n")
def passive(ask):
    """The dashpot takes energy in both directions of motion, also when the sum attracts"""
    rows = [(ask.log_uniform(1e-6, 1e-2), ask.sign() * ask.log_uniform(0.01, 100),
             ask.log_uniform(1, 1e4), ask.log_uniform(0.1, 10)) for _ in range(40)]
    moving = ask.call("normal_force", rows)
    still = ask.call("normal_force", [(d, 0.0, kn, cn) for d, _, kn, cn in rows])
    for row, (f,), (f0,) in zip(rows, moving, still):
        if not ((f - f0) * row[1] < 0 and f0 > 0 and (f < 0) == (row[1] * row[3] > f0)):
            return ask.outcome(math.inf, f"{f:.4g} N, and {f0:.4g} N at v_n = 0",
                               "a push at rest; less while parting, more while approaching",
                               ask.inputs("normal_force", row))
    return ask.outcome(0)


def coarse_restitution(ask, impacts, n):
    """The same impacts with the solver's method, n equal steps in the contact of an elastic one."""
    deepest = [(1.25 * reduced(c) * c[1] ** 2 / c[4]) ** 0.4 for c in impacts]
    dt = [2.94 * d / (c[1] * n) for d, c in zip(deepest, impacts)]
    state, active = [(0.0, -c[1]) for c in impacts], list(range(len(impacts)))
    for _ in range(8 * n):
        a = accelerations(ask, [impacts[k] for k in active], [state[k][0] for k in active],
                          [state[k][1] for k in active])
        for k, rate in zip(active, a):
            v = state[k][1] + dt[k] * rate
            state[k] = (state[k][0] - dt[k] * v, v)
        active = [k for k in active if 0 < state[k][0] < 100 * deepest[k]]
        if not active:
            break
    return [v / c[1] for (_, v), c in zip(state, impacts)]


@check("convergence", 15, "restitution with the step of the solver", sharp=True,
       cause="the error does not vanish with the step: the force law itself gives another "
             "restitution, see the check `restitution`")
def order(ask):
    """Steps per contact from 16 to 256: the error of the restitution falls with order 1"""
    impacts = cases(ask, [0.3, 0.4, 0.5, 0.6, 0.7, 0.8])
    errors = []
    for n in 16, 64, 256:
        e = coarse_restitution(ask, impacts, n)
        errors.append(math.sqrt(sum((x - c[0]) ** 2 for x, c in zip(e, impacts)) / len(impacts)))
    slope = math.log(errors[0] / errors[2]) / math.log(16) if min(errors) > 0 else 0.0
    text = ", ".join(f"{x:.2g}" for x in errors)
    good = 0.8 < slope < 1.5 and errors[2] < 0.01
    return ask.outcome(0 if good else math.inf, f"errors {text}: order {slope:.2f}",
                       "order 1 (0.8 to 1.5), and an error below 0.01 in the end")


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    en = [(k / 41,) for k in range(1, 41)]
    kn = [(ask.log_uniform(1, 1e6), ask.uniform(0.1, 1), ask.uniform(0.1, 1), e) for e, in en]
    force = [(ask.uniform(-0.1, 0.5), ask.uniform(-1, 1), 1e3, 2.0) for _ in en]
    return [ask.same_bits("damping_factor", en), ask.same_bits("damping", kn),
            ask.same_bits("normal_force", force)]

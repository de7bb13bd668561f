"""Exercise 04: choosing the time step."""
import math

from grader.course import check

TITLE = "Choosing the time step"
LEVEL = "*"
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"default_step": ("E nu rho Rmin Rmax", "dt"),
             "contact_time": ("E nu rho R v", "t"),
             "restitution": ("e_n steps phase", "e"),
             "fewest_steps": ("e_n error", "n")}
LIMITS = {"cpu": 1}  # a right answer needs 0.01 s; wrong ones search for ever


def material(ask):
    """E, nu, rho."""
    return ask.log_uniform(1e5, 1e11), ask.uniform(-0.2, 0.5), ask.log_uniform(300, 1e4)


@check("contract", 10, "Eqs. (21), (50)", sharp=True,
       cause="ln 1 = 0 in Eq. (21); or an impact that is left before its overlap is gone; or fewer "
             "than 4 steps, or not a whole number")
def limits(ask):
    """Elastic impacts come back, inelastic ones too; at least 4 steps, and a whole number"""
    for en in 1.0, 0.9, 0.5, 0.2, 0.05:
        rows = [(en, n, ask.uniform(0.01, 1)) for n in (6.0, 20.0, 300.0)]
        for row, (e,) in zip(rows, ask.call("restitution", rows)):
            if not en - 0.2 < e < en + 0.2 or e <= 0:
                return ask.outcome(math.inf, f"e = {e:.4g}", f"about {en:g}, and above 0",
                                   ask.inputs("restitution", row))
    rows = [(ask.uniform(0.3, 1), error) for error in (10.0, 1.0, 0.02)]
    steps = [n for n, in ask.call("fewest_steps", rows)]
    if not (steps[:2] == [4, 4] and steps[2] >= 4 and all(n == int(n) for n in steps)):
        return ask.outcome(math.inf, "n = " + ", ".join(f"{n:g}" for n in steps),
                           "4, 4 and a whole number", "error = 10, 1, 0.02")
    m = material(ask)
    one, other = [dt for dt, in ask.call("default_step", [(*m, 0.01, 0.01), (*m, 0.01, 0.05)])]
    return ask.outcome(0 if one == other > 0 else math.inf, f"{one:.4g}, {other:.4g}",
                       "the same positive time for any Rmax",
                       cause="the smallest sphere has the shortest contacts: R_min")


# Tolerances: rounding errors, 1e-15 for any way to write the formulas.
@check("pointwise", 10, "Eq. (50)", tol=1e-12, unit="s",
       cause="Eq. (50): R_min times the square root of rho (1 - nu^2)/E")
def step(ask):
    """The default time step, for soft and hard, light and heavy, small and large spheres"""
    rows = []
    for _ in range(40):
        R = ask.log_uniform(1e-4, 1)
        rows.append((*material(ask), R, R * ask.uniform(1.5, 10)))
    return ask.compare("default_step", rows)


@check("pointwise", 10, "hertz_time * deepest overlap / v", tol=1e-12, unit="s",
       cause="the deepest overlap: all of m* v^2/2 becomes 8/15 E* sqrt(R*) delta^(5/2); for equal "
             "spheres m* = m/2, R* = R/2, E* = E/(2(1 - nu^2))")
def duration(ask):
    """How long a head-on impact lasts"""
    rows = [(*material(ask), ask.log_uniform(1e-4, 1), ask.log_uniform(1e-3, 10))
            for _ in range(40)]
    return ask.compare("contact_time", rows, ratios={
        2 ** 0.2: "R* = R/2: a sphere and its twin",
        2 ** 0.4: "m* = m/2 of two equal masses, or E* of both spheres, not of one",
        0.5: "the time until the deepest overlap is only half of it"})


# Tolerance: rounding errors, which the end of the contact amplifies.
@check("pointwise", 15, "Eqs. (5), (18), (44), (45)", tol=1e-9,
       cause="in every step: k_n and c_n of the overlap now, then the new velocity, Eq. (44), then "
             "the new overlap with it, Eq. (45); the step is the elastic contact time / steps")
def rebound(ask):
    """Restitution of the model impact, for 5 to 200 steps per contact"""
    rows = [(ask.uniform(0.2, 1), ask.log_uniform(5, 200), ask.uniform(0.05, 1))
            for _ in range(40)]
    return ask.compare("restitution", rows)


@check("invariants", 8, "t_c/dt for delta/(2 R*) = 10 %", tol=1e-9,
       cause="this number must not depend on size or material: one of the two times does so in "
             "another way than the other")
def a_dozen(ask):
    """The default step resolves an impact with 10 % indentation with a dozen steps, always"""
    outcomes = []
    for _ in range(20):
        m, R = material(ask), ask.log_uniform(1e-4, 1)
        v = ask.reference("speed", [(*m, R, 0.1)])[0][0]
        want = ask.reference("contact_time", [(*m, R, v)])[0][0] / \
            ask.reference("default_step", [(*m, R, R)])[0][0]
        t, dt = ask.call("contact_time", [(*m, R, v)])[0][0], \
            ask.call("default_step", [(*m, R, R)])[0][0]
        got = t / dt if dt else 0.0
        outcomes.append(ask.outcome(
            abs(got / want - 1), f"{got:.6g} steps", f"{want:.6g} steps",
            "E = {:.3g}, nu = {:.3g}, rho = {:.3g}, R = {:.3g}, v = {:.3g}".format(*m, R, v)))
    return outcomes


@check("invariants", 7, "dimensions; t_c as v^(-1/5)", tol=1e-12,
       cause="in other units of mass, length and time, both results must be the same times: the "
             "root is missing, or a power is wrong")
def units(ask):
    """The same times in other units; and a faster impact is shorter, as v^(-1/5)"""
    outcomes = []
    for _ in range(20):
        (E, nu, rho), R, v = material(ask), ask.log_uniform(1e-3, 0.1), ask.log_uniform(0.1, 10)
        M, L, T = 8.0, 0.5, 0.25  # powers of two: no rounding
        here = [(E, nu, rho, R, 2 * R), (E, nu, rho, R, v), (E, nu, rho, R, 32 * v)]
        E, rho, R, v = E * M / (L * T * T), rho * M / (L * L * L), R * L, v * L / T
        there = [(E, nu, rho, R, 2 * R), (E, nu, rho, R, v)]
        (dt,), (dt2,) = ask.call("default_step", [here[0], there[0]])
        (t,), (t2,), (t32,) = ask.call("contact_time", [here[1], there[1], here[2]])
        if not min(dt, t) > 0:
            return ask.outcome(math.inf, f"{dt:.3g} s, {t:.3g} s", "positive times")
        for name, got, want in (("dt", dt2, T * dt), ("t_c", t2, T * t), ("t_c(32 v)", t32, t / 2)):
            outcomes.append(ask.outcome(abs(got / want - 1), f"{name} = {got:.6g}", f"{want:.6g}",
                                        "the units 8 kg, 0.5 m, 0.25 s" if name != "t_c(32 v)" else
                                        "32 times the speed: half the time"))
    return outcomes


def compression_time(K, v, n=400):
    """Time until the deepest overlap, delta'' = -K delta^(3/2), with Runge and Kutta."""
    h, delta, w, t = (v * v / K) ** 0.4 / v / n, 0.0, v, 0.0

    def rates(d, u):
        return u, -K * max(d, 0.0) * math.sqrt(max(d, 0.0))
    while w > 0:
        a = rates(delta, w)
        b = rates(delta + h / 2 * a[0], w + h / 2 * a[1])
        c = rates(delta + h / 2 * b[0], w + h / 2 * b[1])
        d = rates(delta + h * c[0], w + h * c[1])
        delta += h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
        old, w, t = w, w + h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1]), t + h
    return t - h * w / (w - old)


# Tolerance: the integration is exact to 2e-11.
@check("invariants", 10, "m* d2(delta)/dt2 = -4/3 E* sqrt(R*) delta^(3/2)", tol=2e-10, unit="s",
       cause="the equation of motion, integrated, gives another time: m*, R*, E*, or hertz_time")
def impact(ask):
    """The duration of an impact, from the equation of motion"""
    outcomes = []
    for _ in range(4):
        m, R, v = material(ask), ask.log_uniform(1e-3, 0.1), ask.log_uniform(0.1, 10)
        K = ask.reference("hertz", [(*m, R)])[0][0]
        want = 2 * compression_time(K, v)
        got = ask.call("contact_time", [(*m, R, v)])[0][0]
        outcomes.append(ask.outcome(abs(got / want - 1), f"{got:.8g}", f"{want:.8g}",
                                    ask.inputs("contact_time", (*m, R, v))))
    return outcomes


@check("convergence", 7, "error of e_n with the number of steps", sharp=True,
       cause="the error must vanish with the step: damping, or the order of Eqs. (44), (45), or "
             "the length of the step")
def order(ask):
    """Twice the steps, half the error: 16, 64, 256 steps per contact"""
    table = [(ask.uniform(0.3, 0.8), ask.uniform(0.01, 1)) for _ in range(40)]
    errors = []
    for n in 16.0, 64.0, 256.0:
        rows = [(en, n, phase) for en, phase in table]
        squares = [(e - row[0]) ** 2 for row, (e,) in zip(rows, ask.call("restitution", rows))]
        errors.append(math.sqrt(sum(squares) / len(squares)))
    slope = math.log(errors[0] / errors[2]) / math.log(16) if min(errors) > 0 else 0.0
    text = ", ".join(f"{x:.2g}" for x in errors)
    good = 0.85 < slope < 1.6 and errors[2] < 0.002
    return ask.outcome(0 if good else math.inf, f"errors {text}: order {slope:.2f}",
                       "order 1 (0.85 to 1.6), and an error below 0.002 in the end")


@check("convergence", 8, "least work for an asked error", sharp=True,
       cause="too few steps miss the asked error, more than needed cost time: the first of 4, 5, "
             "6, ... whose root mean square over the 16 phases is not above it")
def cheapest(ask):
    """The fewest steps per contact that keep an asked error of the restitution"""
    rows = [(ask.uniform(0.3, 0.95), ask.log_uniform(0.003, 0.04)) for _ in range(12)]
    want = ask.reference("fewest_steps", rows)
    for row, (n,), (best,) in zip(rows, ask.call("fewest_steps", rows), want):
        if n != best:
            return ask.outcome(math.inf, f"n = {n:g}: " + ("the error is larger" if n < best else
                                                           f"{n / best - 1:.0%} more work"),
                               f"n = {best:g}", ask.inputs("fewest_steps", row))
    return ask.outcome(0)


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    m = [material(ask) for _ in range(20)]
    return [ask.same_bits("default_step", [(*a, 0.01, 0.02) for a in m]),
            ask.same_bits("contact_time", [(*a, 0.01, 1.0) for a in m]),
            ask.same_bits("restitution", [(ask.uniform(0.3, 1), 20.0, 0.5) for _ in m]),
            ask.same_bits("fewest_steps", [(0.5, 0.005), (0.5, 0.01), (0.9, 0.03)])]

"""Exercise 13: adhesion (DMT) in a copy of the solver."""
import math

from grader import solver
from grader.course import check
from grader.solver import Refused, Sphere, setting, simulate
from grader.vec import add, cross, dot, norm, scale, sub

TITLE, LEVEL, KIND = "Change the solver I: adhesion", "***", "solver"
FUNCTIONS = {"simulate": ("", "")}
LIMITS = {"cpu": 10, "wall": 20}
RHO, NU = 1000.0, 0.3
PLANE = ([(-9.0, -9.0, 0.0), (9.0, -9.0, 0.0), (9.0, 9.0, 0.0), (-9.0, 9.0, 0.0)],
         [((0, 1, 2, 3), 0)])


def mass(R):
    return 4 / 3 * math.pi * RHO * R ** 3


def natural_step(R, E):
    """Eq. (50)."""
    return R * math.sqrt(RHO * (1 - NU * NU) / E)


def pair(ask):
    """Two random spheres: R, R', E, nu, gamma, delta, and a dictionary for the scene."""
    R, other = ask.uniform(0.005, 0.02), ask.uniform(0.005, 0.02)
    E, gamma, delta = ask.log_uniform(1e6, 1e7), ask.log_uniform(0.1, 10), ask.log_uniform(1e-5, 3e-4)
    return R, other, E, NU, gamma, delta


def touching(ask, R, other, delta):
    """Two spheres that overlap by delta in a random direction n (from the second to the first)."""
    n, at = ask.direction(), tuple(ask.uniform(-0.1, 0.1) for _ in range(3))
    return n, Sphere(add(at, scale(R + other - delta, n)), R), Sphere(at, other)


def force(sphere, was, dt):
    """The force in a first step, from the change of the velocity."""
    return scale(mass(sphere.R) / dt, sub(sphere.v, was.v))


# --------------------------------------------------------------------------------- the contract

@check("contract", 5, "Table 2", sharp=True,
       cause="the line of the table: name, type, default 0, dimension, range [0, inf), help")
def parameter(ask):
    """gamma is a parameter: 0 if nobody sets it, any number from 0 on, nothing below"""
    spheres = [Sphere((0.0, 0.0, 0.0), 0.01), Sphere((0.0199, 0.0, 0.0), 0.01)]
    bits = [simulate(ask, scene, spheres, frames=(1, 5))[1].bits
            for scene in ("", "gamma = 0", "gamma = 1e-3", "gamma = 25")]
    for bad in "-1e-9", "-1", "inf", "nan", "much":
        try:
            simulate(ask, f"gamma = {bad}", spheres)
        except Refused:
            continue
        return ask.outcome(math.inf, "the solver takes it", "an error message", f"gamma = {bad}")
    good = bits[0] == bits[1] and bits[1] != bits[2] != bits[3]
    return ask.outcome(0 if good else math.inf, "something else",
                       "the default is gamma = 0, and other values change the motion")


@check("contract", 5, "Eq. (7)", sharp=True,
       cause="bodies that do not touch do not attract each other in this model")
def apart(ask):
    """Bodies that are apart feel nothing, however near they are and however large gamma is"""
    for _ in range(12):
        R, other, E, _, gamma, delta = pair(ask)
        n, a, b = touching(ask, R, other, -delta)
        scene = setting(E=E, gamma=gamma)
        moved = [simulate(ask, scene, [a, b])[0], simulate(ask, scene, [a, b], frames=(0,))[0]]
        alone = Sphere((0.0, 0.0, R + delta), R)
        moved.append(simulate(ask, scene + "; Rmesh = 0", [alone], PLANE)[0])
        if any(norm(s.v) for frame in moved for s in frame.spheres):
            return ask.outcome(math.inf, "a force", "none", f"a gap of {delta:.3g} m")
        near = touching(ask, R, other, delta)[1:]
        if not norm(simulate(ask, scene, near)[0].spheres[0].v):
            return ask.outcome(math.inf, "no force", "one", f"an overlap of {delta:.3g} m")
    return ask.outcome(0)


# -------------------------------------------------------------------------------- single forces

# Tolerances: positions of 0.1 are exact to 1e-17, overlaps of 1e-5 then to 1e-12, as the forces. With
# a wall, at 0, more digits are left (5e-13); in friction the velocity of 20 takes some (2e-10).
@check("pointwise", 15, "Eq. (A1)", tol=1e-11, unit="N",
       cause="the force on i is (f_n - 4 pi gamma R*) n, with R* of Eq. (17); on j the opposite")
def two_spheres(ask):
    """The force between two spheres at rest, and its reaction"""
    rows = [pair(ask) for _ in range(30)]
    got = []
    for R, other, E, _, gamma, delta in rows:
        n, a, b = touching(ask, R, other, delta)
        dt = natural_step(R, E)
        frame = simulate(ask, setting(E=E, gamma=gamma, dt=dt), [a, b])[0]
        on_i, on_j = (force(s, was, dt) for s, was in zip(frame.spheres, (a, b)))
        across = norm(sub(on_i, scale(dot(on_i, n), n))) + norm(add(on_i, on_j))
        got.append((dot(on_i, n), across))
    return compare(ask, rows, got, RATIOS)


@check("pointwise", 10, "Eqs. (A1), (22), (23)", tol=5e-12, unit="N",
       cause="at a wall R* is the radius of the sphere; the wall doubles the stiffness, not gamma")
def sphere_and_wall(ask):
    """The force between a sphere at rest and a wall"""
    rows = [(R, 0.0, *more) for R, _, *more in (pair(ask) for _ in range(30))]
    got = []
    for R, _, E, _, gamma, delta in rows:
        was, dt = Sphere((ask.uniform(-0.1, 0.1), ask.uniform(-0.1, 0.1), R - delta), R), \
            natural_step(R, E)
        frame = simulate(ask, setting(E=E, gamma=gamma, dt=dt, Rmesh=0), [was], PLANE)[0]
        f = force(frame.spheres[0], was, dt)
        got.append((f[2], norm(f[:2])))
    return compare(ask, rows, got, RATIOS)


RATIOS = {2: "twice the adhesion", 0.5: "half of the adhesion: 2 pi gamma R*",
          -1: "the adhesion has the wrong sign: it attracts"}


def compare(ask, rows, got, ratios):
    """Errors of (f, across) for (R, R', E, nu, gamma, delta); a wrong factor of the pull is named."""
    want = [w[0] for w in ask.reference("force", rows)]
    pulls = [p[0] for p in ask.reference("pull_off", [(*r[:2], r[4]) for r in rows])]
    errors = [(abs(g - w) + across) / max(p, abs(w))
              for (g, across), w, p in zip(got, want, pulls)]
    k = max(range(len(rows)), key=errors.__getitem__)
    causes = [cause for ratio, cause in ratios.items()
              if all(abs(g[0] - (w + p - ratio * p)) < 1e-6 * p
                     for g, w, p in zip(got, want, pulls))]
    R, other, E, _, gamma, delta = rows[k]
    where = f"R = {R:.4g}, " + (f"R' = {other:.4g}" if other else "wall") + \
        f", E = {E:.4g}, gamma = {gamma:.4g}, delta = {delta:.4g}"
    return ask.outcome(errors[k], f"{got[k][0]:.8g}", f"{want[k]:.8g}", where,
                       causes[0] if causes else "")


@check("pointwise", 10, "Eqs. (11), (A2)", tol=1e-9, unit="N",
       cause="the limit of friction is mu_s times the size of f_n as it was, without the adhesion")
def friction(ask):
    """The friction force of two spheres that slip, while they approach or part"""
    rows, got = [], []
    for k in range(24):
        R, other, E, _, gamma, delta = pair(ask)
        n, a, b = touching(ask, R, other, delta)
        t = cross(n, ask.direction())
        t, vn, mus = scale(1 / norm(t), t), (k % 3 - 1) * ask.uniform(0.05, 0.5), \
            ask.uniform(0.1, 0.9)
        a.v, dt = add(scale(20.0, t), scale(vn, n)), natural_step(R, E) / 4
        scene = setting(E=E, gamma=gamma, dt=dt, mus=mus, mur=0, mut=0, en=0.6)
        f = force(simulate(ask, scene, [a, b])[0].spheres[0], a, dt)
        rows.append((R, other, E, NU, mus, 0.6, RHO, delta, vn))
        got.append((-dot(f, t), f"gamma = {gamma:.4g}, delta = {delta:.4g}, v_n = {vn:.3g}"))
    want = [w[0] for w in ask.reference("friction", rows)]
    errors = [abs(g[0] - w) / w for g, w in zip(got, want)]
    k = max(range(len(rows)), key=errors.__getitem__)
    return ask.outcome(errors[k], f"{got[k][0]:.8g}", f"{want[k]:.8g}", got[k][1])


# ------------------------------------------------------------------------------------- motions

def resting(ask, count):
    """(R, E, gamma, pull-off force, overlap at rest) of spheres at a wall."""
    rows = [(ask.uniform(0.005, 0.02), 0.0, 1e6, NU, ask.log_uniform(0.05, 1)) for _ in range(count)]
    pulls = ask.reference("pull_off", [(*r[:2], r[4]) for r in rows])
    overlaps = ask.reference("equilibrium", rows)
    return [(r[0], r[2], r[4], p[0], d[0]) for r, p, d in zip(rows, pulls, overlaps)]


@check("invariants", 8, "Eq. (A3)", sharp=True,
       cause="the pull-off force is 4 pi gamma R*, also for the smallest overlap")
def ceiling(ask):
    """A sphere hangs from a ceiling if it weighs less than the pull-off force, and falls if more"""
    for R, E, gamma, pull, overlap in resting(ask, 6):
        for share in 0.98, 1.02:
            start = Sphere((0.0, 0.0, overlap * (1 - share) ** (2 / 3) - R if share < 1
                            else 1e-3 * overlap - R), R)
            scene = setting(E=E, gamma=gamma, g=(0.0, 0.0, -share * pull / mass(R)), Rmesh=0,
                            Rmin=R, Rmax=R, en=0.2)
            time = math.sqrt(2 * 0.1 * R * mass(R) / (0.02 * pull))  # to fall a tenth of R
            steps = int(time / natural_step(R, E))
            end = simulate(ask, scene, [start], PLANE, frames=(steps,))[0].spheres[0]
            if (end.x[2] > -R) != (share < 1):
                return ask.outcome(math.inf, "it falls" if share < 1 else "it hangs",
                                   "the other", f"weight {share:g} times 4 pi gamma R, R = {R:.3g}, "
                                   f"gamma = {gamma:.3g}")
    return ask.outcome(0)


# The spring and the overlap come to rest in the first half of the time: 8e-8 are left.
@check("invariants", 9, "Eq. (A2)", tol=5e-7,
       cause="the limit of friction: a contact that carries no load is pressed by its own adhesion")
def vertical_wall(ask):
    """A sphere sticks to a vertical wall if it weighs less than mu_s 4 pi gamma R, else it slips"""
    worst = ask.outcome(0)
    for R, E, gamma, pull, overlap in resting(ask, 5):
        mus, dt, steps = ask.uniform(0.3, 1), natural_step(R, E) / 2, 1500
        for share in 0.9, 1.2:
            weight = share * mus * pull
            scene = setting(E=E, gamma=gamma, g=(weight / mass(R), 0.0, 0.0), Rmesh=0, Rmin=R,
                            Rmax=R, mus=mus, mur=20, mut=20, en=0.2, dt=dt)
            first, last = (f.spheres[0].v for f in simulate(
                ask, scene, [Sphere((0.0, 0.0, R - overlap), R)], PLANE, frames=(steps, steps)))
            gain = norm(sub(last, first)) / (steps * dt)
            want = max(share - 1, 0) * mus * pull / mass(R)
            error = abs(gain - want) / (0.2 * mus * pull / mass(R))
            if not error <= worst.error:
                worst = ask.outcome(error, f"acceleration {gain:.6g} m/s2", f"{want:.6g} m/s2",
                                    f"weight {share:g} times mu_s 4 pi gamma R, R = {R:.3g}, "
                                    f"gamma = {gamma:.3g}, mu_s = {mus:.3g}")
    return worst


# Semi-implicit Euler: the energy swings with the step, by 0.8 % with a twentieth of Eq. (50).
@check("invariants", 8, "Eq. (A4)", tol=0.02, sharp=True,
       cause="the elastic energy of a contact, in each_contact, has a part that belongs to adhesion")
def energy(ask):
    """Undamped collisions: kinetic and elastic energy together stay what they were"""
    worst = ask.outcome(0)
    for _ in range(4):
        R, E, gamma, pull, overlap = resting(ask, 1)[0]
        n, a, b = touching(ask, R, R, -1e-6 * R)
        v = 1.5 * math.sqrt(pull * overlap / mass(R))
        a.v = scale(-v, n)
        scene = setting(E=E, gamma=gamma, en=1, mus=0, mur=0, mut=0, dt=natural_step(R, E) / 20)
        frames = simulate(ask, scene, [a, b], frames=(0, *[8] * 150))
        start = frames[0].energy()
        error = max(abs(f.energy() - start) for f in frames) / start
        if not any(f.contacts for f in frames):
            error = math.inf
        if not error <= worst.error:
            worst = ask.outcome(error, f"up to {error:.2g} of it come and go", "a constant sum",
                                f"R = {R:.3g}, gamma = {gamma:.3g}, v = {v:.3g} m/s")
    return worst


# The overlap is exact to 1e-17/1e-6: 8e-12.
@check("convergence", 15, "Eq. (A5)", tol=5e-11,
       cause="two spheres without load rest where the Hertz force equals 4 pi gamma R*")
def equilibrium(ask):
    """The overlap at rest: its value, and its growth with gamma^(2/3) over two decades"""
    R, other, E = ask.uniform(0.005, 0.02), ask.uniform(0.005, 0.02), 1e6
    rows = [(R, other, E, NU, gamma) for gamma in (0.01, 0.03, 0.1, 0.3, 1.0)]
    got = []
    for row in rows:
        _, a, b = touching(ask, R, other, 1e-7)
        scene = setting(E=E, gamma=row[4], en=0.1, Rmin=min(R, other), Rmax=0.02)
        end = simulate(ask, scene, [a, b], frames=(6000,))[0].spheres
        got.append(R + other - norm(sub(end[0].x, end[1].x)))
    want = [w[0] for w in ask.reference("equilibrium", rows)]
    errors = [abs(g - w) / w for g, w in zip(got, want)]
    k = max(range(len(rows)), key=errors.__getitem__)
    slope = math.log(got[-1] / got[0]) / math.log(100) if min(got[-1], got[0]) > 0 else 0.0
    return ask.outcome(errors[k], f"{got[k]:.8g} m, exponent {slope:.4f}",
                       f"{want[k]:.8g} m, exponent 0.6667",
                       f"R = {R:.4g}, R' = {other:.4g}, gamma = {rows[k][4]:g}")


@check("clean", 10, "all of the paper", sharp=True,
       cause="something that does not belong to adhesion was changed; compare your files with those "
             "in tinydem/")
def unchanged(ask):
    """Without adhesion, all bits are as they were: a pile with friction, in a box"""
    pile = [Sphere((0.022 * (k % 4) + 0.001 * ask.uniform(-1, 1), 0.022 * (k // 4 % 4),
                    0.012 + 0.02 * (k // 16)), ask.uniform(0.008, 0.011),
                   tuple(ask.uniform(-1, 1) for _ in range(3))) for k in range(64)]
    scene = setting(g=(0.0, 0.0, -9.81), en=ask.uniform(0.3, 0.9), Rmesh=0.001, eta=1e-3)
    frames = (0, 1, 10, 300)
    right = simulate(ask, scene, pile, PLANE, frames, right=True)
    for more in "; gamma = 0", "":
        for mine, good, k in zip(simulate(ask, scene + more, pile, PLANE, frames), right, frames):
            if mine.bits != good.bits:
                return ask.outcome(math.inf, "other bits", "the bits of the solver as it was",
                                   f"{k} steps of a pile{more}")
    other = simulate(ask, scene + "; gamma = 0.1", pile, PLANE, frames)[-1].bits
    return ask.outcome(0 if other != right[-1].bits else math.inf, "gamma changes nothing",
                       "adhesion")

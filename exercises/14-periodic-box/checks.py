"""Exercise 14: a periodic box in a copy of the solver."""
import math

from grader.course import check
from grader.solver import Refused, Sphere, setting, simulate
from grader.vec import add, cross, dot, norm, scale, sub

TITLE, LEVEL, KIND = "Change the solver II: a periodic box", "***", "solver"
FUNCTIONS = {"simulate": ("", "")}
LIMITS = {"cpu": 10, "wall": 20}
RHO, E, NU = 1000.0, 1e6, 0.3
ZERO = (0.0, 0.0, 0.0)
PLANE = ([(-9.0, -9.0, 0.0), (9.0, -9.0, 0.0), (9.0, 9.0, 0.0), (-9.0, 9.0, 0.0)],
         [((0, 1, 2, 3), 0)])
STEP = 0.01 * math.sqrt(RHO * (1 - NU * NU) / E)  # Eq. (50) for R = 0.01
MASKS = (1, 1, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)


def mass(s):
    return 4 / 3 * math.pi * RHO * s.R ** 3


def wrap(x, L):
    """The image in the box; coordinates without a period stay."""
    return tuple(a - l * math.floor(a / l) if l else a for a, l in zip(x, L))


def nearest(d, L):
    """The shortest distance between images."""
    return tuple(a - l * round(a / l) if l else a for a, l in zip(d, L))


def size_of_box(ask):
    return tuple(ask.uniform(0.07, 0.1) for _ in range(3))


def vector(ask, size):
    return tuple(ask.uniform(-size, size) for _ in range(3))


def packing(ask, L, period, count, overlap=0.1, speed=1.0):
    """Spheres at random places of a box of size L, some of which touch; all fly and spin. The first
    touch each other across an edge of the box, if x and y have a period."""
    spheres = [Sphere((0.006, 0.006, 0.04), 0.01, vector(ask, speed), vector(ask, 50 * speed)),
               Sphere((L[0] - 0.006, L[1] - 0.006, 0.04), 0.01, vector(ask, speed))]
    while len(spheres) < count:
        s = Sphere((ask.uniform(0, L[0]), ask.uniform(0, L[1]), ask.uniform(0, L[2])),
                   ask.uniform(0.008, 0.012), vector(ask, speed), vector(ask, 50 * speed))
        if all(norm(nearest(sub(s.x, o.x), period)) > (1 - overlap) * (s.R + o.R) for o in spheres):
            spheres.append(s)
    return spheres


def wrong(ask, text, want, at="", cause=""):
    return ask.outcome(math.inf, text, want, at, cause)


def worst_of(outcomes):
    return max(outcomes, key=lambda o: o.error)


# ------------------------------------------------------------------------------------ contract

def across_a_face():
    """Two spheres that touch if the box is 0.1 long in x."""
    return [Sphere((0.001, -0.02, 0.05), 0.01), Sphere((0.0815, -0.02, 0.05), 0.01)]


@check("contract", 3, "", sharp=True,
       cause="the line of the table: period, Vec3, default 0,0,0, range [0, inf)")
def parameter(ask):
    """period is a parameter of three numbers: 0,0,0 if nobody sets it, nothing negative"""
    spheres = across_a_face()
    first, same, other = (simulate(ask, scene, spheres)[0].bits
                          for scene in ("", "period = 0,0,0", "period = 0.1,0,0"))
    for bad in "-0.1,0.1,0.1", "0,0,-1", "0.1", "0,inf,0", "nan,0,0":
        try:
            simulate(ask, f"period = {bad}", spheres)
        except Refused:
            continue
        return wrong(ask, "the solver takes it", "an error message", f"period = {bad}")
    return ask.outcome(0 if first == same != other else math.inf, "something else",
                       "the default is period = 0,0,0, and other values change the motion")


@check("contract", 3, "Eq. (45)", tol=2e-14, sharp=True, unit="m",
       cause="positions run away from the box, or are put back into it where there is no period")
def in_the_box(ask):
    """Free flight through many periods, from places inside and outside: 0 <= x <= period"""
    outcomes, speed = [], 10.0
    for mask in MASKS:
        L = tuple(l * m for l, m in zip(size_of_box(ask), mask))
        start = Sphere(vector(ask, 0.3), 0.01, vector(ask, speed))
        for frames in (0, 1), (0, 10, 90):
            steps = 0
            scene = setting(period=L, mus=0, mur=0, mut=0, dt=STEP)
            for frame, more in zip(simulate(ask, scene, [start], frames=frames), frames):
                steps += more
                x, way = frame.spheres[0].x, scale(steps * STEP, start.v)
                want = wrap(add(start.x, way), L)
                error = norm(nearest(sub(x, want), L))
                if any(l and not 0 <= c <= l for c, l in zip(x, L)):
                    error = math.inf
                outcomes.append(ask.outcome(error, str(x), str(want), f"period = {L}"))
    return worst_of(outcomes)


@check("contract", 4, "", sharp=True,
       cause="is_free, which spawn asks, must know of the images as well")
def spawning(ask):
    """Particles that are spawned keep clear of each other's images, and of those that are there"""
    for mask in MASKS[:3]:
        L = size_of_box(ask)
        period = tuple(l * m for l, m in zip(L, mask))
        there = [Sphere((0.002, 0.002, 0.002), 0.01)]
        scene = setting(period=period, smin=ZERO, smax=L, Rmin=0.01, Rmax=0.01, v0=ZERO, Nmax=60)
        all_of_them = simulate(ask, scene + "; Nspawn = 300", there, frames=(1, 1))[1].spheres
        if len(all_of_them) < 10:
            return wrong(ask, f"{len(all_of_them)} particles", "ten or more")
        for k, a in enumerate(all_of_them):
            for b in all_of_them[:k]:
                if norm(nearest(sub(a.x, b.x), period)) < a.R + b.R - 1e-12:
                    return wrong(ask, f"overlap at {a.x} and {b.x}", "none", f"period = {period}")
    return ask.outcome(0)


# -------------------------------------------------------------------------------- single forces

def compare(ask, mine, good, size, at, cause=""):
    """Largest difference of velocities and of R times spins, divided by `size`."""
    worst = ask.outcome(0)
    for k, (a, b) in enumerate(zip(mine, good)):
        error = (norm(sub(a.v, b.v)) + b.R * norm(sub(a.w, b.w))) / size
        if not error <= worst.error:
            text = [f"sphere {k + 1}: v = {', '.join(f'{c:.6g}' for c in s.v)}; w = "
                    f"{', '.join(f'{c:.6g}' for c in s.w)}" for s in (a, b)]
            worst = ask.outcome(error, *text, at, cause)
    return worst


# Tolerances: rounding of positions, 1e-17, and of velocities that change little in a step where the
# overlap is small: up to 2e-12 for single pairs, 5e-15 of the largest change in a packing.
@check("pointwise", 15, "Eqs. (5)-(60)", tol=5e-12,
       cause="the partner is not at its image that is nearest: x_i - x_j is long by a period")
def pair_across(ask):
    """A contact across each of the 6 faces, 12 edges and 8 corners: the same as within the box"""
    outcomes = []
    for mask in MASKS:
        L = tuple(l * m for l, m in zip(size_of_box(ask), mask))
        for k in range(27):
            side = (k % 3 - 1, k // 3 % 3 - 1, k // 9 - 1)
            if any(s and not m for s, m in zip(side, mask)):
                continue
            n = ask.direction()
            n = tuple(abs(c) * s if s else c for c, s in zip(n, side))
            corner = tuple(l if s > 0 else 0.0 if s < 0 else ask.uniform(0.02, 0.05)
                           for s, l in zip(side, L))
            a = Sphere(add(corner, scale(0.0097, n)), 0.01, vector(ask, 1), vector(ask, 50))
            b = Sphere(add(corner, scale(-0.0097, n)), 0.01, vector(ask, 1), vector(ask, 50))
            inside = [Sphere(wrap(s.x, L), s.R, s.v, s.w) for s in (a, b)]
            scene = setting(dt=STEP)
            good = simulate(ask, scene, [a, b], right=True)[0].spheres
            mine = simulate(ask, scene + f"; {setting(period=L)}", inside)[0].spheres
            size = norm(sub(good[0].v, a.v))
            outcomes.append(compare(ask, mine, good, size, f"period = {L}, side {side}"))
    return worst_of(outcomes)


@check("pointwise", 20, "Eqs. (5)-(60)", tol=5e-14,
       cause="the box and 26 copies around it tell the right answer: a neighbour was not found, or "
             "found twice")
def replicas(ask):
    """One step of a packing: the same as in the middle of copies of it, without a period"""
    outcomes = []
    for mask in MASKS:
        L = size_of_box(ask)
        period = tuple(l * m for l, m in zip(L, mask))
        spheres = packing(ask, L, period, 25)
        copies = list(spheres)
        for k in range(27):
            shift = tuple((k // d % 3 - 1) * l for d, l in zip((1, 3, 9), period))
            if any(shift) and all(d or not l or k // e % 3 == 1 for d, l, e in
                                  zip(shift, period, (1, 3, 9))):
                copies += [Sphere(add(s.x, shift), s.R, s.v, s.w) for s in spheres]
        unique = {s.x: s for s in copies}
        good = simulate(ask, setting(dt=STEP), list(unique.values()), right=True)[0]
        mine = simulate(ask, setting(dt=STEP, period=period), spheres)[0]
        size = max(norm(sub(a.v, b.v)) for a, b in zip(good.spheres, spheres))
        if not size or not any(norm(sub(c.fn, ZERO)) for c in good.contacts):
            return wrong(ask, "no contact", "some")
        outcomes.append(compare(ask, mine.spheres, good.spheres[:len(spheres)], size,
                                f"period = {period}"))
    return worst_of(outcomes)


# ------------------------------------------------------------------------------------- motions

@check("invariants", 5, "Eqs. (56), (57)", tol=1e-15, sharp=True,
       cause="the reaction on the image is the reaction on the particle")
def momentum(ask):
    """A gas with friction and damping: its momentum stays"""
    L = size_of_box(ask)
    spheres = packing(ask, L, L, 25, speed=0.3)
    frames = simulate(ask, setting(period=L, dt=STEP), spheres, frames=(0, 40))
    sums = [[sum(mass(s) * s.v[k] for s in f.spheres) for k in range(3)] for f in frames]
    size = sum(mass(s) * norm(s.v) for s in spheres)
    changed = any(norm(sub(a.v, b.v)) for a, b in zip(frames[0].spheres, frames[1].spheres))
    error = norm(sub(sums[1], sums[0])) / size if changed else math.inf
    return ask.outcome(error, f"{error:.2g} of the sum of sizes has gone", "nothing")


# The energy swings with the step: by 1.5 % at a tenth of Eq. (50).
@check("invariants", 5, "Eqs. (5), (12)", tol=0.03, sharp=True,
       cause="each_contact, which adds up the elastic energy, must know of the images as well")
def energy(ask):
    """Collisions across faces, without damping: kinetic and elastic energy add up to the same"""
    outcomes = []
    for _ in range(4):
        L = size_of_box(ask)
        n = ask.direction()
        place = tuple(0.0 if k == _ % 3 else ask.uniform(0.02, 0.05) for k in range(3))
        a, b = (Sphere(wrap(add(place, scale(s * 0.0102, n)), L), 0.01, scale(-s * 0.5, n))
                for s in (1, -1))
        scene = setting(period=L, en=1, mus=0, mur=0, mut=0, dt=STEP / 10)
        frames = simulate(ask, scene, [a, b], frames=(0, *[3] * 60))
        start = frames[0].energy()
        error = max(abs(f.energy() - start) for f in frames) / start
        if norm(sub(frames[-1].spheres[0].v, a.v)) < 0.9:
            error = math.inf  # no collision
        outcomes.append(ask.outcome(error, f"up to {error:.2g} of it come and go",
                                    "a constant sum", f"period = {L}"))
    return worst_of(outcomes)


# Rounding grows in collisions, by a thousand in these: 4e-13.
@check("invariants", 8, "", tol=3e-12,
       cause="nothing may depend on where the boundary is")
def shift_invariance(ask):
    """The same packing, shifted by any vector, moves in the same way"""
    outcomes = []
    for mask in MASKS[0], MASKS[4]:
        box = size_of_box(ask)
        L = tuple(l * m for l, m in zip(box, mask))
        spheres = packing(ask, box, L, 25)
        scene, size = setting(period=L, dt=STEP), 1.0
        first = simulate(ask, scene, spheres, frames=(60,))[0].spheres
        for _ in range(3):
            shift = vector(ask, 0.2)
            moved = [Sphere(wrap(add(s.x, shift), L), s.R, s.v, s.w) for s in spheres]
            other = simulate(ask, scene, moved, frames=(60,))[0].spheres
            outcomes.append(compare(ask, other, first, size, f"period = {L}, shift {shift}"))
            for a, b in zip(other, first):
                error = norm(nearest(sub(sub(a.x, b.x), shift), L)) / 0.01
                outcomes.append(ask.outcome(error, str(a.x), str(wrap(add(b.x, shift), L)),
                                            f"period = {L}, shift {shift}"))
        if not any(norm(sub(a.v, b.v)) > 0.01 for a, b in zip(first, spheres)):
            return wrong(ask, "nothing collides", "collisions")
    return worst_of(outcomes)


@check("invariants", 7, "Eqs. (51), (53)", tol=5e-13,  # 6e-14: rounding
       cause="the springs of a contact belong to the pair: they must not end, or change their sign, "
             "when one of the two crosses the boundary")
def history(ask):
    """Two spheres stick to each other, or one to a floor, and cross the boundary: as without it"""
    outcomes = []
    for k in range(12):
        L, n = size_of_box(ask), ask.direction()
        drift = tuple(ask.sign() * ask.uniform(5, 10) for _ in range(3))
        if k % 3 == 2:  # a sphere falls on a floor and rolls over it
            a = Sphere((0.01, 0.02, 0.0102), 0.01, (drift[0], drift[1], -1.0), vector(ask, 50))
            L, start, mesh = (L[0], L[1], 0.0), [a], PLANE
        else:
            t = cross(n, ask.direction())
            part = add(scale(0.3, n), scale(0.4, t))
            start = [Sphere(scale(s * 0.01001, n), 0.01, sub(drift, scale(s, part)),
                            vector(ask, 50)) for s in (1, -1)]
            mesh = ((), ())
        scene = setting(dt=STEP / 4, mus=2, mur=0.5, en=0.8, Rmesh=0)
        good = simulate(ask, scene, start, mesh, frames=(400,), right=True)[0].spheres
        steps = 10 * (1 + k % 4)  # until they cross, so that some lists are built while they do
        touch = wrap(scale(-steps * STEP / 4, drift), L)
        if k % 3 == 2:
            touch = (touch[0], touch[1], 0.0)
        inside = [Sphere(wrap(add(s.x, touch), L), s.R, s.v, s.w) for s in start]
        mine = simulate(ask, f"{scene}; {setting(period=L)}", inside, mesh,
                        frames=(400,))[0].spheres
        outcomes.append(compare(ask, mine, good, 1.0, f"period = {L}, drift {drift}"))
    return worst_of(outcomes)


@check("convergence", 15, "Eq. (12)", sharp=True,
       cause="the ends of the chain do not touch across the boundary, or the force between them is "
             "not that of Hertz")
def ring(ask):
    """Standing waves in a ring of spheres: the frequency of theory, and an error of order 2 in dt"""
    spheres, R, waves, axis = 6, 0.01, 1 + ask.random.randrange(2), ask.random.randrange(3)
    delta = ask.uniform(0.01, 0.05) * R
    w = ask.reference("ring", [(waves, spheres, R, E, NU, RHO, delta)])[0][0]
    spacing = 2 * R - delta
    L = [0.0, 0.0, 0.0]
    L[axis] = spheres * spacing
    place = spacing * ask.uniform(0, 1)

    def at(c):
        x = [0.0, 0.0, 0.0]
        x[axis] = c
        return tuple(x)

    shape = [math.cos(2 * math.pi * waves * k / spheres) for k in range(spheres)]
    size, errors = 1e-4 * delta, []
    start = [Sphere(wrap(at(place + k * spacing + size * u), L), R) for k, u in enumerate(shape)]
    for steps in 32, 64, 128, 256:
        dt = 2 * math.pi / w / steps
        scene = setting(period=tuple(L), en=1, mus=0, mur=0, mut=0, dt=dt)
        end = simulate(ask, scene, start, frames=(steps,))[0].spheres
        errors.append(math.sqrt(sum(
            norm(nearest(sub(a.x, b.x), L)) ** 2 + (norm(a.v) / w) ** 2
            for a, b in zip(end, start)) / spheres) / size)
    slope = math.log(errors[0] / errors[-1]) / math.log(8) if min(errors) > 0 else 0.0
    text = ", ".join(f"{e:.2g}" for e in errors)
    good = 1.8 < slope < 2.2 and errors[-1] < 0.001  # measured: 2.01 and 0.0001
    return ask.outcome(0 if good else math.inf, f"errors after one period, with 32 ... 256 steps: "
                       f"{text}; order {slope:.2f}",
                       "order 2 (1.8 to 2.2), and an error below 0.001 in the end",
                       f"period = {tuple(L)}, {waves} wavelengths")


@check("clean", 10, "all of the paper", sharp=True,
       cause="something changed although there is no period; compare your files with those in "
             "tinydem/")
def unchanged(ask):
    """Without a period, all bits are as they were: a pile with friction"""
    pile = [Sphere((0.022 * (k % 4) + 0.001 * ask.uniform(-1, 1), 0.022 * (k // 4 % 4) - 0.03,
                    0.012 + 0.02 * (k // 16)), ask.uniform(0.008, 0.011), vector(ask, 1))
            for k in range(64)]
    scene = setting(g=(0.0, 0.0, -9.81), en=ask.uniform(0.3, 0.9), Rmesh=0.001, eta=1e-3)
    frames = (0, 1, 10, 300)
    right = simulate(ask, scene, pile, PLANE, frames, right=True)
    for more in "; period = 0,0,0", "":
        for mine, good, k in zip(simulate(ask, scene + more, pile, PLANE, frames), right, frames):
            if mine.bits != good.bits:
                return wrong(ask, "other bits", "the bits of the solver as it was",
                             f"{k} steps of a pile{more}")
    pair, period = across_a_face(), "; period = 0.1,0,0"
    other, same = (simulate(ask, scene + more, pair)[0].bits for more in (period, ""))
    return ask.outcome(0 if other != same else math.inf, "period changes nothing",
                       "a periodic box")

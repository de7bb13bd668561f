#!/usr/bin/env python3
"""Hand a scene that outgrows this machine to LAMMPS, and read what LAMMPS wrote back.

    lammps.py SCENE_OR_OUTPUT DIR               DIR/data.tinydem, in.tinydem, README.txt
    mpirun -np 8 lmp -in in.tinydem             in DIR, on as many machines as MPI has
    lammps.py --back DIR OUTPUT                 its dumps as frames, for render.py and the others
    lammps.py SCENE_OR_OUTPUT DIR --liggghts    for LIGGGHTS, which knows triangles

From an OUTPUT the last frame goes (--frame N: another one), from a SCENE its start. Normal and
sliding forces, walls, vibration, drag, gravity and velocities mean the same in LAMMPS. Rolling and
twisting springs have constant stiffness there, one for each class of radii. What would silently
differ is refused. README.txt in DIR says what holds for the scene; see also docs/scaling.md.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from frames import HEADER, columns, fail, read_motion, read_run, read_scene
from mesh_tools import triangles_of

#: Polynomial of Tsuji's damping in LAMMPS: damping ratio over coefficient of restitution.
TSUJI = (1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218)
INDENTATION = 0.02   # overlap / radius for rolling and twisting springs: the mean in a soft bed
CLASS_RATIO = 1.2    # largest over smallest radius in a class, as long as MOST_CLASSES are enough
MOST_CLASSES = 8
FRAMES = 100         # default of --Nframes
ALIKE = 1e-9         # planes are one if their normals and places [size of the mesh] differ by less
COVERED = 1e-6       # share of a wall that may be missing in its faces: digits of an OFF file
PHASE_STEPS = 10**6  # steps among which the phase of a vibration is looked for
DUMP = "id type radius mass x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz"
SLIDING = "sliding: the velocity at the contact takes the lever arm R (at walls the torque too) " \
    "where TinyDEM takes R - delta/2, and a spring that slips is reset as printed in Eq. (55), " \
    "D2 in docs/deviations.md; docs/scaling.md tells how much impacts differ"
FILES = {False: ("data.tinydem", "in.tinydem"), True: ("data.tinydem", "in.liggghts", "mesh.stl")}


# --------------------------------------------------------------------------------- contact law

def damping_ratio(en):
    """beta of Eq. (21) for a restitution en in [0, 1]."""
    return 1.0 if en == 0 else 0.0 if en == 1 else 1 / math.hypot(1, math.pi / math.log(en))


def tsuji(e):
    """The damping ratio that LAMMPS takes for a restitution e."""
    return sum(c * e**k for k, c in enumerate(TSUJI))


def restitution_for(en):
    """The restitution to write for LAMMPS, such that its damping is that of Eq. (21).

    That is tsuji(e) = sqrt(5) beta; e is negative for en < 0.114 and 1.0007 for en = 1.
    """
    wanted, low, high = math.sqrt(5) * damping_ratio(en), -0.5, 1.001  # falls from 8.1 to -2e-4
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if tsuji(middle) > wanted else (low, middle)
    return low


def shear_damping(p):
    """c_s/c_n, Eq. (25)."""
    return math.sqrt((1 - p["nu"]) / (10 * (2 - p["nu"])))


def contact_words(p, R, other=None, indentation=INDENTATION):
    """What LAMMPS must know of a contact between radii R and `other` [L], or R and a wall.

    p: the parameters of a scene by name. Rolling and twisting have the constants of Eqs. (12)-(20)
    at an overlap of `indentation` times the smaller radius.
    """
    wall = other is None
    E, nu, xg, stiff = p["E"], p["nu"], shear_damping(p), 2 if wall else 1
    Rstar = R if wall else R * other / (R + other)
    m, M = (4 / 3 * math.pi * p["rho"] * r**3 for r in (R, R if wall else other))
    mstar = m if wall else m * M / (m + M)
    a = math.sqrt(Rstar * indentation * min(R, R if wall else other))
    kn = 4 / 3 * stiff * E / (2 * (1 - nu**2)) * a
    ks = 8 * stiff * E / (4 * (2 - nu) * (1 + nu)) * a
    cn = damping_ratio(p["en"]) * math.sqrt(5 * mstar * kn)
    cor = restitution_for(p["en"])
    words = f"hertz {4 / 3 * E / (1 - nu**2):.17g} {cor:.17g}" if wall else \
        f"hertz/material {E:.17g} {cor:.17g} {nu:.17g}"
    stiffness = f"{4 * E / ((2 - nu) * (1 + nu)):.17g}" if wall else "NULL"
    words += f" tangential mindlin {stiffness} {xg:.17g} {p['mus']:.17g}" if p["mus"] > 0 else \
        " tangential linear_nohistory 0 0"
    if p["mur"] > 0:
        words += f" rolling sds {kn:.9g} {cn:.9g} {p['mur']:.17g}"
    if p["mut"] > 0:
        words += f" twisting sds {ks * Rstar**2:.9g} {xg * cn * Rstar**2:.9g} " \
                 f"{p['mut'] * Rstar:.9g}"
    return words + " damping tsuji"


class Classes(NamedTuple):
    """Radius classes: type (N,) from 0 of every particle, the radius of each class [L] and the
    largest relative distance of a radius from that of its class."""
    of: np.ndarray
    radii: np.ndarray
    error: float


def radius_classes(R, count=None):
    """Classes of radii R (N,) [L], of equal ratio; by default so many that the ratio is at most
    CLASS_RATIO, but at most MOST_CLASSES. The radius of a class is the mean of its members."""
    spread = math.log(R.max() / R.min())
    count = count or min(max(math.ceil(spread / math.log(CLASS_RATIO)), 1), MOST_CLASSES)
    of = np.minimum((np.log(R / R.min()) / max(spread, 1e-12) * count).astype(int), count - 1)
    _, of = np.unique(of, return_inverse=True)  # classes without members are left out
    radii = np.bincount(of, R) / np.bincount(of)
    error = float(np.abs(R / radii[of] - 1).max())
    return Classes(of, radii, error if error > ALIKE else 0.0)


# ----------------------------------------------------------------------------------- geometry

class Plane(NamedTuple):
    """A wall: points x inside have n.x > d [L]; faces: numbers of its mesh elements."""
    n: np.ndarray
    d: float
    group: int
    faces: list


def name_of(k, element):
    """How messages call mesh element k."""
    kind = ("point", "edge", "triangle", "rectangle")[len(element.corners) - 1]
    at = "; ".join(",".join(f"{v:g}" for v in corner) for corner in element.corners)
    return f"mesh element {k} ({kind} {at})"


def refuse(what):
    """The scene would not be the same in LAMMPS."""
    fail(f"{what}; LAMMPS would compute something else, so this scene is not handed off; try: "
         "--liggghts, which reads triangles (same normal law, approximate friction)")


def planes_of(elements, frame):
    """The mesh as planes around all particles; what is no such wall is refused."""
    centres, R, planes = columns(frame, "x,y,z"), frame["R"], []
    size = np.ptp(np.vstack([e.corners for e in elements] or [np.zeros(3)]), axis=0).max()
    for k, e in enumerate(elements):
        if len(e.corners) < 3:
            refuse(f"{name_of(k, e)} is no plane wall")
        n = np.cross(e.corners[1] - e.corners[0], e.corners[2] - e.corners[0])
        n /= np.linalg.norm(n)
        n[np.abs(n) < 1e-15] = 0
        s = centres @ n - e.corners[0] @ n
        if s.min() < 0 < s.max():
            refuse(f"{name_of(k, e)} has particle {s.argmin() + 1} on one side and particle "
                   f"{s.argmax() + 1} on the other: the walls are not convex")
        n, s = (n, s) if s.max() > 0 else (-n, -s)
        if (s <= e.radius).any():
            fail(f"particle {s.argmin() + 1}: its centre lies within {name_of(k, e)}; try: an "
                 "earlier --frame")
        d = float(e.corners[0] @ n) + e.radius
        for p in planes:
            if np.abs(p.n - n).max() < ALIKE and abs(p.d - d) < ALIKE * size:
                if p.group != e.group:
                    refuse(f"{name_of(k, e)} lies in one plane with mesh element {p.faces[0]}, "
                           "which has another group")
                p.faces.append(k)
                break
        else:
            planes.append(Plane(n, d, e.group, [k]))
    return planes


def clip(polygon, n, d):
    """The part of a convex polygon (k, 3) with n.x >= d."""
    s = polygon @ n - d
    parts = []
    for a, b, sa, sb in zip(polygon, np.roll(polygon, -1, 0), s, np.roll(s, -1)):
        if sa >= 0:
            parts.append(a)
        if (sa < 0) != (sb < 0):
            parts.append(a + sa / (sa - sb) * (b - a))
    return np.reshape(parts, (-1, 3))


def area(polygon):
    """Area of a plane polygon (k, 3)."""
    if len(polygon) < 3:
        return 0.0
    a = polygon - polygon[0]
    return float(np.linalg.norm(np.cross(a[1:-1], a[2:]).sum(axis=0)) / 2)


def sides(low, high):
    """Six planes (n, d) of the box between two corners."""
    return [(sign * np.eye(3)[k], float(sign * (low, high)[sign < 0][k]))
            for k in range(3) for sign in (1, -1)]


def sheet(n, d, middle, size):
    """A large square on the plane n.x = d."""
    u = np.cross(n, np.eye(3)[np.abs(n).argmin()])
    u /= np.linalg.norm(u)
    v, centre = np.cross(n, u), middle + (d - n @ middle) * n
    return centre + 4 * size * np.array([u + v, v - u, -u - v, u - v])


def check_walls(planes, elements, g, smallest):
    """Refuses walls that have holes where LAMMPS' infinite planes have none, and those that let
    particles fall out; returns the corners (low, high) of the mesh [L].

    smallest: the smallest radius [L]. No centre comes nearer to another wall than half of it, so
    that a face may end there.
    """
    points = np.vstack([elements[k].corners + elements[k].radius * p.n
                        for p in planes for k in p.faces])
    low, high = points.min(axis=0), points.max(axis=0)
    size, middle = np.linalg.norm(high - low), (low + high) / 2
    grown = [(n, d - ALIKE * size) for n, d in sides(low, high)]
    for p in planes:
        bounds = grown + [(q.n, q.d + (smallest / 2 if q.n @ p.n < ALIKE else -ALIKE * size))
                          for q in planes if q is not p]

        def cut(polygon):
            for n, d in bounds:
                polygon = clip(polygon, n, d)
            return area(polygon)
        whole = cut(sheet(p.n, p.d, middle, size))
        faces = sum(cut(elements[k].corners + elements[k].radius * p.n) for k in p.faces)
        if abs(faces - whole) > COVERED * whole + (ALIKE * size)**2:
            what = "has holes or ends" if faces < whole else "lies twice"
            refuse(f"the wall of {name_of(p.faces[0], elements[p.faces[0]])} {what} where "
                   f"particles can be: its faces cover {100 * faces / whole:.4g} % of it: the "
                   "walls are not those of a convex box")
    for n, d in sides(low, high):
        if -n @ g > ALIKE * np.linalg.norm(g):
            polygon = sheet(n, d, middle, size)
            for m, e in grown + [(p.n, p.d + COVERED * size) for p in planes]:
                polygon = clip(polygon, m, e)
            if area(polygon) > COVERED * size**2:
                axis = np.abs(n).argmax()
                refuse(f"the walls are open at {'xyz'[axis]} = {-d * -n[axis]:g}, where particles "
                       "fall out")
    return low, high


def vibrations(scene, planes):
    """{group: (axis, amplitude [L], frequency [1/T], phase)} of the groups that have walls."""
    moves = {}
    for group, kind, numbers in read_motion(scene.get("motion")):
        walls = [p for p in planes if p.group == group]
        if not walls:
            continue
        if kind != "vibrate":
            refuse(f"motion: group {group} moves by '{kind}'; only 'vibrate' is exact there")
        axis = np.flatnonzero(numbers[:3])
        slanted = [p for p in walls if np.count_nonzero(p.n) > 1]
        if len(axis) > 1 or (len(axis) and slanted):
            refuse(f"motion: group {group} must vibrate along x, y or z and have walls that are "
                   "normal to an axis")
        if len(axis) and numbers[3] != 0:
            phase = numbers[4] if len(numbers) > 4 else 0.0
            moves[group] = (int(axis[0]), float(numbers[axis[0]]), float(numbers[3]), phase)
    return moves


def shifted(planes, elements, shifts):
    """Planes and elements with groups moved by shifts {group: (3,) [L]}."""
    elements = [e._replace(corners=e.corners + shifts.get(e.group, np.zeros(3))) for e in elements]
    return [p._replace(d=p.d + float(p.n @ shifts.get(p.group, np.zeros(3)))) for p in planes], \
        elements


def wiggle(move, t, dt):
    """LAMMPS' wall at lo + A - A cos(w s) as our A (sin(w t + phase) - sin(phase)).

    s counts from the step at which the wall is defined; the run starts at step 0, so s begins with
    minus that step. Returns the offset of lo [L], A, the step, and the error of the phase [rad]
    that is left because steps are whole: that of the best among PHASE_STEPS.
    """
    _, A, F, phase = move
    w = 2 * math.pi * F
    wanted = w * t + phase + math.pi / 2  # because sin(a) = -cos(a + pi/2)
    off = (-w * dt * np.arange(PHASE_STEPS) - wanted + math.pi) % (2 * math.pi) - math.pi
    best = 0 if abs(off[0]) < 1e-12 else int(np.abs(off).argmin())
    return -A * math.sin(phase) - A, A, best, float(off[best])


# ------------------------------------------------------------------------------------- writing

class State(NamedTuple):
    """What goes: the run, the number and the content of the frame, how many frames are to come,
    and the texts of scene.ini and mesh.off."""
    run: object
    number: int
    frame: np.ndarray
    ahead: int
    ini: str
    off: str


def state_of(run, number, ahead):
    """The state of a run at a frame."""
    off = Path(run.scene["mesh"]).read_text(errors="replace") if "mesh" in run.scene else ""
    ini = (run.folder / "scene.ini").read_text(errors="replace")
    return State(run, number, run.frame(number), ahead, ini, off)


def load(source, number):
    """The state of an OUTPUT, or of a scene: the program itself resolves what the scene says."""
    source = Path(source)
    if any(source.glob("particles" + "[0-9]" * 6 + ".csv")):
        run = read_run(source)
        number = max(run.files) if number is None else number
        return state_of(run, number, max(run.scene["Nframes"] - number, 1))
    if number is not None:
        fail(f"--frame {number}: {source} holds no run; try: the OUTPUT of a run")
    scene = source / "scene.ini" if source.is_dir() else source
    frames = read_scene(scene).get("Nframes", FRAMES)
    program = os.environ.get("TINYDEM", Path(__file__).parents[1] / "build/default/tinydem")
    with tempfile.TemporaryDirectory() as folder:
        words = [program, "", "", Path(folder) / "run", "--scene", scene, "--Nframes", 0, "--quiet"]
        try:
            done = subprocess.run(list(map(str, words)), capture_output=True, text=True)
        except OSError as error:
            fail(f"{program}: cannot be run ({error.strerror}); try: ./dem build, or set TINYDEM")
        if done.returncode:
            print(done.stderr.strip(), file=sys.stderr)
            sys.exit(2)
        run = read_run(Path(folder) / "run")
        run.scene["Nframes"] = frames
        return state_of(run, 0, frames)


def check(state, args):
    """Refuses scenes that would silently differ, for both programs."""
    p, N = state.run.scene, len(state.frame)
    if N == 0:
        fail(f"{args.source}: has no particles; try: run it first, then hand the OUTPUT off")
    if p["scheme"] != "consistent":
        fail("scheme = paper: LAMMPS updates friction springs as 'consistent' does; try: "
             "--scheme consistent")
    if p["Nspawn"] > 0 and N < p["Nmax"] and not args.stop_spawning:
        fail(f"{args.source}: only {N} of Nmax = {p['Nmax']} particles are there, and LAMMPS fills "
             "a box by other rules; try: run until all are there, or --stop-spawning")


def gravity_words(p):
    """Magnitude and direction of g as LAMMPS wants them."""
    g = np.asarray(p["g"], float)
    return f"gravity {np.linalg.norm(g):.17g} vector " + " ".join(f"{v:.17g}" for v in g)


def start_velocities(state, damping):
    """v (N, 3) [L/T] and w (N, 3) [1/T] whose first step in velocity Verlet is ours; damping (N,)
    [1/T] of Eq. (3). Without drag: v + g dt/2."""
    p, f = state.run.scene, state.frame
    dt, c, d = p["dt"], damping[:, None], 10 / 3 * damping[:, None]
    v = (columns(f, "vx,vy,vz") * (1 - c * dt) + dt / 2 * np.asarray(p["g"])) / (1 - c * dt / 2)
    return v, columns(f, "wx,wy,wz") * (1 - d * dt) / (1 - d * dt / 2)


def write_data(path, frame, kinds, types, rho, v, w, box, title):
    """A data file of spheres: kinds (N,) from 0 of `types`, v (N, 3), w (N, 3); box (low, high)."""
    number = np.arange(1, len(frame) + 1)
    with open(path, "w") as file:
        file.write(f"{title}\n\n{len(frame)} atoms\n{types} atom types\n")
        for k, axis in enumerate("xyz"):
            file.write(f"{box[0][k]:.17g} {box[1][k]:.17g} {axis}lo {axis}hi\n")
        file.write("\nAtoms\n\n")
        rows = np.column_stack([number, kinds + 1, 2 * frame["R"], np.full(len(frame), rho),
                                columns(frame, "x,y,z")])
        np.savetxt(file, rows, fmt="%d %d" + " %.17g" * 5)
        file.write("\nVelocities\n\n")
        np.savetxt(file, np.column_stack([number, v, w]), fmt="%d" + " %.17g" * 6)


def open_sides(planes, corners, g):
    """Which sides of the box of a mesh may be left, array (2, 3) of bool for low and high: those
    against gravity, and those beyond which LAMMPS' infinite planes do not go on."""
    low, high = corners
    size, middle, free = np.linalg.norm(high - low), (low + high) / 2, np.zeros((2, 3), bool)
    facets = []
    for p in planes:
        polygon = sheet(p.n, p.d, middle, 1000 * size)
        for q in planes:
            polygon = polygon if q is p else clip(polygon, q.n, q.d - ALIKE * size)
        facets.append(polygon)
    points = np.vstack(facets)
    for k in range(3):
        for sign, at in ((-1, low[k]), (1, high[k])):
            faced = any(sign * p.n[k] < -ALIKE for p in planes)
            beyond = (sign * points[:, k]).max() - sign * at > COVERED * size
            free[(sign + 1) // 2, k] = sign * g[k] < -ALIKE * np.linalg.norm(g) or not (
                faced or beyond)
    return free


def box_of(frame, corners, free):
    """Box of LAMMPS (low, high) [L] and its words after `boundary`; free: see open_sides.

    There the box grows with the particles. An atom that leaves another side is lost, which stops
    LAMMPS: in the scene it would have left the walls.
    """
    centres, R = columns(frame, "x,y,z"), frame["R"].max()
    box, words = [centres.min(axis=0) - 2 * R, centres.max(axis=0) + 2 * R], ["", "", ""]
    for end, sign in ((0, -1), (1, 1)):
        for k in range(3):
            at = sign * corners[end][k] if corners is not None else -np.inf
            if corners is None or free[end, k]:
                box[end][k] = sign * max(sign * box[end][k], at + R)
            else:
                beyond = sign * centres[:, k] > at
                if beyond.any():
                    fail(f"particle {beyond.argmax() + 1} at {centres[beyond.argmax()]} is beyond "
                         f"the walls ({'xyz'[k]} = {sign * at:g}); try: an earlier --frame")
                box[end][k] = sign * (at + 0.01 * R)
            words[k] += "m" if corners is None or free[end, k] else "f"
    return *box, " ".join(word if word[0] != word[1] else word[0] for word in words)


def wall_fixes(planes, moves, classes, p, t, indentation):
    """Lines of in.tinydem for the walls, lines before them for vibration, and notes."""
    lines, notes = [], []
    for k, plane in enumerate(planes):
        axis = int(np.abs(plane.n).argmax())
        straight, low, wiggles, began = abs(plane.n[axis]) == 1, 0.0, "", 0
        if plane.group in moves:
            move = moves[plane.group]
            low, A, began, off = wiggle(move, t, p["dt"])
            low = low if axis == move[0] else 0.0
            wiggles = f" wiggle {'xyz'[move[0]]} {A:.17g} {1 / move[2]:.17g}"
            notes.append(f"group {plane.group}: the phase of the vibration is off by {off:.1g} rad; "
                         "friction and damping see its velocity half a step later than here")
        place = plane.n[axis] * plane.d + low if straight else 0.0
        where = f"{'xyz'[axis]}plane " + (f"{place:.17g} NULL" if plane.n[axis] > 0 else
                                          f"NULL {place:.17g}")
        style = "wall/gran"
        if not straight:
            point, n = plane.d * plane.n, plane.n
            lines.append(f"region wall{k} plane " + " ".join(f"{v:.17g}" for v in (*point, *n)))
            style, where = "wall/gran/region", f"region wall{k}"
        if began:
            lines.append(f"reset_timestep {began}  # the wall counts its time from here: its phase")
        for c, R in enumerate(classes.radii):
            group = "all" if len(classes.radii) == 1 else f"class{c + 1}"
            words = contact_words(p, R, None, indentation)
            lines.append(f"fix wall{k}_{c + 1} {group} {style} granular {words} {where}{wiggles}")
        if began:
            lines.append("reset_timestep 0")
    return lines, sorted(set(notes))


def write_lammps(state, folder, args):
    """data.tinydem and in.tinydem; returns what README.txt must say about this scene."""
    p, frame, run = state.run.scene, state.frame, state.run
    g, t, R = np.asarray(p["g"], float), run.time(state.number), frame["R"]
    elements = run.mesh_at(0)
    springs = p["mur"] > 0 or p["mut"] > 0
    classes = radius_classes(R, args.classes if springs or p["eta"] > 0 else 1)
    now = run.mesh_at(t)
    planes_now, corners = planes_of(now, frame), None
    moves = vibrations(p, planes_now)
    shifts = [{group: sign * A * np.eye(3)[k] - A * math.sin(phase) * np.eye(3)[k]
               for group, (k, A, F, phase) in moves.items()} for sign in (-1, 1)]
    at_rest = [q._replace(d=float(elements[q.faces[0]].corners[0] @ q.n)
                          + elements[q.faces[0]].radius) for q in planes_now]
    if planes_now:
        ends = [check_walls(planes_now, now, g, R.min())]
        ends += [check_walls(*shifted(at_rest, elements, s), g, R.min()) for s in shifts if s]
        corners = np.min([e[0] for e in ends], axis=0), np.max([e[1] for e in ends], axis=0)
    free = None if corners is None else open_sides(planes_now, corners, g)
    low, high, boundary = box_of(frame, corners, free)
    drag = 4.5 * p["eta"] / (p["rho"] * classes.radii[classes.of]**2)
    v, w = start_velocities(state, drag)
    write_data(folder / "data.tinydem", frame, classes.of, len(classes.radii), p["rho"], v, w,
               (low, high), f"TinyDEM frame {state.number}, t = {t:.17g}")
    walls, notes = wall_fixes(at_rest, moves, classes, p, t, args.indentation)
    many = len(classes.radii) > 1
    ratio = R.max() / R.min()
    pairs = [f"pair_coeff {i + 1} {j + 1} {contact_words(p, a, b, args.indentation)}"
             for i, a in enumerate(classes.radii) for j, b in enumerate(classes.radii) if i <= j]
    up = int(np.abs(g).argmax())
    lines = ["# Written by TinyDEM's lammps.py; README.txt says what is exact. mpirun -np N lmp "
             "-in in.tinydem",
             "units si", "atom_style sphere", f"boundary {boundary}", "newton off",
             "comm_modify vel yes"]
    if g.any():  # a bed lies flat: no cuts across gravity
        lines.append("processors " + " ".join("1" if k == up else "*" for k in range(3)))
    lines += ["read_data data.tinydem"]
    if ratio > 3 and many:
        lines += ["comm_modify mode multi", f"neighbor {R.min() / 2:.6g} multi"]
    else:
        lines += [f"neighbor {R.mean() / 2:.6g} bin"]
    lines += ["neigh_modify delay 0 every 1 check yes", "pair_style granular", *pairs,
              f"timestep {p['dt']:.17g}", "fix motion all nve/sphere"]
    if g.any():
        lines.append(f"fix weight all {gravity_words(p)}")
    if p["eta"] > 0:
        damp = p["rho"] * classes.radii**2 / (4.5 * p["eta"])
        scale = "".join(f" scale {k + 1} {d / damp[0]:.17g}" for k, d in enumerate(damp) if k)
        lines.append(f"fix drag all langevin 0 0 {damp[0]:.17g} 1 omega yes{scale}")
    if many:
        lines += [f"group class{k + 1} type {k + 1}" for k in range(len(classes.radii))]
    lines += walls
    lines += [f"dump frames all custom {p['Nsteps']} frame.*.dump {DUMP}",
              "dump_modify frames sort id format float %.17g",
              f"thermo {p['Nsteps']}", "thermo_modify lost error",
              f"run {state.ahead * p['Nsteps']}",
              "# To go on here: `run N pre no`. A plain `run` would make the walls bounce more."]
    (folder / "in.tinydem").write_text("\n".join(lines) + "\n")
    return notes + lammps_notes(p, classes, planes_now, elements, boundary, args, springs)


def lammps_notes(p, classes, planes, elements, boundary, args, springs):
    """What is approximate for this scene, a sentence each."""
    notes = [SLIDING] if p["mus"] > 0 else []
    if springs:
        notes.append("rolling and twisting springs are constant, those of an overlap of "
                     f"{args.indentation:g} R (--indentation); a settled bed and a collapsed "
                     "column agree to 0.5 and 1.5 %, single trajectories do not")
    if classes.error:
        x = classes.error
        text = f"{len(classes.radii)} radius classes: a radius is up to {100 * x:.1f} % off that " \
            "of its class"
        if springs:
            text += f", rolling stiffness and twisting limit {100 * x:.1f} %, twisting stiffness " \
                f"{100 * ((1 + x)**3 - 1):.1f} %"
        if p["eta"] > 0:
            text += f", drag {100 * ((1 - x)**-2 - 1):.1f} %"
        if springs or p["eta"] > 0:
            notes.append(text + "; normal and sliding forces take the true radii")
    tiled = sum(len(q.faces) for q in planes) - len(planes)
    if tiled:
        notes.append(f"{tiled} seams between faces of one plane are gone: no bump when a particle "
                     "crosses them")
    if planes:
        notes.append("walls are infinite planes: above a rim they go on. An atom that leaves the "
                     "box through a side of kind f (boundary " + boundary + ") stops LAMMPS with "
                     "'Lost atoms'")
    return notes


# ------------------------------------------------------------------------------------ LIGGGHTS

def write_stl(path, triangles):
    """An STL file as text, because binary ones have only seven digits; triangles (n, 3, 3)."""
    with open(path, "w") as file:
        file.write("solid mesh\n")
        for t in triangles:
            n = np.cross(t[1] - t[0], t[2] - t[0])
            n /= np.linalg.norm(n)
            rows = ["vertex " + " ".join(f"{v:.17g}" for v in corner) for corner in t]
            file.write(f"facet normal {n[0]:.9g} {n[1]:.9g} {n[2]:.9g}\nouter loop\n"
                       + "\n".join(rows) + "\nendloop\nendfacet\n")
        file.write("endsolid mesh\n")


def check_liggghts(p, elements):
    """Refuses what LIGGGHTS cannot do."""
    limits = {"en": (p["en"] > 0.05, "must be above 0.05"), "eta": (p["eta"] == 0, "must be 0"),
              "mur": (p["mur"] <= 1, "must be at most 1"),
              "nu": (0 <= p["nu"] < 0.5, "must be from 0 to below 0.5")}
    for name, (good, rule) in limits.items():
        if not good:
            fail(f"{name} = {p[name]:g}: {rule} in LIGGGHTS; try: the hand-off to LAMMPS")
    groups = {e.group for e in elements}
    for group, kind, _ in read_motion(p.get("motion")):
        if group in groups:
            fail(f"motion: group {group} moves by '{kind}'; LIGGGHTS gets meshes at rest; try: a "
                 "scene without motion")
    for k, e in enumerate(elements):
        if len(e.corners) < 3 or e.radius > 0:
            fail(f"{name_of(k, e)}: LIGGGHTS has triangles without thickness (Rmesh = "
                 f"{e.radius:g}); try: a mesh of faces, Rmesh = 0 for them")


def write_liggghts(state, folder, args):
    """data.tinydem, mesh.stl and in.liggghts; returns what README.txt must say."""
    p, frame, elements = state.run.scene, state.frame, state.run.mesh
    check_liggghts(p, elements)
    g, R = np.asarray(p["g"], float), frame["R"]
    v, w = start_velocities(state, np.zeros(len(frame)))
    corners = None
    if elements:
        points = np.vstack([e.corners for e in elements])
        corners = points.min(axis=0), points.max(axis=0)
        write_stl(folder / "mesh.stl", triangles_of(elements))
    low, high, _ = box_of(frame, corners, np.ones((2, 3), bool))
    if corners is not None:  # LIGGGHTS wants the mesh inside
        low, high = low - 2 * R.max(), high + 2 * R.max()
    write_data(folder / "data.tinydem", frame, np.zeros(len(frame)), 2, p["rho"], v, w,
               (low, high), f"TinyDEM frame {state.number}")
    law = "model hertz tangential " + ("history" if p["mus"] > 0 else "off")
    law += " rolling_friction epsd3" if p["mur"] > 0 else ""
    options = " tangential_damping off" if p["mus"] > 0 else ""
    prop = "fix {0} all property/global {1} "

    def pairs(name, value):
        return prop.format(name, name) + f"peratomtypepair 2 {value:.17g} {value:.17g} " \
            f"{value:.17g} {value:.17g}"
    lines = ["# Written by TinyDEM's lammps.py --liggghts: same normal law, approximate friction.",
             "# mpirun -np N liggghts -in in.liggghts (not with -screen none)",
             "units si", "atom_style granular", "boundary m m m", "newton off",
             "communicate single vel yes", "soft_particles yes",
             "hard_particles yes", "read_data data.tinydem",
             f"neighbor {R.mean() / 2:.6g} bin", "neigh_modify delay 0",
             prop.format("youngsModulus", "youngsModulus") + f"peratomtype {p['E']:.17g} 1e30",
             prop.format("poissonsRatio", "poissonsRatio") + f"peratomtype {p['nu']:.17g} "
             f"{p['nu']:.17g}",
             pairs("coefficientRestitution", p["en"]), pairs("coefficientFriction", p["mus"])]
    if p["mur"] > 0:
        lines += [pairs("coefficientRollingFriction", p["mur"]),
                  prop.format("rollingStiffness", "rollingStiffness")
                  + f"scalar {p['mur']**-2:.17g}",
                  pairs("coefficientRollingViscousDamping", damping_ratio(p["en"]))]
    lines += [f"pair_style gran {law}{options}", "pair_coeff * *", f"timestep {p['dt']:.17g}",
              "fix motion all nve/sphere"]
    if g.any():
        lines.append(f"fix weight all {gravity_words(p)}")
    if elements:
        lines += ["fix mesh all mesh/surface file mesh.stl type 2",
                  f"fix walls all wall/gran {law} mesh n_meshes 1 meshes mesh{options}"]
    form = " ".join(["%d", "%d"] + ["%.17g"] * (len(DUMP.split()) - 2))
    lines += [f"dump frames all custom {p['Nsteps']} frame.*.dump {DUMP}",
              f'dump_modify frames sort id format "{form}"', f"thermo {p['Nsteps']}",
              "thermo_modify lost error", f"run {state.ahead * p['Nsteps']}"]
    (folder / "in.liggghts").write_text("\n".join(lines) + "\n")
    return ["same normal law, approximate friction: no damping of sliding, another rolling dashpot,"
            " no twisting friction of its own (mu_t is not used)"]


# --------------------------------------------------------------------------------- whole thing

README = """Handed off by TinyDEM: frame {number} of {source}, t = {t:g}, {N} particles.

Run:   mpirun -np N {program} -in {script}
Back:  lammps.py --back {folder} OUTPUT      (or ./dem handoff --back {folder} OUTPUT)

Exact: {exact}.
Approximate:
{notes}
Lost on the way: the springs of friction (contacts start anew) and orientations (frames that come
back have q = 1,0,0,0).
"""


def hand_off(args):
    """Write all files."""
    state, folder = load(args.source, args.frame), args.target
    if not args.overwrite and any((folder / f).exists() for f in (*FILES[0], *FILES[1])):
        fail(f"{folder}: holds a hand-off; try: --overwrite, or another folder")
    check(state, args)
    write = write_liggghts if args.liggghts else write_lammps
    with tempfile.TemporaryDirectory() as scratch:  # nothing partial stays if it is refused
        scratch = Path(scratch)
        notes = write(state, scratch, args)
        p, t = state.run.scene, state.run.time(state.number)
        exact = "normal forces, gravity, triangles, start velocities" if args.liggghts else \
            "normal forces, stiffness, damping and limit of sliding, plane walls, vibration, " \
            "gravity, drag, start velocities"
        (scratch / "README.txt").write_text(README.format(
            number=state.number, source=args.source, t=t, N=len(state.frame), exact=exact,
            program="liggghts" if args.liggghts else "lmp", script=FILES[args.liggghts][1],
            folder=folder, notes="\n".join(f"- {note}." for note in notes) or "- nothing."))
        (scratch / "handoff.json").write_text(json.dumps(
            {"frame": state.number, "particles": len(state.frame)}) + "\n")
        (scratch / "scene.ini").write_text(scene_text(state))
        if state.off:
            (scratch / "mesh.off").write_text(state.off)
        try:
            folder.mkdir(parents=True, exist_ok=True)
            for old in folder.glob("frame.*.dump"):
                old.unlink()
            for path in scratch.iterdir():
                (folder / path.name).write_bytes(path.read_bytes())
        except OSError as error:
            fail(f"{folder}: cannot be written ({error.strerror}); try: another folder")
    print((folder / "README.txt").read_text(), end="")


def scene_text(state):
    """scene.ini of the frames that come back: it starts the solver where the hand-off started."""
    lines = [f"# Frames from another program, started from frame {state.number} of a TinyDEM run."]
    for line in state.ini.splitlines():
        name = line.partition("=")[0].strip()
        if line.startswith("# render:") or name not in ("particles", "output", "Nspawn", "Nframes",
                                                        "") and not line.startswith("#"):
            lines.append(line)
    return "\n".join(lines + [f"Nframes = {state.run.scene['Nframes']}", "Nspawn = 0",
                              f"particles = particles{state.number:06d}.csv"]) + "\n"


def read_dump(path, N):
    """A dump: (time step, structured array by column name, sorted by id); N: particles expected."""
    try:
        lines = Path(path).read_text(errors="replace").splitlines()
    except OSError as error:
        fail(f"{path}: cannot be read ({error.strerror}); try: run LAMMPS again")
    heads = {0: "ITEM: TIMESTEP", 2: "ITEM: NUMBER OF ATOMS", 4: "ITEM: BOX BOUNDS",
             8: "ITEM: ATOMS"}
    for k, head in heads.items():
        if k >= len(lines) or not lines[k].startswith(head):
            fail(f"{path}:{k + 1}: expected '{head}', found "
                 f"'{lines[k][:60] if k < len(lines) else 'the end'}'; try: the dump of in.tinydem")
    names = lines[8].split()[2:]
    if missing := [name for name in DUMP.split() if name not in names]:
        fail(f"{path}:9: no column {', '.join(missing)}; try: the dump of in.tinydem as it is")
    if not (lines[1].strip().isdigit() and lines[3].strip() == str(N)):
        fail(f"{path}:4: {lines[3][:20]} atoms at step {lines[1][:20]}, expected {N}; try: the "
             "folder of one hand-off, and all its atoms")
    try:
        data = np.loadtxt(lines[9:], ndmin=2)
    except ValueError:
        data = np.empty((0, 0))
    if data.shape != (N, len(names)) or not np.isfinite(data).all():
        bad = next((k for k, line in enumerate(lines[9:], 10) if not finite(line, len(names))),
                   len(lines))
        fail(f"{path}:{bad}: expected {N} lines of {len(names)} finite numbers; try: run LAMMPS "
             "again, the dump is not complete")
    data = data[np.argsort(data[:, names.index("id")])]
    if (data[:, names.index("id")] != np.arange(1, N + 1)).any():
        fail(f"{path}: the ids are not 1 to {N}; try: the dump of in.tinydem as it is")
    table = np.empty(N, [(name, float) for name in names])
    for k, name in enumerate(names):
        table[name] = data[:, k]
    return int(lines[1]), table


def finite(line, count):
    """Does a line hold so many finite numbers?"""
    try:
        values = [float(word) for word in line.split()]
    except ValueError:
        return False
    return len(values) == count and all(map(math.isfinite, values))


def frame_of(dump, dt):
    """A dump as an array with the columns of HEADER. Velocities are those of the half step before,
    as the semi-implicit Euler method has them: v - dt/2 f/m, w - dt/2 torque/I."""
    frame = np.zeros(len(dump), [(name, float) for name in HEADER.split(",")])
    inertia = 0.4 * dump["mass"] * dump["radius"]**2
    frame["R"], frame["q0"] = dump["radius"], 1
    for axis in "xyz":
        frame[axis] = dump[axis]
        frame["v" + axis] = dump["v" + axis] - dt / 2 * dump["f" + axis] / dump["mass"]
        frame["w" + axis] = dump["omega" + axis] - dt / 2 * dump["tq" + axis] / inertia
    return frame


def bring_back(args):
    """Dumps of a hand-off as the frames of an OUTPUT."""
    folder, target = args.source, args.target
    try:
        facts = json.loads((folder / "handoff.json").read_text())
    except (OSError, ValueError):
        fail(f"{folder}/handoff.json: cannot be read; try: a folder that lammps.py wrote")
    scene = read_scene(folder / "scene.ini")
    dumps = sorted(folder.glob("frame.*.dump"), key=lambda f: (len(f.name), f.name))
    if not dumps:
        fail(f"{folder}: no frame.*.dump there; try: run LAMMPS in it first")
    if not args.overwrite and any(target.glob("particles*.csv")):
        fail(f"{target}: holds a run; try: --overwrite, or another folder")
    rows = []
    for k, path in enumerate(dumps):
        step, dump = read_dump(path, facts["particles"])
        if step % scene["Nsteps"]:
            fail(f"{path}:2: step {step} is no multiple of Nsteps = {scene['Nsteps']}; try: the "
                 "dump of in.tinydem as it is")
        if k == 0:  # the first file is good: begin
            target.mkdir(parents=True, exist_ok=True)
            for old in target.glob("particles*.csv"):
                old.unlink()
        number = facts["frame"] + step // scene["Nsteps"]
        frame, g = frame_of(dump, scene["dt"]), np.asarray(scene["g"], float)
        np.savetxt(target / f"particles{number:06d}.csv", columns(frame, HEADER), fmt="%.17g",
                   delimiter=",", header=HEADER, comments="")
        m, v, w = dump["mass"], columns(frame, "vx,vy,vz"), columns(frame, "wx,wy,wz")
        rows.append([number, number * scene["Nsteps"] * scene["dt"], len(frame),
                     (m * (v**2).sum(axis=1)).sum() / 2,
                     (m * frame["R"]**2 * (w**2).sum(axis=1)).sum() / 5,
                     -(m * (columns(frame, "x,y,z") @ g)).sum()])
    for name in ("scene.ini", "mesh.off"):
        if (folder / name).exists():
            (target / name).write_bytes((folder / name).read_bytes())
    np.savetxt(target / "log.csv", rows, fmt="%.17g", delimiter=",", comments="",
               header="frame,t,N,kinetic,rotational,potential")
    print(f"{target}: {len(rows)} frames, {rows[0][0]} to {rows[-1][0]}")


def main():
    """Convert as the command line says."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path, help="a scene or an OUTPUT; with --back: DIR")
    parser.add_argument("target", type=Path, help="DIR; with --back: OUTPUT")
    parser.add_argument("--back", action="store_true", help="dumps of DIR to frames in OUTPUT")
    parser.add_argument("--liggghts", action="store_true", help="write for LIGGGHTS")
    parser.add_argument("--frame", type=int, help="of an OUTPUT (default: the last)")
    parser.add_argument("--classes", type=int, help="number of radius classes, 1 to 50")
    parser.add_argument("--indentation", type=float, default=INDENTATION,
                        help="overlap / radius for rolling and twisting (default %(default)s)")
    parser.add_argument("--stop-spawning", action="store_true",
                        help="hand off although particles are still to come")
    parser.add_argument("--overwrite", action="store_true", help="replace what is there")
    args = parser.parse_args()
    if args.classes is not None and not 1 <= args.classes <= 50:
        fail(f"--classes {args.classes}: must be from 1 to 50; try: 8")
    if not 0 < args.indentation < 1:
        fail(f"--indentation {args.indentation:g}: must be between 0 and 1; try: {INDENTATION}")
    (bring_back if args.back else hand_off)(args)


if __name__ == "__main__":
    main()

"""Case 27: the same scenes by the solver and by LAMMPS, handed over and back by lammps.py."""
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import style

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tinydem"), str(ROOT / "verification/bench")]
from frames import HEADER, columns, read_run  # noqa: E402  (after the path is set)
from lammps_runs import Lammps  # noqa: E402

PLATE = "OFF\n4 1 0\n-9 -9 0\n9 -9 0\n9 9 0\n-9 9 0\n4 0 1 2 3\n"
CUP = "OFF\n8 5 0\n" + "".join(f"{x} {y} {z}\n" for z in (0, 0.5) for x, y in
                               ((0, 0), (0.14, 0), (0.14, 0.144), (0, 0.144))) + \
    "4 0 1 2 3\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
GROOVE = "OFF\n6 2 0\n0 -1 0\n0 1 0\n1 -1 0.7\n1 1 0.7\n-1 -1 0.7\n-1 1 0.7\n4 0 1 3 2\n4 0 1 5 4\n"
ANGLES = range(0, 86, 5)
R, SPACE = 0.01, 0.2  # radius; distance between impacts, m
#: What LAMMPS does otherwise in sliding, as texts of tinydem.cpp: three statements.
ARM = [("cross(c.n, c.ri * i.w + c.rj * j.w)", "cross(c.n, i.R * i.w + j.R * j.w)"),
       ("c.ri = i.R - c.delta / 2;", "c.ri = select(wall, i.R, i.R - c.delta / 2);")]
RESET = [("const V rest = M::printed ? f + m.c * v : f;", "const V rest = f + m.c * v;")]
#: And of a vibrating wall: its velocity is that of the end of a step, not of the middle.
LATE = [("std::cos(angle - pi * g.F * p.dt)", "std::cos(angle)")]


class Both:
    """Scenes in a folder, run by both codes. solver: the program; tools: where lammps.py is."""

    def __init__(self, folder, solver, tools):
        self.folder, self.solver, self.tools = Path(folder), solver, tools
        self.lammps = Lammps(self.folder)

    def call(self, *words, where=None):
        env = {**os.environ, "OMP_NUM_THREADS": "1", "TINYDEM": str(self.solver)}
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True, env=env,
                              cwd=where or self.folder, timeout=280)
        if done.returncode:
            raise RuntimeError(f"{' '.join(map(str, words))}: {(done.stdout + done.stderr)[-400:]}")

    def scene(self, name, rows, mesh=None, **parameters):
        """Writes a scene; rows: x, y, z, R, v (3), w (3) of the particles. Nothing falls and no
        friction unless asked. Returns its file."""
        folder = self.folder / name
        folder.mkdir()
        table = np.array([(*r[:7], 1, 0, 0, 0, *r[7:]) for r in rows], float)
        np.savetxt(folder / "p.csv", table, "%.17g", ",", header=HEADER, comments="")
        radii = table[:, 3]
        values = {"particles": "p.csv", "Rmesh": 0, "Nspawn": 0, "mus": 0, "mur": 0, "mut": 0,
                  "g": "0,0,0", "Rmin": radii.min(), "Rmax": radii.max(), **parameters}
        if mesh:
            (folder / "mesh.off").write_text(mesh)
            values["mesh"] = "mesh.off"
        text = "".join(f"{key} = {value}\n" for key, value in values.items())
        (folder / "scene.ini").write_text(text)
        return folder / "scene.ini"

    def ours(self, scene, out, solver=None):
        """The run of the solver (or of another program)."""
        self.call(solver or self.solver, "", "", out, "--scene", scene, "--quiet")
        return read_run(self.folder / out)

    def theirs(self, source, out, ranks=1, script=None, options=()):
        """The run of LAMMPS; script(text): changes in.tinydem."""
        there = self.folder / f"{out}.lammps"
        self.call(sys.executable, self.tools / "lammps.py", source, there, *options)
        if script:
            path = there / "in.tinydem"
            path.write_text(script(path.read_text()))
        words = self.lammps.launcher(ranks)
        self.call(*words, self.lammps.program, "-in", "in.tinydem", where=there)
        self.call(sys.executable, self.tools / "lammps.py", "--back", there, self.folder / out)
        return read_run(self.folder / out)


def difference(a, b, names="vx,vy,vz"):
    """Largest length of the difference of two frames in these columns."""
    return float(np.linalg.norm(columns(a, names) - columns(b, names), axis=1).max())


def impacts(angles, spin=True):
    """Particles of many impacts at 1 m/s on a plate at z = 0 and on spheres at rest, that are
    equal, twice as large or half as large; every third comes with a spin."""
    rows = []
    for k, angle in enumerate(np.radians(angles)):
        v, w = (np.sin(angle), 0, -np.cos(angle)), (0, 0, 0)
        if spin and k % 3 == 0:
            w = (10, -20, 30)
        rows.append((SPACE * k, 0, R + 1e-4, R, *v, *w))
        for j, (a, b) in enumerate(((R, R), (R / 2, R), (R, R / 2)), start=1):
            z = 0.3
            rows.append((SPACE * k, SPACE * j, z, b, *(0,) * 6))
            rows.append((SPACE * k, SPACE * j, z + a + b + 1e-4, a, *v, *w))
    return [(r[0] - SPACE * len(angles) / 2, *r[1:]) for r in rows]


def variant(build, changes):
    """The solver with some texts replaced, as a program; it is kept for the next time."""
    folder = build / f"variants/{len(changes)}"
    folder.mkdir(parents=True, exist_ok=True)
    source, program, header = folder / "tinydem.cpp", folder / "tinydem", folder / "tinydem.hpp"
    text = (ROOT / "tinydem/tinydem.cpp").read_text()
    for old, new in changes:
        if text.count(old) != 1:
            raise RuntimeError(f"this must stand once in tinydem.cpp: {old}")
        text = text.replace(old, new)
    wanted = {source: text.replace("#if defined(__x86_64__) && ", "#if 0 && "),
              header: (ROOT / "tinydem/tinydem.hpp").read_text()}
    if program.exists() and all(p.exists() and p.read_text() == t for p, t in wanted.items()):
        return program
    program.unlink(missing_ok=True)
    for path, content in wanted.items():
        path.write_text(content)
    compiler, *flags = (build / "compile.txt").read_text().split("\n")
    flags = [f for f in flags if f and f not in ("-shared", "-fPIC", "-DTINYDEM_NO_MAIN")]
    done = subprocess.run([compiler, *flags, source, "-o", program], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr[-2000:])
    return program


def normal_impacts(both):
    """Largest difference of the velocities [impact speed] over e_n, nu and E."""
    worst = 0
    for k, (en, nu, E) in enumerate(((0, .3, 1e6), (.05, .3, 1e6), (.5, .3, 1e6), (.9, .3, 1e6),
                                     (1, .3, 1e6), (.5, 0, 1e6), (.7, .5, 1e8))):
        scene = both.scene(f"normal{k}", impacts([0], False), PLATE, en=en, nu=nu, E=E, Nframes=1,
                           Nsteps=300)
        a, b = both.ours(scene, f"normal{k}.ours"), both.theirs(scene, f"normal{k}.lmp")
        if a.frame()["vz"][0] < -0.9:
            raise RuntimeError("nothing hit the plate")
        worst = max(worst, difference(a.frame(), b.frame()))
    return worst


def oblique_impacts(both, arm, arm_and_reset):
    """Differences of velocities [impact speed] at E = 1e6 and 1e8, those to the two variants, and
    the rebounds over the angle."""
    result = {"oblique_1e6": 0, "oblique_1e8": 0, "oblique_same_statements": 0, "reset_alone": 0}
    rows = impacts(list(ANGLES))
    materials = (("1e6", 1, .3, .3), ("1e6", .5, .3, .3), ("1e6", .5, 0, .1), ("1e8", .5, .3, .3))
    for k, (E, en, nu, mus) in enumerate(materials):
        scene = both.scene(f"oblique{k}", rows, PLATE, en=en, nu=nu, E=E, mus=mus, Nframes=1,
                           Nsteps=150)
        ours, theirs = both.ours(scene, f"oblique{k}.ours"), both.theirs(scene, f"oblique{k}.lmp")
        same = both.ours(scene, f"oblique{k}.same", arm_and_reset).frame()
        half = both.ours(scene, f"oblique{k}.arm", arm).frame()
        a, b = ours.frame(), theirs.frame()
        result[f"oblique_{E}"] = max(result[f"oblique_{E}"], difference(a, b))
        both_v = max(difference(same, b), R * difference(same, b, "wx,wy,wz"))
        result["oblique_same_statements"] = max(result["oblique_same_statements"], both_v)
        result["reset_alone"] = max(result["reset_alone"], difference(half, b))
    return result


def sweep(both, out):
    """Rebounds of both codes over the angle, and their errors over the step; no spin at first, so
    that all happens in planes: the largest velocity and spin out of them is returned."""
    left, table = 0.0, style.read(out / "reference.csv")
    v = [(np.sin(a), 0, -np.cos(a)) for a in np.radians(table["angle_deg"])]
    with open(out / "sweep.csv", "w") as csv, open(out / "precision.csv", "w") as work:
        csv.write("code,angle_deg,vx,vz,spin\n")
        work.write("code,angle_deg,steps,error\n")
        for k in range(8):
            dt = 0.01 * np.sqrt(1000 * (1 - 0.3**2) / 1e6) / 2**k
            gaps = dt * np.arange(1, 5) / 4  # where in a step they touch: four phases
            rows = [(SPACE * n - 2, SPACE * j, R + gap * -a[2], R, *a, 0, 0, 0)
                    for n, a in enumerate(v) for j, gap in enumerate(gaps)]
            scene = both.scene(f"sweep{k}", rows, PLATE, en=0.5, mus=0.3, dt=repr(float(dt)),
                               Nframes=1, Nsteps=40 * 2**k)
            for code, run in (("TinyDEM", both.ours(scene, f"sweep{k}.ours")),
                              ("LAMMPS", both.theirs(scene, f"sweep{k}.lmp"))):
                f = run.frame()
                left = max(left, np.abs(columns(f, "vy,wx,wz")).max())
                shape = (len(v), len(gaps))
                vx, vz, spin = f["vx"].reshape(shape), f["vz"].reshape(shape), \
                    R * f["wy"].reshape(shape)
                square = (vx - table["vx"][:, None])**2 + (vz - table["vz"][:, None])**2 + \
                    (spin - R * table["wy"][:, None])**2
                for angle, error in zip(table["angle_deg"], np.sqrt(square.mean(axis=1))):
                    work.write(f"{code},{angle:g},{12.7 * 2**k},{error:.12g}\n")
                if k == 5:
                    for n, angle in enumerate(table["angle_deg"]):
                        csv.write(f"{code},{angle:g},{vx[n, 0]:.12g},{vz[n, 0]:.12g},"
                                  f"{spin[n, 0]:.12g}\n")
    return {"out_of_plane": left}


def walls_and_drag(both, same):
    """Errors of positions [R] and velocities [m/s] for a groove, a vibrating floor (two phases,
    and along itself) and drag of 3 sizes; same: the solver with LAMMPS' statements."""
    groove = both.scene("groove", [(0.001, 0, 0.02, 0.005, 0, 0, -1, 0, 0, 0),
                                   (0.1, 0.02, 0.2, 0.004, 0, 0, 1, 0, 0, 0)], GROOVE,
                        Rmesh=0.001, g="0,0,-9.81", Nframes=1, Nsteps=600)
    drag = both.scene("drag", [(k, 0, 0, r, 1, 0, -1, 4, 5, 6) for k, r in enumerate((.002, .004,
                                                                                   .006))],
                      eta=0.05, mur=0.3, g="0,0,-9.81", Nframes=1, Nsteps=500)
    result = {}
    for name, scene, size in (("groove", groove, 0.004), ("drag", drag, 0.002)):
        a, b = both.ours(scene, f"{name}.ours").frame(), both.theirs(scene, f"{name}.lmp").frame()
        result[name] = max(difference(a, b, "x,y,z") / size, difference(a, b),
                           size * difference(a, b, "wx,wy,wz"))
    for name, motion in (("vibration", "0 vibrate 0,0,0.002 15.3 -1.5707963267948966"),
                         ("vibration_phase", "0 vibrate 0,0,0.002 15.3 0.7"),
                         ("vibration_side", "0 vibrate 0.002,0,0 15.3 -1.5707963267948966")):
        scene = both.scene(name, [(0.1 * k, 0, 0.02, 0.005, 0.1 * k, 0, -1, 0, 0, 0)
                                  for k in range(3)], PLATE, motion=motion, g="0,0,-9.81", en=1,
                           mus=0.2 if name == "vibration_side" else 0, E=1e8, Nframes=1,
                           Nsteps=4000)
        a, b = both.ours(scene, f"{name}.ours", same).frame(), \
            both.theirs(scene, f"{name}.lmp").frame()
        result[name] = difference(a, b, "x,y,z") / 0.005
    return result


def second_run(both):
    """Restitution of a wall in a second `run`: distance from e_n with `pre no`, and without."""
    scene = both.scene("again", [(0, 0, R + 0.002, R, 0, 0, -1, 0, 0, 0)], PLATE, dt=1e-5,
                       Nframes=1, Nsteps=3000)
    result = []
    for name, pre in (("again.once", None), ("again.no", " pre no"), ("again.plain", "")):
        def script(text):
            return text if pre is None else text.replace("\nrun 3000\n",
                                                         f"\nrun 100\nrun 2900{pre}\n")
        result.append(float(both.theirs(scene, name, script=script).frame()["vz"][0]))
    once, no, plain = result
    return {"second_run_pre_no": abs(no - once), "second_run_plain": abs(plain - once)}


def settle(both, out):
    """Three loose beds of 2000 spheres fall into a box, in both codes; then the first one goes on
    for 400 steps on one and on two ranks."""
    side, across = 0.14, 11  # of the box [m]; spheres along it at first
    k, j, i = (a.ravel()[:2000] for a in np.meshgrid(*map(np.arange, (20, across, across)),
                                                     indexing="ij"))
    heights = {"TinyDEM": [], "LAMMPS": []}
    for seed in (1, 2, 3):
        random = np.random.default_rng(seed)
        places = np.column_stack([side / across * (i + 0.5), side / across * (j + 0.5),
                                  0.013 * (k + 0.6)])
        rows = [(*p, 0.005, *v, 0, 0, 0) for p, v in
                zip(places + 1e-3 * random.uniform(-1, 1, places.shape),
                    random.uniform(-0.3, 0.3, places.shape))]
        scene = both.scene(f"settle{seed}", rows, CUP, mus=0.3, mur=0.3, mut=0.2, g="0,0,-9.81",
                           Nframes=20, Nsteps=200)
        with ThreadPoolExecutor(2) as pool:
            runs = [pool.submit(both.ours, scene, f"settle{seed}.ours"),
                    pool.submit(both.theirs, scene, f"settle{seed}.lmp")]
        for code, run in zip(heights, runs):
            run = run.result()
            heights[code].append([frame["z"].mean() for _, frame in run.frames()])
    means = {code: np.mean(h, axis=0) for code, h in heights.items()}
    with open(out / "settle.csv", "w") as csv:
        csv.write("code,t,height\n")
        for code, mean in means.items():
            for number, height in enumerate(mean):
                csv.write(f"{code},{run.time(number):.9g},{height:.12g}\n")
    return {"settle_height": abs(means["LAMMPS"][-1] / means["TinyDEM"][-1] - 1),
            **ranks(both, "settle1.ours")}


def ranks(both, run):
    """A bed at rest, frame 18 of a run, goes on for 400 steps on 1 and 2 ranks: largest distance
    of a particle [R], and how far particles moved meanwhile [R]: contacts start without friction."""
    ends = []
    for n in (1, 2):
        there = both.theirs(both.folder / run, f"ranks{n}", n, options=("--frame", "18"))
        ends.append((there.frame(18), there.frame(20)))
    return {"ranks": difference(ends[0][1], ends[1][1], "x,y,z") / 0.005,
            "ranks_moved": difference(*ends[0], "x,y,z") / 0.005}


def collapse(both, out):
    """The scene column_collapse in both codes, three times from places that differ by a micrometre:
    mean height and mean radius of the deposit, relative difference of the means of the three."""
    home = ROOT / "tinydem/scenes/column_collapse"
    header, *lines = (home / "particles.csv").read_text().splitlines()
    table, jobs = np.array([line.split(",") for line in lines], float), []
    with ThreadPoolExecutor(2) as pool:
        for seed in (1, 2, 3):
            folder = both.folder / f"collapse{seed}"
            folder.mkdir()
            for name in ("scene.ini", "mesh.off"):
                shutil.copy(home / name, folder)
            moved = table.copy()
            moved[:, :3] += 1e-6 * np.random.default_rng(seed).uniform(-1, 1, (len(table), 3))
            np.savetxt(folder / "particles.csv", moved, "%.17g", ",", header=header, comments="")
            for code, run in (("TinyDEM", both.ours), ("LAMMPS", both.theirs)):
                name = f"collapse{seed}.{code}"
                jobs.append((code, pool.submit(run, folder / "scene.ini", name)))
        frames = {code: [job.result().frame() for name, job in jobs if name == code]
                  for code in ("TinyDEM", "LAMMPS")}
    edges, rows, means = np.arange(0, 0.26, 0.006), [], {}
    for code, all_three in frames.items():
        r = [np.hypot(f["x"], f["y"]) for f in all_three]
        means[code] = np.array([(f["z"].mean(), x.mean()) for f, x in zip(all_three, r)])
        volume = sum(np.histogram(x, edges, weights=4 / 3 * np.pi * f["R"]**3)[0]
                     for f, x in zip(all_three, r)) / 3
        height = volume / (np.pi * (edges[1:]**2 - edges[:-1]**2))
        rows += [f"{code},{x:.9g},{h:.9g}\n" for x, h in zip(edges[1:] - 0.003, height)]
    (out / "collapse.csv").write_text("code,r,height\n" + "".join(rows))
    off = np.abs(means["LAMMPS"].mean(axis=0) / means["TinyDEM"].mean(axis=0) - 1)
    spread = means["TinyDEM"].std(axis=0, ddof=1) / means["TinyDEM"].mean(axis=0)
    return {"collapse_height": off[0], "collapse_radius": off[1],
            "collapse_height_chaos": spread[0], "collapse_radius_chaos": spread[1]}


def measure(out, build, tools, quick):
    """Runs everything (quick: no beds, for mutants of the hand-off) and writes metrics.csv."""
    both = Both(out, build.parent / "tinydem", tools)
    with ThreadPoolExecutor(2) as pool:
        arm, same = pool.map(lambda c: variant(build, c), (ARM, ARM + RESET + LATE))
    metrics = {"normal": normal_impacts(both), **oblique_impacts(both, arm, same),
               **walls_and_drag(both, same), **second_run(both)}
    if not quick:
        metrics.update({**sweep(both, out), **settle(both, out), **collapse(both, out)})
    (out / "metrics.csv").write_text("name,value\n" + "".join(f"{name},{value:.12g}\n"
                                                              for name, value in metrics.items()))


def draw(data, out):
    line = {"TinyDEM": style.LINE["consistent"], "LAMMPS": style.LINE["paper"]}
    fig, ax = style.figure(1, 3)
    reference, table = style.read(data / "reference.csv"), style.read(data / "sweep.csv")
    for k, (name, y, ours) in enumerate((("vx", "tangential velocity / impact speed", "vx"),
                                         ("spin", "spin R ω / impact speed", "wy"))):
        size = R if ours == "wy" else 1
        ax[k].plot(reference["angle_deg"], size * reference[ours], **style.LINE["reference"],
                   label="reference")
        for code in line:
            rows = style.where(table, code=code)
            ax[k].plot(rows["angle_deg"], rows[name], **{**line[code], "linestyle": "none"},
                       label=code)
        style.label(ax[k], "impact angle / deg", y, "after an impact on a plate")
        ax[k].legend()
    for code in line:
        rows = style.where(table, code=code)
        miss = np.sqrt((rows["vx"] - reference["vx"])**2 + (rows["vz"] - reference["vz"])**2 +
                       (rows["spin"] - R * reference["wy"])**2)
        ax[2].semilogy(rows["angle_deg"], np.maximum(miss, 1e-17), **line[code], label=code)
    style.label(ax[2], "impact angle / deg", "distance from the reference", "step / 32")
    ax[2].legend()
    style.save(fig, out, "27_lammps")

    fig, ax = style.figure(1, 2)
    work = style.read(data / "precision.csv")
    for panel, angle in zip(ax, (0, 45)):
        for code in line:
            rows = style.where(work, code=code, angle_deg=angle)
            panel.loglog(rows["steps"], rows["error"], **line[code], label=code)
        style.label(panel, "force evaluations in an impact", "error / impact speed",
                    f"{angle} degrees")
        panel.legend()
    style.save(fig, out, "27_lammps_work")

    fig, ax = style.figure(1, 2)
    for panel, name, x, y, labels in (
            (ax[0], "settle", "t", "height", ("time / s", "mean height / mm",
                                              "2000 spheres settle")),
            (ax[1], "collapse", "r", "height", ("radius / m", "height of the deposit / mm",
                                                "a column collapses"))):
        table = style.read(data / f"{name}.csv")
        for code in line:
            rows = style.where(table, code=code)
            panel.plot(rows[x], 1000 * rows[y], **line[code], label=code)
        style.label(panel, *labels)
        panel.legend()
    style.save(fig, out, "27_lammps_beds")

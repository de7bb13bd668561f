"""The same packing in LAMMPS: coefficients, data file, one timed run.

LAMMPS is an engine for clusters with the same family of contact law. Normal and sliding forces are
the same formulas; rolling and twisting springs have constant coefficients there, taken here at an
overlap of 2 % of the radius, the mean of a settled bed.
"""
import math
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
#: Polynomial of Tsuji's damping in LAMMPS: damping ratio over coefficient of restitution.
TSUJI = (1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218)
INDENTATION = 0.02  # overlap / radius at which rolling and twisting springs are evaluated


def restitution_for(en):
    """The value that gives LAMMPS the damping of a restitution `en`: TSUJI(x) = sqrt(5) beta."""
    wanted = math.sqrt(5) / math.sqrt(1 + (math.pi / math.log(en)) ** 2)
    low, high = 0.0, 1.0  # the polynomial falls from 1.27 at 0 to 0 at 1
    for _ in range(60):
        middle = (low + high) / 2
        if sum(c * middle ** k for k, c in enumerate(TSUJI)) > wanted:
            low = middle
        else:
            high = middle
    return low


def coefficients(p, R, wall):
    """The words after pair_coeff (or of a wall) for parameters p and a radius R [m]."""
    E, nu, en = p["E"], p["nu"], p["en"]
    beta = 1 / math.sqrt(1 + (math.pi / math.log(en)) ** 2)
    stiff, Rstar = (2, R) if wall else (1, R / 2)
    mstar = 4 / 3 * math.pi * R ** 3 * p["rho"] / (1 if wall else 2)
    a = math.sqrt(Rstar * INDENTATION * R)
    kn = 4 / 3 * stiff * E / (2 * (1 - nu ** 2)) * a
    ks = 8 * stiff * E / (4 * (2 - nu) * (1 + nu)) * a
    cn = beta * math.sqrt(5 * mstar * kn)
    xg = math.sqrt((1 - nu) / (10 * (2 - nu)))
    cor = restitution_for(en)
    if wall:
        normal = f"hertz {4 / 3 * E / (1 - nu ** 2):.9g} {cor:.9g}"
        shear = f"mindlin {4 * E / ((2 - nu) * (1 + nu)):.9g} {xg:.9g} {p['mus']}"
    else:
        normal = f"hertz/material {E:.9g} {cor:.9g} {nu}"
        shear = f"mindlin NULL {xg:.9g} {p['mus']}"
    return f"{normal} tangential {shear} rolling sds {kn:.6g} {cn:.6g} {p['mur']} " \
           f"twisting sds {ks * Rstar ** 2:.6g} {xg * cn * Rstar ** 2:.6g} " \
           f"{p['mut'] * Rstar:.6g} damping tsuji"


def write_data(state, path, rho):
    """The data file for a state (see machinery.read_state)."""
    L, H, rows = state["L"], state["H"], state["particles"]
    with open(path, "w") as f:
        f.write(f"a packing of the bench\n\n{len(rows)} atoms\n1 atom types\n"
                f"0 {L:.17g} xlo xhi\n0 {L:.17g} ylo yhi\n{-0.01 * L:.17g} {H:.17g} zlo zhi\n\n"
                "Atoms\n\n")
        for k, r in enumerate(rows):
            f.write(f"{k + 1} 1 {2 * r[3]:.17g} {rho:.17g} {r[0]:.17g} {r[1]:.17g} {r[2]:.17g}\n")
        f.write("\nVelocities\n\n")
        for k, r in enumerate(rows):
            f.write(f"{k + 1} " + " ".join(f"{v:.17g}" for v in (*r[4:7], *r[11:14])) + "\n")


class Lammps:
    """LAMMPS of this machine; `here` is False when it is not installed."""

    def __init__(self, folder):
        self.program, self.mpirun = shutil.which("lmp"), shutil.which("mpirun")
        self.here = self.program is not None
        self.folder, self.peak = folder, 0

    def version(self):
        text = subprocess.run([self.program, "-h"], capture_output=True, text=True).stdout
        found = re.search(r"Simulator - (.+)", text)
        return found[1].strip() if found else "of unknown version"

    def launcher(self, ranks):
        """The words before `lmp` for some ranks; None: not possible here."""
        if ranks == 1:
            return []
        if not self.mpirun:
            return None
        open_mpi = "Open MPI" in subprocess.run([self.mpirun, "--version"], capture_output=True,
                                                text=True).stdout
        extra = ["--oversubscribe", "--allow-run-as-root", "--bind-to", "none"] if open_mpi else []
        return [self.mpirun, *extra, "-n", str(ranks)]

    def run(self, data, p, geometry, ranks=1, skin=0.5, newton="off", steps=100, warm=20,
            dump=0, wrap=()):
        """One run; {time [ns], rebuilds [per 1000 steps], pairs per particle}.

        data: file of write_data; p: parameters; geometry: {L, R, dt, N} with the mean radius R [m];
        skin in units of R; dump=1: writes what was read to
        read.dump. Raises RuntimeError with the end of LAMMPS' output when it fails.
        """
        R = geometry["R"]
        variables = {"data": data, "newton": newton, "skin": skin * R, "dt": repr(geometry["dt"]),
                     "L": repr(geometry["L"]), "warm": warm, "steps": steps, "dump": dump,
                     "pair": coefficients(p, R, False), "wall": coefficients(p, R, True)}
        words = [*wrap, *self.launcher(ranks), self.program, "-in", HERE / "in.packing",
                 "-log", "none"]
        for name, value in variables.items():
            words += ["-var", name, str(value)]
        env = {**os.environ, "OMP_NUM_THREADS": "1"}
        code, text = self.watch([str(w) for w in words], env)
        loops = re.findall(r"Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms",
                           text)
        if code or len(loops) != 2:
            raise RuntimeError("LAMMPS failed: " + text[-600:])
        seconds, procs, count, atoms = loops[1]
        if (int(procs), int(count), int(atoms)) != (ranks, steps, geometry["N"]):
            raise RuntimeError(f"LAMMPS ran {loops[1]}, asked for {ranks} ranks, {steps} steps, "
                               f"{geometry['N']} particles")
        builds = re.findall(r"Neighbor list builds = (\d+)", text)
        pairs = re.findall(r"Ave neighs/atom = (\S+)", text)
        return {"time": float(seconds) / steps / geometry["N"] * 1e9,
                "rebuilds": 1000 * float(builds[-1]) / steps, "pairs": float(pairs[-1])}

    def watch(self, words, env):
        """Runs words; exit status and output. `peak` becomes the most memory that the process had
        in the end [bytes]; 0 where the system has no /proc."""
        self.peak = 0
        with tempfile.TemporaryFile("w+") as out:
            child = subprocess.Popen(words, cwd=self.folder, env=env, stdout=out,
                                     stderr=subprocess.STDOUT)
            while child.poll() is None:
                self.peak = peak_of(child.pid) or self.peak
                time.sleep(0.02)
            out.seek(0)
            return child.returncode, out.read()


def peak_of(pid):
    """The most memory that a process had so far [bytes]; 0 if that is not to be found out."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return 0
    return next((1024 * int(line.split()[1]) for line in lines if line.startswith("VmHWM")), 0)

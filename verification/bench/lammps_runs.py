"""The same packing in LAMMPS: data file, one timed run. Coefficients: tinydem/lammps.py."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tinydem"))
import lammps  # noqa: E402  (after the path is set)
from frames import HEADER, columns  # noqa: E402

def clock(text):
    """Seconds since the start of the last run in LAMMPS' output, from its lines `step, CPU`."""
    table = re.split("Step +CPU", text)[-1].split("Loop time")[0]
    return [float(line.split()[1]) for line in table.splitlines() if line.strip()]


def write_data(state, path, rho):
    """The data file for a state (see machinery.read_state)."""
    L, H, rows = state["L"], state["H"], np.array(state["particles"], float)
    frame = np.empty(len(rows), [(name, float) for name in HEADER.split(",")])
    for k, name in enumerate(frame.dtype.names):
        frame[name] = rows[:, k]
    lammps.write_data(path, frame, np.zeros(len(rows)), 1, rho, columns(frame, "vx,vy,vz"),
                      columns(frame, "wx,wy,wz"), ((0, 0, -0.01 * L), (L, L, H)),
                      "a packing of the bench")


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
        """One run; {time [ns], blocks (see machinery.Bench.time), rebuilds [per 1000 steps], pairs
        per particle}.

        data: file of write_data; p: parameters; geometry: {L, R, dt, N} with the mean radius R [m];
        skin in units of R; dump=1: writes what was read to
        read.dump. Raises RuntimeError with the end of LAMMPS' output when it fails.
        """
        R, block = geometry["R"], (steps + 199) // 200  # as in bench.cpp
        variables = {"data": data, "newton": newton, "skin": skin * R, "dt": repr(geometry["dt"]),
                     "L": repr(geometry["L"]), "warm": warm, "steps": steps, "dump": dump,
                     "block": block,
                     "pair": lammps.contact_words(p, R, R), "wall": lammps.contact_words(p, R)}
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
        times = clock(text)
        if len(times) != 1 + -(-steps // block) or not times[-1] < 1.1 * float(seconds) + 0.01:
            raise RuntimeError(f"LAMMPS' clock does not fit to {steps} steps in {seconds} s: "
                               f"{len(times)} moments, the last after {times[-1:]} s")
        builds = re.findall(r"Neighbor list builds = (\d+)", text)
        pairs = re.findall(r"Ave neighs/atom = (\S+)", text)
        scale = 1e9 / steps / geometry["N"]
        return {"time": float(seconds) * scale,
                "blocks": [(b - a) * scale for a, b in zip(times, times[1:])],
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

"""Runs the programs of the bench: states, interleaved repetitions, medians and spreads."""
import os
import statistics
import subprocess
import sys
from pathlib import Path

import numpy as np

#: The material of every part unless it says otherwise (dt: Eq. 50 of the smallest radius).
MATERIAL = {"rho": 1e3, "E": 1e6, "nu": 0.3, "en": 0.5, "mus": 0.3, "mur": 0.3, "mut": 0.2}
SMOOTH = {"mus": 0, "mur": 0, "mut": 0}  # no friction
NOTE = "Times: undisturbed (median ± half the range); ratios are of the undisturbed ones."


def parse(text):
    """Lines `name,value,unit` as {name: value}; `blocks` are several, separated by blanks."""
    rows = (line.split(",") for line in text.splitlines())
    return {row[0]: list(map(float, row[1].split())) if row[0] == "blocks" else float(row[1])
            for row in rows}


def read_state(path):
    """A state as written by states.hpp: {L, H, Rmin, Rmax, steps, unrest, particles (N x 14)}."""
    with open(path, "rb") as f:
        if f.read(8) != b"TDBENCH1":
            sys.exit(f"{path}: is no state of the bench; remove it and start again")
        n = int(np.fromfile(f, np.int64, 1)[0])
        head = np.fromfile(f, float, 6)
        particles = np.fromfile(f, float, 14 * n).reshape(n, 14)
    names = ("L", "H", "Rmin", "Rmax", "steps", "unrest")
    return {**dict(zip(names, map(float, head))), "particles": particles}


class Bench:
    """The programs in `build`, states kept in build/states; wrap: words before timed commands."""

    def __init__(self, build, wrap=(), smoke=False, large=False):
        self.build, self.wrap, self.smoke, self.large = Path(build), list(wrap), smoke, large
        self.states = self.build / ("smoke" if smoke else "states")
        self.states.mkdir(parents=True, exist_ok=True)
        self.repeats = 1 if smoke else 5
        if not (self.build / "bench").exists():
            sys.exit(f"{self.build}/bench is missing; build it first: ./dem bench does")

    def call(self, *words, threads=1, program="bench", wrap=()):
        """Runs a program of the bench; what it printed as {name: value}."""
        env = {**os.environ, "OMP_NUM_THREADS": str(threads),
               "GOMP_SPINCOUNT": os.environ.get("GOMP_SPINCOUNT", "10000")}
        words = [str(w) for w in (*wrap, self.build / program, *words)]
        done = subprocess.run(words, env=env, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{' '.join(words)}\nexit code {done.returncode}: {done.stderr.strip()}")
        return parse(done.stdout)

    def knows(self, parameter):
        """Has the solver this parameter?"""
        return self.call("has", parameter)[parameter] == 1

    @staticmethod
    def words(settings):
        return [f"{name}={value}" for name, value in settings.items()]

    def state(self, kind, n, settings=None, most=20000, block=None):
        """The file of a settled state; made once. block: a settled state to stack."""
        path = self.states / f"{kind}_{n}.state"
        if not path.exists():
            part = path.with_suffix(".part")
            print(f"  settling {kind} of {n} particles ...", flush=True)
            all_settings = self.words({**MATERIAL, "steps": most, **(settings or {})})
            verb = ["stack", block] if block else ["settle", kind]
            self.call(*verb, n, part, *all_settings, threads=os.cpu_count() or 1)
            part.rename(path)
        return path

    def time(self, state, threads=1, program="bench", **settings):
        """One timed run of a state: {time [ns], blocks, contacts, pairs, rebuilds, horizon,
        unrest}; blocks: the parts of the time that are due to consecutive blocks of steps."""
        return self.call("time", state, *self.words({**MATERIAL, **settings}), threads=threads,
                         program=program, wrap=self.wrap)

    def interleave(self, jobs, repeats=None, gather=None):
        """jobs: {key: function that returns {name: value}}, all called in turn, several times over.

        Returns {key: what `gather` (by default summary) makes of its runs}; a single bad moment of
        the machine hits one repetition of each job and not all of one job.
        """
        runs = {key: [] for key in jobs}
        for _ in range(repeats or self.repeats):
            for key, job in jobs.items():
                runs[key].append(job())
        gather = gather or summary
        return {key: gather(all_runs) for key, all_runs in runs.items()}


def summary(runs):
    """Medians of all values; of the time also the range ("low", "high") and its "floor": every
    block of steps is the same work in all runs, so its lowest time is the least disturbed one, and
    these add up to the time of a run that nothing disturbed."""
    result = {name: statistics.median(r[name] for r in runs) for name in runs[0]
              if name != "blocks"}
    if "time" in result:
        times = [r["time"] for r in runs]
        floor = sum(map(min, zip(*(r["blocks"] for r in runs))))
        result.update(low=min(times), high=max(times), floor=min(floor, *times))
    return result


def highest(runs):
    """The highest of all values, for rates: what disturbs a run lowers them."""
    return {name: max(r[name] for r in runs) for name in runs[0]}


def spread(result):
    """Half of the range of the repetitions, as a share of the median."""
    return (result["high"] - result["low"]) / 2 / result["time"]


def cell(result):
    """The time of a summary in words: floor (median ± half the range)."""
    return f"{result['floor']:.0f} ({result['time']:.0f} ± {100 * spread(result):.0f} %)"

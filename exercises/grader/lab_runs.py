"""Makes the runs of a lab sheet: solver and measurement, a row per run. Standard library only; the
measurement needs a Python that can draw (numpy, scipy, matplotlib)."""
import csv
import re
import subprocess
import sys
from pathlib import Path

from .course import Mistake


def seed_list(text):
    """The seeds that a text like 101-104 or 3,8,12 names."""
    found = re.match(r"^(\d+)-(\d+)$", text)
    seeds = list(range(int(found.group(1)), int(found.group(2)) + 1)) if found else [
        int(word) for word in text.split(",") if word.isdigit()]
    if not seeds or len(seeds) > 100 or (not found and len(seeds) < len(text.split(","))):
        raise Mistake(f"--seeds {text}: name up to 100 of them, like 101-104 or 7,9,12")
    return seeds


def one_run(lab, value, seed, program, folder, extra=()):
    """Runs the scene into `folder` and measures; the row as texts."""
    scenes, folder = lab.folder.parents[2] / "tinydem" / "scenes", Path(folder)
    scene, options = lab.sheet.run(value, seed)
    particles = ""
    if hasattr(lab.sheet, "start"):  # a scene without spawning: the seed makes its start
        particles = folder.with_suffix(".csv")
        folder.parent.mkdir(parents=True, exist_ok=True)
        particles.write_text(lab.sheet.start(seed, (scenes / scene).parent))
    solve = [str(program), "", str(particles), str(folder), "--scene", str(scenes / scene),
             "--quiet", "--overwrite", *options, *extra]
    done = subprocess.run(solve, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise Mistake(f"the run failed: {done.stderr.strip()}")
    measure = [sys.executable, str((scenes / scene).parent / "measure.py"), str(folder)]
    done = subprocess.run(measure, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise Mistake(f"the measurement failed: {done.stdout.strip()}")
    with open(folder / "result.csv", newline="") as file:
        result = {row["quantity"]: (float(row["value"]), row["unit"])
                  for row in csv.DictReader(file)}
    return [f"{x:.7g}" for x in (value, seed, *lab.sheet.read(result))]


def make_runs(lab, seeds, program, output, values=None):
    """All runs of the sheet (or with these values of its parameter): yields a row of texts each."""
    for value in values or lab.sheet.VALUES:
        for seed in seeds:
            folder = Path(output) / lab.slug / f"{lab.sheet.VARY}-{value:g}-seed-{seed}"
            yield one_run(lab, value, seed, program, folder)


def instructor_table(lab, program, output):
    """Writes runs.csv."""
    lines = [",".join(lab.columns)]
    for row in make_runs(lab, lab.sheet.INSTRUCTOR, program, output):
        lines.append(",".join(row))
        print(" ".join(row), flush=True)
    (lab.folder / "runs.csv").write_text("\n".join(lines) + "\n")

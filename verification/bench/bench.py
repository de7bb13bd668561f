"""The bench: measures what a step costs, writes tables, CSV files, figures and one page.

    ./dem bench                       all parts (10 minutes on two cores; LAMMPS when installed)
    ./dem bench --large               also 10^6, 3 10^6 and 9 10^6 particles; settling takes hours
    ./dem bench --only NAME ...       only these parts; the page keeps the others' last results
    bench.py --markdown               print the tables of the last results as Markdown
    bench.py --docs                   the same into docs/performance.md, between its two marks
    bench.py --smoke                  tiny sizes; checks inputs and that all numbers are finite

Runs of the same comparison are interleaved; medians are taken, and what undisturbed runs would take
(machinery.summary). No number is judged: a bench that
fails on a slow machine says nothing about the program. Programs: bench.cpp, machine.cpp, count.cpp.
"""
import argparse
import html
import importlib
import json
import math
import os
import platform
import shlex
import subprocess
import sys
import time
from datetime import date
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
from lammps_runs import Lammps  # noqa: E402  (after the path is set)
from machinery import Bench, read_state  # noqa: E402
import report  # noqa: E402

REPORT = HERE.parent / "report"
DOCS = HERE.parents[1] / "docs" / "performance.md"
FORM = 2  # of kept results; those of another form are left out of the page
PARTS = ("scaling", "memory", "features", "sizes", "meshes", "horizon", "roofline",
         "accuracy")


def part(name):
    return importlib.import_module(f"parts.{name}")


# ---------------------------------------------------------------------------------------- output

def write_csv(rows, path):
    """A list of dictionaries as CSV; columns in order of appearance, empty where missing."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    lines = [",".join(names)]
    lines += [",".join(str(row.get(name, "")) for name in names) for row in rows]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")


def markdown(table):
    """A table as Markdown."""
    lines = [f"**{table['title']}**", "", "| " + " | ".join(table["head"]) + " |",
             "|" + "---|" * len(table["head"])]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in table["rows"]]
    return "\n".join(lines + (["", table["note"]] if table.get("note") else []))


def chapters(results):
    """All kept tables as Markdown."""
    parts = []
    for name, result in results.items():
        tables = "\n\n".join(markdown(t) for t in part(name).tables(result["data"]))
        parts.append(f"### {part(name).TITLE}\n\n{tables}\n\nMeasured {result['date']}: "
                     f"{result['machine']}\n")
    return "\n".join(parts)


def update_docs(text):
    """Puts text between the marks of docs/performance.md."""
    marks, old = ("<!-- tables -->\n", "<!-- end of tables -->"), DOCS.read_text()
    if any(old.count(mark) != 1 for mark in marks):
        sys.exit(f"{DOCS}: must hold {marks[0].strip()} and {marks[1]}, once each")
    before, rest = old.split(marks[0])
    DOCS.write_text(before + marks[0] + "\n" + text + "\n" + marks[1] + rest.split(marks[1])[1])


def as_html(table):
    rows = [[html.escape(str(c)) for c in row] for row in table["rows"]]
    classes = [""] + ["n"] * (len(table["head"]) - 1)
    note = f"<p><small>{report.light(table['note'])[3:-4]}</small></p>" if table.get("note") else ""
    return f"<h3>{html.escape(table['title'])}</h3>" + report.table(
        [html.escape(h) for h in table["head"]], rows, classes) + note


def machine(bench):
    """Words on the machine and the flags."""
    cpu = platform.processor() or platform.machine()
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        cpu = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    flags = subprocess.run([bench.build / "bench", "flags"], capture_output=True,
                           text=True).stdout.split(",")[1]
    return f"{cpu}, {os.cpu_count()} cores, {platform.system()}. Compiled with {flags}."


def page(results, words):
    body = []
    for name, result in results.items():
        module = part(name)
        figures = "".join(report.image(REPORT / f"{figure}.svg", caption)
                          for figure, caption in module.draw(result["data"], REPORT))
        body.append(f"<h2 id='{name}'>{html.escape(module.TITLE)}</h2>"
                        f"{report.light(module.TEXT)}"
                        + "".join(as_html(t) for t in module.tables(result["data"])) + figures +
                        f"<p><small>Measured {result['date']} in {result['seconds']:.0f} s. "
                        f"{html.escape(result['machine'])}</small></p>")
    links = "".join(f"<li><a href='#{name}'>{html.escape(part(name).TITLE)}</a></li>"
                    for name in results)
    return f"""<!DOCTYPE html>
<html lang='en'><head><meta charset='utf-8'><title>TinyDEM: bench</title>
<meta name='viewport' content='width=device-width'><style>{report.CSS}</style></head><body>
<h1>TinyDEM: bench</h1>
<p class='lead'>What a step costs, and why. Runs of a comparison take turns. Undisturbed: every
block of steps, the same work in each repetition, at its lowest time, added up. Times belong to the
machine that is named below each chapter; ratios travel better.</p>
<p><small>{html.escape(words)} <a href='index.html'>Verification</a></small></p>
<nav><ol>{links}</ol></nav>
{"".join(body)}
</body></html>
"""


# ------------------------------------------------------------------------------------- running

def finite(value, where=""):
    """Yields what is no finite number in nested results; times, rates and counts must be > 0."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from finite(inner, f"{where}.{key}")
    elif isinstance(value, list):
        for k, inner in enumerate(value):
            yield from finite(inner, f"{where}[{k}]")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        name = where.rsplit(".", 1)[-1]
        if not math.isfinite(value) or value < 0 or (value == 0 and name.endswith("time")):
            yield f"{where} = {value}"


def same_particles(bench, lmp):
    """The largest difference between the state and what LAMMPS read (radii, positions, velocities);
    without LAMMPS, its data file is read."""
    import numpy as np
    from machinery import MATERIAL
    from parts.scaling import prepare
    path = bench.state("poly", 200)
    box, data = prepare(bench, path)
    ours = read_state(path)["particles"][:, [0, 1, 2, 3, 4, 5, 6, 11, 12, 13]]
    if lmp.here:
        lmp.run(data, MATERIAL, box, steps=1, warm=1, dump=1)
        theirs = np.loadtxt(bench.states / "read.dump", skiprows=9)[:, 1:]
    else:
        lines = data.read_text().split("\n")
        atoms, speeds = lines.index("Atoms") + 2, lines.index("Velocities") + 2
        n = len(ours)
        a = np.array([list(map(float, r.split())) for r in lines[atoms:atoms + n]])
        v = np.array([list(map(float, r.split())) for r in lines[speeds:speeds + n]])
        theirs = np.hstack([a[:, 4:7], a[:, 2:3] / 2, v[:, 1:]])
    if theirs.shape != ours.shape:
        return math.inf
    return float(abs(theirs - ours).max())


def smoke(bench, lmp, names):
    """Every part in tiny form; stops at what is not finite. Nothing is judged by its speed."""
    problems = []
    for name in names:
        data = part(name).measure(bench, lmp)
        part(name).tables(data)
        part(name).draw(data, bench.states)
        problems += [f"{name}{p}" for p in finite(data)]
    off = same_particles(bench, lmp)
    who = "LAMMPS read" if lmp.here else "the data file for LAMMPS holds"
    print(f"largest difference between the state and what {who}: {off:.1e}")
    if not off < 1e-15:
        problems.append(f"the two codes get different particles, by {off:g}")
    sys.exit("\n".join(problems) if problems else 0)


def run(bench, lmp, names):
    """Measures parts, keeps their results, writes CSV files."""
    for name in names:
        print(f"{name} ...", flush=True)
        start = time.monotonic()
        data = part(name).measure(bench, lmp)
        seconds = time.monotonic() - start
        result = {"form": FORM, "data": data, "seconds": seconds, "date": date.today().isoformat(),
                  "machine": machine(bench)}
        (bench.build / "results").mkdir(exist_ok=True)
        (bench.build / "results" / f"{name}.json").write_text(json.dumps(result, indent=1))
        write_csv(data["rows"], REPORT / "data" / "bench" / f"{name}.csv")
        for table in part(name).tables(data):
            print(markdown(table) + "\n")
        print(f"{name}: {seconds:.0f} s", flush=True)


def kept(bench):
    """The last results of all parts that have some of this form."""
    paths = {name: bench.build / "results" / f"{name}.json" for name in PARTS}
    results = {name: json.loads(path.read_text()) for name, path in paths.items() if path.exists()}
    return {name: r for name, r in results.items() if r.get("form") == FORM}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--only", nargs="+", choices=PARTS, metavar="NAME",
                        help="only these parts: " + " ".join(PARTS))
    parser.add_argument("--lammps", action="store_true",
                        help="LAMMPS must be there (./dem bench --lammps installs it)")
    parser.add_argument("--large", action="store_true",
                        help="also 10^6, 3 10^6, 9 10^6 particles; settling takes hours")
    parser.add_argument("--smoke", action="store_true", help="tiny sizes, no report")
    parser.add_argument("--markdown", action="store_true", help="print the kept tables and stop")
    parser.add_argument("--docs", action="store_true",
                        help="write the kept tables into docs/performance.md and stop")
    parser.add_argument("--repeats", type=int, help="runs of each kind (default 5)")
    parser.add_argument("--wrap", default="", metavar="COMMAND",
                        help="put before every timed command, e.g. 'taskset -c 0,1'")
    parser.add_argument("--build", type=Path,
                        default=HERE.parents[1] / "build/default/verification/bench",
                        help="where the programs are")
    args = parser.parse_args()
    bench = Bench(args.build.resolve(), shlex.split(args.wrap), args.smoke, args.large)
    bench.repeats = args.repeats or bench.repeats
    lmp = Lammps(bench.states)
    if args.markdown or args.docs:
        text = chapters(kept(bench))
        print(text) if args.markdown else update_docs(text)
        return
    names = args.only or PARTS
    if args.lammps and not lmp.here:
        parser.error("--lammps: lmp is not on the PATH; install LAMMPS or leave the option out")
    if args.smoke:
        smoke(bench, lmp, names)
    if not lmp.here:
        print("LAMMPS (lmp) is not installed: going on without; ./dem bench --lammps installs it")
    run(bench, lmp, names)
    REPORT.mkdir(exist_ok=True)
    (REPORT / "bench.html").write_text(page(kept(bench), machine(bench)))
    print(f"the page is {os.path.relpath(REPORT / 'bench.html')}")


if __name__ == "__main__":
    main()

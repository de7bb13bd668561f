#!/usr/bin/env python3
"""Runs the verification cases, judges them, draws them, and writes report/index.html.

    verify.py                        every case in full, and the report (./dem verify builds first)
    verify.py 02 oblique             only these (number, id or part of an id)
    verify.py --quick 02_restitution the reduced form that the tests run; no report
    verify.py --mutants [all|fast]   break the solver on purpose: which case notices?
    verify.py --lammps               the comparison with LAMMPS (./dem verify --lammps installs it)
    verify.py --check                only the tables: complete, tolerances not too loose
    verify.py --update               write what was measured into the tables (never a tolerance)

A case is cases/NN_name.{toml,cpp,py}: what it claims, the program that measures, the figure. The
program writes CSV files; it does not judge. A metric fails above its tolerance, and also when the
tolerance is more than ten times what is measured: then the table must be updated.
"""
import argparse
import concurrent.futures
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
REPORT = HERE / "report"
SOLVER = HERE.parent / "tinydem"
ROUNDING = 1e-13  # below this, a tolerance may be as loose as its reason says
LOOSE = 10        # otherwise a tolerance is at most so many times what is measured
CASE_KEYS = {"id": str, "title": str, "shows": str, "equations": list, "features": list,
             "reference": str, "program": str, "figures": list, "text": str, "metric": list}
METRIC_KEYS = {"name": str, "meaning": str, "tolerance": (int, float), "reason": str,
               "measured": (int, float)}
SKIPPED = 77  # exit code: not possible here
KINDS = ("below", "above", "equal")


# ---------------------------------------------------------------------------------- tables

def load_cases():
    """All cases in order; every mistake in a table is reported at once."""
    cases, problems = [], []
    for path in sorted((HERE / "cases").glob("*.toml")):
        try:
            entries = tomllib.loads(path.read_text())["case"]
        except (tomllib.TOMLDecodeError, KeyError) as error:
            problems.append(f"{path.name}: {error}")
            continue
        for case in entries if isinstance(entries, list) else [entries]:
            problems += [f"{path.name}: {p}" for p in mistakes(case, path)]
            cases.append({**case, "path": path})
    ids = [case.get("id") for case in cases]
    problems += [f"{i}: two cases have this id" for i in sorted(set(ids)) if ids.count(i) > 1]
    if problems:
        sys.exit("the tables of cases are wrong:\n  " + "\n  ".join(problems))
    return cases


def mistakes(case, path):
    for key, kind in CASE_KEYS.items():
        if not isinstance(case.get(key), kind):
            yield f"{key} is missing or no {kind.__name__}"
    if case.get("id") != path.stem:
        yield f"id is {case.get('id')}, the file {path.stem}"
    for suffix in (".cpp", ".py"):
        if not path.with_name(f"{case.get('program')}{suffix}").exists():
            yield f"{case.get('program')}{suffix} is missing"
    if not case.get("metric"):
        yield "there is no metric: a case that cannot fail"
    for metric in case.get("metric", []):
        for key, kind in METRIC_KEYS.items():
            if not isinstance(metric.get(key), kind):
                yield f"metric {metric.get('name')}: {key} is missing or of the wrong kind"
        if metric.get("kind", "below") not in KINDS:
            yield f"metric {metric.get('name')}: kind must be one of {KINDS}"


def judge(metric, value, guard=True):
    """pass, fail, or loose: the tolerance is more than LOOSE times what is measured."""
    kind, tolerance = metric.get("kind", "below"), metric["tolerance"]
    if value is None or value != value:
        return "fail"
    if kind == "equal":
        return "pass" if value == tolerance else "fail"
    if kind == "above":
        return "fail" if value < tolerance else \
            "loose" if guard and value > LOOSE * tolerance else "pass"
    if value > tolerance:
        return "fail"
    loose = guard and value >= ROUNDING and tolerance > LOOSE * value
    return "loose" if loose else "pass"


def check_tables(cases):
    """The written measured values against the tolerances; True when all is well."""
    good = True
    for case in cases:
        for metric in case["metric"]:
            verdict = judge(metric, metric["measured"])
            if verdict != "pass":
                good = False
                print(f"{case['id']}: {metric['name']}: measured {metric['measured']:g}, "
                      f"tolerance {metric['tolerance']:g}: {verdict}")
    features = {word for case in cases for word in case["features"]}
    print(f"{len(cases)} cases, {sum(len(c['metric']) for c in cases)} metrics, "
          f"{len(features)} features")
    return good


def selected(cases, words):
    if not words:
        return cases
    chosen = []
    for word in words:
        number = word.zfill(2) + "_" if word.isdigit() else None
        found = [c for c in cases if c["id"] == word] or \
                [c for c in cases if c["id"].startswith(number or "\0")] or \
                [c for c in cases if not number and word in c["id"]]
        if not found:
            sys.exit(f"there is no case '{word}'; there are " + " ".join(c["id"] for c in cases))
        chosen += [c for c in found if c not in chosen]
    return chosen


def able(cases, args):
    """The cases that can run here; --lammps: only those that need LAMMPS, and no excuses. Mutants
    are of the solver, or with --lammps of the tools."""
    needy = [c for c in cases if c.get("needs")]
    absent = sorted({c["needs"] for c in needy if not shutil.which(c["needs"])})
    if args.lammps:
        if absent or not needy:
            sys.exit(f"{', '.join(absent)} is not on the PATH; ./dem verify --lammps installs it")
        return needy
    if args.mutants and len(needy) < len(cases):
        return [c for c in cases if not c.get("needs")]
    if args.quick:
        absent = [c["needs"] for c in needy]  # no quick form: it would take minutes
    for c in needy:
        if c["needs"] in absent:
            print(f"skip {c['id']:<24} needs {c['needs']} and minutes: ./dem verify --lammps")
    cases = [c for c in cases if c.get("needs") not in absent]
    if not cases:
        sys.exit(SKIPPED)
    return cases


# ------------------------------------------------------------------------------------- run

def environment(library=None, threads=1):
    env = {**os.environ, "OMP_NUM_THREADS": str(threads), "GOMP_SPINCOUNT": "10000"}
    if library:
        for name in ("LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH"):
            env[name] = f"{library}:{env.get(name, '')}"
    return env


def run_program(program, out, quick, env, timeout):
    """Runs one program; what went wrong, or an empty word."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    try:
        done = subprocess.run([program, out] + ["quick"] * quick, env=env, timeout=timeout,
                              capture_output=True, text=True)
    except subprocess.TimeoutExpired:
        return f"took more than {timeout:.0f} s"
    except OSError as error:
        return f"{error}; build it first: ./dem verify does"
    (out / "output.txt").write_text(done.stdout + done.stderr)
    return f"exit code {done.returncode}: {done.stderr.strip()[-300:]}" if done.returncode else ""


def script_of(case):
    """cases/NN_name.py as a module."""
    spec = importlib.util.spec_from_file_location(case["program"],
                                                  HERE / "cases" / f"{case['program']}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def run_case(case, build, out, quick, env, timeout=300, tools=SOLVER):
    """Measures a case: {metrics, seconds, error}. tools: where the Python tools are."""
    start = time.monotonic()
    error = run_program(build / case["program"], out, quick, env, timeout)
    if case.get("precisions") and not error and not quick:  # only the figure needs these
        for real in ("float", "long_double"):
            program = build / f"{case['program']}_{real}"
            error = error or run_program(program, out / real, quick, env, timeout)
    if case.get("needs") and not error:  # other programs: the script measures with them
        try:
            script_of(case).measure(out, build, tools, quick)
        except (RuntimeError, OSError, subprocess.TimeoutExpired, SystemExit) as failure:
            error = str(failure)
    metrics = {}
    path = out / "metrics.csv"
    if not error and not path.exists():
        error = "wrote no metrics.csv"
    if not error:
        for line in path.read_text().splitlines()[1:]:
            name, value = line.rsplit(",", 1)
            metrics[name] = float(value)
    return {"metrics": metrics, "seconds": time.monotonic() - start, "error": error}


def verdicts(case, result, guard):
    """A verdict per metric; what comes out of a chaotic run may be better by chance."""
    return {m["name"]: judge(m, result["metrics"].get(m["name"]),
                             guard and not m.get("chaotic", False)) for m in case["metric"]}


def tell(case, result, guard):
    """Prints a line per case, and a line per metric that does not pass; True if all pass."""
    states = verdicts(case, result, guard)
    bad = [m for m in case["metric"] if states[m["name"]] != "pass"]
    good = not bad and not result["error"]
    print(f"{'ok  ' if good else 'FAIL'} {case['id']:<24} {len(case['metric']):>2} metrics "
          f"{result['seconds']:6.1f} s", flush=True)
    if result["error"]:
        print(f"     {result['error']}")
        return False
    for m in bad:
        value = result["metrics"].get(m["name"], float("nan"))
        hint = {"loose": ": better than the table says; update its tolerance"}
        print(f"     {m['name']}: {value:.6g}, tolerance {m['tolerance']:g} "
              f"({m.get('kind', 'below')}){hint.get(states[m['name']], '')}")
    return good


def in_parallel(jobs, work):
    """work(job) for all jobs, as many at a time as there are cores; results in order."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return list(pool.map(work, jobs))


def draw(case, data):
    """Runs cases/NN_name.py; returns the figures (SVG) that the table names."""
    script_of(case).draw(data, REPORT)
    missing = [f for f in case["figures"] if not (REPORT / f"{Path(f).stem}.svg").exists()]
    if missing:
        raise RuntimeError(f"{case['id']}: the script did not draw {missing}")


def update_table(case, result):
    """Writes measured values into the case's file, next to their names."""
    text = case["path"].read_text()
    for name, value in result["metrics"].items():
        rest_of_metric = r"(?:(?!\[\[case\.metric\]\]).)*?"
        pattern = rf'(name\s*=\s*"{re.escape(name)}"{rest_of_metric}measured\s*=\s*)\S+'
        text = re.sub(pattern, lambda m: f"{m[1]}{value:.3g}", text, flags=re.S)
    case["path"].write_text(text)


# --------------------------------------------------------------------------------- mutants

def load_mutants():
    mutants = []
    for path in sorted(HERE.glob("mutants*.toml")):
        mutants += tomllib.loads(path.read_text()).get("mutant", [])
    ids = [m["id"] for m in mutants]
    if len(set(ids)) != len(ids):
        sys.exit(f"two mutants have one id: {sorted(i for i in set(ids) if ids.count(i) > 1)}")
    return mutants


def check_mutants(cases):
    """Do their texts stand in the solver, once, and are the cases there? True when all is well."""
    known, good = {c["id"] for c in cases}, True
    for m in load_mutants():
        found = (SOLVER / m["file"]).read_text().count(m["old"])
        strange = sorted(set(m["killed_by"]) - known)
        if found != 1 or strange or not m["killed_by"]:
            good = False
            print(f"mutant {m['id']}: text found {found} times in {m['file']}, must be once; "
                  f"killed_by: {strange or m['killed_by']}" + " is unknown" * bool(strange))
    return good


def build_mutant(mutant, build):
    """Compiles the library with one statement replaced; returns its folder."""
    folder = build / "mutants" / mutant["id"]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in ("tinydem.cpp", "tinydem.hpp"):
        text = (SOLVER / name).read_text()
        if mutant.get("file") == name:
            if text.count(mutant["old"]) != 1:
                raise RuntimeError(f"mutant {mutant['id']}: this must stand once in {name}, not "
                                   f"{text.count(mutant['old'])} times: {mutant['old']}")
            text = text.replace(mutant["old"], mutant["new"])
        # One instruction set is enough here, and compiles in half the time.
        (folder / name).write_text(text.replace("#if defined(__x86_64__) && ", "#if 0 && "))
    for name in ("one_contact.cpp", "one_contact.hpp"):
        shutil.copy(HERE / name, folder)
    compiler, *flags = (build / "compile.txt").read_text().split("\n")
    command = [compiler, *filter(None, flags), "-Wl,-Bsymbolic", f"-I{folder}",
               folder / "one_contact.cpp", "-o", folder / "libverification_solver.so"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"mutant {mutant['id']} does not compile:\n{done.stderr[-2000:]}")
    return folder


def build_tool(mutant, build):
    """The Python tools with one text replaced; returns their folder."""
    folder = build / "mutants" / mutant["id"]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for path in SOLVER.glob("*.py"):
        text = path.read_text()
        (folder / path.name).write_text(text.replace(mutant["old"], mutant["new"])
                                        if path.name == mutant.get("file") else text)
    return folder


def try_mutant(mutant, cases, build):
    """Which cases fail with this mutant, and by which metric: {case: reason or empty}."""
    tools = mutant.get("file", "").endswith(".py") or any(c.get("needs") for c in cases)
    folder = build_tool(mutant, build) if tools else build_mutant(mutant, build)
    kills = {}
    for case in cases:
        result = run_case(case, build, folder / case["id"], True,
                          environment(None if tools else folder), 90, folder if tools else SOLVER)
        bad = [n for n, state in verdicts(case, result, False).items() if state != "pass"
               and not (tools and n not in result["metrics"])]  # its quick form has not all
        kills[case["id"]] = result["error"] or ", ".join(bad)
    print(f"{mutant['id']:<28} " + (" ".join(c[:2] for c in kills if kills[c]) or "-"), flush=True)
    return {"id": mutant["id"], "what": mutant.get("what", ""), "kills": kills,
            "expected": mutant.get("killed_by", [])}


def run_mutants(cases, build, fast):
    """The kill matrix; True when the control is clean, every mutant dies as expected, and (all
    mutants, all cases) every case kills one."""
    other = [c for c in cases if c.get("needs")]  # they check the tools: mutants of those
    cases = other or cases
    mutants = [m for m in load_mutants() if m["file"].endswith(".py") == bool(other)]
    if fast:
        mutants = [m for m in mutants if m.get("fast")]
        wanted = {m["killed_by"][0] for m in mutants}
        cases = [c for c in cases if c["id"] in wanted]
    control = {"id": "none", "what": "the solver as it is", "killed_by": []}
    rows = in_parallel([control] + mutants, lambda m: try_mutant(m, cases, build))
    problems = [f"the solver as it is fails {c}: {why}"
                for c, why in rows[0]["kills"].items() if why]
    for row in rows[1:]:
        if not any(row["kills"].values()):
            problems.append(f"mutant {row['id']} survives")
        problems += [f"mutant {row['id']} is not noticed by {c}" for c in row["expected"]
                     if row["kills"].get(c) == ""]
    if not fast:
        idle = [c["id"] for c in cases if not any(r["kills"][c["id"]] for r in rows[1:])]
        problems += [f"case {c} kills no mutant" for c in idle]
        REPORT.mkdir(exist_ok=True)
        path, mine = REPORT / "kills.json", {row["id"] for row in rows}
        kept = [k for k in json.loads(path.read_text()) if k["id"] not in mine] \
            if path.exists() and other else []
        path.write_text(json.dumps(kept + rows[1:], indent=1))
    print("\n".join(problems) or f"{len(rows) - 1} mutants, all killed")
    return not problems


# ------------------------------------------------------------------------------------ main

def run_cases(cases, args):
    quick, build = args.quick, args.build
    data = (build / "quick") if quick else (REPORT / "data")

    def work(case):
        result = run_case(case, build, data / case["id"], quick, environment())
        return result, tell(case, result, not quick)
    outcome = in_parallel(cases, work)
    results = {case["id"]: result for case, (result, _) in zip(cases, outcome)}
    good = all(fine for _, fine in outcome)
    for case in cases:
        if not quick and not results[case["id"]]["error"]:
            draw(case, data / case["id"])
            (data / case["id"] / "result.json").write_text(json.dumps(results[case["id"]]))
            if args.update:
                update_table(case, results[case["id"]])
    return good


def write_report(cases):
    """From what lies in report/data, so that cases can be run one by one."""
    import report
    results = {}
    for case in cases:
        path = REPORT / "data" / case["id"] / "result.json"
        if path.exists():
            results[case["id"]] = json.loads(path.read_text())
    path = REPORT / "kills.json"
    kills = json.loads(path.read_text()) if path.exists() else []
    states = {c["id"]: verdicts(c, results[c["id"]], True) for c in cases if c["id"] in results}
    page = report.page([c for c in cases if c["id"] in results], results, states, kills, REPORT)
    (REPORT / "index.html").write_text(page)
    print(f"the report is {os.path.relpath(REPORT / 'index.html')}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("cases", nargs="*", metavar="CASE", help="number, id or part of an id")
    parser.add_argument("--quick", action="store_true", help="reduced form, no report")
    parser.add_argument("--mutants", nargs="?", const="all", choices=("all", "fast"))
    parser.add_argument("--lammps", action="store_true",
                        help="the cases that need LAMMPS (mutants: of the hand-off)")
    parser.add_argument("--check", action="store_true", help="only check the tables")
    parser.add_argument("--update", action="store_true", help="write measured values to the tables")
    parser.add_argument("--build", type=Path, default=HERE.parent / "build/default/verification",
                        help="where the programs are")
    args = parser.parse_args()
    args.build = args.build.resolve()
    every = load_cases()
    if args.check:
        good = [check_tables(every), check_mutants(every)]
        sys.exit(not all(good))
    start, cases = time.monotonic(), able(selected(every, args.cases), args)
    REPORT.mkdir(exist_ok=True)
    good = run_mutants(cases, args.build, args.mutants == "fast") if args.mutants else \
        run_cases(cases, args)
    if not args.quick and args.mutants != "fast":
        write_report(every)
    verdict = "all well" if good else "FAILED"
    print(f"{len(cases)} cases in {time.monotonic() - start:.0f} s: {verdict}")
    sys.exit(not good)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""The exercises: grade an answer, show the progress, make a hand-out, grade a class.

    ./dem grade [NN ...] [--watch]      build and grade your answers (all, or those named)
    ./dem lab [NAME]                    make the runs of a lab sheet
    ./dem progress                      the table of points
    ./dem handout DIR                   the tree for students: no solutions, no mutants
    ./dem gradebook SUBMISSIONS_DIR     grade a class

`python3 exercises/grade.py VERB --help` lists the options. Exit code 0: all that was graded has
full points (or the verb was done), 1: points are missing, 2: the command line is wrong.
"""
import argparse
import json
import os
import sys
import textwrap
import time
from pathlib import Path

TOP = Path(__file__).resolve().parent
sys.path.insert(0, str(TOP))
sys.dont_write_bytecode = True

from grader import course, labs, program  # noqa: E402  (after the path is known)

BUILD = TOP.parent / "build" / "exercises"
PROGRESS = TOP / "progress.json"
FULL = sum(course.CATEGORIES.values())


# ---------------------------------------------------------------------------------- what is meant

def find_all():
    """All exercises, then all lab sheets."""
    return course.find_exercises(TOP) + labs.find_labs(TOP)


def choose(names):
    """The exercises with these numbers (or folder names), all if there are none; lab sheets too."""
    every = find_all()
    known = {key: e for e in every for key in (e.number, e.slug)}
    for name in names:
        if name.rstrip("/").split("/")[-1] not in known and name.zfill(2) not in known:
            raise course.Mistake(f"there is no exercise '{name}'; there are "
                          f"{', '.join(e.number for e in every)}")
    return [known.get(n.rstrip("/").split("/")[-1]) or known[n.zfill(2)] for n in names] or every


def compiler_for(options):
    """The C++ compiler, or course.Mistake."""
    found = program.find_compiler(options.compiler)
    if not found:
        raise course.Mistake(f"there is no compiler '{options.compiler or 'c++'}'; install one "
                      "(apt-get install g++) or name it: --compiler clang++")
    return found


def check_names(exercises, only):
    """course.Mistake if --check names a check that none of the exercises has."""
    known = [c.name for e in exercises for c in e.checks]
    for name in only or []:
        if name not in known:
            raise course.Mistake(f"there is no check '{name}'; there are {', '.join(known)}")


# ---------------------------------------------------------------------------------- showing

def show(sheet, partial):
    """Prints a score sheet."""
    e = sheet.exercise
    total = "" if partial else f"{sheet.points:g}/{FULL}"
    print(f"\n{e.number} {e.title:<50}{total:>10}")
    for line in sheet.lines:
        mark = "ok " if line.full else "-- "
        eq = f"   {line.check.eq}" if line.check else ""
        print(f"  {mark}{line.name:<22}{line.points:>5g}/{line.maximum:<3g}{eq}")
        for text in course.feedback(line, sheet):
            print(textwrap.fill(text, 100, initial_indent=" " * 7, subsequent_indent=" " * 9))
    for text in (note for line in sheet.lines for note in line.notes):
        print(textwrap.fill(text, 100, initial_indent="  ", subsequent_indent="    "))
    if sheet.said and sheet.lines[0].points:
        print("  the compiler warns:")
        for text in sheet.said.splitlines()[:8]:
            print(f"       {text}")


def remember(sheet):
    """Keeps the last and the best points of every exercise for `progress`."""
    table = json.loads(PROGRESS.read_text()) if PROGRESS.exists() else {}
    best = max(sheet.points, table.get(sheet.exercise.slug, {}).get("best", 0))
    table[sheet.exercise.slug] = {"last": sheet.points, "best": best}
    fresh = PROGRESS.with_suffix(".new")
    fresh.write_text(json.dumps(table, indent=1) + "\n")
    os.replace(fresh, PROGRESS)


# ---------------------------------------------------------------------------------- verbs

def grade_once(exercises, options, compiler):
    """Grades, shows and remembers; True if nothing is missing."""
    sheets = []
    for exercise in exercises:
        answer = Path(options.file) if options.file else exercise.answer()
        sheet = course.grade(exercise, answer, BUILD, compiler, [options.seed], options.check,
                             options.threads, options.jobs)
        sheets.append(sheet)
        if not options.json:
            show(sheet, options.check)
        if not (options.check or options.file):
            remember(sheet)
    if options.json:
        print(json.dumps([s.as_dict() for s in sheets], indent=1))
    return all(x.full for s in sheets for x in s.lines)


def watch(exercises, options, compiler):
    """Grades an exercise again whenever its answer was saved, until Ctrl-C."""
    seen = {}
    while True:
        for exercise in exercises:
            answer = Path(options.file) if options.file else exercise.answer()
            files = answer.glob("*.?pp") if answer.is_dir() else [answer]
            saved = sum(f.stat().st_mtime_ns for f in files if f.exists())
            if saved != seen.get(exercise.slug):
                seen[exercise.slug] = saved
                if saved:
                    grade_once([exercise], options, compiler)
                    print("\nwatching; Ctrl-C ends", flush=True)
        time.sleep(0.3)


def do_grade(options):
    exercises = choose(options.exercise)
    if options.self_test:
        from grader import selftest
        return selftest.run(exercises, BUILD, options)
    check_names(exercises, options.check)
    if options.file and (len(exercises) > 1 or not exercises[0].accepts(Path(options.file))):
        raise course.Mistake(f"--file {options.file} must be a file (13, 14: a folder with the two "
                             "files), and goes with one exercise")
    compiler = compiler_for(options)
    if options.watch:
        try:
            watch(exercises, options, compiler)
        except KeyboardInterrupt:
            return 0
    return 0 if grade_once(exercises, options, compiler) else 1


def do_lab(options):
    from grader import lab_runs
    every = {lab.folder.name: lab for lab in labs.find_labs(TOP)}
    lab = every.get(options.name.replace("lab-", "", 1).rstrip("/").split("/")[-1])
    if not lab:
        raise course.Mistake(f"there is no lab sheet '{options.name}'; there are "
                             f"{', '.join(every)}")
    if options.instructor:
        lab_runs.instructor_table(lab, options.program, options.output)
        return 0
    labs.need_prediction(lab)
    values = options.at or lab.sheet.VALUES
    if not set(values) <= set(lab.sheet.VALUES):
        raise course.Mistake(f"--at must be of {', '.join(f'{v:g}' for v in lab.sheet.VALUES)}")
    print(f"# {lab.sheet.ROW}      for [runs] of {lab.answer()}", flush=True)
    for row in lab_runs.make_runs(lab, lab_runs.seed_list(options.seeds), options.program,
                                  options.output, values):
        print(" ".join(row), flush=True)
    print(f"# pictures: {options.output}/{lab.slug}/*/result.png")
    return 0


def do_progress(_):
    table = json.loads(PROGRESS.read_text()) if PROGRESS.exists() else {}
    total = 0
    every = find_all()
    wide = max(len(e.number) for e in every)
    print(f"{'':{wide}} {'exercise':<44}{'level':<6}{'last':>6}{'best':>6}")
    for e in every:
        entry = table.get(e.slug)
        last, best = (f"{entry[k]:g}" if entry else "-" for k in ("last", "best"))
        bar = "#" * round((entry or {"best": 0})["best"] / 10)
        print(f"{e.number:{wide}} {e.title:<44}{e.level:<6}{last:>6}{best:>6}  {bar}")
        total += (entry or {"best": 0})["best"]
    print(f"{'':{wide}} {'all':<44}{'':6}{'':6}{total:>6g}  of {FULL * len(every)}")
    return 0


def do_handout(options):
    from grader import classroom
    return classroom.handout(TOP, Path(options.directory), choose(options.exercise), BUILD,
                             compiler_for(options))


def do_gradebook(options):
    from grader import classroom
    return classroom.gradebook(choose(options.exercise), Path(options.submissions), BUILD,
                               compiler_for(options), options)


def command_line():
    """The options of every verb."""
    parser = argparse.ArgumentParser(prog="dem", description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")

    def verb(name, text, run):
        sub = verbs.add_parser(name, help=text, description=text)
        sub.set_defaults(run=run)
        return sub

    def common(sub):
        sub.add_argument("--compiler", help="C++ compiler (default: $CXX, c++, g++ or clang++)")
        sub.add_argument("--jobs", type=int, default=2, help="checks or answers at a time")
        sub.add_argument("--threads", type=int, default=1, help="threads that an answer may use")

    sub = verb("grade", "build and grade your answers", do_grade)
    sub.add_argument("exercise", nargs="*", help="number, e.g. 06; default: all")
    sub.add_argument("--watch", action="store_true", help="grade again whenever a file is saved")
    sub.add_argument("--check", action="append", help="only this check (can be repeated)")
    sub.add_argument("--seed", type=int, default=1, help="seed of the random inputs (default 1)")
    sub.add_argument("--file", help="grade this file instead of answer.cpp")
    sub.add_argument("--json", action="store_true", help="print the sheets as JSON")
    sub.add_argument("--self-test", action="store_true",
                     help="instructors: starter, solutions and mutants, and who fails what")
    common(sub)
    sub = verb("lab", "make the runs of a lab sheet", do_lab)
    sub.add_argument("name", help="folder in exercises/labs, e.g. repose")
    sub.add_argument("--seeds", default="1-4", help="e.g. 101-104, or 7,9,12: choose your own")
    sub.add_argument("--at", type=float, action="append", help="only this value of the parameter")
    sub.add_argument("--program", default=str(TOP.parent / "build/default/tinydem"),
                     help="the solver (./dem lab builds it)")
    sub.add_argument("--output", default="output", help="where the runs go (default: output)")
    sub.add_argument("--instructor", action="store_true", help=argparse.SUPPRESS)
    verb("progress", "the table of points", do_progress)
    if (TOP / "grader" / "classroom.py").exists():
        sub = verb("handout", "write the tree for students", do_handout)
        sub.add_argument("directory", help="a directory that does not exist yet")
        sub.add_argument("exercise", nargs="*", help="numbers; default: all")
        common(sub)
        sub = verb("gradebook", "grade a class", do_gradebook)
        sub.add_argument("submissions", help="a directory with a directory per student")
        sub.add_argument("exercise", nargs="*", help="numbers; default: all")
        sub.add_argument("--output", default="gradebook", help="directory (default: gradebook)")
        sub.add_argument("--seed", type=int, help="of the hidden inputs (default: drawn)")
        sub.add_argument("--overwrite", action="store_true", help="replace an earlier gradebook")
        common(sub)
    return parser


def main():
    options = command_line().parse_args()
    try:
        return options.run(options)
    except (course.Mistake, course.BadExercise) as problem:
        print(f"dem: {problem}", file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader (head, less) has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1


if __name__ == "__main__":
    sys.exit(main())

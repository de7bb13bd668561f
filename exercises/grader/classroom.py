"""For teachers: the tree that students get, and the grades of a class."""
import csv
import json
import re
import secrets
import shutil
import sys
import time
import xml.etree.ElementTree as xml
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from . import course, labs, solver

DEM = """#!/bin/sh
# The exercises. ./dem grade 01 builds and grades your answer, ./dem progress shows where you are.
set -eu
here=$(cd -P -- "$(dirname -- "$0")" && pwd)
python=$(command -v "${PYTHON:-python3}") || {
  echo 'dem: python3 is missing; install it, or set PYTHON' >&2
  exit 1
}
if [ $# -eq 0 ]; then set -- --help; fi
exec "$python" "$here/exercises/grade.py" "$@"
"""
# What a student gets of an exercise; everything else stays with the teacher.
HANDED_OUT = ["README.md", "exercise.hpp", "checks.cpp", "checks.py", "solvers.py", "starter.cpp",
              "*.png", "*.svg"]
GRADER = ["__init__.py", "course.py", "program.py", "solver.py", "vec.py", "sandbox.cpp", "labs.py",
          "lab_runs.py"]
# Of a lab sheet, and what its runs need: the program, its scenes, and a front door that builds it.
LAB_HANDED_OUT = ["README.md", "lab.py", "starter.ini", "*.png"]
PROGRAM = ["CMakeLists.txt", "CMakePresets.json"]
FOR_TEACHERS = "test|verify|bench|docs|handout|gradebook"  # verbs of ./dem


# ------------------------------------------------------------------------------------- hand-out

def expected_values(exercise, build, compiler):
    """The reference's results for the public seeds, as the checks ask for them."""
    exercise.recorded.clear()
    for seed in course.PUBLIC_SEEDS:
        sheet = course.grade(exercise, exercise.folder / f"solution{exercise.suffix}", build, compiler, [seed])
        if not all(line.full for line in sheet.lines):
            raise course.BadExercise(f"{exercise.slug}: the solution has {sheet.points:g} points "
                                     f"with seed {seed}; run ./dem grade {exercise.number} "
                                     "--self-test")
    return dict(sorted(exercise.recorded.items()))


def student_readme(text, exercises, at="exercises/"):
    """A README without the part for teachers and without absent exercises; links lead to `at`."""
    folders = [e.folder.name for e in exercises]
    lines = []
    for line in text.split("**For teachers.**")[0].rstrip().splitlines():
        link = re.search(r"\]\((?:labs/)?([^/)]+)/README.md\)", line)
        if not link or link.group(1) in folders or link.group(1) == "labs":
            lines.append(re.sub(r"\]\((\d\d-|labs/)", rf"]({at}\1", line))
    return "\n".join(lines) + "\n"


def student_front_door(text):
    """./dem without the verbs for teachers."""
    verb = rf"^#: (?:{FOR_TEACHERS})\b.*\n(?:#: .*\n)*do_\w+\(\) \{{(?:.*\}}|\n(?:.*\n)*?\}})\n+"
    text = re.sub(r"^#   \./dem test .*\n", "", text, flags=re.MULTILINE)
    return re.sub(verb, "", text, flags=re.MULTILINE)


def handout_labs(top, directory, sheets):
    """Lab sheets without the instructor's runs, and the program that they need."""
    inside = directory / "exercises" / "labs"
    for lab in sheets:
        copy(LAB_HANDED_OUT, lab.folder, inside / lab.folder.name)
        shutil.copy(lab.folder / "starter.ini", inside / lab.folder.name / lab.answer_name)
    readme = student_readme((top / "labs" / "README.md").read_text(), sheets, "")
    (inside / "README.md").write_text(readme)
    copy(PROGRAM, top.parent, directory)
    shutil.copytree(top.parent / "tinydem", directory / "tinydem", dirs_exist_ok=True,
                    ignore=shutil.ignore_patterns("__pycache__"))
    return student_front_door((top.parent / "dem").read_text())


def copy(names, source, target):
    target.mkdir(parents=True, exist_ok=True)
    for name in names:
        for path in source.glob(name):
            shutil.copy(path, target)


def handout(top, directory, exercises, build, compiler):
    """Writes the tree for students; the exit code. Mistake if the directory is not empty."""
    if directory.exists() and (not directory.is_dir() or any(directory.iterdir())):
        raise course.Mistake(f"{directory} exists already; name a new directory")
    inside = directory / "exercises"
    copy(["grade.py", ".gitignore"], top, inside)
    copy(GRADER, top / "grader", inside / "grader")
    copy(["*.hpp", "*.cpp"], top / "include", inside / "include")
    sheets = [e for e in exercises if isinstance(e, labs.Lab)]
    if any(e.kind not in ("functions", "lab") for e in exercises):
        copy(solver.FILES, top.parent / "tinydem", directory / "tinydem")
    for exercise in (e for e in exercises if e not in sheets):
        folder = inside / exercise.slug
        copy(HANDED_OUT, exercise.folder, folder)
        if exercise.kind == "solver":
            copy(solver.FILES, exercise.solver, folder / "answer")
        else:
            shutil.copy(folder / "starter.cpp", folder / "answer.cpp")
        values = expected_values(exercise, build, compiler)
        (folder / "expected.json").write_text(json.dumps(values) + "\n")
    copy(["LICENSE"], top.parent, directory)
    readme = student_readme((top / "README.md").read_text(), exercises)
    (directory / "README.md").write_text(readme)
    (directory / "dem").write_text(handout_labs(top, directory, sheets) if sheets else DEM)
    (directory / "dem").chmod(0o755)
    print(f"dem: {len(exercises)} exercises for students are in {directory}")
    return 0


# ------------------------------------------------------------------------------------- gradebook

def find_answer(student, exercise):
    """A student's answer, or None. A link that leads out of the student's directory is none."""
    slug, number = exercise.slug, exercise.number

    def own(path):
        return path.is_file() and student.resolve() in path.resolve().parents

    if exercise.kind == "solver":
        for name in number, f"{number}/answer", slug, f"{slug}/answer", f"exercises/{slug}/answer":
            here = [student / name / file for file in solver.FILES]
            if any(map(own, here)) and all(own(f) or not f.exists() for f in here):
                return student / name
        return None
    for name in exercise.submissions:
        path = student / name
        if own(path):
            return path
    return None


def grade_one(folder, answer, build, compiler, seeds, threads):
    """A sheet as a dictionary, with the seconds that it took; in a process of its own."""
    start = time.monotonic()
    exercise = labs.Lab(folder) if (folder / "lab.py").exists() else course.Exercise(folder)
    sheet = course.grade(exercise, answer, build, compiler, seeds, threads=threads, jobs=1)
    return {**sheet.as_dict(), "seconds": round(time.monotonic() - start, 2)}


def not_submitted(exercise):
    """The sheet of an answer that is not there; the maximum is the same."""
    lines = [("builds", "builds", course.CATEGORIES["builds"])]
    lines += [(c.name, c.category, c.points) for c in exercise.checks]
    return {"exercise": exercise.slug, "title": exercise.title, "points": 0, "seconds": 0,
            "maximum": sum(course.CATEGORIES.values()), "compiler": "",
            "checks": [{"name": n, "category": k, "points": 0, "maximum": p,
                        "feedback": ["not submitted"]} for n, k, p in lines]}


def write_csv(path, grades):
    """A line per student and exercise: points in all and by category."""
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["student", "exercise", "points", "maximum", *course.CATEGORIES, "lost",
                      "seconds"])
        for student, sheet in grades:
            by = [round(sum(c["points"] for c in sheet["checks"] if c["category"] == k), 1)
                  for k in course.CATEGORIES]
            lost = [c["name"] for c in sheet["checks"] if c["points"] < c["maximum"]]
            out.writerow([student, sheet["exercise"], sheet["points"], sheet["maximum"], *by,
                          " ".join(lost), sheet["seconds"]])


def write_junit(path, grades):
    """JUnit XML: a test suite per student and exercise, a test case per check."""
    suites = xml.Element("testsuites", name="exercises")
    for student, sheet in grades:
        failed = [c for c in sheet["checks"] if c["points"] < c["maximum"]]
        suite = xml.SubElement(suites, "testsuite", name=f"{student}.{sheet['exercise']}",
                               tests=str(len(sheet["checks"])), failures=str(len(failed)),
                               errors="0", skipped="0", time=str(sheet["seconds"]))
        for c in sheet["checks"]:
            case = xml.SubElement(suite, "testcase", name=c["name"], time="0",
                                  classname=f"{student}.{sheet['exercise']}")
            if c in failed:
                failure = xml.SubElement(case, "failure", type="points",
                                         message=f"{c['points']:g} of {c['maximum']:g} points")
                failure.text = "\n".join(c["feedback"])
    xml.ElementTree(suites).write(path, encoding="utf-8", xml_declaration=True)


def results(sheets):
    """What Gradescope reads: the points and the feedback of every check of one student."""
    tests = []
    for sheet in sheets:
        slug = sheet["exercise"]
        number = slug.split("-")[0] if slug[0].isdigit() else slug
        for k, c in enumerate(sheet["checks"]):
            tests.append({
                "name": f"{sheet['title']}: {c['name']}", "number": f"{number}.{k}",
                "score": c["points"], "max_score": c["maximum"], "visibility": "visible",
                "status": "passed" if c["points"] == c["maximum"] else "failed",
                "output": "\n".join(c["feedback"]) or "full points"})
    return {"score": round(sum(s["points"] for s in sheets), 1), "tests": tests,
            "execution_time": round(sum(s["seconds"] for s in sheets)), "visibility": "visible"}


def gradebook(exercises, submissions, build, compiler, options):
    """Grades a class: a directory per student in `submissions`; the exit code."""
    students = sorted(p for p in submissions.glob("*") if p.is_dir() and p.name[0] != ".")
    if not students:
        raise course.Mistake(f"{submissions} must be a directory with a directory per student")
    output = Path(options.output)
    if output.exists() and not options.overwrite:
        raise course.Mistake(f"{output} exists already; --overwrite replaces it, --output names "
                             "another")
    hidden = secrets.randbelow(10 ** 9) + 1000 if options.seed is None else options.seed
    seeds = [course.PUBLIC_SEEDS[0], hidden]
    grades = []
    with ProcessPoolExecutor(options.jobs) as pool:
        waiting = [(student, e, find_answer(student, e)) for student in students for e in exercises]
        sheets = [pool.submit(grade_one, e.folder, answer, build, compiler, seeds, options.threads)
                  if answer else None for _, e, answer in waiting]
        for (student, e, _), sheet in zip(waiting, sheets):
            grades.append((student.name, sheet.result() if sheet else not_submitted(e)))
            print(f"{student.name:<30} {e.number} {grades[-1][1]['points']:>6g}", file=sys.stderr)
    output.mkdir(parents=True, exist_ok=True)
    write_csv(output / "grades.csv", grades)
    write_junit(output / "junit.xml", grades)
    for student in students:
        (output / student.name).mkdir(exist_ok=True)
        mine = results([sheet for name, sheet in grades if name == student.name])
        (output / student.name / "results.json").write_text(json.dumps(mine, indent=1) + "\n")
    print(f"dem: {len(students)} students, {len(exercises)} exercises, hidden seed {hidden}: "
          f"{output}/grades.csv, junit.xml, STUDENT/results.json")
    return 0

"""Is the grader right? Starter, solutions and mutants of an exercise, and the kill matrix.

A mutant says in its first lines what it must lose, and why:

    // loses: equal_spheres unequal_spheres elastic_impact~
    // 2/3 where Eq. (12) has 4/3.

Every named check must give 0 points (with ~: less than its points), every other check all of its
points. `loses: everything` is for what does not compile.
"""
import re
import time

from . import course
from .program import find_compiler


def promised(path):
    """What a mutant's header says: {check: "all" or "some"}, or {"builds": "all"}."""
    found = re.search(r"^(?://|#) loses: (.+)$", path.read_text(), re.MULTILINE)
    if not found:
        raise course.BadExercise(f"{path}: the header must have a line '// loses: CHECK ...'")
    words = found.group(1).split()
    if words == ["everything"]:
        return {"builds": "all"}
    return {w.rstrip("~"): "some" if w.endswith("~") else "all" for w in words}


def lost(sheet):
    """What an answer has lost: {check: "all" or "some"}."""
    return {x.name: "some" if x.points else "all" for x in sheet.lines if not x.full}


def mismatch(kind, sheet, promise):
    """How a sheet differs from what it should be, as text; empty if it does not."""
    have = lost(sheet)
    if kind == "starter":
        return "" if sheet.points <= 5 else f"the starter has {sheet.points:g} points, at most 5"
    if kind == "solution":
        return "" if not have else f"a solution loses {', '.join(have)}"
    if "builds" in promise or "builds" in have:
        good = "builds" in promise and sheet.points == 0
        return "" if good else f"compiles: {'builds' not in have}, {sheet.points:g} points"
    texts = [f"{name}: loses {have.get(name, 'nothing')}, not {promise.get(name, 'nothing')}"
             for name in {**promise, **have} if have.get(name) != promise.get(name)]
    return "; ".join(texts)


def subjects(exercise):
    """(name, kind, path, promise) of everything that is graded."""
    folder = exercise.folder
    yield "starter", "starter", exercise.starter(), {}
    for name in "solution", "solution2":
        yield name, "solution", folder / f"{name}{exercise.suffix}", {}
    for path in sorted((folder / "mutants").glob(f"*{exercise.suffix}")):
        yield path.stem, "mutant", path, promised(path)


def test(exercise, build, compiler, options):
    """Self-test of one exercise; a list of what is wrong. Prints the kill matrix."""
    start, problems, rows = time.monotonic(), [], []
    known = ["builds"] + [c.name for c in exercise.checks]
    killed = dict.fromkeys(known, "")
    for name, kind, path, promise in subjects(exercise):
        sheet = course.grade(exercise, path, build, compiler, [options.seed],
                             threads=options.threads, jobs=options.jobs)
        unknown = [c for c in promise if c not in known]
        text = f"there is no check {unknown}" if unknown else mismatch(kind, sheet, promise)
        if text:
            problems.append(f"{name}: {text}")
        have = lost(sheet)
        if kind == "mutant" and not have:
            problems.append(f"{name}: no check notices it")
        for check in have if kind == "mutant" and "builds" not in have else ["builds"] * (
                kind == "mutant" and "builds" in have):
            killed[check] = name
        rows.append((name, sheet, have, "" if not text else "  <- " + text))
    problems += [f"{check}: no mutant fails it" for check, by in killed.items() if not by]
    print_matrix(exercise, compiler, known, rows, time.monotonic() - start)
    return problems


def print_matrix(exercise, compiler, known, rows, seconds):
    """Rows: answers; columns: checks. # all points lost, ~ some, . none."""
    print(f"\n{exercise.slug}, {compiler}, {len(rows)} answers in {seconds:.1f} s")
    for k, check in enumerate(known):
        print(f"  {'| ' * k}{check}")
    for name, sheet, have, text in rows:
        marks = " ".join({"all": "#", "some": "~"}.get(have.get(c), ".") for c in known)
        print(f"  {marks}  {sheet.points:>5g}  {name}{text}")


def run(exercises, build, options):
    """Self-test of some exercises; the exit code."""
    compiler, failed = find_compiler(options.compiler), False
    for exercise in exercises:
        for problem in test(exercise, build, compiler, options):
            failed = True
            print(f"FAILED {exercise.slug}: {problem}")
    print("self-test failed" if failed else "self-test passed")
    return 1 if failed else 0

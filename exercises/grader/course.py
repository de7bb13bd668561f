"""Exercises, their checks, and how a check becomes points. AUTHORING.md explains the use."""
import hashlib
import importlib.util
import json
import math
import random
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from decimal import Context, Decimal
from pathlib import Path

from . import solver
from .program import Lost, Starter, Workshop, finite
from .vec import norm, scale, sub

#: Points of every exercise, by category.
CATEGORIES = {"builds": 5, "contract": 10, "pointwise": 35, "invariants": 25, "convergence": 15,
              "clean": 10}
LIMITS = {"cpu": 2, "memory": 1024, "wall": 4, "threads": 1}
PUBLIC_SEEDS = (1, 2, 3, 4)
CONTEXT = Context(prec=25)


# ----------------------------------------------------------------------------- an exercise's checks

class Check:
    """One line of the score: what it is called, what it is worth, and the function that decides."""

    def __init__(self, name, category, points, eq, tol, unit, cause, sharp, evaluate):
        self.name, self.category, self.points, self.evaluate = name, category, points, evaluate
        self.eq, self.tol, self.unit, self.cause, self.sharp = eq, tol, unit, cause, sharp
        self.title = " ".join((evaluate.__doc__ or name).split())


def check(category, points, eq, tol=0.0, unit="", cause="", sharp=False):
    """Makes the function below it a check: f(ask) -> outcome or list of outcomes.

    category: of CATEGORIES; points: what it is worth; eq: equations, as text; tol: error that still
    gives full points (0: only an exact result); unit: of what is measured; cause: what usually went
    wrong; sharp: all or nothing (signs, conventions). The docstring says what is checked.
    """
    def register(f):
        f.check = Check(f.__name__, category, points, eq, tol, unit, cause, sharp, f)
        return f
    return register


class Outcome:
    """What a check found: error (compared with the tolerance), and words for the feedback."""

    def __init__(self, error, measured="", expected="", at="", cause=""):
        self.error = error if math.isfinite(error) else math.inf
        self.measured, self.expected, self.at, self.cause = measured, expected, at, cause


def credit(error, tol, sharp):
    """Share of the points: 1 inside the tolerance, then linear in log10(error) to 0 at 100 tol."""
    if error <= tol:
        return 1.0
    if sharp or not error < 100 * tol:
        return 0.0
    return 1.0 - math.log10(error / tol) / 2


def number(x):
    """A number, or a tuple of numbers, as feedback shows it."""
    if isinstance(x, tuple):
        return number(x[0]) if len(x) == 1 else f"({', '.join(map(number, x))})"
    return f"{x:.6g}"


def as_tuple(value):
    return tuple(value) if isinstance(value, (tuple, list)) else (value,)


class Ask:
    """What a check uses: random inputs, the answer's functions, the reference, comparisons."""

    def __init__(self, exercise, one_check, seed, start):
        self.exercise, self.check, self.seed, self.start = exercise, one_check, seed, start
        self.random = random.Random(f"{exercise.slug} {one_check.name} {seed}")
        self.runner, self.references, self.printed, self.notes = None, 0, b"", []

    # ------------------------------------------------------------------------ inputs

    def uniform(self, low, high):
        return self.random.uniform(low, high)

    def log_uniform(self, low, high):
        """Its logarithm is uniform. Computed in decimals: the same bits with every C library."""
        share = Decimal(self.random.random())
        ratio = CONTEXT.divide(Decimal(high), Decimal(low))
        power = CONTEXT.exp(CONTEXT.multiply(share, CONTEXT.ln(ratio)))
        return float(CONTEXT.multiply(Decimal(low), power))

    def sign(self):
        return self.random.choice((-1.0, 1.0))

    def direction(self):
        """A unit vector, all directions alike."""
        while True:
            v = tuple(self.random.uniform(-1, 1) for _ in range(3))
            if 0.1 < norm(v) < 1:
                return scale(1 / norm(v), v)

    # ------------------------------------------------------------------------ evaluation

    def close(self):
        """Ends the program that evaluates the answer, if there is one."""
        if self.runner:
            self.printed += self.runner.printed
            self.runner.close()
        self.runner = None

    def fresh(self):
        """Lets the next call start a new process: nothing is remembered."""
        self.close()

    def call(self, name, rows, any_value=False):
        """Evaluates a function of the answer on rows (tuples of float); a list of tuples.

        Raises Lost, which costs this check, when the program crashes, when a result has the wrong
        length, and when a number is not finite, unless any_value.
        """
        inputs, outputs = self.exercise.functions[name]
        for row in rows:
            assert not inputs or len(row) == len(inputs), f"{name} takes {inputs}, got {row}"
        try:
            self.runner = self.runner or self.start()
            results = self.runner.ask(name, rows)
        except Lost as problem:
            self.close()
            if problem.late:
                self.start.lose_patience()
            where = "" if problem.late else self.guilty(name, rows)
            raise Lost(f"{name}: the program {problem}{where}", problem.late) from None
        for row, result in zip(rows, results):
            if outputs and len(result) != len(outputs):
                raise RuntimeError(f"{name} returns {len(result)} numbers, not {outputs}")
            if not any_value and not finite([result]):
                raise Lost(f"{name} = {number(result)} for {self.inputs(name, row)}")
        return results

    def right(self, name, rows, **_):
        """The same with the solver as it was, for an exercise about the solver as a whole."""
        runner = self.start.right()
        try:
            return runner.ask(name, rows)
        except Lost as problem:
            raise Lost(f"{name}: with the unchanged solver, the program {problem}",
                       problem.late) from None
        finally:
            self.printed += runner.printed
            runner.close()

    def guilty(self, name, rows):
        """The first row on which a new process ends as well, as text."""
        if len(rows) > 1000:
            return ""
        for row in rows:
            try:
                self.runner = self.runner or self.start()
                self.runner.ask(name, [row])
            except Lost:
                self.close()
                return f"; for {self.inputs(name, row)}"
        return ""

    def inputs(self, name, row):
        """A row of inputs in words: "delta = 0.001, R = 0.01"."""
        names = self.exercise.functions[name][0]
        if not names:
            return f"{len(row)} numbers {number(row[:6])}..."
        return ", ".join(f"{n} = {number(x)}" for n, x in zip(names, row))

    def reference(self, name, rows):
        """The right results: reference.py of the exercise, or its table in a hand-out."""
        key = f"{self.seed} {self.check.name} {self.references}"
        self.references += 1
        return self.exercise.reference(key, name, rows)

    # ------------------------------------------------------------------------ comparisons

    def note(self, text):
        """A line below the score sheet that earns and costs nothing."""
        self.notes.append(text)

    def outcome(self, error, measured="", expected="", at="", cause=""):
        """error is compared with the tolerance; the texts are shown when it is too large."""
        return Outcome(error, str(measured), str(expected), at, cause)

    def compare(self, name, rows, want=None, part=slice(None), scale=0.0, ratios=None):
        """Worst relative error |got - want| / max(|want|, scale) over all rows.

        want: the right results, default: those of the reference. part: of the numbers of a result,
        e.g. slice(0, 3). scale: below it errors are absolute. ratios: {got/want: cause}; a mistake
        that shows as a constant factor is named.
        """
        want = [as_tuple(w)[part] for w in (want or self.reference(name, rows))]
        got = [g[part] for g in self.call(name, rows)]
        errors = []
        for g, w in zip(got, want):
            size = max(norm(w), scale)
            errors.append(norm(sub(g, w)) / size if size > 0 else (norm(g) and math.inf))
        k = max(range(len(rows)), key=errors.__getitem__)
        return Outcome(errors[k], number(got[k]), number(want[k]), self.inputs(name, rows[k]),
                       self.cause_of_ratio(got, want, ratios or {}))

    @staticmethod
    def cause_of_ratio(got, want, ratios):
        """The cause whose factor explains all results, if there is one."""
        for ratio, cause in ratios.items():
            if all(norm(sub(g, tuple(ratio * x for x in w))) <= 1e-6 * norm(w)
                   for g, w in zip(got, want)):
                return cause
        return ""

    def same_bits(self, name, rows):
        """The check of category `clean`: the same bits forwards, backwards, and in a new process.

        An answer that gives the same number for all rows has not begun, and earns nothing.
        """
        first = self.call(name, rows)
        again = self.call(name, rows[::-1])[::-1]
        self.fresh()
        anew = self.call(name, [row for row in rows for _ in (0, 1)])[::2]
        if all(f == first[0] for f in first):
            return Outcome(math.inf, f"{number(first[0])} for all inputs", "results that differ",
                           cause=f"{name} does not use its arguments yet")
        for row, a, b, c in zip(rows, first, again, anew):
            if not a == b == c:
                other = b if a != b else c
                return Outcome(math.inf, f"{number(a)} once and {number(other)} later",
                               "the same bits", self.inputs(name, row),
                               "a static or global variable, or one without a value")
        return Outcome(0.0)


# ---------------------------------------------------------------------------------- exercises

class Mistake(Exception):
    """The command line asks for something that is not there; the text says what to try."""


class BadExercise(Exception):
    """An exercise that breaks the rules of AUTHORING.md; the text says which file and why."""


def load_module(path):
    """Runs a Python file of an exercise as a module of its own."""
    spec = importlib.util.spec_from_file_location(f"{path.parent.name}/{path.stem}", str(path))
    module = importlib.util.module_from_spec(spec)
    written, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    spec.loader.exec_module(module)
    sys.dont_write_bytecode = written
    return module


def digest(rows):
    """A short text that stands for a table of numbers, bit for bit."""
    return hashlib.sha256(json.dumps(rows).encode()).hexdigest()[:12]


class Exercise:
    """A folder NN-name: README.md, starter.cpp, exercise.hpp, checks.cpp, checks.py, and for the
    instructor reference.py, solution.cpp, solution2.cpp, mutants/. A hand-out has expected.json in
    place of reference.py. Of kind "solver": the starter is the solver, the answer a folder with a
    copy of its two files, and solutions and mutants are lists of changes (solver.py). Of kind
    "tests": the answer is tests of the solver, and checks.py lists CHANGES that break it."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.slug, self.number = self.folder.name, self.folder.name.split("-")[0]
        module = load_module(self.folder / "checks.py")
        self.title, self.level = module.TITLE, module.LEVEL
        self.kind = getattr(module, "KIND", "functions")
        self.suffix = ".py" if self.kind == "solver" else ".cpp"  # of solutions and mutants
        self.include = self.folder.parent / "include"
        self.solver = self.folder.parents[1] / "tinydem"
        self.functions = {name: (i.split(), o.split()) for name, (i, o) in module.FUNCTIONS.items()}
        self.limits = {**LIMITS, **getattr(module, "LIMITS", {})}
        self.checks = [f.check for f in vars(module).values() if hasattr(f, "check")]
        self.changes = getattr(module, "CHANGES", [])
        self.headers = [*sorted(self.folder.glob("*.hpp")), *sorted(self.include.glob("*.hpp"))]
        if self.kind == "tests":
            self.headers.append(self.solver / "tinydem.hpp")
        self.recorded, self.table, self.formulas = {}, None, None
        if (self.folder / "reference.py").exists():
            self.formulas = load_module(self.folder / "reference.py")
        elif (self.folder / "expected.json").exists():
            self.table = json.loads((self.folder / "expected.json").read_text())
        self.validate()

    def validate(self):
        """Every category has its points, every check its docstring and its equation."""
        for category, points in CATEGORIES.items():
            have = sum(c.points for c in self.checks if c.category == category)
            if category != "builds" and have != points:
                raise BadExercise(f"{self.folder}/checks.py: category {category} has {have} points,"
                                  f" it must have {points}")
        for c in self.checks:
            if c.category not in CATEGORIES or c.category == "builds" or not c.evaluate.__doc__:
                raise BadExercise(f"{self.folder}/checks.py: {c.name} needs a docstring and a "
                                  f"category of {', '.join(CATEGORIES)} (not builds)")

    def reference(self, key, name, rows):
        """The right results for rows; recorded under `key` for a hand-out."""
        if self.formulas:
            values = [as_tuple(getattr(self.formulas, name)(*row)) for row in rows]
            self.recorded[key] = {"rows": digest(rows), "values": values}
            return values
        entry = (self.table or {}).get(key)
        if entry is None:
            raise Lost(f"there are no expected values for seed {key.split()[0]}; use one of "
                       f"{', '.join(map(str, PUBLIC_SEEDS))}")
        if entry["rows"] != digest(rows):
            raise Lost(f"{self.slug}/checks.py or expected.json was changed; get them anew")
        return [tuple(v) for v in entry["values"]]

    def starter(self):
        """What the answer is made from."""
        return self.solver if self.kind == "solver" else self.folder / "starter.cpp"

    def accepts(self, path):
        """Can this file or folder be an answer?"""
        if self.kind == "solver" and path.is_dir():
            return any((path / name).is_file() for name in solver.FILES)
        return path.is_file() and (self.kind != "solver" or path.suffix == self.suffix)

    def solver_texts(self, answer):
        """{name: text} of a copy of the solver: a folder with both files or one, or changes."""
        if answer.suffix != ".py":
            return solver.read(answer, self.solver)
        texts = solver.read(self.solver)
        first = [self.folder / "solution.py"] if answer.parent.name == "mutants" else []
        try:
            for path in [*first, answer]:
                texts = solver.changed(texts, load_module(path).CHANGES, path)
        except ValueError as problem:
            raise BadExercise(str(problem)) from None
        return texts

    @property
    def submissions(self):
        """Where a student's answer may be, in the student's directory."""
        return [f"{self.number}.cpp", f"{self.slug}.cpp", f"{self.number}/answer.cpp",
                f"{self.slug}/answer.cpp", f"exercises/{self.slug}/answer.cpp"]

    def broken_solver(self, number, right):
        """The text of tinydem.cpp with all CHANGES, of which the variable `number` chooses."""
        try:
            return solver.one_of_many((self.solver / "tinydem.cpp").read_text(),
                                      [] if right else self.changes, number)
        except ValueError as problem:
            raise BadExercise(f"{self.folder}: {problem}") from None

    def answer(self):
        """The file (or folder) that the student edits; made from the starter at first."""
        if self.kind == "solver":
            path = self.folder / "answer"
            return path if path.is_dir() else solver.write(solver.read(self.solver), path)
        path = self.folder / "answer.cpp"
        if not path.exists():
            path.write_text((self.folder / "starter.cpp").read_text())
        return path


def find_exercises(top):
    """All exercises of a folder, by number."""
    folders = [p.parent for p in Path(top).glob("*/checks.py") if re.match(r"\d\d-", p.parent.name)]
    return [Exercise(folder) for folder in sorted(folders)]


# ---------------------------------------------------------------------------------- grading

class Line:
    """A line of a score sheet. check: None for `builds`; problem: why there is no outcome."""

    def __init__(self, maximum, points=0, check=None, seed=1, outcome=None, problem="", printed="",
                 notes=()):
        self.name = check.name if check else "builds"
        self.category = check.category if check else "builds"
        self.check, self.points, self.maximum, self.seed = check, points, maximum, seed
        self.outcome, self.problem, self.printed, self.notes = outcome, problem, printed, notes

    @property
    def full(self):
        return self.points == self.maximum


class Sheet:
    """The score of one answer: a Line for `builds` and one for every check."""

    def __init__(self, exercise, seeds, lines, said):
        self.exercise, self.seeds, self.lines, self.said = exercise, seeds, lines, said

    @property
    def points(self):
        return round(sum(line.points for line in self.lines), 1)

    def as_dict(self):
        """The sheet as numbers and texts."""
        return {"exercise": self.exercise.slug, "title": self.exercise.title, "seeds": self.seeds,
                "points": self.points, "maximum": sum(CATEGORIES.values()), "compiler": self.said,
                "checks": [{"name": x.name, "category": x.category, "points": x.points,
                            "maximum": x.maximum, "feedback": feedback(x, self, True)}
                           for x in self.lines]}


def run_check(exercise, one_check, seed, start):
    """One check in its own process; a Line."""
    ask = Ask(exercise, one_check, seed, start)
    worst, problem = None, ""
    try:
        outcomes = one_check.evaluate(ask)
        worst = max(outcomes if isinstance(outcomes, list) else [outcomes], key=lambda o: o.error)
    except Lost as lost:
        problem = str(lost)
    except (ArithmeticError, ValueError) as lost:
        problem = f"the results are far out of range ({lost})"
    finally:
        ask.close()
    share = credit(worst.error, one_check.tol, one_check.sharp) if worst else 0.0
    return Line(one_check.points, round(one_check.points * share, 1), one_check, seed, worst,
                problem, ask.printed.decode(errors="replace"), ask.notes)


def grade(exercise, answer, build, compiler, seeds=(1,), only=None, threads=1, jobs=2):
    """Builds and checks one answer (a path); a Sheet.

    build: directory for compiled files; seeds: of the random inputs, the worst result counts; only:
    names of the checks to run, default all; threads: that the answer may use; jobs: checks at a
    time.
    """
    if hasattr(exercise, "sheet"):  # a lab sheet: numbers, no program
        return exercise.grade(answer, seeds, only)
    chosen = [c for c in exercise.checks if not only or c.name in only]
    limits = {**exercise.limits, "threads": threads}
    with Workshop(compiler, build) as shop:
        program, said = shop.program(exercise, answer)
        if not program:
            lines = [Line(CATEGORIES["builds"], problem="it does not compile")]
            lines += [Line(c.points, check=c, problem="not run") for c in chosen]
            return Sheet(exercise, seeds, lines, said)
        start = Starter(shop.sandbox(), program, limits)
        if exercise.kind != "functions":
            right = shop.program(exercise, exercise.solver) if exercise.kind == "solver" else \
                shop.program(exercise, answer, right=True)
            if not right[0]:
                raise BadExercise(f"the solver as it is does not compile:\n{right[1]}")
            start.right = Starter(shop.sandbox(), right[0], limits)
        with ThreadPoolExecutor(jobs) as pool:
            every = [list(pool.map(lambda c, s=seed: run_check(exercise, c, s, start), chosen))
                     for seed in seeds]
    worst = [min(lines, key=lambda x: x.points) for lines in zip(*every)]
    return Sheet(exercise, seeds, [Line(CATEGORIES["builds"], CATEGORIES["builds"]), *worst], said)


def printable(text):
    """Text without the characters that no report can hold."""
    return "".join(c if c.isprintable() else "?" for c in text)


def feedback(line, sheet, equations=False):
    """Why points are missing and what to do: a list of texts; empty at full points. equations: with
    those of the check, for who does not see them beside its name."""
    if line.full or line.problem == "not run":
        return []
    if not line.check:
        return [printable(x) for x in ["the answer does not compile:",
                                       *sheet.said.splitlines()[:12]]]
    one, out = line.check, line.outcome
    texts = [f"{one.title}; {one.eq}" if equations and one.eq else one.title]
    if out:
        unit = f" {one.unit}" if one.unit else ""
        band = f"; error {out.error:.2g}, allowed {one.tol:.2g}" if one.tol else ""
        texts += [f"measured: {out.measured}{unit}", f"expected: {out.expected}{unit}{band}"]
        texts += [f"at: {out.at}"] if out.at else []
        cause = out.cause or one.cause
        texts += [f"likely cause: {cause}"] if cause else []
    else:
        texts.append(line.problem)
    if line.printed:
        texts.append(f"it printed: {line.printed.splitlines()[0][:70]}")
    seed = f" --seed {line.seed}" if line.seed in PUBLIC_SEEDS else "   (with hidden inputs)"
    texts.append(f"again: ./dem grade {sheet.exercise.number} --check {line.name}"
                 + ("" if hasattr(sheet.exercise, "sheet") else seed))
    return [printable(x) for x in texts]

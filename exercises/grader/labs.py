"""Lab sheets: a scene is run and measured; the answer is numbers with errors, no program.

A sheet is a folder labs/NAME/, see ../labs/AUTHORING.md. Its answer, answer.ini, has three parts:

    [prediction]    what the student expects, and the seal that ./dem grade gives for it
    [runs]          a row of numbers per run
    [result]        value +- standard error, unit

What the student's own runs say is computed here (values, and their errors by leaving out one seed
after the other). The instructor's runs, runs.csv, say what comes out, and how much it scatters.
"""
import hashlib
import math
import random
import re
import time
from pathlib import Path

from . import course
from .course import Check, Line, Mistake, Outcome, Sheet

FULL_BAND = 3.0     # standard deviations that a result of so many runs may be off; twice: half
DRAWS = 400         # students who are drawn from the instructor's runs to know their scatter
NEAR = 1.5          # factor by which an error may differ from what the runs say
FAR = 5.0           # and from what the instructor's runs say, in any case
SCATTER = (0.25, 2.5)  # of the student's runs over the instructor's: chance hardly ever leaves it
TRENDS = ("rises", "falls", "stays")
SECTIONS = ("prediction", "runs", "result")
QUANTITY = re.compile(r"^([-+.\deE]+)(?:\s*(?:\+-|\+/-|±)\s*([-+.\deE]+))?\s*([a-zA-Z/^0-9%]*)$")

CHECKS = [  # name, category, points, what it asks, unit-free cause of a failure
    ("builds", "builds", 5, "The answer can be read", ""),
    ("prediction", "contract", 7, "A prediction was given and sealed before the results", ""),
    ("foresight", "contract", 3, "The predicted trend is the one that was found", ""),
    ("first_result", "pointwise", 25, "The first result, within the scatter of honest runs",
     "another parameter or another number of grains than on the sheet, or a slip in the mean"),
    ("units", "pointwise", 10, "The units that the sheet asks for", ""),
    ("trend", "invariants", 10, "The trend, in the runs and in words", "columns exchanged"),
    ("own_runs", "invariants", 15, "The results follow from the runs, and the runs are plausible",
     "the results are not the means of these runs"),
    ("second_result", "convergence", 15, "The second result, within the scatter of honest runs",
     "see how the sheet computes it"),
    ("error_bar", "clean", 10, "Error bars that the runs justify",
     "the error of a mean is the standard deviation over the root of the number of runs"),
]


# ------------------------------------------------------------------------------- reading answers

class Unreadable(Exception):
    """An answer that breaks the format; the text says where and what to try."""


class Quantity:
    """A number as a student writes it: 16.2 +- 0.6 deg. error: None if there is none."""

    def __init__(self, text):
        found = QUANTITY.match(text)
        try:
            self.value = float(found.group(1))
            self.error = float(found.group(2)) if found.group(2) else None
        except (AttributeError, ValueError):
            raise Unreadable(f"'{text}' is no quantity; write 16.2 +- 0.6 deg") from None
        self.unit = found.group(3)
        if not all(map(math.isfinite, (self.value, self.error or 0))):
            raise Unreadable(f"'{text}' is not finite")
        digits = found.group(1).lower().split("e")[0].partition(".")[2]
        power = int(found.group(1).lower().partition("e")[2] or 0)
        self.rounding = 0.5 * 10.0 ** (power - len(digits))


def read_answer(path):
    """An answer as {section: {name: text}}, its runs as a list of rows of float."""
    answer = {"prediction": {}, "runs": [], "result": {}}
    section = None
    for number, line in enumerate(Path(path).read_text(errors="replace").splitlines(), start=1):
        line = line.partition("#")[0].strip()
        where = f"line {number}: "
        if not line:
            continue
        if line[0] == "[":
            section = line.strip("[] ")
            if section not in SECTIONS:
                raise Unreadable(f"{where}there is no part [{section}]; the parts are "
                                 f"{', '.join(f'[{s}]' for s in SECTIONS)}")
        elif section == "runs":
            try:
                row = [float(word) for word in line.replace(",", " ").split()]
                if not all(map(math.isfinite, row)):
                    raise ValueError
            except ValueError:
                raise Unreadable(f"{where}'{line[:40]}' must be finite numbers") from None
            answer["runs"].append(row)
        else:
            name, equals, text = (word.strip() for word in line.partition("="))
            if section is None or not equals:
                raise Unreadable(f"{where}'{line[:40]}' must be name = value, below a [part]")
            if name in answer[section]:
                raise Unreadable(f"{where}{name} is there twice")
            answer[section][name] = text
    return answer


def seal_of(slug, prediction, names, when):
    """The seal of a prediction: the time, and what of it nobody can guess."""
    words = [" ".join(prediction[name].split()) for name in names]
    return f"{when}-{hashlib.sha256(repr([slug, when, *words]).encode()).hexdigest()[:10]}"


# ----------------------------------------------------------------------------------- statistics

def mean(values):
    return sum(values) / len(values)


def deviation(values):
    """Standard deviation of a sample."""
    middle = mean(values)
    return math.sqrt(sum((v - middle) ** 2 for v in values) / (len(values) - 1))


def by_seed(rows):
    """{seed: its rows}, rows as dictionaries."""
    seeds = {}
    for row in rows:
        seeds.setdefault(row["seed"], []).append(row)
    return seeds


def own_error(function, rows):
    """Standard error of function(rows) by leaving out one seed after the other (jackknife). For a
    mean of one number per seed it is the deviation over the root of their number."""
    seeds = by_seed(rows)
    n = len(seeds)
    parts = [function([r for r in rows if r["seed"] != seed]) for seed in seeds]
    return math.sqrt((n - 1) / n * sum((p - mean(parts)) ** 2 for p in parts))


def expected_error(function, rows, n):
    """Standard error of function for a student with n seeds, drawn from the instructor's runs."""
    dice, groups = random.Random(f"{n} seeds"), list(by_seed(rows).values())
    drawn = []
    for _ in range(DRAWS):
        chosen = [dict(row, seed=k) for k in range(n) for row in dice.choice(groups)]
        drawn.append(function(chosen))
    return deviation(drawn) * math.sqrt(len(groups) / (len(groups) - 1))


def mean_at(column, name=None, value=None):
    """A function of rows: the mean of a column, of those rows where `name` has this value."""
    return lambda rows: mean([r[column] for r in rows if name is None or r[name] == value])


def power_between(column, name, low, high, length):
    """A function of rows: the exponent p of column ~ length^p, from the means at both ends.

    length: the ratio of the two lengths (or coefficients, amplitudes) that belong to high and low.
    """
    a, b = mean_at(column, name, low), mean_at(column, name, high)
    return lambda rows: math.log(b(rows) / a(rows)) / math.log(length)


# ---------------------------------------------------------------------------------------- sheets

class Result:
    """A quantity that is asked for. units: {name: factor to the first one}; wide: a band for
    everybody, (low, high) in the first unit; function: of rows."""

    def __init__(self, text, units, wide, function):
        self.text, self.units, self.wide, self.function = text, units, wide, function
        self.unit = next(iter(units))


class Lab:
    """A folder labs/NAME: README.md, lab.py, starter.ini, and for the instructor runs.csv,
    solution.ini, solution2.ini, mutants/."""
    answer_name, kind, suffix = "answer.ini", "lab", ".ini"

    def __init__(self, folder):
        self.folder = Path(folder)
        self.slug = self.number = f"lab-{self.folder.name}"
        self.sheet = course.load_module(self.folder / "lab.py")
        self.title, self.level = self.sheet.TITLE, self.sheet.LEVEL
        self.results = self.sheet.RESULTS
        self.columns = self.sheet.ROW.split()
        self.recorded = {}
        self.checks = [Check(name, category, points, self.sheet.EQUATIONS.get(name, ""), 0.0, "",
                             cause, not name.endswith("result"), _titled(title))
                       for name, category, points, title, cause in CHECKS[1:]]
        self.first = Check(*CHECKS[0][:3], "", 0.0, "", "", True, _titled(CHECKS[0][3]))
        table = self.folder / "runs.csv"
        self.runs = self.read_table(table) if table.exists() else None

    def read_table(self, path):
        """The instructor's runs: dictionaries."""
        head, *lines = path.read_text().splitlines()
        if head.split(",") != self.columns:
            raise course.BadExercise(f"{path}: the columns must be {','.join(self.columns)}")
        return [dict(zip(self.columns, map(float, line.split(",")))) for line in lines]

    @property
    def submissions(self):
        """Where a student's answer may be."""
        name = self.folder.name
        return [f"lab-{name}.ini", f"lab-{name}/answer.ini", f"{name}/answer.ini",
                f"labs/{name}/answer.ini", f"exercises/labs/{name}/answer.ini"]

    def starter(self):
        """What the answer is made from."""
        return self.folder / "starter.ini"

    def accepts(self, path):
        """Can this file be an answer?"""
        return path.is_file()

    def answer(self):
        """The file that the student edits; made from the starter at first."""
        path = self.folder / self.answer_name
        if not path.exists():
            path.write_text(self.starter().read_text())
        return path

    def load(self, path):
        """An answer as read_answer gives it."""
        try:
            answer = read_answer(path)
            if Path(path).parent.name == "mutants" and self.runs:
                right = read_answer(self.folder / "solution.ini")
                for part in "prediction", "result":
                    merged = {**right[part], **answer[part]}
                    answer[part] = {k: v for k, v in merged.items() if v}
                answer["runs"] = answer["runs"] or right["runs"]
            for row in answer["runs"]:
                if len(row) != len(self.columns):
                    raise Unreadable(f"[runs]: a row must have {len(self.columns)} numbers, "
                                     f"{' '.join(self.columns)}; found {len(row)}")
            answer["runs"] = [dict(zip(self.columns, row)) for row in answer["runs"]]
            answer["quantities"] = {n: Quantity(answer["result"][n]) for n in self.results
                                    if answer["result"].get(n)}
        except OSError as problem:
            raise Unreadable(f"{path}: {problem.strerror}") from None
        return answer

    def grade(self, path, seeds=(1,), only=None):
        """The Sheet of an answer (a path)."""
        chosen = [c for c in self.checks if not only or c.name in only]
        try:
            answer = self.load(path)
        except Unreadable as problem:
            lines = [Line(self.first.points, 0, self.first, problem=str(problem))]
            return Sheet(self, seeds, lines + [Line(c.points, check=c, problem="not run")
                                               for c in chosen], "")
        lines = [Line(self.first.points, self.first.points, self.first)]
        for one in chosen:
            share, outcome = judge(self, one.name, answer)
            lines.append(Line(one.points, round(share * one.points, 1), one, outcome=outcome))
        return Sheet(self, seeds, lines, "")


def _titled(title):
    """A function that carries the title of a check as its docstring."""
    def nothing():
        return None
    nothing.__doc__ = title
    return nothing


def find_labs(top):
    """All lab sheets, by name."""
    return [Lab(p.parent) for p in sorted(Path(top).glob("labs/*/lab.py"))]


# ---------------------------------------------------------------------------------------- judging

def judge(lab, name, answer):
    """(share of the points, Outcome) of one check."""
    try:
        outcomes = JUDGES[name](lab, answer)
    except (ArithmeticError, ValueError) as problem:  # logarithm of 0, and the like
        outcomes = [no(f"numbers with which nothing can be computed ({problem})", "other numbers")]
    share, outcome = min(outcomes, key=lambda x: x[0])
    return share, outcome


def yes():
    return 1.0, Outcome(0.0)


def no(measured, expected, cause="", share=0.0):
    return share, Outcome(math.inf, measured, expected, cause=cause)


def prediction_names(lab):
    """What a prediction must have, in the order of the seal."""
    return ["trend", next(iter(lab.results)), "because"]


def judge_prediction(lab, answer):
    given, names = answer["prediction"], prediction_names(lab)
    for name in names:
        if not given.get(name):
            return [no(f"[prediction] without {name}", f"{', '.join(names)}, before any run",
                       "begin with the prediction; it may be wrong")]
    if given["trend"] not in TRENDS or len(given["because"]) < 20:
        return [no(f"trend = {given['trend']}, because = {given['because']}",
                   f"trend: one of {', '.join(TRENDS)}; because: a sentence")]
    seal = given.get("seal", "")
    if seal and seal == seal_of(lab.slug, given, names, seal.rpartition("-")[0]):
        return [yes()]
    if answer["runs"] or answer["result"].get("trend") or answer["quantities"]:
        return [no("results, but the prediction has no seal, or was changed after it",
                   "a prediction that was sealed first", "take runs and results out, grade, put "
                   "the seal in, then put them back; a seal is void when the prediction changes")]
    seal = seal_of(lab.slug, given, names, time.strftime("%y%m%d-%H%M"))
    return [no("a prediction without a seal", f"seal = {seal}   in [prediction]; copy it, your "
               "prediction stands from now on, and the runs can begin")]


def judge_foresight(lab, answer):
    if answer["prediction"].get("trend") == lab.sheet.TREND and answer["runs"]:
        return [yes()]
    return [no(f"predicted: {answer['prediction'].get('trend', 'nothing')}; {len(answer['runs'])} "
               "runs", "the trend of the runs", "which effect was stronger than you thought?")]


def judge_units(lab, answer):
    out = []
    for name, result in lab.results.items():
        have = answer["quantities"].get(name)
        if have is None or have.unit != result.unit:
            out.append(no(f"{name} = {answer['result'].get(name) or 'nothing'}",
                          f"{name} in {result.unit}" if result.unit else f"{name} without a unit"))
    return out or [yes()]


def converted(lab, name, answer):
    """(value, error or None) of a result in the unit that is asked for; None if it is missing."""
    have, units = answer["quantities"].get(name), lab.results[name].units
    if have is None:
        return None
    factor = units.get(have.unit, 1.0)
    return have.value * factor, have.error and have.error * factor


def band(lab, name, answer):
    """(low, high) in which a result must lie, from the instructor's runs or the public band."""
    result, n = lab.results[name], max(len(by_seed(answer["runs"])), lab.sheet.LEAST)
    if not lab.runs:
        return result.wide
    centre, have = result.function(lab.runs), len(by_seed(lab.runs))
    sigma = math.hypot(expected_error(result.function, lab.runs, n),
                       expected_error(result.function, lab.runs, have))
    return centre - FULL_BAND * sigma, centre + FULL_BAND * sigma


def judge_band(lab, name, answer):
    have = converted(lab, name, answer)
    if have is None:  # the band would spoil the prediction
        return [no(f"no {name}", "a number from your runs")]
    low, high = band(lab, name, answer)
    unit = lab.results[name].unit
    expected = f"{name} from {low:.4g} to {high:.4g} {unit}".rstrip()
    off = abs(have[0] - (low + high) / 2) / ((high - low) / 2)
    if off <= 1:
        return [yes()]
    return [no(f"{name} = {have[0]:.4g} {unit}".rstrip(), expected,
               share=0.5 if off <= 2 and lab.runs else 0.0)]


def judge_first(lab, answer):
    return judge_band(lab, list(lab.results)[0], answer)


def judge_second(lab, answer):
    return judge_band(lab, list(lab.results)[1], answer)


def judge_trend(lab, answer):
    if not answer["runs"]:
        return [no("no runs", "rows in [runs]")]
    missing = complete(lab, answer["runs"], 2)
    if missing:
        return [missing]
    levels = lab.sheet.levels(answer["runs"])
    steps = [b - a for a, b in zip(levels, levels[1:])]
    found = "rises" if min(steps) > 0 else "falls" if max(steps) < 0 else "stays"
    said = answer["result"].get("trend", "nothing")
    if found == said == lab.sheet.TREND:
        return [yes()]
    numbers = ", ".join(f"{v:.4g}" for v in levels)
    return [no(f"in the runs it {found} ({numbers}), in words: {said}",
               "the same in both, and what other runs of this scene show")]


def complete(lab, rows, least):
    """What is missing in the runs, as a judgement; None if they are complete. least: seeds."""
    seeds, values = by_seed(rows), lab.sheet.VALUES
    for seed, group in seeds.items():
        have = sorted(r[lab.sheet.VARY] for r in group)
        if have != sorted(values):
            return no(f"seed {seed:g} has {lab.sheet.VARY} = {', '.join(f'{v:g}' for v in have)}",
                      f"every seed with {', '.join(f'{v:g}' for v in sorted(values))}, once each")
    if len(seeds) < least:
        return no(f"{len(seeds)} seeds", f"at least {least}")
    return None


def judge_own_runs(lab, answer):
    rows = answer["runs"]
    if not rows:
        return [no("no runs", "rows in [runs]")]
    missing = complete(lab, rows, lab.sheet.LEAST)
    if missing:
        return [missing]
    out = []
    column = lab.sheet.SCATTERS
    digits = [r[column] for r in rows if r[column]]
    if len(set(digits)) < len(digits):  # five digits of a chaotic run
        out.append(no(f"{column} has the same digits twice", "different numbers in different runs",
                      "a run was counted twice"))
    for name, result in lab.results.items():
        have = converted(lab, name, answer)
        value, error = result.function(rows), own_error(result.function, rows)
        if have is None:
            out.append(no(f"no {name}", f"{name} of these runs"))
        elif abs(have[0] - value) > error + answer["quantities"][name].rounding * \
                result.units.get(answer["quantities"][name].unit, 1.0):
            out.append(no(f"{name} = {have[0]:.4g} {result.unit}".rstrip(),
                          f"{value:.4g} +- {error:.2g} {result.unit}".rstrip() +
                          ", which these runs give"))
    if lab.runs:
        ratio = scatter(lab, rows) / scatter(lab, lab.runs)
        if not SCATTER[0] < ratio < SCATTER[1]:
            out.append(no(f"runs that scatter {ratio:.2g} times as much as others",
                          f"{SCATTER[0]:g} to {SCATTER[1]:g} times",
                          "numbers that were not measured, or runs that differ in more than seed"))
    return out or [yes()]


def scatter(lab, rows):
    """Relative standard deviation of the runs with the same parameters, over all of them; a run
    whose number is 0 had nothing to measure."""
    groups = {}
    for row in rows:
        if row[lab.sheet.SCATTERS]:
            groups.setdefault(row[lab.sheet.VARY], []).append(row[lab.sheet.SCATTERS])
    return math.sqrt(mean([(deviation(v) / mean(v)) ** 2 for v in groups.values() if len(v) > 1]))


def judge_error_bar(lab, answer):
    """An error is honest if it is near to what the own runs say, or what other runs say."""
    rows, out = answer["runs"], []
    missing = no("no runs", "rows in [runs]") if not rows else complete(lab, rows, 2)
    if missing:
        return [missing]
    for name, result in lab.results.items():
        have, n = converted(lab, name, answer), len(by_seed(rows))
        errors, limits = [own_error(result.function, rows)], (0.0, math.inf)
        if lab.runs:
            errors.append(expected_error(result.function, lab.runs, n))
            limits = errors[1] / FAR, errors[1] * FAR
        bands = [(e / NEAR, e * NEAR) for e in errors]
        error = have and have[1]
        if not error or not limits[0] < error < limits[1] or not any(
                low <= error <= high for low, high in bands):
            texts = [f"{low:.2g} to {high:.2g}" for low, high in bands]
            out.append(no(f"{name} +- {error:.2g}" if error else f"{name} without an error",
                          f"{name} +- {', or '.join(texts)} {result.unit}".rstrip()))
    return out or [yes()]


JUDGES = {"prediction": judge_prediction, "foresight": judge_foresight, "first_result": judge_first,
          "units": judge_units, "trend": judge_trend, "own_runs": judge_own_runs,
          "second_result": judge_second, "error_bar": judge_error_bar}


def need_prediction(lab):
    """Mistake unless the prediction of the student's answer is sealed (for the verb `lab`)."""
    try:
        answer = lab.load(lab.answer())
    except Unreadable as problem:
        raise Mistake(f"{lab.answer()}: {problem}") from None
    share, outcome = judge(lab, "prediction", answer)
    if share < 1:
        raise Mistake(f"first the prediction, in {lab.answer()}: {outcome.measured}; expected: "
                      f"{outcome.expected}; then ./dem grade {lab.number}")

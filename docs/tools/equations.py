"""Where every equation of the paper is stated, tested, verified and practised.

    python3 docs/tools/equations.py            is docs/equations.md complete and up to date?
    python3 docs/tools/equations.py --update   write it; drops reasons why no exercise grades an
                                               equation once one does

The links come from tags in the sources, `Eq. (12)`, `Eqs. (5, 10)`, `Eqs. (3), (42)-(46)`:

- stated: a comment `// Eq. (12)` at the end of a statement of the two files of the solver; `[D1]`
  behind it names a section of docs/deviations.md,
- unit test: a tag inside a TEST_CASE, or in the comment lines directly above it,
- verified: the list `equations` of a case, verification/cases/*.toml,
- practised: the third argument of a check in exercises/*/checks.py, which is graded.

docs/tools/equations.toml has names and formulas, and the reasons of exceptions: an equation
that no statement carries, that several do, that no exercise grades. Everything else that is
missing, double, or names an equation that the paper does not have is an error. Exit code 0: good;
1: not.
"""
import argparse
import ast
import re
import sys
import tomllib
from pathlib import Path

from links import ROOT, anchors

TABLE = Path(__file__).with_name("equations.toml")
PAGE = ROOT / "docs/equations.md"
SOLVER = ("tinydem/tinydem.cpp", "tinydem/tinydem.hpp")

NUMBER = r"\(?\d+\)?"
TAG = re.compile(rf"\bEqs?\.\s*((?:\(\s*)?{NUMBER}(?:\s*(?:,|-|–|and|or|,\s*and)\s*{NUMBER})*)")


#: How the page introduces the exceptions of the table.
NOTES = {"unstated": "no statement", "repeated": "{statements} statements each",
         "unpractised": "no exercise"}

HEAD = """# Equations: stated, tested, verified, practised

Every equation of the paper, where the solver states it, which unit tests and verification cases
check it, and which exercises ask you to write it. Made from the tags in the sources by
`./dem docs --update`; a test fails when a link is missing, double, or no longer true.

Signs, factors and units are those of R. Vetter, Comput. Phys. Commun. (2025) 109942, with the slips
of the text repaired (Eqs. 26, 52); D1 to D3 are [deliberate deviations](deviations.md).
*.cpp* is [tinydem.cpp](../tinydem/tinydem.cpp), the last word of a test file stands for the file,
and the numbers behind a colon are lines.
"""


class Wrong(Exception):
    """Something that a tag or the table says and that cannot be."""


def numbers(text, last=60):
    """The equations that a text names, a sorted list; ranges are filled in."""
    found = set()
    for match in TAG.finditer(text):
        tokens = re.findall(r"\d+|[-–]", match[1])
        for k, token in enumerate(tokens):
            if not token.isdigit():
                continue
            low = high = int(token)
            if k > 1 and not tokens[k - 1].isdigit():
                low = int(tokens[k - 2])
            if not 1 <= low <= high <= last:
                raise Wrong(f"'{match[0]}' names an equation that the paper does not have")
            found.update(range(low, high + 1))
    return sorted(found)


def tagged(where, text):
    """`numbers`, but what is wrong comes with its place, e.g. "tests/test_motion.cpp:32"."""
    try:
        return numbers(text)
    except Wrong as what:
        raise Wrong(f"{where}: {what}") from None


def statements(root=ROOT):
    """[(equation, file, line number, deviation such as "D1" or "")] of the solver."""
    found = []
    for name in SOLVER:
        for number, line in enumerate((root / name).read_text().splitlines(), 1):
            code, _, comment = line.rpartition("//")
            if not code.strip() or code.rstrip().endswith("/") or code.lstrip().startswith("//"):
                continue  # no statement in front of the comment
            if re.match(r"\s*Eqs?\.", comment):
                deviation = re.search(r"\[(D\d+)\]", comment)
                found += [(equation, name, number, deviation[1] if deviation else "")
                          for equation in tagged(f"{name}:{number}", comment)]
    return found


def unit_tests(root=ROOT):
    """{equation: {(file, line number of the TEST_CASE, its name)}}."""
    found = {}
    for path in sorted((root / "tests").rglob("*.cpp")):
        name = str(path.relative_to(root))
        case, above = None, []
        for number, line in enumerate(path.read_text().splitlines(), 1):
            start = re.match(r'TEST_CASE\("(.*?)"', line)
            if start:
                case = (name, number, start[1])
                for equation in above:
                    found.setdefault(equation, set()).add(case)
            elif line.startswith("}"):
                case = None
            tags = tagged(f"{name}:{number}", line)
            if case:
                for equation in tags:
                    found.setdefault(equation, set()).add(case)
            above = above + tags if not case and line.startswith("//") else []
    return found


def cases(root=ROOT):
    """{equation: {(file, id, title)}} of the verification cases."""
    found = {}
    for path in sorted((root / "verification/cases").glob("*.toml")):
        for case in tomllib.loads(path.read_text())["case"]:
            entry = (str(path.relative_to(root)), case["id"], case["title"])
            for equation in case["equations"]:
                if not 1 <= equation <= 60:
                    raise Wrong(f"{entry[0]}: the paper has no Eq. ({equation})")
                found.setdefault(equation, set()).add(entry)
    return found


def exercises(root=ROOT):
    """{equation: {(README.md, number, title)}}: what the checks of the exercises grade."""
    found = {}
    for path in sorted((root / "exercises").glob("[0-9]*/checks.py")):
        tree = ast.parse(path.read_text())
        readme = path.with_name("README.md")
        title = readme.read_text().splitlines()[0].lstrip("# ")
        entry = (str(readme.relative_to(root)), path.parent.name[:2], title)
        for node in ast.walk(tree):
            if not isinstance(node, ast.Call) or getattr(node.func, "id", "") != "check":
                continue
            if len(node.args) > 2 and isinstance(node.args[2], ast.Constant):
                where = f"{path.relative_to(root)}:{node.lineno}"
                for equation in tagged(where, str(node.args[2].value)):
                    found.setdefault(equation, set()).add(entry)
    return found


def exceptions(table, kind):
    """{equation: entry} of [[kind]] in the table; entries have equations and a reason."""
    return {number: entry for entry in table.get(kind, ()) for number in entry["equations"]}


def faults(table, stated, tested, verified, practised, sections):
    """What is missing, double or has an old reason: a list of lines."""
    wrong, equations = [], table["equation"]
    unstated, repeated, unpractised = (exceptions(table, kind) for kind in
                                       ("unstated", "repeated", "unpractised"))
    if sorted(map(int, equations)) != list(range(1, 61)):
        wrong.append("equations.toml must have the equations 1 ... 60")
    for key, row in equations.items():
        number, name = int(key), f"Eq. ({key}), {row['name']}"
        count = sum(equation == number for equation, *_ in stated)
        allowed = repeated.get(number, {"statements": 1})["statements"]
        if count == 0 and number not in unstated:
            wrong.append(f"{name}: no statement of the solver carries its number; tag it, or say "
                         "why under [[unstated]] in equations.toml")
        if count > 0 and number in unstated:
            wrong.append(f"{name}: has a statement now; take it from [[unstated]]")
        if count != allowed and count > 0:
            where = ", ".join(f"{Path(file).name}:{line}" for equation, file, line, _ in stated
                              if equation == number)
            wrong.append(f"{name}: {count} statements carry its number ({where}), [[repeated]] in "
                         f"equations.toml explains {allowed}")
        if number not in tested:
            wrong.append(f"{name}: no unit test carries its number")
        if number not in verified:
            wrong.append(f"{name}: no verification case lists it")
        if number not in practised and number not in unpractised:
            wrong.append(f"{name}: no exercise grades it; say why under [[unpractised]]")
        if number in practised and number in unpractised:
            wrong.append(f"{name}: an exercise grades it now; take it from [[unpractised]]")
    for _, file, line, deviation in stated:
        if deviation and not any(anchor.startswith(deviation.lower()) for anchor in sections):
            wrong.append(f"{file}:{line}: docs/deviations.md has no section {deviation}")
    return wrong


def page(table, stated, tested, verified, practised, sections):
    """The text of docs/equations.md."""
    lines = HEAD.splitlines() + [""]
    rows = {int(key): row for key, row in table["equation"].items()}
    starts = [section["first"] for section in table["section"]] + [61]
    for section, first, end in zip(table["section"], starts, starts[1:]):
        lines += [f"## {section['title']}, ({first}) to ({end - 1})", "",
                  "| | equation | stated | unit tests | verified | practised |",
                  "|---|---|---|---|---|---|"]
        for number in range(first, end):
            row = rows[number]
            code = [f"[{file[-4:]}:{line}](../{file}#L{line})" +
                    (f" [{deviation}](deviations.md#" +
                     next(a for a in sorted(sections) if a.startswith(deviation.lower())) + ")"
                     if deviation else "")
                    for equation, file, line, deviation in stated if equation == number]
            tests = [f"[{Path(file).stem.split('_')[-1]}:{line}](../{file}#L{line})"
                     for file, line, _ in sorted(tested.get(number, ()))]
            proofs, tasks = ([f"[{name[:2]}](../{file})" for file, name, _ in
                              sorted(links.get(number, ()))] for links in (verified, practised))
            lines.append(f"| ({number}) | {row['name']}<br>${row['formula']}$ | " + " | ".join(
                ", ".join(cell) or "–" for cell in (code, tests, proofs, tasks)) + " |")
        lines.append("")
        for kind, what in NOTES.items():
            for entry in table.get(kind, ()):
                these = [number for number in entry["equations"] if first <= number < end]
                if these:
                    lines.append(f"- ({'), ('.join(map(str, these))}), {what.format(**entry)}: "
                                 f"{entry['reason']}.")
        if lines[-1]:
            lines.append("")
    lines += ["## The cases and exercises", "", "| verification | |", "|---|---|"]
    for file, name, title in sorted(set().union(*verified.values())):
        lines.append(f"| [{name[:2]}](../{file}) | {title} |")
    lines += ["", "| exercise | |", "|---|---|"]
    for file, name, title in sorted(set().union(*practised.values())):
        lines.append(f"| [{name}](../{file}) | {title.removeprefix(name).strip()} |")
    return "\n".join(lines) + "\n"


def made(root=ROOT):
    """(faults, text of the page). Raises Wrong for a tag that cannot be."""
    table = tomllib.loads(TABLE.read_text())
    sections = anchors((root / "docs/deviations.md").read_text())
    links = statements(root), unit_tests(root), cases(root), exercises(root)
    wrong = faults(table, *links, sections)
    return wrong, "" if wrong else page(table, *links, sections)


def drop_old_reasons(text, practised):
    """equations.toml without the reasons for equations that an exercise grades by now."""
    def one(entry):
        left = [n for n in map(int, re.findall(r"\d+", entry[1])) if n not in practised]
        return entry[0].replace(entry[1], ", ".join(map(str, left))) if left else ""
    return re.sub(r"\[\[unpractised\]\]\nequations = \[(.*)\]\nreason = .*\n", one, text)


def main():
    """The program; see the top of this file."""
    arguments = argparse.ArgumentParser(description="Make or check docs/equations.md.")
    arguments.add_argument("--update", action="store_true", help="write it")
    update = arguments.parse_args().update
    try:
        if update:
            TABLE.write_text(drop_old_reasons(TABLE.read_text(), exercises()))
        wrong, text = made()
    except Wrong as what:
        wrong, text = [str(what)], ""
    if not wrong and update:
        PAGE.write_text(text)
    elif not wrong and (not PAGE.exists() or PAGE.read_text() != text):
        wrong = ["docs/equations.md is not what the sources say; ./dem docs --update writes it"]
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

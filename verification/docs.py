#!/usr/bin/env python3
"""Numbers and figures of the documentation that the verification measured.

    docs.py            write them anew: numbers from cases/*.toml, tables and figures from report/
    docs.py --check    only look, at what needs no report; exit code 1 when something is stale

In README.md and docs/*.md a number is followed by what it comes from, in a comment that no reader
sees: `0.8 %<!-- 08_oblique.elastic_dt0 -->`, or an expression of metrics, `<!-- 1 - 09_ ... -->`.
It keeps its number of digits. Between `<!-- steps: CASE ... -->` and `<!-- end of steps -->` stands
a table of the largest steps for an error. docs/images/NAME.png is a copy of report/NAME.png, in few
colours, for every NAME that the documentation shows and the report has. Between `<!-- measured -->`
and `<!-- end of measured -->` every number in a column of a table but the first must have a source;
links and `code` are no numbers.
"""
import argparse
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
ROOT = HERE.parent
RAISED = dict(zip("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
NUMBER = r"[-−]?\d+(?:\.\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?(?: ?%)?"
SOURCED = re.compile(rf"({NUMBER})(<!-- ([^>]*?[a-z]\w*\.\w+[^>]*?) -->)")
METRIC = re.compile(r"\b(\d\d_\w+)\.(\w+)\b")
STEPS = re.compile(r"(<!-- steps: ([\w ]+) -->\n)(.*?)(<!-- end of steps -->)", re.S)
MEASURED = re.compile(r"<!-- measured -->\n(.*?)<!-- end of measured -->", re.S)
IMAGE = re.compile(r"\((?:docs/)?images/(\w+\.png)\)")
COLOURS = 64  # of a figure: a third of its size, and nothing to be seen


def measured(cases):
    """{case: {metric: measured value}}"""
    return {c["id"]: {m["name"]: m["measured"] for m in c["metric"]} for c in cases}


def evaluate(expression, values):
    """The value of an expression of numbers and metrics; KeyError for an unknown metric."""
    numbers = METRIC.sub(lambda m: repr(float(values[m[1]][m[2]])), expression)
    if not re.fullmatch(r"[-+*/(). \de]+", numbers):
        raise ValueError(f"'{expression}' is no expression of metrics")
    return eval(numbers, {"__builtins__": {}})  # numbers and arithmetic only, see above


def written(value, like):
    """A value in the form of the text `like`: as many digits, percent or powers of ten."""
    mantissa, _, power = like.rstrip(" %").partition("·10")
    decimals = len(mantissa.partition(".")[2])
    if power:
        digits, exponent = f"{value:.{decimals}e}".split("e")
        text = f"{digits}·10" + "".join(RAISED[c] for c in str(int(exponent)))
    elif like.endswith("%"):
        text = f"{100 * value:.{decimals}f}" + (" %" if " %" in like else "%")
    else:
        text = f"{value:.{decimals}f}"
    return text.replace("-", "−") if "−" in like else text


def renewed(text, values, where, problems):
    """The text with its sourced numbers as they are now; problems: what has no metric."""
    def number(match):
        try:
            return written(evaluate(match[3], values), match[1]) + match[2]
        except (KeyError, ValueError, SyntaxError, ZeroDivisionError) as error:
            problems.append(f"{where}: {match[0]}: {type(error).__name__} {error}")
            return match[0]
    return SOURCED.sub(number, text)


def bare_numbers(text, where):
    """Complaints about numbers without a source in the tables of measured values."""
    for block in MEASURED.findall(text):
        rows = [line for line in block.splitlines() if line.startswith("|")][2:]
        for row in rows:
            for cell in row.strip("|").split("|")[1:]:
                rest = re.sub(r"`[^`]*`|\[.*?\]\(.*?\)", "", SOURCED.sub("", cell))
                if re.search(r"\d", rest):
                    yield f"{where}: a number without a source: {cell.strip()}"


def steps_table(ids, cases):
    """Markdown: the largest step [Eq. (50)] for an error of 1 % and 0.1 %, scheme by scheme."""
    import report
    known = {c["id"]: c for c in cases}
    works = report.load_work(cases, HERE / "report")
    levels = (0.01, 0.001)
    lines = ["| case | " + " | ".join(f"{s}, {100 * e:g} %" for e in levels
                                      for s in report.SCHEMES) + " |", "|---|" + "---|" * 4]
    for i in ids:
        found = [report.reach(works[i], s, e) for e in levels for s in report.SCHEMES]
        cells = [("≥ " if f[2] else "") + f"{f[0]:.2g}" if f else "never" for f in found]
        lines.append(f"| {int(i[:2])} {known[i]['title']} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def copy_image(name, folder):
    """A figure of the report in few colours."""
    from PIL import Image
    picture = Image.open(HERE / "report" / name).convert("RGB")
    picture.quantize(COLOURS, dither=Image.Dither.NONE).save(folder / name, optimize=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="change nothing; needs no report")
    parser.add_argument("pages", nargs="*", type=Path, help="default: README.md and docs/*.md")
    args = parser.parse_args()
    import verify
    cases = verify.load_cases()
    values, problems, numbers = measured(cases), [], 0
    figures = {Path(figure).stem for case in cases for figure in case["figures"]}
    for page in args.pages or [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        old = page.read_text()
        new = renewed(old, values, page.name, problems)
        numbers += len(SOURCED.findall(old))
        problems += bare_numbers(old, page.name)
        for words in STEPS.findall(old):
            problems += [f"{page.name}: there is no case {i}" for i in words[1].split()
                         if i not in values]
        if not args.check:
            new = STEPS.sub(lambda m: m[1] + steps_table(m[2].split(), cases) + m[4], new)
        for name in sorted(set(IMAGE.findall(old))):
            if not args.check and (HERE / "report" / name).exists():
                copy_image(name, ROOT / "docs" / "images")
            if not (ROOT / "docs" / "images" / name).exists():
                problems.append(f"{page.name}: docs/images/{name} is missing")
            if name[:2].isdigit() and name[:-4] not in figures:
                problems.append(f"{page.name}: no case draws {name}")
        if new != old and args.check:
            problems += [f"{page.name}: stale: {a.strip()}" for a, b in
                         zip(old.splitlines(), new.splitlines()) if a != b]
        elif new != old:
            page.write_text(new)
            print(f"{page.name}: renewed")
    print("\n".join(problems) or f"{numbers} measured numbers, all as in the tables of cases")
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()

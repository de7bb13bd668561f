"""Tables of parameters and symbols: docs/symbols.md, and the one in README.md.

    python3 docs/tools/symbols.py            are they up to date?
    python3 docs/tools/symbols.py --update   write them

The parameters, their defaults, ranges and meanings come from the table in tinydem.hpp that the
solver itself uses, for `--help` as well. symbols.toml adds the paper's symbols, and explains the
members of structs of the contact law. A member without an explanation, an explanation without a
member, and a statement that does not stand once in its file are errors. Exit code 0: good; 1: not.
"""
import argparse
import ast
import re
import sys
import tomllib
from pathlib import Path

from links import ROOT

TABLE = Path(__file__).with_name("symbols.toml")
PAGE = ROOT / "docs/symbols.md"
README = ROOT / "README.md"
HEADER = "tinydem/tinydem.hpp"

HEAD = """# Symbols

Which letter of the paper is which name in the code. Made by `./dem docs --update` from the table of
parameters in [tinydem.hpp](../tinydem/tinydem.hpp), which is also what `tinydem --help` prints, and
from [symbols.toml](tools/symbols.toml); a test fails when a name is missing, old or unexplained.
Units only have to be consistent: M mass, L length, T time; – stands for none.

## Parameters

Every one is an option of the program, `--Rmin 0.002`, and a line of a scene file, `Rmin = 0.002`.
"""


class Wrong(Exception):
    """A table that does not fit the sources."""


def short(value):
    """A number in few digits that mean the same number: 0.002, 1e6."""
    text = f"{value:g}"
    return (text if float(text) == value else repr(value)).replace("e+0", "e")


def parameters(root=ROOT):
    """[{name, kind, default, unit, range, help}] from the table in tinydem.hpp, texts as --help
    prints them."""
    text = (root / HEADER).read_text()
    body = text[text.index("#define TINYDEM_PARAMETERS(X)"):]
    body = re.sub(r"\\\n", " ", body[:re.search(r"[^\\]\n", body).start() + 1])
    body = re.sub(r'"\s+"', "", body)  # texts over several lines
    found = []
    for entry in re.findall(r'X\((\w+, \w+, .*?, "[^"]*", "[^"]*",\s*"[^"]*")\)', body):
        name, kind, default, *words = re.match(
            r'(\w+), (\w+), (.*), "([^"]*)", "([^"]*)",\s*"([^"]*)"$', entry).groups()
        values = default.strip("()").partition("{")[2].rstrip("}") or default
        if default == "unset":
            values = ""
        elif default.startswith('"'):
            values = ast.literal_eval(default)
        else:
            values = ",".join(short(float(value)) for value in values.split(","))
        found.append(dict(zip(("name", "kind", "default", "unit", "range", "help"),
                              (name, kind, values, *words))))
    if len(found) != body.count("X("):
        raise Wrong(f"{HEADER}: only {len(found)} of {body.count('X(')} parameters can be read")
    return found


def members(root, file, struct):
    """{name: line} of the members of a struct without functions."""
    text = (root / file).read_text()
    start = re.search(rf"\bstruct {struct} (: [\w<>]+ )?\{{", text)
    if not start:
        raise Wrong(f"{file}: there is no struct {struct}")
    depth, end = 1, start.end()
    while depth:
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
    code = re.sub(r"//[^\n]*|\{[^{}]*\}", lambda blank: " " * len(blank[0]),
                  text[start.end():end - 1])
    found, place = {}, 0
    for declaration in code.split(";"):
        for name in re.finditer(r"(\w+)\s*(?=,|$)", re.sub(r"<[^>]*>", lambda t: "." * len(t[0]),
                                                          declaration.rstrip())):
            line = text.count("\n", 0, start.end() + place + name.start()) + 1
            found[name[1]] = line
        place += len(declaration) + 1
    return found


def dimension(unit):
    """A dimension as the pages write it: M/L³, – for none."""
    return "–" if unit == "-" else unit.replace("^2", "²").replace("^3", "³")


def readable(interval, table):
    """A range as the README writes it: > 0, ≥ R_min, any."""
    low, high = re.fullmatch(r"[\[(](.*), (.*)[\])]", interval).groups() \
        if re.fullmatch(r"[\[(].*, .*[\])]", interval) else (None, None)
    if low is None:
        return interval.replace("|", ", ")
    if high != "inf":
        return interval
    name = table.get(low, {}).get("text", low)
    return "any" if low == "-inf" else ("> " if interval[0] == "(" else "≥ ") + name


def rows(root, table, latex):
    """The lines of a table of parameters; README.md has symbols as text and no file names."""
    lines = []
    for entry in parameters(root):
        more = table.get(entry["name"], {})
        if more.get("file") and not latex:
            continue
        symbol = f"${more['latex']}$" if latex and "latex" in more else \
            "" if latex else more.get("text", "")
        meaning = more.get("meaning", entry["help"])
        if "remark" in more:
            link = more["remark"] if latex else more["remark"].replace("](", "](docs/")
            meaning += ("" if link.startswith("and ") else ";") + " " + link
        default = more.get("default", entry["default"]) or "none"
        option = f"`--{entry['name']}`" if not more.get("file") else f"`{entry['name']}`"
        limits = more.get("range") or readable(entry["range"], table)
        lines.append(f"| {symbol} | {option} | {default} | {limits} | "
                     f"{dimension(entry['unit'])} | {meaning} |".replace("|  |", "| |", 1))
    return lines


def page(root, table):
    """The text of docs/symbols.md."""
    lines = HEAD.splitlines() + [""]
    lines += ["| symbol | option | default | range | dimension | meaning |",
              "|---|---|---|---|---|---|"]
    lines += [row.replace("see below", "see [README](../README.md#parameters)")
              for row in rows(root, table["parameter"], latex=True)]
    for group in table["group"]:
        file = group["file"]
        lines += ["", f"## {group['title']}", ""]
        if "struct" in group:
            found = members(root, file, group["struct"])
            symbols = group["symbol"]
            if set(found) != set(symbols):
                raise Wrong(f"symbols.toml and struct {group['struct']} of {file} differ in "
                            f"{', '.join(sorted(set(found) ^ set(symbols)))}")
            entries = [(found[name], name, *symbols[name]) for name in found]
            lines.append(f"{group['text']} `struct {group['struct']}` in "
                         f"[{Path(file).name}](../{file}#L{min(found.values())}).")
        else:
            text, entries = (root / file).read_text(), []
            for code, (name, *words) in group["code"].items():
                if text.count(code) != 1:
                    raise Wrong(f"symbols.toml: '{code}' stands {text.count(code)} times in {file}")
                entries.append((text.count("\n", 0, text.index(code)) + 1, name, *words))
            lines.append(group["text"])
        many = "struct" not in group  # places
        lines += ["", f"| symbol | name |{' line |' * many} dimension | meaning |",
                  "|---|---|---|---|" + "---|" * many]
        for line, name, latex, unit, meaning in entries:
            symbol = f" ${latex}$" if latex else ""
            place = f" [{line}](../{file}#L{line}) |" * many
            lines.append(f"|{symbol} | `{name}` |{place} {unit} | {meaning} |")
    return "\n".join(lines) + "\n"


def readme(root, table):
    """The README with a new table of parameters."""
    text = (root / "README.md").read_text()
    old = re.search(r"(\| symbol \| option \|[^\n]*\n\|[-|]+\|\n)((?:\|[^\n]*\n)+)", text)
    if not old:
        raise Wrong("README.md: there is no table that begins with | symbol | option |")
    return text[:old.end(1)] + "\n".join(rows(root, table, latex=False)) + "\n" + text[old.end(2):]


def made(root=ROOT):
    """{path: text} of the two pages. Raises Wrong."""
    table = tomllib.loads(TABLE.read_text())
    names = {entry["name"] for entry in parameters(root)}
    unknown = set(table["parameter"]) - names
    if unknown:
        raise Wrong(f"symbols.toml: there is no parameter {', '.join(sorted(unknown))}")
    return {root / "docs/symbols.md": page(root, table),
            root / "README.md": readme(root, table["parameter"])}


def main():
    """The program; see the top of this file."""
    arguments = argparse.ArgumentParser(description="Make or check the tables of symbols.")
    arguments.add_argument("--update", action="store_true", help="write them")
    update, wrong = arguments.parse_args().update, []
    try:
        for path, text in made().items():
            if update:
                path.write_text(text)
            elif not path.exists() or path.read_text() != text:
                wrong.append(f"{path.relative_to(ROOT)}: a table is not what the sources say; "
                             "./dem docs --update writes it")
    except Wrong as what:
        wrong = [str(what)]
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

"""Every command and code block of the documentation is run, or says why not.

The blocks of a page run one after the other in a copy of the repository, each from its root. What
happens depends on the word behind the three backticks:

    sh      run with `sh -e`; docs_commands.py says which commands are cut short or only checked
    python  run, with the folders tinydem and exercises on the path
    cpp     a program with a main() must compile
    ini     a scene file: the solver runs it for a few steps
    off     a mesh, and
    csv     particles: the solver reads them
    json, toml   must be well formed
    diff    changes the copy: the lines with ' ' and '-' must stand once in the file behind `+++ b/`
    math    a formula, not run
    text, or nothing   output or a drawing, not run; a command in it is a mistake

A comment on the line above a block changes that:

    <!-- test: file NAME -->           the block is written to NAME in the copy; a program or script
                                       is not run, the next sh block can do that
    <!-- test: excerpt FILE -->        the block must stand in FILE, but for indentation
    <!-- test: insert FILE after X --> the block is inserted in FILE of the copy, below the one line
                                       that contains X; sh blocks then see the changed file
    <!-- test: output -->              what the sh block before must have printed; ... is any text
    <!-- test: paths -->               the first word of every line is a file or folder
    <!-- test: skip REASON -->         not run

A block without a rule is an error in README.md and docs/; on other pages, blocks of cpp and python
without a marker are not run.  By hand, for one page:

    cd tests && TINYDEM=../build/default/tinydem DOCS=README.md python3 -m unittest -v test_docs
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "docs/tools"))
from links import markdown_files  # noqa: E402

COMMANDS = Path(__file__).with_name("docs_commands.py")
STANDINS = ("tinydem", "g++", "clang++", "apt", "apt-get", "sudo", "dnf", "brew", "conda", "cmake",
            "ctest", "git", "lmp", "paraview")
#: Beginnings of lines that are commands, and so belong into a block of sh.
COMMAND = re.compile(r"\s*(\$ |\./dem |sudo |apt |apt-get |g\+\+ |cmake |ctest |python3 |cd )")
TIMEOUT = 120  # s, for one block; a block takes some tenths of a second


class Fault(Exception):
    """A block that does not do what the page promises."""


class Block:
    """A fenced block: page and line (from 1) of its fence, language, marker, text."""

    def __init__(self, page, line, language, marker, text):
        self.page, self.line, self.language = page, line, language
        self.marker, self.text = marker, text


def blocks(page, text):
    """All blocks of a Markdown text, in order."""
    found, fence, marker = [], None, ""
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r"(\s*)(`{3,}|~{3,})\s*(\w*)", line)
        comment = re.match(r"\s*<!--\s*test:\s*(.*?)\s*-->\s*$", line)
        if fence and mark and mark[2].startswith(fence[0]) and not mark[3]:
            found.append(Block(page, fence[1], fence[2], marker, "".join(fence[3])))
            fence, marker = None, ""
        elif fence:
            fence[3].append(line.removeprefix(fence[4]) + "\n")
        elif mark:
            fence = (mark[2], number, mark[3], [], mark[1])
        elif comment:
            marker = comment[1]
        elif line.strip():
            marker = ""
    return found


def stripped(text):
    """The lines of a text without indentation and without what is blank."""
    return [line.strip() for line in text.splitlines() if line.strip()]


class Copy:
    """A copy of the repository in which the blocks of one page run."""

    def __init__(self, folder, program):
        self.root = Path(folder).resolve() / "tinydem-docs"
        self.log = Path(folder) / "log"
        self.log.touch()
        shutil.copytree(ROOT, self.root, ignore=self.skipped)
        (self.root / "dem").rename(self.root / "dem.real")
        commands = self.root.parent / "commands"
        commands.mkdir()
        for name in STANDINS:
            self.stand_in(commands / name, name)
        self.stand_in(self.root / "dem", "dem")
        (self.root / "build/default").mkdir(parents=True)
        self.stand_in(self.root / "build/default/tinydem", "tinydem")
        self.program(commands / "python3", f'"{sys.executable}"')
        self.environment = {
            **os.environ, "PATH": f"{commands}:{os.environ['PATH']}", "HOME": str(self.root),
            "TINYDEM": str(Path(program).resolve()), "DOCS_COPY": str(self.root),
            "DOCS_LOG": str(self.log), "MPLBACKEND": "Agg", "PYTHONDONTWRITEBYTECODE": "1",
            "PYTHON": sys.executable, "LC_ALL": "C.UTF-8",
            "PYTHONPATH": f"{self.root / 'tinydem'}:{self.root / 'exercises'}"}
        for name in ("g++", "clang++", "ctest"):
            self.environment["DOCS_REAL_" + name.upper().replace("+", "P")] = \
                shutil.which(name) or ""
        self.printed = ""  # by the last block of sh

    @staticmethod
    def skipped(folder, names):
        """What a clone would not have."""
        inside = Path(folder) == ROOT
        return [name for name in names if name in (".git", "__pycache__", "report") or
                inside and name in ("build", "output")]

    @staticmethod
    def program(path, command):
        """Writes a program that runs a command with its arguments."""
        path.write_text(f'#!/bin/sh\nexec {command} "$@"\n')
        path.chmod(0o755)

    def stand_in(self, path, name):
        """Writes a program that leaves a command to docs_commands.py."""
        self.program(path, f'"{sys.executable}" "{COMMANDS}" {name}')

    def run(self, *words, text=None):
        """Runs a command from the root of the copy; what it prints. Fault unless it succeeds."""
        try:
            done = subprocess.run(words, input=text, cwd=self.root, env=self.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            raise Fault(f"takes more than {TIMEOUT} s; mark it with `skip REASON`") from None
        if done.returncode != 0:
            raise Fault(f"exit code {done.returncode}:\n{done.stdout}")
        return done.stdout

    def inside(self, name):
        """The path of a file of the copy."""
        path = (self.root / name).resolve()
        if not path.is_relative_to(self.root):
            raise Fault(f"{name} leaves the copy of the repository")
        return path

    # ------------------------------------------------------------------------------- languages

    def sh(self, block):
        """Run; the commands of docs_commands.py are cut short. Failures before `&&` count."""
        self.printed = self.run("sh", "-e", "-c", block.text.replace(" && ", " ; "))

    bash = sh

    def python(self, block):
        """Run from the standard input."""
        self.run(sys.executable, "-", text=block.text)

    def cpp(self, block):
        """Compile, if it is a program."""
        if not re.search(r"\bmain\(", block.text):
            raise Fault("is part of a program; say what it is: <!-- test: excerpt FILE -->, "
                        "insert FILE after X, or skip REASON")
        path = self.root / "block.cpp"
        path.write_text(block.text)
        self.run("g++", "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Itinydem",
                 "-Iexercises/include", str(path))

    def read(self, *words):
        """Lets the solver read files and take a few steps."""
        self.run("tinydem", *words, "--overwrite", "--quiet")

    def ini(self, block):
        """A scene: run it for a few steps."""
        path = self.written or self.root / "block.ini"
        path.write_text(block.text)
        self.read("", "", "output/block", "--scene", str(path))

    def off(self, block):
        """A mesh that the solver reads."""
        path = self.written or self.root / "block.off"
        path.write_text(block.text)
        self.read(str(path), "", "output/block")

    def csv(self, block):
        """Particles that the solver reads."""
        path = self.written or self.root / "block.csv"
        path.write_text(block.text)
        self.read("", str(path), "output/block", "--Nspawn", "0")

    def json(self, block):
        """Well formed."""
        json.loads(block.text)

    def toml(self, block):
        """Well formed."""
        tomllib.loads(block.text)

    def diff(self, block):
        """Changes the copy; line numbers do not matter."""
        path, old, new = None, [], []
        for line in [*block.text.splitlines(), "@@"]:
            if line.startswith("@@") or line.startswith("--- ") or line.startswith("+++ "):
                if old or new:
                    self.replace(path, "".join(old), "".join(new))
                old, new = [], []
                if line.startswith("+++ "):
                    path = self.inside(line[4:].removeprefix("b/"))
                continue
            if line[:1] in (" ", "-", ""):
                old.append(line[1:] + "\n")
            if line[:1] in (" ", "+", ""):
                new.append(line[1:] + "\n")

    def replace(self, path, old, new):
        """Replaces a text of a file that stands there once."""
        text = path.read_text()
        if text.count(old) != 1:
            raise Fault(f"these lines stand {text.count(old)} times in {path.name}:\n{old}")
        path.write_text(text.replace(old, new))

    def math(self, block):
        """A formula."""

    def text(self, block):
        """Output, or a drawing: no commands."""
        for line in block.text.splitlines():
            if COMMAND.match(line):
                raise Fault(f"'{line.strip()}' is a command; make it a block of sh")

    # --------------------------------------------------------------------------------- markers

    written = None

    def do(self, block, strict=True):
        """Does what the language and the marker of a block ask for."""
        what, _, rest = block.marker.partition(" ")
        language = block.language or "text"
        if not block.text.strip():
            raise Fault("is empty")
        if what and not hasattr(self, "mark_" + what):
            raise Fault(f"there is no marker '{what}'")
        if what:
            return getattr(self, "mark_" + what)(block, rest)
        if language not in ("sh", "bash", "python", "cpp", "ini", "off", "csv", "json", "toml",
                            "diff", "math", "text"):
            raise Fault(f"there is no rule for a block of '{language}'")
        if strict or language not in ("cpp", "python"):
            self.written = None
            getattr(self, language)(block)

    def mark_skip(self, block, reason):
        """Not run; the reason is printed."""
        if len(reason.split()) < 2:
            raise Fault("a block that is skipped needs a reason: <!-- test: skip REASON -->")
        with open(self.log, "a") as log:
            log.write(f"block of {block.language or 'text'}: {reason}\n")

    def mark_file(self, block, name):
        """Written into the copy."""
        self.written = self.inside(name)
        self.written.parent.mkdir(parents=True, exist_ok=True)
        self.written.write_text(block.text)
        if block.language in ("ini", "off", "csv", "json", "toml"):
            getattr(self, block.language)(block)
        if block.language == "python":
            compile(block.text, name, "exec")

    def mark_excerpt(self, block, name):
        """Part of a file."""
        whole, part = stripped((ROOT / name).read_text()), stripped(block.text)
        if not any(whole[k:k + len(part)] == part for k in range(len(whole))):
            raise Fault(f"does not stand in {name} (any more)")

    def mark_insert(self, block, rest):
        """Inserted into a file of the copy."""
        name, _, text = rest.partition(" after ")
        path = self.inside(name)
        lines = path.read_text().splitlines(keepends=True)
        places = [k for k, line in enumerate(lines) if text.strip() in line]
        if not text or len(places) != 1:
            raise Fault(f"'{text}' stands in {len(places)} lines of {name}, it must be one")
        lines.insert(places[0] + 1, block.text)
        path.write_text("".join(lines))

    def mark_output(self, block, rest):
        """What the block of sh before has printed."""
        printed = " ".join(self.printed.split())
        for line in stripped(block.text):
            parts = [re.escape(" ".join(part.split())) for part in line.split("...")]
            if not re.search(r"\s?.*?\s?".join(parts), printed):
                raise Fault(f"'{line}' was not printed; it was:\n{self.printed}")

    def mark_paths(self, block, rest):
        """A map of the repository."""
        for line in stripped(block.text):
            if not (ROOT / line.split()[0].rstrip(",")).exists():
                raise Fault(f"there is no {line.split()[0]}")


def faults(page, text, copy, strict=True):
    """Lines page:line: what is wrong, after all blocks of a text were done in a copy."""
    wrong = []
    for block in blocks(page, text):
        try:
            copy.do(block, strict)
        except (Fault, ValueError, OSError, SyntaxError) as what:
            wrong.append(f"{page}:{block.line}: {what}")
    return wrong


class InCopies(unittest.TestCase):
    """Tests that need copies of the repository."""

    def copy(self):
        """A fresh one, gone after the test."""
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        return Copy(holder.name, os.environ["TINYDEM"])


class Pages(InCopies):
    """The pages of the repository."""

    def test_every_block_of_every_page(self):
        seen, shared = 0, self.copy()
        for path in markdown_files():
            page, text = str(path.relative_to(ROOT)), path.read_text()
            if os.environ.get("DOCS", page) != page or not blocks(page, text):
                continue
            strict = page == "README.md" or page.startswith("docs/")
            seen += len(blocks(page, text))
            with self.subTest(page=page):
                copy = self.copy() if strict else shared
                wrong = faults(page, text, copy, strict)
                for line in copy.log.read_text().splitlines():
                    print(f"{page}: {line}")
                copy.log.write_text("")
                self.assertEqual(wrong, [], "\n" + "\n".join(wrong))
        self.assertGreater(seen, 0)


class Rules(InCopies):
    """A block that does not do what it promises is noticed."""

    def faults(self, copy, *page):
        """What is wrong with lines of a page, as one text."""
        return "\n".join(faults("page", "\n".join(page) + "\n", copy))

    def test_broken_blocks_are_faults(self):
        copy = self.copy()
        for language, text, marker, said in (
                ("sh", "./dem vreify", "", "no verb vreify"),
                ("sh", "./dem verify 99", "", "no 99"),
                ("sh", "./dem grade 01 --wacth", "", "no option --wacth"),
                ("sh", "./dem run hourglas", "", "no scene hourglas"),
                ("sh", "./dem run hourglass --musss 1", "", "mus"),
                ("sh", "./dem run billiard --full", "", "no full.ini"),
                ("sh", "sudo apt install libeigen4-dev", "", "libeigen4-dev"),
                ("sh", "cmake --preset fast", "", "no preset fast"),
                ("sh", "g++ -std=c++71 -o tinydem tinydem/tinydem.cpp", "", "c++71"),
                ("sh", "tinydem --mus -1", "", "mus = '-1'"),
                ("sh", "nosuchprogram", "", "nosuchprogram"),
                ("sh", "cd nosuchfolder && true\ntrue", "", "nosuchfolder"),
                ("text", " ", "", "is empty"),
                ("python", "import nosuchmodule", "", "nosuchmodule"),
                ("cpp", "int x;", "", "part of a program"),
                ("cpp", "int main() { return y; }", "", "not declared in this scope"),
                ("ini", "mus = -1", "", "mus"),
                ("off", "OFF\n1 0 0\n0 0\n", "", "z = ''"),
                ("csv", "x,y,z\n1,2,3\n", "", "column"),
                ("json", "{", "", "page:2"),
                ("toml", "a =", "", "page:2"),
                ("diff", "+++ b/LICENSE\n@@\n-not in the licence\n+new", "", "0 times"),
                ("text", "./dem test", "", "is a command"),
                ("", "$ ls", "", "is a command"),
                ("fortran", "end", "", "no rule"),
                ("sh", "true", "skip", "needs a reason"),
                ("sh", "true", "skpi it is slow", "no marker"),
                ("cpp", "int not_there;", "excerpt tinydem/tinydem.cpp", "does not stand in"),
                ("cpp", "int x;", "insert LICENSE after not there", "0 lines"),
                ("text", "nosuch.md   a file", "paths", "no nosuch.md"),
                ("text", "a", "file ../../outside", "leaves the copy")):
            with self.subTest(text=text, marker=marker):
                comment = f"<!-- test: {marker} -->" if marker else ""
                self.assertIn(said, self.faults(copy, comment, f"```{language}", text, "```"))
        self.assertIn("was not printed", self.faults(
            copy, "```sh", "echo seven steps", "```", "<!-- test: output -->", "```", "eight ...",
            "```"))

    def test_good_blocks_pass(self):
        self.assertEqual("", self.faults(
            self.copy(), "```sh", "# a comment", "./dem run billiard --mus 0.2 --Nframes 500",
            "ls output/billiard/particles000002.csv", "! ls output/billiard/particles000003.csv",
            "cd tinydem", "g++ -std=c++17 -O3 -fopenmp -o tinydem tinydem.cpp",
            "./tinydem --version", "```",
            "<!-- test: output -->", "```", "frame 0/2 ... N = ...", "```",
            "<!-- test: file a.py -->", "```python", "print(6 * 7)", "```",
            "- a list", "  ```sh", "  python3 a.py", "  ```",
            "<!-- test: output -->", "```", "42", "```",
            "```diff", "+++ b/LICENSE", "@@ -1 +1 @@", "+A line", " BSD 3-Clause License", "```",
            "```sh", "head -n 1 LICENSE", "```", "<!-- test: output -->", "```", "A line", "```",
            "<!-- test: insert LICENSE after A line -->", "```text", "Another", "```",
            "```sh", "grep Another LICENSE", "sudo apt install g++", "./dem test -R docs",
            "cmake --preset default", "```",
            "```cpp", '#include "tinydem.hpp"',
            "int main() { return tinydem::count(tinydem::Reals()); }",
            "```"))

    def test_blocks_and_markers_are_found(self):
        found = blocks("p", "<!-- test: skip it -->\n\n```sh\na\n```\ntext\n~~~\n```\n~~~\n")
        self.assertEqual([(b.line, b.language, b.marker, b.text) for b in found],
                         [(3, "sh", "skip it", "a\n"), (7, "", "", "```\n")])


if __name__ == "__main__":
    unittest.main()

"""Links of the documentation: between its pages, from equations to code, tests and cases, from
symbols to code."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1] / "docs/tools"
sys.path.insert(0, str(TOOLS))
import equations  # noqa: E402
import links  # noqa: E402
import make_site  # noqa: E402
import symbols  # noqa: E402


class Folder(unittest.TestCase):
    """A folder that is gone after the test."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = Path(holder.name).resolve()

    def write(self, **files):
        """Writes files: a__b_md="text" is a/b.md."""
        for name, text in files.items():
            name, _, kind = name.replace("__", "/").rpartition("_")
            path = self.root / f"{name}.{kind}"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)


class Markdown(Folder):
    """The link checker finds what is broken, and nothing else."""

    def faults(self, **files):
        self.write(**files)
        return links.check_markdown(self.root)

    def test_the_repository_has_no_broken_link(self):
        faults, count = links.check_markdown()
        self.assertEqual(faults, [])
        self.assertGreater(count, 500)

    def test_every_kind_of_broken_link_is_reported_with_its_line(self):
        page = "\n".join([
            "[a](missing.md)", "![b](missing.png)", "[c](#nowhere)", "[d](docs/other.md#nowhere)",
            "[e](code.cpp#L4)", "[f](Docs/other.md)", "[g](docs#heading)", "[h](/etc/passwd)",
            "[i](../outside.md)", "[j](ftp://host/file)", "[k][undefined]", "[l](code.cpp#main)",
            "[![m](missing.gif)](code.cpp)", "<img src='missing.svg'>", "[n]: missing.txt",
            "[o](code.cpp \"title\") [p](missing(1).md)"])
        faults, _ = self.faults(page_md=page, docs__other_md="# Heading\n", code_cpp="1\n2\n3\n")
        self.assertEqual([int(fault.split(":")[1]) for fault in faults], list(range(1, 17)), faults)

    def test_good_links_pass(self):
        page = "\n".join([
            "# Two `words`, *here*", "## Twice", "## Twice", "[a](#two-words-here) [b](#twice-1)",
            "[c](docs/other.md#a-heading) ![d](docs/x.png) [e](code.cpp#L2-L3) [f](docs)",
            "[g](https://doi.org/10.1016/j.cpc.2025.109942) <https://a.b> [h][where]",
            "`[i](missing.md)`", "```sh", "[j](missing.md)", "# no heading", "```",
            "[where]: docs/other.md", "u[i][j] is no link, [k] neither"])
        faults, count = self.faults(page_md=page, docs__other_md="A [link](../page.md).\n\n"
                                    "# A heading\n", docs__x_png="", code_cpp="1\n2\n3\n",
                                    build__made_md="[x](missing.md)")
        self.assertEqual(faults, [])
        self.assertEqual(count, 10)

    def test_anchors_are_those_of_github(self):
        text = "# D1: when the spring advances, Eq. (53)\n# `--scheme` & *co*\n# ρ, μ_s\n"
        self.assertEqual(links.anchors(text),
                         {"d1-when-the-spring-advances-eq-53", "--scheme--co", "ρ-μ_s"})


class Site(Folder):
    """The same for rendered pages."""

    def test_broken_links_anchors_images_and_scripts_are_reported(self):
        self.write(index_html='<h1 id="top2"></h1><a href="sub/a.html#here">x</a><a href="#top2">'
                              '</a><a href="https://a.b">y</a><img src="p.png">',
                   sub__a_html='<p id="here"></p><a href="../index.html">z</a>', p_png="")
        self.assertEqual(links.check_site(self.root), ([], 4))
        self.write(bad_html='<a href="sub/b.html"></a><a href="sub/a.html#there"></a>'
                            '<img src="q.png"><script src="https://far.away/x.js"></script>'
                            '<a href="sub"></a>')
        faults, _ = links.check_site(self.root)
        self.assertEqual(len(faults), 5, faults)


class Preparation(Folder):
    """What Sphinx gets to see of a page."""

    def test_links_lead_to_pages_of_the_site(self):
        pages = make_site.Pages(self.root)
        for line, expected in (
                ("[a](deviations.md#d1)", "[a](deviations.md#d1)"),
                ("[b](../README.md)", "[b](../index.md)"),
                ("[c](../exercises)", "[c](../exercises/README.md)"),
                ("[`d`](../tinydem/tinydem.cpp#L12-L15)",
                 '<a href="../source/tinydem/tinydem.cpp.html#L-12">`d`</a>'),
                ("[e](https://a.b) [f](#g) `[h](i.md)`", "[e](https://a.b) [f](#g) `[h](i.md)`"),
                ("![j](images/heap.png)", "![j](images/heap.png)"),
                ("[k](images/heap.png)", '<a href="../source/docs/images/heap.png">k</a>')):
            self.assertEqual(pages.links_of("docs/equations.md", line), expected)
        self.assertTrue((self.root / "docs/images/heap.png").exists())
        self.assertEqual(pages.sources, {"tinydem/tinydem.cpp", "docs/images/heap.png"})
        with self.assertRaises(SystemExit):
            pages.links_of("docs/equations.md", "[l](missing.cpp)")

    def test_every_page_is_in_the_side_bar_once(self):
        pages = make_site.Pages(self.root)
        listed = [name for _, these in pages.contents() for name in these]
        self.assertEqual(sorted(listed), sorted({*pages.names, "reference.md"} - {"README.md"}))


class Equations(unittest.TestCase):
    """docs/equations.md is complete and says what the sources say."""

    def test_the_page_is_complete_and_up_to_date(self):
        wrong, text = equations.made()
        self.assertEqual(wrong, [])
        self.assertEqual(equations.PAGE.read_text(), text, "run ./dem docs --update")

    def test_tags(self):
        for text, expected in {
                "// Eq. (12)": [12], "Eqs. (5, 10) [D1]": [5, 10],
                "Eqs. (3), (42)-(44)": [3, 42, 43, 44],
                "Eqs. (26)-(28), (36)": [26, 27, 28, 36], "Eqs. 41 and 50": [41, 50],
                "Eqs. (31), (60) and I = 8/15": [31, 60], "Eq. (50)/64": [50], "Eq. n": [],
                "Eqs. (5-8, 10), then Eq. (20)": [5, 6, 7, 8, 10, 20]}.items():
            self.assertEqual(equations.numbers(text), expected, text)
        for text in ("Eq. (61)", "Eq. (0)", "Eqs. (12-10)"):
            with self.assertRaises(equations.Wrong):
                equations.numbers(text)


class Faults(Folder):
    """What is missing, double or dangling is noticed: a repository with two equations, spoiled."""

    def made(self, solver="x = 1;  // Eq. (1) [D1]\n", test='// Eqs. (1, 2)\nTEST_CASE("t") {\n}\n',
             case="[1, 2]", check="Eqs. (1), (2)", **table):
        self.write(tinydem__tinydem_cpp=solver, tinydem__tinydem_hpp="y = 2;  // Eq. (2)\n",
                   tests__law__test_law_cpp=test,
                   verification__cases__01_toml=f'[[case]]\nid = "01"\ntitle = ""\n'
                                                f'equations = {case}\n',
                   exercises__01__checks_py=f'@check("pointwise", 1, "{check}")\ndef f(): pass\n',
                   exercises__01__README_md="# 01 Title\n")
        rows = {str(k): {"name": "n", "formula": "f"} for k in (1, 2)}
        found = [look(self.root) for look in (equations.statements, equations.unit_tests,
                                              equations.cases, equations.exercises)]
        wrong = equations.faults({"equation": rows, **table}, *found, {"d1-a-section"})
        return "\n".join(line for line in wrong if "1 ... 60" not in line)

    def test_a_complete_table_has_no_faults(self):
        self.assertEqual(self.made(), "")

    def test_missing_links(self):
        self.assertIn("no statement", self.made(solver="x = 1;\n"))
        self.assertIn("no statement", self.made(solver="// Eq. (1)\nx = 1;\n"))
        self.assertIn("no unit test",
                      self.made(test='// Eq. (1)\nTEST_CASE("t") {\n}\n// Eq. (2)\n'))
        self.assertIn("no verification", self.made(case="[1]"))
        self.assertIn("no exercise", self.made(check="Eq. (1)"))

    def test_double_and_dangling_links(self):
        twice = "x = 1;  // Eq. (1)\nz = 1;  // Eq. (1)\n"
        self.assertIn("2 statements", self.made(solver=twice))
        repeated = [{"equations": [1], "statements": 2}]
        self.assertEqual("", self.made(solver=twice, repeated=repeated))
        self.assertIn("no section D2", self.made(solver="x = 1;  // Eq. (1) [D2]\n"))
        for spoiled in ({"solver": "x = 1;  // Eq. (99)\n"}, {"case": "[1, 2, 61]"},
                        {"check": "Eq. (77)"}):
            with self.assertRaises(equations.Wrong):
                self.made(**spoiled)

    def test_reasons_that_no_longer_apply(self):
        self.assertIn("[[unstated]]", self.made(unstated=[{"equations": [1]}]))
        self.assertIn("[[unpractised]]", self.made(unpractised=[{"equations": [2]}]))
        table = "[[unpractised]]\nequations = [{}]\nreason = \"r\"\n"
        both = table.format("1, 2") + table.format("3") + "[x]\n"
        self.assertEqual(equations.drop_old_reasons(both, {2, 3}), table.format("1") + "[x]\n")


class Symbols(Folder):
    """docs/symbols.md and the table of parameters in README.md say what the sources say."""

    def test_the_tables_are_complete_and_up_to_date(self):
        for path, text in symbols.made().items():
            self.assertEqual(path.read_text(), text, "run ./dem docs --update")

    def test_the_parameters_are_those_of_help(self):
        said = " ".join(subprocess.run([os.environ["TINYDEM"], "--help"], capture_output=True,
                                       text=True, check=True).stdout.split())
        entries = symbols.parameters()
        self.assertGreater(len(entries), 25)
        for entry in entries:
            words = f"{entry['help']} [{entry['unit']}], {entry['range']}, default"
            if entry["default"] and entry["name"] not in ("E", "contacts"):  # 1e+06; a flag
                words += f" {entry['default']}"
            if entry["name"] == "contacts":
                words = entry["help"]
            self.assertIn(words, said)

    def test_a_struct_that_changed_is_noticed(self):
        self.write(a_hpp="struct Other { int q; };\n\nstruct Two {\n  T a, b;  // c, d;\n"
                         "  Vec<T> e{}; };\n")
        self.assertEqual(symbols.members(self.root, "a.hpp", "Two"), {"a": 4, "b": 4, "e": 5})
        with self.assertRaises(symbols.Wrong):
            symbols.members(self.root, "a.hpp", "Three")
        self.write(README_md="| symbol | option |\n|---|---|\n| old | row |\n")
        table = symbols.tomllib.loads(symbols.TABLE.read_text())
        for spoil, why in ((lambda text: text.replace("T stiff;", "T stiff, more;")
                            .replace("vt, stiff;", "vt, stiff, more;"), "more"),
                           (lambda text: text.replace("const T cn = ", "T cn = "), "const T cn")):
            for name in ("tinydem/tinydem.hpp", "tinydem/tinydem.cpp"):
                path = self.root / name
                path.parent.mkdir(exist_ok=True)
                path.write_text(spoil((links.ROOT / name).read_text()))
            with self.assertRaisesRegex(symbols.Wrong, why):
                symbols.page(self.root, table)


if __name__ == "__main__":
    unittest.main()

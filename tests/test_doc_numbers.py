"""Numbers in the documentation are those of the verification. By hand: cd tests && python3 -m
unittest test_doc_numbers"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "verification"))
import docs  # noqa: E402  (after the path is set)

VALUES = {"08_oblique": {"a": 0.00804, "b": 1.78}, "10_energy": {"c": 3.14e-5}}


def check(*pages):
    done = subprocess.run([sys.executable, ROOT / "verification/docs.py", "--check", *pages],
                          capture_output=True, text=True)
    return done.returncode, done.stdout


class DocNumbers(unittest.TestCase):
    def test_documentation_is_up_to_date(self):
        code, said = check()
        self.assertEqual(code, 0, said)
        self.assertGreater(int(said.split()[0]), 40)

    def test_times_of_the_readme_are_those_of_the_performance_page(self):
        lines = (ROOT / "docs/performance.md").read_text().splitlines()
        head = next(k for k, line in enumerate(lines) if "LAMMPS, 1 rank" in line)
        row = next(line for line in lines[head:] if line.startswith("| packing | 10 000 |"))
        names, cells = ([c.strip() for c in text.split("|")] for text in (lines[head], row))
        ours, lammps = (cells[names.index(n)].split(" ±")[0] for n in ("1 thread", "LAMMPS, 1 rank"))
        self.assertIn(f"one core | {ours} | | {lammps} |", (ROOT / "README.md").read_text())

    def test_numbers_keep_their_form(self):
        for like, value, expected in [
                ("0.8 %", 0.00804, "0.8 %"), ("12%", 0.00804, "1%"), ("5.00", 1.78, "1.78"),
                ("7", 1.78, "2"), ("−1.0", -0.78, "−0.8"), ("2.0·10⁻³", 3.14e-5, "3.1·10⁻⁵")]:
            self.assertEqual(docs.written(value, like), expected)

    def test_expressions(self):
        text = "-9.99<!-- 1 - 08_oblique.b --> and 1 %<!-- 08_oblique.a --> and 7 apples"
        problems = []
        self.assertEqual(docs.renewed(text, VALUES, "here", problems),
                         "-0.78<!-- 1 - 08_oblique.b --> and 1 %<!-- 08_oblique.a --> and 7 apples")
        self.assertEqual(problems, [])

    def test_unknown_metrics_and_strange_expressions_are_reported(self):
        for source in ("08_oblique.z", "99_none.a", "exit(08_oblique.a)", "08_oblique.a +"):
            problems = []
            docs.renewed(f"1.0<!-- {source} -->", VALUES, "here", problems)
            self.assertEqual(len(problems), 1, source)

    def test_numbers_without_a_source_in_a_table_are_reported(self):
        table = "<!-- measured -->\n| a | b |\n|---|---|\n| 5 m/s | {} |\n<!-- end of measured -->"
        self.assertEqual(list(docs.bare_numbers(table.format("2.1<!-- 08_oblique.b -->"), "")), [])
        self.assertEqual(len(list(docs.bare_numbers(table.format("2.1"), ""))), 1)

    def test_stale_page_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.md"
            page.write_text("one in 9.9<!-- 22_pile.step_ratio -->, ![x](images/99_none.png)\n")
            code, said = check(page)
            self.assertEqual(code, 1)
            self.assertIn("stale: one in 9.9", said)
            self.assertIn("docs/images/99_none.png is missing", said)
            self.assertIn("no case draws 99_none.png", said)


if __name__ == "__main__":
    unittest.main()

"""The lab sheets: reading, sealing, bands, honest and dishonest answers, and their commands. The
self-test of each sheet (./dem grade lab-NAME --self-test) is a test of its own."""
import csv
import json
import os
import random
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from test_grader import EXERCISES, RESULTS, ROOT, conforms, lost, run, told
from grader import classroom, course, lab_runs, labs  # noqa: E402  (test_grader sets the path)

PROGRAM = os.environ.get("TINYDEM", str(ROOT / "build/default/tinydem"))
SHEETS = labs.find_labs(EXERCISES)
REPOSE = next(lab for lab in SHEETS if lab.folder.name == "repose")


class Scratch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="labs-test-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def graded(self, text, lab=REPOSE):
        """The sheet of an answer with this text."""
        path = self.folder / "answer.ini"
        path.write_text(text)
        return lab.grade(path)


def answer_text(lab, rows, prediction=None):
    """What an honest student with these runs writes."""
    names = labs.prediction_names(lab)
    given = prediction or dict(zip(names, (lab.sheet.TREND, "1", "because it must be so, I think")))
    lines = ["[prediction]", *(f"{k} = {v}" for k, v in given.items()),
             f"seal = {labs.seal_of(lab.slug, given, names, '261127-1000')}", "[runs]"]
    lines += [" ".join(f"{row[c]:.7g}" for c in lab.columns) for row in rows]
    lines += ["[result]", f"trend = {lab.sheet.TREND}"]
    for name, result in lab.results.items():
        value, error = result.function(rows), labs.own_error(result.function, rows)
        lines.append(f"{name} = {value:.5g} +- {error:.1g} {result.unit}")
    return "\n".join(lines) + "\n"


class Reading(Scratch):
    """Mistakes in answer.ini are named with their line."""

    def test_mistakes(self):
        for text, said in (("[prediktion]\n", "line 1: there is no part [prediktion]"),
                           ("trend = rises\n", "line 1: 'trend = rises' must be name = value"),
                           ("[runs]\n0.1 one 7\n", "line 2: '0.1 one 7' must be finite numbers"),
                           ("[runs]\n0.1 1 nan\n", "line 2"), ("[runs]\n0.1 1\n", "3 numbers"),
                           ("[result]\nangle = 1 deg\nangle = 2 deg\n", "line 3: angle is there"),
                           ("[result]\nangle = 12,3 deg\n", "'12,3 deg' is no quantity"),
                           ("[result]\nangle = 12 +- nan deg\n", "is no quantity")):
            sheet = self.graded(text)
            self.assertEqual(sheet.points, 0, text)
            self.assertIn(said, told(sheet, "builds"))
            self.assertEqual(sum(line.maximum for line in sheet.lines), 100)

    def test_quantities(self):
        for text, value, error, unit in (("16.2 +- 0.6 deg", 16.2, 0.6, "deg"),
                                         ("16.2±.6deg", 16.2, 0.6, "deg"), ("-2", -2, None, ""),
                                         ("1.2e-3 +/- 4e-4 m/s", 1.2e-3, 4e-4, "m/s")):
            q = labs.Quantity(text)
            self.assertEqual((q.value, q.error, q.unit), (value, error, unit))
        self.assertAlmostEqual(labs.Quantity("16.2").rounding, 0.05)
        self.assertAlmostEqual(labs.Quantity("1.25e2").rounding, 0.5)

    def test_every_sheet_has_100_points(self):
        for lab in SHEETS:
            have = {k: sum(c.points for c in [lab.first, *lab.checks] if c.category == k)
                    for k in course.CATEGORIES}
            self.assertEqual(have, course.CATEGORIES)


class Sealing(Scratch):
    """A prediction counts when it was sealed before there were results."""

    def seal(self, text):
        """The line that the grader tells."""
        return re.search(r"seal = (\S+)", told(self.graded(text), "prediction")).group(1)

    def test_in_order(self):
        text = "[prediction]\ntrend = rises\nangle = 20 deg\nbecause = rough grains hold better\n"
        sheet = self.graded(text)
        self.assertEqual(sheet.points, 5)
        text += f"seal = {self.seal(text)}\n"
        self.assertEqual(self.graded(text).points, 12)
        self.assertIn("prediction", lost(self.graded(text.replace("20", "17"))))

    def test_after_the_results(self):
        text = answer_text(REPOSE, REPOSE.runs)
        late = re.sub("seal = .*", "seal =", text)
        self.assertEqual(lost(self.graded(text)), set())
        self.assertEqual(lost(self.graded(late)), {"prediction"})
        self.assertIn("take runs and results out", told(self.graded(late), "prediction"))

    def test_no_runs_without_a_prediction(self):
        tree = self.folder / "exercises"
        shutil.copytree(EXERCISES / "labs/repose", tree / "labs/repose",
                        ignore=shutil.ignore_patterns("answer.ini"))
        with self.assertRaisesRegex(course.Mistake, "first the prediction"):
            labs.need_prediction(labs.Lab(tree / "labs/repose"))
        (tree / "labs/repose/answer.ini").write_text(
            answer_text(REPOSE, REPOSE.runs).split("[runs]")[0])
        labs.need_prediction(labs.Lab(tree / "labs/repose"))


class Honest(Scratch):
    """Students who do what the sheet says, with runs that are drawn from the instructor's."""

    def test_full_points(self):
        dice = random.Random(1)
        for lab in SHEETS:
            seeds = labs.by_seed(lab.runs)
            for _ in range(12):
                chosen = dice.sample(sorted(seeds), lab.sheet.LEAST)
                rows = [row for seed in chosen for row in seeds[seed]]
                sheet = self.graded(answer_text(lab, rows), lab)
                bad = [told(sheet, name) for name in lost(sheet)]
                self.assertEqual(bad, [], f"{lab.slug} with seeds {chosen}")

    def test_error_of_a_mean(self):
        """Leaving out one after the other gives s/sqrt(n) for a mean."""
        values = [2.0, 3.0, 3.0, 4.0]
        rows = [{"seed": k, "y": v} for k, v in enumerate(values)]
        self.assertAlmostEqual(labs.own_error(labs.mean_at("y"), rows),
                               labs.deviation(values) / 2, places=14)

    def test_expected_error_is_that_of_many_students(self):
        """Seeds with Gaussian numbers: sigma/sqrt(n), within 4 standard errors of each figure."""
        dice = random.Random(3)
        rows = [{"seed": k, "y": dice.gauss(10, 1)} for k in range(400)]
        sigma = labs.deviation([r["y"] for r in rows])
        error = labs.expected_error(labs.mean_at("y"), rows, 4)
        self.assertAlmostEqual(error, sigma / 2, delta=4 * sigma / 2 / (2 * labs.DRAWS) ** 0.5)


class Bands(Scratch):
    def test_narrower_than_the_public_ones(self):
        """What the teacher accepts is inside of what a hand-out accepts, or nearly."""
        for lab in SHEETS:
            for name, result in lab.results.items():
                low, high = labs.band(lab, name, {"runs": []})
                self.assertLess(result.wide[0], low, f"{lab.slug} {name}")
                self.assertGreater(result.wide[1], min(high, 1.0 if name == "share" else high) -
                                   1e-9, f"{lab.slug} {name}")

    def test_more_runs_narrower_band(self):
        few = labs.band(REPOSE, "angle", {"runs": []})
        rows = [dict(row, seed=row["seed"] + 100 * k) for k in range(6) for row in REPOSE.runs]
        many = labs.band(REPOSE, "angle", {"runs": rows})
        self.assertLess(many[1] - many[0], few[1] - few[0])


def tiny(options):
    """The options of a run, for five steps of it."""
    options = list(options)
    if "--Nframes" in options:
        k = options.index("--Nframes")
        del options[k:k + 2]
    return options + ["--Nframes", "1", "--Nsteps", "5"]


class Commands(Scratch):
    """What the sheets tell students to type."""

    def commands(self):
        for lab in SHEETS:
            text = (lab.folder / "README.md").read_text()
            blocks = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
            lines = [line for block in blocks for line in block.splitlines()]
            self.assertGreaterEqual(len(lines), 2, lab.slug)
            for line in lines:
                yield lab, line.split("#")[0], shlex.split(line, comments=True)

    def solve(self, scene, options, line):
        self.assertTrue(scene.is_file(), f"{scene}: {line}")
        done = subprocess.run([PROGRAM, "", "", self.folder / "out", "--scene", scene,
                               "--overwrite", "--quiet", *options], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{line}: {done.stderr}")

    def test_they_start(self):
        verbs = set()
        scenes = ROOT / "tinydem" / "scenes"
        for lab, line, words in self.commands():
            self.assertEqual(words[0], "./dem", line)
            verbs.add(words[1])
            if words[1] == "run":
                scene = scenes / words[2] / "scene.ini"
                self.solve(scene if scene.is_file() else ROOT / words[2], tiny(words[3:]), line)
            else:
                self.assertEqual(words[1:4], ["lab", lab.folder.name, "--seeds"], line)
                seeds = lab_runs.seed_list(words[4])
                self.assertEqual(len(seeds), lab.sheet.LEAST, line)
                for value in lab.sheet.VALUES:
                    scene, options = lab.sheet.run(value, seeds[0])
                    self.solve(scenes / scene, tiny(options), f"{line}, {value}")
        self.assertEqual(verbs, {"run", "lab"})

    def test_look_is_one_of_the_runs(self):
        """The scene that the student looks at is measured with the same options later."""
        for lab, line, words in self.commands():
            if words[1] == "run":
                known = [[w for w in lab.sheet.run(value, 1)[1]] for value in lab.sheet.VALUES]
                known = [dict(zip(o[::2], o[1::2])) for o in known]
                asked = dict(zip(words[3::2], words[4::2]))
                for options in (asked, *known):
                    options.pop("--seed", None)
                self.assertIn(asked, known, line)

    def test_a_row_from_a_real_run(self):
        """Solver, measurement and row: the arches of one run (three seconds)."""
        lab = next(lab for lab in SHEETS if lab.folder.name == "arches")
        row = lab_runs.one_run(lab, 1.0, 1, PROGRAM, self.folder / "run")
        got = dict(zip(lab.columns, map(float, row)))
        self.assertEqual((got["mu"], got["seed"]), (1, 1))
        self.assertLessEqual(got["bridged"], got["throats"])
        self.assertTrue(0 <= got["throats"] <= 2 and 0 <= got["arches"] <= 6, row)
        self.assertTrue((self.folder / "run" / "result.png").is_file())

    def test_mistakes(self):
        for arguments, said in ((["lab", "nosuch"], "no lab sheet 'nosuch'"),
                                (["grade", "lab-nosuch"], "no exercise 'lab-nosuch'"),
                                (["lab"], "NAME")):
            code, text = run(ROOT, *arguments)
            self.assertEqual(code, 2, text)
            self.assertIn(said.lower(), text.lower())
        for seeds in "", "a-b", "1,x", "4-1", "1-999":
            self.assertRaises(course.Mistake, lab_runs.seed_list, seeds)


class ForTeachers(Scratch):
    """Hand-out and gradebook."""

    def test_handout(self):
        tree = self.folder / "hand out"
        code, said = run(ROOT, "handout", tree, "lab-repose", "lab-arches")
        self.assertEqual(code, 0, said)
        names = {p.name for p in tree.rglob("*")}
        self.assertFalse(names & {"runs.csv", "solution.ini", "solution2.ini", "mutants",
                                  "figures.py", "AUTHORING.md", "classroom.py"}, names)
        readme = (tree / "README.md").read_text() + (
            tree / "exercises" / "labs" / "README.md").read_text()
        self.assertIn("repose/README.md", readme)
        self.assertNotIn("discharge/README.md", readme)
        self.assertNotIn("teacher's", (tree / "README.md").read_text())
        code, said = run(tree, "grade", "lab-repose")
        self.assertEqual(code, 1, said)
        self.assertIn("5/100", said)
        answer = tree / "exercises" / "labs" / "repose" / "answer.ini"
        shutil.copy(REPOSE.folder / "solution.ini", answer)
        code, said = run(tree, "grade", "lab-repose")
        self.assertEqual(code, 0, said)
        self.assertRegex(run(tree, "progress")[1], r"lab-repose .* 100 +100")
        code, said = run(tree, "help")
        for verb in "run", "lab", "grade", "progress", "build":
            self.assertRegex(said, rf"\n  {verb}\b")
        for verb in classroom.FOR_TEACHERS.split("|"):
            self.assertNotRegex(said, rf"\n  {verb}\b")
            self.assertEqual(run(tree, verb)[0], 2)

    def test_no_number_of_the_instructor(self):
        """No row of runs.csv or of a solution in what is handed out of a sheet."""
        for lab in SHEETS:
            texts = "".join(p.read_text() for name in classroom.LAB_HANDED_OUT if "png" not in name
                            for p in lab.folder.glob(name))
            for row in lab.runs:
                number = f"{row[lab.sheet.SCATTERS]:.5g}"
                if len(number) > 4:
                    self.assertNotIn(number, texts)

    def test_gradebook(self):
        students = self.folder / "class"
        for name, source in (("right", "solution.ini"), ("forged", "mutants/other_results.ini")):
            (students / name).mkdir(parents=True)
            shutil.copy(REPOSE.folder / source, students / name / "lab-repose.ini")
        (students / "forged" / "lab-repose.ini").write_text(
            (REPOSE.folder / "solution.ini").read_text().replace("+-", "+- 0.0001 #"))
        (students / "absent").mkdir()
        code, said = run(ROOT, "gradebook", students, "lab-repose", "--output",
                         self.folder / "grades")
        self.assertEqual(code, 0, said)
        with open(self.folder / "grades" / "grades.csv", newline="") as file:
            rows = {row["student"]: row for row in csv.DictReader(file)}
        self.assertEqual(float(rows["right"]["points"]), 100)
        self.assertEqual(rows["forged"]["lost"], "units error_bar")
        self.assertEqual(float(rows["absent"]["points"]), 0)
        for row in rows.values():
            parts = sum(float(row[k]) for k in course.CATEGORIES)
            self.assertAlmostEqual(parts, float(row["points"]))
        results = json.loads((self.folder / "grades" / "forged" / "results.json").read_text())
        self.assertTrue(conforms(results, RESULTS), results)


if __name__ == "__main__":
    unittest.main()

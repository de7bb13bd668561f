"""The grader of the exercises: hostile answers, hand-out, gradebook, command line. Exercise 01."""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
EXERCISES = ROOT / "exercises"
sys.path.insert(0, str(EXERCISES))
from grader import classroom, course, program, selftest, solver  # noqa: E402  (after the path is known)

HERTZ = course.Exercise(EXERCISES / "01-hertz-force")
SOLUTION = (HERTZ.folder / "solution.cpp").read_text()
COMPILER = program.find_compiler()
FAST = {"cpu": 1, "memory": 512, "wall": 3}


def setUpModule():
    global SCRATCH
    SCRATCH = Path(tempfile.mkdtemp(prefix="grader-test-"))
    HERTZ.limits.update(FAST)


def tearDownModule():
    shutil.rmtree(SCRATCH)


def graded(text, only=None, compiler=COMPILER, **options):
    """The sheet of an answer with this text."""
    answer = SCRATCH / "text.cpp"
    answer.write_text(text)
    return course.grade(HERTZ, answer, SCRATCH / "build", compiler, only=only, **options)


def lost(sheet):
    """Names of the checks that miss points."""
    return {line.name for line in sheet.lines if not line.full}


def spoiled(statement, includes=""):
    """The solution, with a statement after the overlap is known."""
    head = "if (delta <= 0) return {0, 0, 0};"
    assert SOLUTION.count(head) == 1
    return includes + SOLUTION.replace(head, statement + "\n  " + head)


def told(sheet, name):
    """The feedback of one check, as one text."""
    return " ".join(course.feedback(next(x for x in sheet.lines if x.name == name), sheet))


class Credit(unittest.TestCase):
    """Error to points."""

    def test_inside_the_tolerance_all(self):
        self.assertEqual(course.credit(1e-9, 1e-9, False), 1)
        self.assertEqual(course.credit(0, 0, True), 1)

    def test_fades_with_the_logarithm(self):
        self.assertAlmostEqual(course.credit(1e-8, 1e-9, False), 0.5)
        self.assertAlmostEqual(course.credit(1e-9 * 10 ** 1.5, 1e-9, False), 0.25)
        self.assertEqual(course.credit(1e-7, 1e-9, False), 0)
        self.assertEqual(course.credit(float("inf"), 1e-9, False), 0)
        self.assertEqual(course.credit(float("nan"), 1e-9, False), 0)

    def test_sharp_is_all_or_nothing(self):
        self.assertEqual(course.credit(1.01e-9, 1e-9, True), 0)

    def test_nan_is_an_infinite_error(self):
        self.assertEqual(course.Outcome(float("nan")).error, float("inf"))

    def test_every_exercise_has_100_points(self):
        for e in course.find_exercises(EXERCISES):
            self.assertEqual(5 + sum(c.points for c in e.checks), 100, e.slug)


class Hostile(unittest.TestCase):
    """What goes wrong costs the checks that it hits, and nothing else."""

    def only_unequal(self, sheet):
        """All checks with spheres of different size fail, the other ones are full."""
        self.assertEqual(lost(sheet) & {"builds", "equal_spheres", "elastic_impact"}, set())
        self.assertIn("unequal_spheres", lost(sheet))
        self.assertEqual(sheet.lines[0].points, 5)
        self.assertEqual(sum(x.maximum for x in sheet.lines), 100)

    def test_crash(self):
        sheet = graded(spoiled("if (i.R != j.R) *static_cast<volatile int*>(nullptr) = 1;"))
        self.only_unequal(sheet)
        self.assertIn("crashed", told(sheet, "unequal_spheres"))
        self.assertIn("R_i = ", told(sheet, "unequal_spheres"))

    def test_endless_loop(self):
        text = spoiled("for (volatile bool on = delta < -i.R; on;) {}")
        sheet = graded(text, ["no_force_apart", "equal_spheres"])
        self.assertEqual(lost(sheet), {"no_force_apart"})
        self.assertIn("endless loop", told(sheet, "no_force_apart"))

    def test_sleep(self):
        text = spoiled("if (delta < -i.R) pause();", "#include <unistd.h>\n")
        start = time.monotonic()
        sheet = graded(text, ["no_force_apart", "equal_spheres"])
        self.assertEqual(lost(sheet), {"no_force_apart"})
        self.assertIn("waiting", told(sheet, "no_force_apart"))
        self.assertLess(time.monotonic() - start, 60)

    def test_an_answer_that_always_hangs_is_graded_soon(self):
        text = spoiled("pause();", "#include <unistd.h>\n")
        start = time.monotonic()
        self.assertEqual(graded(text).points, 5)
        self.assertLess(time.monotonic() - start, 40)  # 10 s on an idle machine

    def test_memory_bomb(self):
        text = spoiled("if (i.R != j.R) for (std::vector<double> v(1 << 20);; v.resize(2 * "
                       "v.size())) {}", "#include <vector>\n")
        sheet = graded(text)
        self.only_unequal(sheet)
        self.assertIn("memory", told(sheet, "unequal_spheres"))
        self.assertIn("bad_alloc", told(sheet, "unequal_spheres"))

    def test_threads_without_end(self):
        text = spoiled("std::vector<std::thread> all;\n  for (int k = 0; i.R != j.R && k < 100000; "
                       "++k) all.emplace_back([] { for (;;) pause(); });",
                       "#include <thread>\n#include <vector>\n#include <unistd.h>\n")
        self.only_unequal(graded(text))

    def test_global_state(self):
        """An answer that counts its calls loses the check of memory, and what its calls spoil."""
        sheet = graded(spoiled("static int calls = 0;\n  if (++calls > 60) return {0, 0, 0};"),
                       ["equal_spheres", "no_memory"])
        self.assertEqual(lost(sheet), {"no_memory"})

    def test_nan(self):
        sheet = graded(spoiled("if (i.R != j.R) return {std::nan(\"\"), 0, 0};"))
        self.only_unequal(sheet)
        self.assertIn("nan", told(sheet, "unequal_spheres"))

    def test_exit(self):
        sheet = graded(spoiled("if (i.R != j.R) std::exit(0);", "#include <cstdlib>\n"))
        self.only_unequal(sheet)
        self.assertIn("exit code 0", told(sheet, "unequal_spheres"))

    def test_exit_before_main(self):
        text = SOLUTION + "\n#include <cstdlib>\nstatic const int end = (std::exit(0), 0);\n"
        self.assertEqual(graded(text).points, 5)

    def test_printed_results_do_not_count(self):
        text = spoiled("if (i.R != j.R) { puts(\"100/100 passed\"); return {0, 0, 0}; }",
                       "#include <cstdio>\n")
        sheet = graded(text)
        self.only_unequal(sheet)
        self.assertIn("it printed: 100/100 passed", told(sheet, "unequal_spheres"))

    def test_endless_printing(self):
        text = spoiled("while (delta < -i.R) puts(\"again\");", "#include <cstdio>\n")
        self.assertEqual(lost(graded(text, ["no_force_apart", "repulsion"])), {"no_force_apart"})

    def test_forged_reply(self):
        """An answer that writes replies of its own into every open file."""
        forged = """if (i.R != j.R) {
    const unsigned long long reply[] = {0, 0, 40, 3};
    double zeros[120] = {};
    for (int file = 3; file < 64; ++file) {
      if (write(file, reply, sizeof reply) < 0) continue;
      if (write(file, zeros, sizeof zeros) < 0) continue;
    }
    _exit(0);
  }"""
        sheet = graded(spoiled(forged, "#include <unistd.h>\n"))
        self.only_unequal(sheet)
        self.assertIn("no answer to the question", told(sheet, "unequal_spheres"))

    def test_far_too_many_numbers(self):
        forged = """const unsigned long long reply[] = {0, 0, 1ull << 40, 1ull << 20};
  for (int file = 3; file < 64; ++file) if (write(file, reply, sizeof reply) < 0) continue;"""
        sheet = graded(spoiled(forged, "#include <unistd.h>\n"), ["repulsion"])
        self.assertIn("far too many", told(sheet, "repulsion"))

    def test_processes(self):
        """fork, daemons and other programs; nothing is left behind."""
        text = spoiled("if (fork() == 0) { setsid(); sleep(1000); }\n"
                       "  execl(\"/bin/sleep\", \"sleep\", \"1000\", (char*)nullptr);",
                       "#include <unistd.h>\n")
        sheet = graded(text, ["repulsion"])
        if sys.platform == "linux":
            self.assertEqual(lost(sheet), set())  # both were refused, the rest is right
            for entry in Path("/proc").glob("[0-9]*/cmdline"):
                try:
                    self.assertNotIn(str(SCRATCH), entry.read_text())
                except OSError:
                    pass

    @unittest.skipUnless(sys.platform == "linux", "needs seccomp")
    def test_signals_files_and_network(self):
        """None of these may work; the answer fails where one did."""
        victim = SCRATCH / "victim.txt"
        victim.write_text("here")
        text = spoiled(f"""const char* const file = "{victim}";
  const bool done = kill(getppid(), SIGKILL) == 0 || fopen(file, "w") || fopen(file, "a") ||
      remove(file) == 0 || truncate(file, 0) == 0 || rename(file, "/tmp/elsewhere") == 0 ||
      chmod(file, 0) == 0 || mkdir("made", 0777) == 0 || socket(AF_INET, SOCK_STREAM, 0) >= 0 ||
      system("true") == 0 || ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0;
  if (done) return {{0, 0, 0}};""", """#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>
""")
        self.assertEqual(lost(graded(text, ["repulsion"])), set())
        self.assertEqual(victim.read_text(), "here")

    def test_includes_of_the_project(self):
        for name in "solution.cpp", f"{HERTZ.folder}/solution.cpp":
            sheet = graded(f'#include "{name}"\n')
            self.assertEqual(sheet.points, 0)
            self.assertIn("solution.cpp", told(sheet, "builds"))

    def test_own_main_and_endless_include(self):
        self.assertEqual(graded(SOLUTION + "int main() {}\n").points, 0)
        self.assertEqual(graded('#include "answer.cpp"\n').points, 0)

    def test_macros_do_not_reach_the_checks(self):
        self.assertEqual(graded(SOLUTION + "#define double float\n#define return\n").points, 100)


class Feedback(unittest.TestCase):
    """What a student is told about a check that failed."""

    def test_fields(self):
        text = (HERTZ.folder / "mutants" / "two_thirds.cpp").read_text()
        sheet = graded(text, ["equal_spheres"])
        said = " ".join(sheet.as_dict()["checks"][1]["feedback"])
        for part in ("Eqs. (5), ", "measured: (", "expected: (", " N; error 0.5, allowed 1e-09",
                     "at: ", "likely cause: 2/3", "--check equal_spheres --seed 1"):
            self.assertIn(part, said)

    def test_every_check_of_every_exercise_has_them(self):
        without_equations = {"10", "11", "12", "14", "15"}  # geometry, search, programming
        for e in course.find_exercises(EXERCISES):
            for c in e.checks:
                self.assertTrue(c.title, f"{e.slug}: {c.name}")
                self.assertTrue(c.eq or e.number in without_equations, f"{e.slug}: {c.name}")
                self.assertTrue(c.cause or c.category == "clean", f"{e.slug}: {c.name}")

    def test_the_command_repeats_the_check(self):
        answer = SCRATCH / "again.cpp"
        answer.write_text((HERTZ.folder / "mutants" / "two_thirds.cpp").read_text())
        sheet = course.grade(HERTZ, answer, SCRATCH / "build", COMPILER, seeds=[3])
        for line in [x for x in sheet.lines if not x.full][:1]:
            words = re.search(r"again: \./dem (.*)", course.feedback(line, sheet)[-1]).group(1)
            code, said = run(ROOT, *words.split(), "--file", answer, "--json")
            again = json.loads(said)[0]["checks"]
            self.assertEqual(code, 1)
            self.assertEqual([(x["name"], x["points"]) for x in again[1:]],
                             [(line.name, line.points)])


class SameScores(unittest.TestCase):
    """The compiler and the number of threads change nothing."""

    def test_compilers_and_threads(self):
        answer = HERTZ.folder / "mutants" / "attraction_when_apart.cpp"
        sheets = []
        for compiler in filter(shutil.which, ("g++", "clang++")):
            for threads in 1, 2:
                sheet = course.grade(HERTZ, answer, SCRATCH / "build", compiler, threads=threads,
                                     jobs=threads)
                sheets.append([(line.name, line.points) for line in sheet.lines])
        self.assertTrue(0 < sum(p for _, p in sheets[0]) < 100)
        for sheet in sheets:
            self.assertEqual(sheet, sheets[0])


class SelfTest(unittest.TestCase):
    """The self-test notices what it must notice; by hand: ./dem grade --self-test."""

    def sheet(self, **points):
        """A sheet with these points; all other checks are full."""
        lines = [course.Line(5, 5)]
        lines += [course.Line(c.points, points.get(c.name, c.points), c) for c in HERTZ.checks]
        return course.Sheet(HERTZ, [1], lines, "")

    def test_mutants_must_lose_exactly_what_they_say(self):
        promise = {"repulsion": "all", "power_law": "some"}
        good = self.sheet(repulsion=0, power_law=3.2)
        self.assertEqual(selftest.mismatch("mutant", good, promise), "")
        for bad in (self.sheet(), self.sheet(repulsion=0), self.sheet(repulsion=1, power_law=3),
                    self.sheet(repulsion=0, power_law=0),
                    self.sheet(repulsion=0, power_law=3, equal_spheres=0)):
            self.assertNotEqual(selftest.mismatch("mutant", bad, promise), "")
        self.assertNotEqual(selftest.mismatch("mutant", good, {"builds": "all"}), "")

    def test_solutions_and_starter(self):
        self.assertEqual(selftest.mismatch("solution", self.sheet(), {}), "")
        self.assertNotEqual(selftest.mismatch("solution", self.sheet(repulsion=9.9), {}), "")
        self.assertNotEqual(selftest.mismatch("starter", self.sheet(repulsion=0), {}), "")

    def test_header(self):
        path = SCRATCH / "mutant.cpp"
        path.write_text("// loses: a b~\n")
        self.assertEqual(selftest.promised(path), {"a": "all", "b": "some"})
        path.write_text("// nothing\n")
        self.assertRaises(course.BadExercise, selftest.promised, path)

    def test_points_must_add_up(self):
        copy = SCRATCH / "99-short"
        shutil.copytree(HERTZ.folder, copy)
        text = (copy / "checks.py").read_text()
        (copy / "checks.py").write_text(text.replace('"invariants", 5', '"invariants", 6'))
        with self.assertRaisesRegex(course.BadExercise, "invariants has 26 points"):
            course.Exercise(copy)


def run(folder, *arguments, **options):
    """./dem of a hand-out, or grade.py of the project; (exit code, output)."""
    front = [str(folder / "dem")] if (folder / "LICENSE").exists() and folder != ROOT else [
        sys.executable, str(folder / "exercises" / "grade.py")]
    done = subprocess.run([*front, *map(str, arguments)], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.STDOUT, env={**os.environ, "PYTHON": sys.executable},
                          timeout=300, **options)
    return done.returncode, done.stdout


def squeezed(path):
    """The text of a file without blanks."""
    return re.sub(r"\s", "", path.read_text(errors="replace"))


def squeezed_code(line):
    """A line of C++ without blanks and comment."""
    return re.sub(r"\s", "", line.split("//")[0])


def given_and_solved(exercise):
    """All that is handed out to begin with, and all solutions, as two texts."""
    if exercise.kind == "solver":
        files = [exercise.solver_texts(exercise.folder / f"{name}.py")
                 for name in ("solution", "solution2")]
        return ("\n".join(solver.read(exercise.solver).values()),
                "\n".join(text for both in files for text in both.values()))
    return ["\n".join((exercise.folder / name).read_text() for name in names)
            for names in (("starter.cpp", "exercise.hpp"), ("solution.cpp", "solution2.cpp"))]


class HandOut(unittest.TestCase):
    """The tree for students, used as a student would."""

    @classmethod
    def setUpClass(cls):
        cls.tree = SCRATCH / "hand out"
        cls.code, cls.said = run(ROOT, "handout", cls.tree, "01")
        cls.files = {p: squeezed(p) for p in cls.tree.rglob("*") if p.is_file()}

    def test_written_once(self):
        self.assertEqual(self.code, 0, self.said)
        code, said = run(ROOT, "handout", self.tree, "01")
        self.assertEqual(code, 2)
        self.assertIn("name a new directory", said)

    def test_nothing_of_the_teacher(self):
        """No file of the teacher in it, no header of a mutant."""
        names = {part for p in self.files for part in p.parts}
        self.assertFalse(names & {"solution.cpp", "solution2.cpp", "mutants", "reference.py",
                                  "classroom.py", "selftest.py", "AUTHORING.md"}, names)
        self.assertEqual([p for p, text in self.files.items() if "//loses:" in text], [])

    def test_no_line_of_a_solution(self):
        """No line of any solution in what is handed out of any exercise."""
        every = course.find_exercises(EXERCISES)
        texts = {**self.files, **{p: squeezed(p) for e in every for name in classroom.HANDED_OUT
                                  for p in e.folder.glob(name)}}
        for e in every:
            given, solved = given_and_solved(e)
            codes = {squeezed_code(line) for line in solved.splitlines()}
            codes -= {squeezed_code(line) for line in given.splitlines()}
            codes = {code for code in codes if len(code) > 12 and "#include" not in code}
            self.assertGreater(len(codes), 4, e.slug)
            self.assertEqual([(p.name, c) for p, text in texts.items() for c in codes
                              if c in text], [], e.slug)

    def test_as_a_student(self):
        code, said = run(self.tree, "grade", "01")
        self.assertEqual(code, 1, said)
        self.assertRegex(said, r"01 .* 5/100")
        (self.tree / "exercises" / HERTZ.slug / "answer.cpp").write_text(SOLUTION)
        for seed in "1", "4":
            code, said = run(self.tree, "grade", "1", "--seed", seed)
            self.assertEqual(code, 0, said)
            self.assertRegex(said, r"01 .* 100/100")
        code, said = run(self.tree, "grade", "01", "--seed", "5", "--check", "equal_spheres")
        self.assertEqual(code, 1)
        self.assertIn("use one of 1, 2, 3, 4", said)
        self.assertRegex(run(self.tree, "progress")[1], r"01 .* 100 +100")


# The shape of the two reports: {key: type}, or [schema of every item].
NUMBER = (int, float)
RESULTS = {"score": NUMBER, "execution_time": int, "visibility": str,
           "tests": [{"name": str, "number": str, "score": NUMBER, "max_score": NUMBER,
                      "output": str, "visibility": str, "status": str}]}
JUNIT = {"testsuites": {"name": str}, "failure": {"message": str, "type": str},
         "testsuite": {"name": str, "tests": int, "failures": int, "errors": int, "skipped": int,
                       "time": float},
         "testcase": {"name": str, "classname": str, "time": float}}
INSIDE = {"testsuites": {"testsuite"}, "testsuite": {"testcase"}, "testcase": {"failure"},
          "failure": set()}


def conforms(value, schema):
    """Does a JSON value have this shape, and no more?"""
    if isinstance(schema, list):
        return isinstance(value, list) and all(conforms(v, schema[0]) for v in value)
    if isinstance(schema, dict):
        return (isinstance(value, dict) and value.keys() == schema.keys()
                and all(conforms(value[k], s) for k, s in schema.items()))
    return isinstance(value, schema)


class GradeBook(unittest.TestCase):
    """A small class: right, wrong, absent, and three who cheat."""

    @classmethod
    def setUpClass(cls):
        cls.folder, cls.output = SCRATCH / "class", SCRATCH / "grades"
        own = cls.folder / "edited & <checks>" / "exercises" / HERTZ.slug
        classroom.copy(["checks.py", "expected.json"], HERTZ.folder, own)
        (own / "checks.py").write_text("raise SystemExit('all points')\n")
        shutil.copy(HERTZ.folder / "starter.cpp", own / "answer.cpp")
        texts = {"right": SOLUTION, "wrong": (HERTZ.folder / "mutants/two_thirds.cpp").read_text(),
                 "crash": spoiled("if (i.R != j.R) { puts(\"\\x01\\xff\"); abort(); }",
                                  "#include <cstdio>\n#include <cstdlib>\n")}
        for name, text in texts.items():
            (cls.folder / name).mkdir()
            (cls.folder / name / "01.cpp").write_text(text)
        (cls.folder / "absent").mkdir()
        (cls.folder / "linked").mkdir()
        (cls.folder / "linked" / "01.cpp").symlink_to(HERTZ.folder / "solution.cpp")
        cls.code, cls.said = run(ROOT, "gradebook", cls.folder, "01", "--output", cls.output,
                                 "--seed", "77")

    def test_csv(self):
        self.assertEqual(self.code, 0, self.said)
        with open(self.output / "grades.csv", newline="") as file:
            rows = {row["student"]: row for row in csv.DictReader(file)}
        points = {name: float(row["points"]) for name, row in rows.items()}
        self.assertEqual(points["right"], 100)
        self.assertEqual(points["wrong"], 55)
        self.assertEqual(points["absent"], 0)
        self.assertEqual(points["linked"], 0)
        self.assertEqual(points["edited & <checks>"], 5)
        self.assertTrue(30 <= points["crash"] < 60, points)
        for row in rows.values():
            self.assertEqual(row["maximum"], "100")
            parts = sum(float(row[k]) for k in course.CATEGORIES)
            self.assertAlmostEqual(parts, float(row["points"]))

    def test_junit(self):
        cases = failures = 0
        for element in xml.parse(self.output / "junit.xml").iter():
            self.assertEqual(set(element.keys()), set(JUNIT[element.tag]))
            for key, kind in JUNIT[element.tag].items():
                kind(element.get(key))
            self.assertTrue({child.tag for child in element} <= INSIDE[element.tag])
            if element.tag == "testsuite":
                self.assertEqual(int(element.get("tests")), len(element))
                self.assertEqual(int(element.get("failures")), len(element.findall("*/failure")))
                cases, failures = cases + len(element), failures + int(element.get("failures"))
        self.assertEqual(cases, 6 * (1 + len(HERTZ.checks)))
        self.assertGreater(failures, 20)

    def test_results(self):
        for name in "right", "crash", "absent":
            text = (self.output / name / "results.json").read_text()
            self.assertTrue(conforms(json.loads(text), RESULTS), text)
        right = json.loads((self.output / "right" / "results.json").read_text())
        self.assertEqual(right["score"], 100)
        self.assertEqual({t["status"] for t in right["tests"]}, {"passed"})
        self.assertFalse(conforms({**right, "score": "100"}, RESULTS))

    def test_an_old_gradebook_is_kept(self):
        code, said = run(ROOT, "gradebook", self.folder, "01", "--output", self.output)
        self.assertEqual(code, 2)
        self.assertIn("--overwrite", said)

    def test_hidden_inputs_find_what_was_copied_from_the_public_ones(self):
        """An answer that knows the public numbers by heart."""
        HERTZ.recorded.clear()
        graded(SOLUTION, ["equal_spheres"])
        values = next(iter(HERTZ.recorded.values()))["values"]
        table = ", ".join("{%r, %r, %r}" % tuple(v) for v in values)
        text = ("#include \"exercise.hpp\"\nVec3 hertz_force(const Sphere&, const Sphere&) {\n"
                "  static int k = 0;\n  const Vec3 table[] = {" + table + "};\n"
                f"  return table[k++ % {len(values)}];\n}}\n")
        self.assertEqual(lost(graded(text, ["equal_spheres"])), set())
        self.assertEqual(lost(graded(text, ["equal_spheres"], seeds=[1, 77])), {"equal_spheres"})


class SolverCopies(unittest.TestCase):
    """Exercises that change the solver: hand-out, grade and gradebook take a folder of two files."""

    @classmethod
    def setUpClass(cls):
        cls.exercise = next(e for e in course.find_exercises(EXERCISES) if e.slug == "13-adhesion")
        cls.right = cls.exercise.solver_texts(cls.exercise.folder / "solution.py")

    def test_changes_must_fit_the_solver(self):
        """A change whose place is gone, or not unique, says where and what to do."""
        texts = solver.read(self.exercise.solver)
        for old, times in ("no such line", 0), ("namespace tinydem", 6):
            found = sum(text.count(old) for text in texts.values())
            self.assertEqual(found > 1, times > 1)
            with self.assertRaisesRegex(ValueError, f"here.py: '{old}' stands {found} times"):
                solver.changed(texts, [(old, "new")], "here.py")

    def test_hidden_ways_to_break_the_solver_stay_with_the_teacher(self):
        folder = EXERCISES / "15-write-the-tests"
        given = {p.name for name in classroom.HANDED_OUT for p in folder.glob(name)}
        self.assertIn("solvers.py", given)
        self.assertTrue((folder / "hidden.py").exists() and "hidden.py" not in given)

    def test_which_folder_is_an_answer(self):
        student = SCRATCH / "solver students" / "ann"
        self.assertIsNone(classroom.find_answer(student, self.exercise))
        for place in "exercises/13-adhesion/answer", "13":
            solver.write(self.right, student / place)
            self.assertEqual(classroom.find_answer(student, self.exercise), student / place)
        (student / "13" / "tinydem.hpp").unlink()  # then that of the solver as it is
        self.assertEqual(classroom.find_answer(student, self.exercise), student / "13")
        self.assertEqual(self.exercise.solver_texts(student / "13")["tinydem.hpp"],
                         (ROOT / "tinydem" / "tinydem.hpp").read_text())
        (student / "13" / "tinydem.hpp").symlink_to(ROOT / "tinydem" / "tinydem.hpp")
        self.assertNotEqual(classroom.find_answer(student, self.exercise), student / "13")

    def test_hand_out_and_gradebook(self):
        """The hand-out has the solver and a copy to edit, and no change of the solution."""
        tree, output = SCRATCH / "solver tree", SCRATCH / "solver grades"
        code, said = run(ROOT, "handout", tree, "13")
        self.assertEqual(code, 0, said)
        for name in solver.FILES:
            text = (tree / "tinydem" / name).read_text()
            self.assertEqual(text, (ROOT / "tinydem" / name).read_text())
            self.assertEqual(text, (tree / "exercises/13-adhesion/answer" / name).read_text())
        self.assertEqual([p.name for p in tree.rglob("*") if p.is_file() and (
            "CHANGES = " in p.read_text(errors="replace") and p.name != "solver.py")], [])
        code, said = run(tree, "grade", "13", "--check", "apart", "--check", "parameter")
        self.assertEqual(code, 1, said)
        self.assertIn("'gamma' is unknown", said)
        solver.write(self.right, tree / "exercises/13-adhesion/answer")
        code, said = run(tree, "grade", "13", "--seed", "3")
        self.assertRegex(said, r"13 .* 100/100")
        hostile = {**self.right, "tinydem.cpp": self.right["tinydem.cpp"].replace(
            "void Simulation::run(long n) {", "void Simulation::run(long n) {\n  if (p.gamma > 1) "
            "std::exit(0);\n  if (p.eta > 0) for (volatile bool on = true; on;) {}", 1)}
        for name, texts in ("right", self.right), ("hostile", hostile):
            solver.write(texts, SCRATCH / "solver class" / name / "13")
        code, said = run(ROOT, "gradebook", SCRATCH / "solver class", "13", "--output", output,
                         "--seed", "7")
        self.assertEqual(code, 0, said)
        with open(output / "grades.csv", newline="") as file:
            rows = {row["student"]: row for row in csv.DictReader(file)}
        self.assertEqual(float(rows["right"]["points"]), 100)
        self.assertIn("two_spheres", rows["hostile"]["lost"])
        self.assertIn("unchanged", rows["hostile"]["lost"])
        self.assertNotIn("ceiling", rows["hostile"]["lost"])
        self.assertEqual(float(rows["hostile"]["builds"]), 5)


class CommandLine(unittest.TestCase):
    """Mistakes, and --watch."""

    def test_mistakes(self):
        for arguments, text in ((["grade", "77"], "no exercise '77'"),
                                (["grade", "01", "--check", "nosuch"], "no check 'nosuch'"),
                                (["grade", "01", "--compiler", "nosuch"], "no compiler 'nosuch'"),
                                (["grade", "01", "--file", "nosuch"], "nosuch must be a file"),
                                (["gradebook", "/nosuch"], "a directory per student"),
                                (["grade", "--seed", "x"], "--seed")):
            code, said = run(ROOT, *arguments)
            self.assertEqual(code, 2, said)
            self.assertIn(text, said)

    def test_json(self):
        code, said = run(ROOT, "grade", "01", "--file", HERTZ.folder / "solution.cpp", "--json")
        self.assertEqual(code, 0, said)
        self.assertEqual(json.loads(said)[0]["points"], 100)

    def test_watch_grades_what_was_saved(self):
        answer = SCRATCH / "watched.cpp"
        shutil.copy(HERTZ.folder / "starter.cpp", answer)
        command = [sys.executable, "-u", str(EXERCISES / "grade.py"), "grade", "01", "--watch",
                   "--file", str(answer), "--check", "repulsion"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as watcher:
            self.assertIn("0/10", self.until_watching(watcher))
            answer.write_text(SOLUTION)
            self.assertIn("10/10", self.until_watching(watcher))
            watcher.terminate()

    def until_watching(self, watcher):
        """What is printed up to the next pause."""
        text = ""
        for line in watcher.stdout:
            text += line
            if line.startswith("watching"):
                break
        return text


if __name__ == "__main__":
    unittest.main()

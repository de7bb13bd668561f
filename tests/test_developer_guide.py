"""The changes that the developer guide shows, made to a copy of the solver: they compile without
warnings and do what the guide says.

By hand: cd tests && TINYDEM=../build/default/tinydem python3 -m unittest test_developer_guide"""
import csv
import math
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
GUIDE = (ROOT / "docs/developer-guide.md").read_text()
SOLVER = ("tinydem.hpp", "tinydem.cpp")
COMPILER = next((c for c in (os.environ.get("CXX"), "c++", "g++", "clang++")
                 if c and shutil.which(c)), None)
PROGRAM = str(Path(os.environ.get("TINYDEM", "tinydem")).resolve())
WARNINGS = "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Wno-unknown-pragmas".split()
HEADER = "x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz\n"
PLATE = "OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n"


def changes(section):
    """The changes in a section of the guide: a list of [file, old lines, new lines]."""
    text = GUIDE.split(f"\n## {section}\n")[1].split("\n## ")[0]
    found, name = [], ""
    for line in "".join(re.findall(r"```diff\n(.*?)```", text, re.S)).splitlines():
        if line.startswith("+++ b/"):
            name = Path(line).name
        elif line.startswith("@@"):
            found.append([name, "", ""])
        elif not line.startswith("--- "):
            found[-1][1] += line[1:] + "\n" if line[:1] in ("", " ", "-") else ""
            found[-1][2] += line[1:] + "\n" if line[:1] in ("", " ", "+") else ""
    return found


def apply(folder, section):
    """Makes the changes of a section; what they replace must stand in the file once."""
    for name, old, new in changes(section):
        text = (folder / name).read_text()
        if text.count(old) != 1:
            raise AssertionError(f"{section}: {name} has {text.count(old)} times:\n{old}")
        (folder / name).write_text(text.replace(old, new))


def compile_copy(folder, *flags):
    """Compiles folder/tinydem.cpp, for one instruction set."""
    source = (folder / "tinydem.cpp").read_text()
    (folder / "one_set.cpp").write_text(source.replace("#if defined(__x86_64__) && ", "#if 0 && "))
    return subprocess.run([COMPILER, "-std=c++17", *flags, "one_set.cpp"], cwd=folder,
                          capture_output=True, text=True)


def rows(path):
    with open(path, newline="") as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


@unittest.skipUnless(COMPILER, "no compiler")
class DeveloperGuide(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory(prefix="tinydem_guide_")
        cls.folder = Path(cls.keep.name)
        cls.addClassCleanup(cls.keep.cleanup)
        for name in SOLVER:
            shutil.copy(ROOT / "tinydem" / name, cls.folder)
        for section, number in (("Add a parameter", 1), ("Change the contact law", 3),
                                ("Add a force", 3)):
            assert len(changes(section)) == number, f"the changes of '{section}' are not found"
            apply(cls.folder, section)
        done = compile_copy(cls.folder, "-O0", *WARNINGS, "-o", "changed")
        assert done.returncode == 0, done.stderr[-3000:]

    def run_it(self, *words, program="./changed"):
        """Runs the changed solver in its folder; the finished process."""
        return subprocess.run([program, *map(str, words), "--overwrite", "--quiet"],
                              cwd=self.folder, capture_output=True, text=True)

    def flight(self, start, *options, mesh=""):
        """The frames of a run of one particle (a line of a particle file), a dictionary each."""
        (self.folder / "start.csv").write_text(HEADER + start + "\n")
        (self.folder / "plate.off").write_text(PLATE)
        done = self.run_it(mesh, "start.csv", "out", "--Nspawn", 0, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [rows(path)[0] for path in sorted((self.folder / "out").glob("particles*.csv"))]

    def test_each_example_compiles_by_itself_without_a_warning(self):
        for section in ("Add a parameter", "Add a force"):
            with tempfile.TemporaryDirectory() as name:
                for file in SOLVER:
                    shutil.copy(ROOT / "tinydem" / file, name)
                apply(Path(name), section)
                done = compile_copy(Path(name), "-fsyntax-only", "-DTINYDEM_NO_MAIN", *WARNINGS)
                self.assertEqual(done.returncode, 0, f"{section}: {done.stderr[-3000:]}")

    def test_parameter_is_listed_checked_and_kept(self):
        self.assertIn("share of the attractive normal force", self.run_it("--help").stdout)
        for words, expected in ((("--cut", "2"), "[0, 1]"), (("--cud", "1"), "cut")):
            done = self.run_it("", "", "bad", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(expected, done.stderr)
            self.assertFalse((self.folder / "bad").exists())
        self.flight("0,0,1,0.01,0,0,0,1,0,0,0,0,0,0", "--cut", 0.25, "--Nframes", 1, "--Nsteps", 1)
        self.assertIn("\ncut = 0.25\n", (self.folder / "out/scene.ini").read_text())

    def test_defaults_change_nothing(self):
        (self.folder / "plate.off").write_text(PLATE)
        options = ("--Nframes", 3, "--Nsteps", 100, "--Nmax", 60, "--seed", 3,
                   "--smin=-0.02,-0.02,0.01", "--smax=0.02,0.02,0.03")
        for out, program in (("new", "./changed"), ("old", PROGRAM)):
            done = self.run_it("plate.off", "", out, *options, program=program)
            self.assertEqual(done.returncode, 0, done.stderr)
        contacts = [row["contacts"] for row in rows(self.folder / "new/log.csv")]
        self.assertGreater(contacts[-1], 10)  # or this would show little
        for k in range(4):
            new, old = (self.folder / out / f"particles{k:06d}.csv" for out in ("new", "old"))
            self.assertEqual(new.read_text(), old.read_text())

    def test_restitution_without_the_attractive_tail(self):
        en = 0.5
        beta = 1 / math.sqrt(1 + (math.pi / math.log(en)) ** 2)
        clipped = math.exp(-2 * beta * math.acos(beta) / math.sqrt(1 - beta ** 2))
        # First order: errors of 1.6e-4 and 1.4e-4 at 1/64 of Eq. (50), where dt is 4.7e-6.
        for cut, expected in ((0, en), (1, clipped)):
            last = self.flight("0,0,0.0101,0.01,0,0,-1,1,0,0,0,0,0,0", "--Rmesh", 0,
                               "--Rmin", 0.01, "--g", "0,0,0", "--en", en, "--cut", cut, "--dt",
                               4.7e-6, "--Nframes", 1, "--Nsteps", 1000,
                               mesh="plate.off")[-1]
            self.assertAlmostEqual(last["vz"], expected, delta=1e-3)
        self.assertGreater(clipped, 0.55)

    def test_particle_in_a_trap_swings_as_its_recursion_does(self):
        omega, dt, start = 50, 1e-3, 0.1
        theta = math.acos(1 - (omega * dt) ** 2 / 2)
        frames = self.flight(f"{start},0,0,0.01,0,0,0,1,0,0,0,0,0,0", "--g", "0,0,0",
                             "--trap", omega, "--dt", dt, "--Nframes", 200, "--Nsteps", 1)
        self.assertEqual(len(frames), 201)
        worst = max(abs(frame["x"] / start - math.cos((n + 0.5) * theta) / math.cos(theta / 2))
                    for n, frame in enumerate(frames))
        self.assertLess(worst, 2e-13)  # rounding of 200 steps: measured 3e-14

    def test_functions_that_the_guide_names_exist(self):
        source = "".join((ROOT / "tinydem" / name).read_text() for name in SOLVER)
        names = set(re.findall(r"\b(\w+)\(\)", GUIDE))
        self.assertGreater(len(names), 20)
        missing = [n for n in sorted(names) if not re.search(rf"\b{n}\(", source)]
        self.assertEqual(missing, [])

    def test_mutant_of_the_guide_fits_the_solver(self):
        old = re.search(r'^old = "(.*)"$', GUIDE, re.M)[1]
        self.assertEqual((ROOT / "tinydem/tinydem.cpp").read_text().count(old), 1)


if __name__ == "__main__":
    unittest.main()

"""Every scene folder is complete, reproducible and accepted by the solver. By hand:

    cd tests && TINYDEM=../build/default/tinydem python3 -m unittest test_scenes
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tool_support import TOOLS

import frames

PROGRAM = os.environ.get("TINYDEM", "tinydem")
FOLDERS = sorted(path.parent for path in (TOOLS / "scenes").glob("*/scene.ini"))


class Scenes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="tinydem_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def copy(self, scene):
        """A copy of a scene, at the same place relative to the tools."""
        target = self.folder / "tinydem" / "scenes" / scene.name
        shutil.copytree(scene, target, ignore=shutil.ignore_patterns("__pycache__"))
        for tool in TOOLS.glob("*.py"):
            shutil.copy(tool, self.folder / "tinydem")
        return target

    def run_scene(self, path, *options):
        """The solver on a scene file; its folder of results."""
        out = self.folder / "out" / f"{path.parent.name}-{path.stem}"
        done = subprocess.run([PROGRAM, "", "", out, "--scene", path, *options],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{path}: {done.stderr}")
        return out

    def test_folders_are_complete(self):
        self.assertGreaterEqual(len(FOLDERS), 7)
        for folder in FOLDERS:
            with self.subTest(folder.name):
                first = (folder / "scene.ini").read_text().splitlines()[0]
                self.assertRegex(first, r"^# \S.{20,}[.?]", "line 1 says what happens")
                self.assertTrue((folder / "README.md").read_text().startswith("# "))
                self.assertTrue((folder / "measure.py").is_file())

    def test_code_makes_the_files_that_are_here(self):
        for folder in FOLDERS:
            if not (folder / "make_mesh.py").is_file():
                continue
            with self.subTest(folder.name):
                copy = self.copy(folder)
                made = [p.name for p in folder.iterdir() if p.suffix in (".off", ".csv")]
                for name in made:
                    (copy / name).unlink()
                subprocess.run([sys.executable, copy / "make_mesh.py"], check=True,
                               capture_output=True)
                # A packing that the solver settles depends on the last digit of every sum.
                settled = "TINYDEM" in (folder / "make_mesh.py").read_text()
                for name in made:
                    new, old = ((f / name).read_text() for f in (copy, folder))
                    if settled and name.endswith(".csv"):
                        self.assertEqual(new.splitlines()[0], old.splitlines()[0], name)
                        grains = [len(text.splitlines()) - 1 for text in (new, old)]
                        self.assertAlmostEqual(grains[0] / grains[1], 1, delta=0.02, msg=name)
                    else:
                        self.assertEqual(new, old, name)

    def test_the_solver_accepts_them(self):
        for folder in FOLDERS:
            copy = self.copy(folder)
            for path in sorted(copy.glob("*.ini")):
                with self.subTest(f"{folder.name}/{path.name}"):
                    scene = frames.read_scene(path)
                    if not scene.get("mesh", path).is_file():
                        subprocess.run([sys.executable, copy / "make_mesh.py"], check=True)
                    few = min(scene.get("Nmax", 1000), 3000)
                    out = self.run_scene(path, "--Nframes", "1", "--Nsteps", "10", "--Nspawn",
                                         "100", "--Nmax", str(few))
                    self.assertEqual(len(frames.read_run(out).files), 2)

    def test_measurements_start(self):
        for folder in FOLDERS:
            for script in folder.glob("measure.py"):
                with self.subTest(folder.name):
                    done = subprocess.run([sys.executable, script, "--help"], capture_output=True)
                    self.assertEqual(done.returncode, 0)
                    done = subprocess.run([sys.executable, script, self.folder / "none"],
                                          capture_output=True)
                    self.assertEqual(done.returncode, 2)

    def test_discs_stay_in_their_plane_bit_for_bit(self):
        out = self.run_scene(TOOLS / "scenes" / "jamming" / "scene.ini", "--Nframes", "2",
                             "--Nsteps", "2000", "--Nmax", "150")
        frame = frames.read_run(out).frame()
        self.assertEqual(len(frame), 150)
        for name in ("y", "vy", "wx", "wz", "q1", "q3"):
            self.assertTrue((frame[name] == 0).all(), name)
        self.assertGreater(abs(frame["wy"]).max(), 0)  # they did touch something


if __name__ == "__main__":
    unittest.main()

"""The program from outside: options, exit codes, files, restart. By hand:

    TINYDEM=../build/default/tinydem python3 -m unittest test_command_line
"""
import csv
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.environ.get("TINYDEM", "tinydem")
HEADER = "x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"
PARAMETERS = """Rmin Rmax Rmesh smin smax rho E nu en mus mur mut eta v0 w0 g dt Nmax Nframes Nsteps Nspawn
                seed scheme orientation""".split()
FLOOR = "OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n"
# Sixty grains fall on the floor and on each other.
SCENE = """mesh = floor.off
Nmax = 60
Nframes = 6
Nsteps = 100
Nspawn = 5
Rmin = 0.004
Rmax = 0.005
smin = -0.02,-0.02,0.02
smax = 0.02,0.02,0.05
"""


def particle(x="0,0,0", R="0.01", v="0,0,0", w="0,0,0"):
    return f"{x},{R},{v},1,0,0,0,{w}\n"


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def files(folder, pattern="*.csv"):
    """Name -> bytes of the files of a run; log.csv without the speed, which is never the same."""
    contents = {path.name: path.read_bytes() for path in sorted(Path(folder).glob(pattern))}
    if "log.csv" in contents:
        contents["log.csv"] = [line.rpartition(b",")[0] for line in contents["log.csv"].splitlines()]
    return contents


class CommandLine(unittest.TestCase):
    maxDiff = 2000

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="tinydem_"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.write("floor.off", FLOOR)
        self.write("scene.ini", SCENE)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def start(self, *arguments, threads=1, **options):
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
        return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)

    def run_it(self, *arguments, code=0, says="", **options):
        """Runs the program; checks its exit code and what it says on stderr."""
        process = self.start(*arguments, **options)
        out, error = process.communicate(timeout=300)
        self.assertEqual(process.returncode, code, f"{arguments}\n{out}\n{error}")
        self.assertIn(says, error)
        return out

    # ------------------------------------------------------------------------- help and frames

    def test_help_lists_every_parameter_with_default_and_range(self):
        text = self.run_it("--help")
        for name in PARAMETERS + "scene overwrite resume contacts quiet version".split():
            self.assertIn(f"--{name} ", text)
        for part in ("Eq. 50", "2/3 mus", "0,0,-9.81", "(-1, 0.5]", "[M/L^3]", "consistent|paper", "mesh", "particles"):
            self.assertIn(part, text)
        self.assertRegex(self.run_it("--version"), r"^\d+\.\d+\.\d+\n$")

    def test_frames_log_and_standard_output(self):
        out = self.run_it("", "", "out", "--scene", "scene.ini", "--contacts")
        self.assertEqual(len(out.splitlines()), 7)
        expected = [f"{kind}{k:06d}.csv" for kind in ("contacts", "particles") for k in range(7)]
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()),
                         sorted(expected + ["log.csv", "scene.ini", "restart.bin", "mesh.off"]))
        self.assertEqual((self.folder / "out/particles000006.csv").read_text().splitlines()[0], HEADER)
        ini = dict(line.split(" = ") for line in (self.folder / "out/scene.ini").read_text().splitlines()[1:])
        self.assertLessEqual(set(PARAMETERS) - {"mesh"}, set(ini))
        supplied = None
        for k, row in enumerate(table(self.folder / "out/log.csv")):
            value = {name: float(text) for name, text in row.items()}
            grains = table(self.folder / f"out/particles{k:06d}.csv")
            contacts = table(self.folder / f"out/contacts{k:06d}.csv")
            sums = {"kinetic": 0, "rotational": 0, "potential": 0}
            for grain in grains:
                g = {name: float(text) for name, text in grain.items()}
                m = 4 / 3 * math.pi * float(ini["rho"]) * g["R"]**3
                sums["kinetic"] += m / 2 * (g["vx"]**2 + g["vy"]**2 + g["vz"]**2)
                sums["rotational"] += m / 5 * g["R"]**2 * (g["wx"]**2 + g["wy"]**2 + g["wz"]**2)
                sums["potential"] += m * 9.81 * g["z"]
            for name, energy in sums.items():
                self.assertAlmostEqual(value[name], energy, delta=1e-13 * (1e-3 + energy))
            self.assertEqual((value["frame"], value["N"], value["contacts"]), (k, len(grains), len(contacts)))
            self.assertAlmostEqual(value["t"], k * 100 * float(ini["dt"]), delta=1e-12)
            self.assertGreaterEqual(value["dissipated"], 0)
            for contact in contacts:
                R = float(grains[int(contact["i"])]["R"])
                if int(contact["j"]) >= 0:
                    self.assertEqual(contact["element"], "-1")
                    R = min(R, float(grains[int(contact["j"])]["R"]))
                self.assertGreater(float(contact["delta"]), 0)
                self.assertLessEqual(float(contact["delta"]) / R, value["overlap"])
            if len(grains) == 60:  # nothing comes in any more: the energies add up to the same
                total = sum(value[n] for n in ("kinetic", "rotational", "potential", "elastic", "dissipated"))
                supplied = supplied or total
                self.assertAlmostEqual(total, supplied, delta=1e-12 * supplied)
        self.assertIsNotNone(supplied)
        self.assertGreater(value["contacts"], 10)

    def test_positional_arguments_may_be_skipped_and_quiet_is_quiet(self):
        self.write("grains.csv", HEADER + "\n" + particle("0,0,1"))
        out = self.run_it("", "grains.csv", "out", "--Nframes", 1, "--Nsteps", 1, "--Nspawn=0", "--quiet")
        self.assertEqual(out, "")
        self.assertEqual(len(table(self.folder / "out/particles000001.csv")), 1)
        self.assertFalse((self.folder / "out/mesh.off").exists())

    def test_paths_by_name(self):
        self.write("grains.csv", HEADER + "\n" + particle("0,0,1"))
        self.write("floor.off", "OFF\n1 1 0\n0 0 0\n1 0 0\n")
        short = ("--Nframes", 1, "--Nsteps", 1, "--Nspawn=0", "--quiet")
        self.run_it("--output", "named", "--particles=grains.csv", "--mesh", "floor.off", *short)
        self.run_it("floor.off", "grains.csv", "placed", *short)
        for name in ("particles000001.csv", "mesh.off", "input.csv", "scene.ini"):
            self.assertEqual((self.folder / "named" / name).read_text(),
                             (self.folder / "placed" / name).read_text(), name)
        self.run_it("--mesh", "none.off", "--output", "new", *short, code=2, says="none.off: cannot be read")
        self.assertFalse((self.folder / "new").exists())

    # --------------------------------------------------------------------------------- mistakes

    def test_bad_input_ends_with_2_and_writes_nothing(self):
        self.write("bad.off", "OFF\n1 1 0\n0 0 x\n1 0\n")
        self.write("bad.csv", HEADER + "\n" + particle("0,0,nan"))
        self.write("bad.ini", "E = 1e6\nE = 2e6\n")
        self.write("twins.csv", HEADER + "\n" + particle() + particle())
        self.write("deep.csv", HEADER + "\n" + particle() + particle("0.009,0,0"))
        table_of_mistakes = [
            (["--E", "-1"], "E = '-1' must be a number in (0, inf)"),
            (["--nu", "0.6"], "(-1, 0.5]"),
            (["--E", "nan"], "E = 'nan'"),
            (["--E", "1e6x"], "E = '1e6x'"),
            (["--E", ""], "E"),
            (["--g", "1,2"], "three numbers (0,0,1)"),
            (["--scheme", "Paper"], "consistent|paper"),
            (["--Nframes", "1.5"], "an integer"),
            (["--mu_s", "0.1"], "did you mean 'mus'?"),
            (["--Emod=3"], "unknown"),
            (["--E", "1e6", "--E", "2e6"], "E"),
            (["--E"], "E"),
            (["--scene", "nowhere.ini"], "nowhere.ini: cannot be read"),
            (["--scene", "bad.ini"], "bad.ini:2: 'E' is repeated, it stands in bad.ini:1"),
            (["one.off", "two.csv", "out", "four"], "four"),
            (["nowhere.off", "", "out"], "nowhere.off: cannot be read"),
            (["bad.off", "", "out"], "bad.off:3: z = 'x'"),
            (["floor.off", "bad.csv", "out"], "bad.csv:2: z = 'nan'"),
            (["", "twins.csv", "out"], "particle 1"),
            (["", "deep.csv", "out"], "overlaps particle"),
            (["", "", "floor.off"], "floor.off: cannot be a directory to write in; name another"),
            (["", "", "/proc/nowhere/out"], "/proc/nowhere/out"),
        ]
        before = sorted(self.folder.iterdir())
        for arguments, says in table_of_mistakes:
            with self.subTest(arguments=arguments):
                if not arguments[0].startswith("--"):
                    arguments = arguments + ["--Nframes", "0"]
                else:
                    arguments = ["", "", "out", "--Nframes", "0"] * (arguments[0] != "--Nframes") + arguments
                try:
                    self.assertEqual(self.run_it(*arguments, code=2, says=says), "")
                    self.assertEqual(sorted(self.folder.iterdir()), before)
                finally:
                    shutil.rmtree(self.folder / "out", ignore_errors=True)

    def test_all_mistakes_are_reported_at_once(self):
        for says in ("E = '-1'", "nu = '7'", "Nmax = '-3'"):
            self.run_it("--E", "-1", "--nu", "7", "--Nmax", "-3", code=2, says=says)

    def test_command_line_beats_scene_file_beats_default(self):
        self.write("one.ini", "E = 5e5\nnu = 0.2\nNframes = 0\noutput = one\n")
        self.run_it("--scene", "one.ini", "--nu", "0.1")
        ini = (self.folder / "one/scene.ini").read_text().splitlines()
        for line in ("E = 5e+05", "nu = 0.1", "rho = 1000", "Nframes = 0"):
            self.assertIn(line, ini)
        (self.folder / "sub").mkdir()
        self.write("sub/two.ini", "mesh = ../floor.off\noutput = two\nNframes = 0\n")  # relative to the file
        self.run_it("--scene", "sub/two.ini")
        self.assertTrue((self.folder / "sub/two/mesh.off").exists())

    # ----------------------------------------------------------------------------- same bits

    def test_overwrite(self):
        self.run_it("", "", "out", "--scene", "scene.ini")
        before = files(self.folder / "out", "*")
        self.run_it("", "", "out", "--scene", "scene.ini", code=2, says="add --overwrite or --resume")
        self.assertEqual(files(self.folder / "out", "*"), before)
        self.run_it("", "", "out", "--scene", "scene.ini", "--overwrite", "--Nframes", 2, "--seed", 2)
        after = files(self.folder / "out", "particles*.csv")
        self.assertEqual(len(after), 3)  # no frame of the old run is left
        self.assertNotEqual(after["particles000002.csv"], before["particles000002.csv"])

    def test_scene_ini_of_a_run_repeats_it_bit_for_bit(self):
        self.write("grains.csv", HEADER + "\n" + particle("0,0,0.3", v="0.1,0.2,-1", w="30,-20,10"))
        for options in ([], ["--scheme", "paper", "--mut", "0.1", "--dt", "1e-5"], ["--orientation", "off", "--eta", "1e-3"]):
            self.run_it("floor.off", "grains.csv", "one", "--scene", "scene.ini", "--contacts", *options)
            self.write("moved.off", FLOOR)
            os.rename(self.folder / "floor.off", self.folder / "away.off")  # the run keeps its own copy
            self.run_it("", "", "two", "--scene", "one/scene.ini")
            self.run_it("--scene", "one/scene.ini", "--overwrite")  # in place
            os.rename(self.folder / "away.off", self.folder / "floor.off")
            self.assertEqual(files(self.folder / "one"), files(self.folder / "two"))
            for name in ("one", "two"):
                shutil.rmtree(self.folder / name)

    def test_frames_come_back_bit_for_bit(self):
        self.run_it("", "", "out", "--scene", "scene.ini")
        frame = self.folder / "out/particles000006.csv"
        self.run_it("", frame, "back", "--Nframes", "0", "--Nspawn", "0")
        self.assertEqual(frame.read_bytes(), (self.folder / "back/particles000000.csv").read_bytes())

    def test_same_bits_for_every_number_of_threads(self):
        numbers = random.Random(1)
        n = 16  # enough for several slabs of particles
        with open(self.folder / "grains.csv", "w") as file:
            file.write(HEADER + "\n")
            for k in range(n**3):
                x = [0.019 * (c - n / 2) for c in (k % n, k // n % n, k // n // n)]
                file.write(particle("{},{},{}".format(*x), repr(numbers.uniform(0.008, 0.0098)),
                                    "{},{},{}".format(*(-15 * c + numbers.uniform(-1, 1) for c in x))))
        for threads in (1, 2, 3):
            self.run_it("", "grains.csv", f"out{threads}", "--Nframes", 3, "--Nsteps", 15, "--Nmax", n**3 + 10,
                        "--Nspawn", 5, threads=threads)
        self.assertEqual(files(self.folder / "out1"), files(self.folder / "out2"))
        self.assertEqual(files(self.folder / "out1"), files(self.folder / "out3"))
        self.assertGreater(int(table(self.folder / "out1/log.csv")[-1]["contacts"]), 1000)

    # --------------------------------------------------------------------------------- restart

    def test_a_killed_run_resumes_bit_for_bit(self):
        arguments = ["--scene", "scene.ini", "--Nframes", 30, "--Nsteps", 200, "--Nmax", 150, "--Nspawn", 1, "--contacts",
                     "--motion", "0 vibrate 0.001,0,0.001 30 1"]
        self.run_it("", "", "whole", *arguments)
        numbers = random.Random(time.time_ns())
        resume, kills = [], 0
        for after_frame in (1, 9, 10, 20, 28):
            process = self.start("", "", "killed", *arguments, *resume)
            while process.poll() is None and not (self.folder / f"killed/particles{after_frame:06d}.csv").exists():
                time.sleep(0.001)
            time.sleep(numbers.uniform(0, 0.01))
            process.send_signal(signal.SIGKILL)
            process.communicate()
            kills += process.returncode == -signal.SIGKILL
            resume = ["--resume"]
        self.assertGreater(kills, 0)
        self.run_it("", "", "killed", *arguments, "--resume")
        self.assertEqual(files(self.folder / "killed"), files(self.folder / "whole"))
        self.assertEqual(list((self.folder / "killed").glob("*.part")), [])
        self.assertEqual(self.run_it("", "", "killed", *arguments, "--resume"), "")  # nothing is left to do

    def test_resume_starts_a_new_run_and_refuses_a_foreign_file(self):
        self.run_it("", "", "out", "--scene", "scene.ini", "--resume")
        whole = files(self.folder / "out")
        restart = self.folder / "out/restart.bin"
        for content in (restart.read_bytes()[:-10], b"", b"foreign" * 1000):
            restart.write_bytes(content)
            self.run_it("", "", "out", "--resume", code=2, says="restart.bin")
        restart.unlink()  # killed before the first frame was complete
        self.run_it("", "", "out", "--resume")
        self.assertEqual(files(self.folder / "out"), whole)

    def test_resume_continues_with_more_frames(self):
        self.run_it("", "", "long", "--scene", "scene.ini")
        self.run_it("", "", "short", "--scene", "scene.ini", "--Nframes", 3)
        self.run_it("", "", "short", "--resume", "--Nframes", 6)
        self.assertEqual(files(self.folder / "short"), files(self.folder / "long"))

    # --------------------------------------------------------------------------------- failure

    def check_no_nan(self, folder):
        for name, content in files(folder).items():
            text = content.decode() if isinstance(content, bytes) else b"\n".join(content).decode()
            for word in ("nan", "inf"):
                self.assertNotIn(word, text, name)

    def test_an_unstable_run_ends_with_1_and_keeps_good_frames(self):
        self.run_it("", "", "out", "--scene", "scene.ini", "--dt", "2e-3", "--Nsteps", "5", "--Nframes", "100", code=1,
                    says="try a smaller --dt")
        self.check_no_nan(self.folder / "out")
        self.assertEqual(list((self.folder / "out").glob("*.part")), [])
        frames = files(self.folder / "out", "particles*.csv")
        self.assertGreater(len(frames), 1)
        self.assertEqual(len(frames), len(table(self.folder / "out/log.csv")))

    def test_a_step_that_is_too_large_is_warned_about_before_the_first_one(self):
        step = 0.004 * math.sqrt(1e3 * (1 - 0.3 ** 2) / 1e6)  # Eq. (50)
        short = ["--scene", "scene.ini", "--Nframes", "0", "--overwrite", "--dt"]
        for times, more, says in [(2, [], "2 times Eq. (50): 6.5 steps per contact, errors of 4 %, "
                                          "unstable from 4 times"),
                                  (3, ["--en", "0", "--mus", "3"], "unstable from 1.5 times"),
                                  (3, ["--en", "1", "--mus", "0"], "unstable from 4.8 times")]:
            self.run_it("", "", "out", *short, times * step, *more, says="warning: dt is " + says
                        if times == 2 else says)
        process = self.start("", "", "out", *short, step)
        self.assertEqual(process.communicate(timeout=300)[1], "")

    def test_extreme_numbers_do_not_become_nan(self):
        self.write("v.csv", HEADER + "\n" + particle(v="0,0,1e200"))
        self.write("w.csv", HEADER + "\n" + particle(w="0,0,1e300"))
        for name, arguments in {"v": ["v.csv", "v"], "w": ["w.csv", "w"], "v0": ["", "v0", "--v0", "0,0,1e200"],
                                "w0": ["", "w0", "--w0", "0,0,1e300"]}.items():
            with self.subTest(arguments=arguments):
                process = self.start("", *arguments, "--Nframes", 2, "--Nsteps", 3, "--Nspawn", 1)
                process.communicate()
                self.assertIn(process.returncode, (1, 2))
                self.check_no_nan(self.folder / name)

    def test_a_full_disk_ends_with_1_and_leaves_no_broken_frame(self):
        def little_space():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))
        self.run_it("", "", "whole", "--scene", "scene.ini")
        self.run_it("", "", "out", "--scene", "scene.ini", code=1, says="cannot be written", preexec_fn=little_space)
        self.assertEqual(list((self.folder / "out").glob("*.part")), [])
        frames, whole = (files(self.folder / name, "particles*.csv") for name in ("out", "whole"))
        self.assertGreater(len(frames), 0)
        for name, content in frames.items():
            self.assertEqual(content, whole[name])
        self.run_it("", "", "out", "--scene", "scene.ini", "--resume")
        self.assertEqual(files(self.folder / "out"), files(self.folder / "whole"))


if __name__ == "__main__":
    unittest.main()

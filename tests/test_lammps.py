"""The hand-off to LAMMPS and LIGGGHTS: numbers, files, refusals and the way back; no LAMMPS here.
What LAMMPS makes of the files is case 27 of the verification suite: ./dem verify --lammps."""
import json
import math
import os
import tempfile
import unittest
from pathlib import Path

import numpy as np

from tool_support import TOOLS, message_of, particle, run_tool, write_run
import lammps
from frames import HEADER, columns, read_mesh, read_run

SCENE = "Rmin = 0.01\nRmax = 0.01\nRmesh = 0,0\nrho = 1000\nE = 1e6\nnu = 0.3\nen = 0.5\n" \
        "mus = 0.3\nmur = 0.3\nmut = 0.2\neta = 0\ng = 0,0,-9.81\ndt = 1e-4\nNmax = 2\n" \
        "Nframes = 3\nNsteps = 10\nNspawn = 0\nscheme = consistent\n"
CUBE = "OFF\n8 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n" \
       "4 0 1 2 3 {g}\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
BOX = CUBE.format(g=0)
TWO = particle("0.5,0.5,0.2", v="1,2,3", w="4,5,6") + particle("0.5,0.5,0.6", "0.02")


def changed(**values):
    """SCENE with other values."""
    lines = [line for line in SCENE.splitlines() if line.split()[0] not in values]
    return "\n".join(lines + [f"{name} = {value}" for name, value in values.items()]) + "\n"


class Folder(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.addCleanup(self.holder.cleanup)
        self.here = Path(self.holder.name)

    def hand_off(self, scene=SCENE, mesh=BOX, particles=TWO, options=(), fails=None):
        """Hands a run made by hand off; the folder, or the message of a refusal with `fails`."""
        run = write_run(self.here / "run", [particles], scene, mesh)
        code, out, err = run_tool(TOOLS / "lammps.py", run, self.here / "to", *options)
        self.assertEqual(code, 2 if fails else 0, err)
        if fails:
            for text in [fails] if isinstance(fails, str) else fails:
                self.assertIn(text, err)
            self.assertEqual(err.count("\n"), 1, err)
            self.assertFalse((self.here / "to").exists(), "a refusal leaves no files")
        else:
            self.assertEqual(out, (self.here / "to/README.txt").read_text())
        return self.here / "to"


class Numbers(unittest.TestCase):
    def test_restitution(self):
        for en in (0, 0.05, 0.3, 0.5, 0.9, 0.999, 1):
            beta = {0: 1, 1: 0}.get(en) if en in (0, 1) else \
                -math.log(en) / math.hypot(math.pi, math.log(en))
            # 1e-15: the last digit of a polynomial with terms up to 27
            self.assertAlmostEqual(lammps.tsuji(lammps.restitution_for(en)), math.sqrt(5) * beta,
                                   delta=2e-14)
        self.assertLess(lammps.restitution_for(0.1), 0)
        self.assertGreater(lammps.restitution_for(0.115), 0)

    def test_words_of_a_pair_and_a_wall(self):
        p = {"E": 1e6, "nu": 0.25, "en": 1, "rho": 1000, "mus": 0.3, "mur": 0.2, "mut": 0.1}
        pair = lammps.contact_words(p, 0.01, 0.01).split()
        self.assertEqual(pair[:2], ["hertz/material", "1000000"])
        self.assertEqual(pair[pair.index("mindlin") + 1], "NULL")
        # by hand: a = sqrt(0.005 * 0.0002) = 1e-3, k_n = 4/3 * 1e6/(2 * 15/16) * 1e-3
        self.assertAlmostEqual(float(pair[pair.index("rolling") + 2]), 32000 / 45, delta=1e-5)
        self.assertEqual(pair[pair.index("rolling") + 3:][:2], ["0", f"{0.2:.17g}"])
        # k_s = 8 * 1e6/(4 * 1.75 * 1.25) * 1e-3, times R*^2
        self.assertAlmostEqual(float(pair[pair.index("twisting") + 2]), 6400 / 7 * 2.5e-5,
                               delta=1e-9)
        self.assertAlmostEqual(float(pair[pair.index("twisting") + 4]), 0.1 * 0.005, delta=1e-12)
        wall = lammps.contact_words(p, 0.01).split()
        self.assertAlmostEqual(float(wall[1]), 4 / 3 * 1e6 * 16 / 15, delta=1e-9)
        self.assertAlmostEqual(float(wall[wall.index("mindlin") + 1]), 4e6 / (1.75 * 1.25),
                               delta=1e-8)
        none = lammps.contact_words({**p, "mus": 0, "mur": 0, "mut": 0}, 0.01)
        self.assertNotIn("mindlin", none)
        self.assertNotIn("sds", none)

    def test_classes(self):
        self.assertEqual(len(lammps.radius_classes(np.full(5, 0.3)).radii), 1)
        self.assertEqual(lammps.radius_classes(np.full(5, 0.3)).error, 0)
        three_to_one = lammps.radius_classes(np.linspace(1, 3, 1000))
        self.assertEqual(len(three_to_one.radii), 7)  # 1.2^7 > 3
        self.assertAlmostEqual(three_to_one.error, 0.078, delta=0.001)
        self.assertEqual(len(lammps.radius_classes(np.linspace(1, 10, 1000)).radii), 8)
        two = lammps.radius_classes(np.array([1.0, 3, 1, 3]))  # classes between are empty
        self.assertEqual((two.radii.tolist(), two.of.tolist()), ([1, 3], [0, 1, 0, 1]))

    def test_start_with_drag(self):
        """Half a kick of velocity Verlet with the drag of v0 leads to our first step."""
        f = np.zeros(1, [(n, float) for n in HEADER.split(",")])
        f["vx"], f["wy"], dt, c, g = 2, 3, 0.01, 7.0, np.array([0, 0, -9.81])

        class run:
            scene = {"dt": dt, "g": g}
        v, w = lammps.start_velocities(lammps.State(run, 0, f, 1, "", ""), np.array([c]))
        np.testing.assert_allclose(v + dt / 2 * (g - c * v),
                                   [[2 * (1 - c * dt), 0, -9.81 * dt]], atol=1e-15)
        d = 10 / 3 * c
        np.testing.assert_allclose(w * (1 - dt / 2 * d), [[0, 3 * (1 - d * dt), 0]], atol=1e-15)

    def test_phase(self):
        A, F, phase, t, dt = 0.002, 15.3, 0.7, 0.4, 1.234567e-4
        lo, a, began, off = lammps.wiggle((2, A, F, phase), t, dt)
        self.assertLess(abs(off), 1e-5)
        for s in (0, 0.01, 0.02):  # LAMMPS' formula, ours
            angle = 2 * math.pi * F * (s - began * dt)
            here = A * (math.sin(2 * math.pi * F * (t + s) + phase) - math.sin(phase))
            self.assertAlmostEqual(lo + a - a * math.cos(angle), here, delta=1e-5 * A)


class Files(Folder):
    def test_data_file(self):
        lines = (self.hand_off() / "data.tinydem").read_text().splitlines()
        self.assertIn("2 atoms", lines)
        self.assertIn("2 atom types", lines)
        rows = [line.split() for line in lines[lines.index("Atoms") + 2:][:2]]
        self.assertEqual([r[:2] for r in rows], [["1", "1"], ["2", "2"]])
        self.assertEqual([float(v) for v in rows[0][2:]], [0.02, 1000, 0.5, 0.5, 0.2])
        v = lines[lines.index("Velocities") + 2].split()
        self.assertEqual([float(x) for x in v],
                         [1, 1, 2, 3 - 9.81 * 1e-4 / 2, 4, 5, 6])

    def test_input_file(self):
        text = (self.hand_off() / "in.tinydem").read_text()
        for line in ("boundary f f fm\n", "processors * * 1\n", "newton off\n", "run 30\n",
                     "timestep 0.0001\n", "dump frames all custom 10 frame.*.dump"):
            self.assertIn(line, text)
        for pair in ("1 1", "1 2", "2 2"):
            self.assertEqual(text.count(f"pair_coeff {pair} "), 1)
        for place in ("xplane 0 NULL", "xplane NULL 1", "yplane 0 NULL", "yplane NULL 1",
                      "zplane 0 NULL"):
            self.assertEqual(text.count(place), 2, place)  # once per class of radii
        self.assertEqual(text.count("\nrun "), 1)  # a second plain run changes the walls
        self.assertNotIn("limit_damping", text)

    def test_readme_says_what_is_approximate(self):
        text = (self.hand_off(particles=TWO + particle("0.5,0.5,0.8", "0.0105")) /
                "README.txt").read_text()
        for word in ("lever arm", "D2", "springs are constant", "2 radius classes", "2.4 %",
                     "Lost atoms", "orientations", "springs of friction"):
            self.assertIn(word, text)

    def test_seams_and_thickness(self):
        tiles = BOX.replace("8 5 0", "8 6 0").replace("4 0 1 2 3 0", "3 0 1 2\n3 0 2 3")
        folder = self.hand_off(changed(Rmesh="0.01"), tiles)
        self.assertIn("1 seams", (folder / "README.txt").read_text())
        self.assertIn("zplane 0.01 NULL", (folder / "in.tinydem").read_text())
        self.assertIn("yplane NULL 0.98999999999999999", (folder / "in.tinydem").read_text())

    def test_vibration_and_drag(self):
        mesh = CUBE.format(g=1)
        motion = "1 vibrate 0,0,0.002 20 -1.5707963267948966"
        folder = self.hand_off(changed(eta=0.01, motion=motion), mesh)
        text = (folder / "in.tinydem").read_text()
        self.assertIn("zplane 0 NULL wiggle z 0.002", text)
        self.assertNotIn("reset_timestep", text)  # this phase is LAMMPS' own
        self.assertIn("langevin 0 0 2.2222222222222223 1 omega yes scale 2 4", text)

    def test_inclined_walls(self):
        groove = "OFF\n6 2 0\n0 -1 0\n0 1 0\n1 -1 0.7\n1 1 0.7\n-1 -1 0.7\n-1 1 0.7\n" \
            "4 0 1 3 2\n4 0 1 5 4\n"
        text = (self.hand_off(mesh=groove, particles=particle("0,0,0.3")) /
                "in.tinydem").read_text()
        self.assertEqual(text.count("wall/gran/region"), 2)
        self.assertEqual(text.count(" plane "), 2)

    def test_liggghts(self):
        folder = self.hand_off(options=["--liggghts"])
        text = (folder / "in.liggghts").read_text()
        for words in ("same normal law, approximate friction", "peratomtype 1000000 1e30",
                      "soft_particles yes", "rolling_friction epsd3", "scalar 11.1111111111",
                      "tangential_damping off", "mesh/surface file mesh.stl"):
            self.assertIn(words, text)
        self.assertIn("same normal law, approximate friction", (folder / "README.txt").read_text())
        code, out, _ = run_tool(TOOLS / "mesh_tools.py", folder / "mesh.stl")
        self.assertEqual(code, 0)
        self.assertIn("10 triangles, 8 vertices", out)

    def test_scene_is_resolved_by_the_program(self):
        if "TINYDEM" not in os.environ:
            self.skipTest("needs TINYDEM")
        folder = self.here / "scene"
        folder.mkdir()
        (folder / "scene.ini").write_text("particles = p.csv\nNspawn = 0\ng = 0,0,0\n")
        (folder / "p.csv").write_text(HEADER + "\n" + TWO)
        code, _, err = run_tool(TOOLS / "lammps.py", folder, self.here / "to")
        self.assertEqual(code, 0, err)
        text = (self.here / "to/in.tinydem").read_text()
        self.assertIn("run 50000\n", text)  # the defaults of Nframes and Nsteps
        self.assertIn("mindlin NULL", text)
        self.assertNotIn("gravity", text)
        (folder / "scene.ini").write_text("particles = p.csv\nEE = 3\n")
        code, _, err = run_tool(TOOLS / "lammps.py", folder, self.here / "to2")
        self.assertEqual(code, 2)
        self.assertIn("'EE' is unknown", err)


class Refusals(Folder):
    def test_shapes(self):
        floor = "OFF\n8 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.2 .2 .4\n.8 .2 .4\n.8 .8 .4\n.2 .8 .4\n"
        hole = "OFF\n8 2 0\n0 0 0\n.4 0 0\n.4 1 0\n0 1 0\n.6 0 0\n1 0 0\n1 1 0\n.6 1 0\n" \
            "4 0 1 2 3\n4 4 5 6 7\n"
        one = particle("0.5,0.5,0.2")
        for mesh, particles, texts in (
                (floor + "4 0 1 2 3\n4 4 5 6 7\n1 0\n", one, ["mesh element 2 (point 0,0,0)"]),
                (floor + "4 0 1 2 3\n4 4 5 6 7\n2 0 1\n", TWO, ["mesh element 1", "not convex"]),
                (floor + "4 0 1 2 3\n4 4 5 6 7\n4 0 1 2 3\n", one,
                 ["mesh element 0", "lies twice"]),
                (hole, one, ["mesh element 0", "has holes or ends", "80 %"]),
                (floor.replace("8 3", "8 2") + "4 0 1 2 3\n4 4 5 6 7\n", one,
                 ["mesh element 1", "has holes or ends", "36 %"])):
            with self.subTest(texts=texts):
                self.hand_off(mesh=mesh, particles=particles, fails=[*texts, "--liggghts"])

    def test_open_below(self):
        funnel = "OFF\n8 4 0\n" + "".join(
            f"{x} {y} {z}\n" for r, z in ((0.1, 0), (0.5, 1)) for x, y in
            ((-r, -r), (r, -r), (r, r), (-r, r)))
        faces = [(a, (a + 1) % 4, 4 + (a + 1) % 4, 4 + a) for a in range(4)]
        mesh = funnel.replace("8 4 0", "8 8 0") + "".join(
            f"3 {a} {b} {c}\n3 {a} {c} {d}\n" for a, b, c, d in faces)
        self.hand_off(mesh=mesh, particles=particle("0,0,0.5"), fails="open at z = 0")

    def test_motion(self):
        mesh = CUBE.format(g=1)
        for motion, text in (("1 translate 0,0,1", "'translate'"),
                             ("0 rotate 0,0,0 0,0,1", "'rotate'"),
                             ("1 vibrate 0.1,0,0.1 3", "along x, y or z")):
            self.hand_off(changed(motion=motion), mesh, fails=["motion: group", text])

    def test_scene(self):
        self.hand_off(changed(scheme="paper"), fails=["scheme = paper", "consistent"])
        self.hand_off(changed(Nspawn=5, Nmax=9), fails=["only 2 of Nmax = 9", "--stop-spawning"])
        self.hand_off(particles=particle("0.5,0.5,2") + particle("1.5,0.5,0.3"),
                      fails=["mesh element 2", "not convex"])
        self.hand_off(options=["--classes", "0"], fails="--classes 0: must be from 1 to 50")
        self.hand_off(options=["--indentation", "2"], fails="must be between 0 and 1")
        self.hand_off(options=["--frame", "7"], fails="no frame 7")

    def test_beyond_the_floor(self):
        floor = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"
        self.hand_off(mesh=floor, particles=particle("1.5,0.5,0.3"),
                      fails=["particle 1", "beyond the walls (x = 1)"])

    def test_liggghts(self):
        for scene, text in ((changed(en=0.01), "en = 0.01: must be above 0.05"),
                            (changed(mur=3), "mur = 3"), (changed(eta=1), "eta = 1"),
                            (changed(motion="0 vibrate 0,0,1 1"), "'vibrate'"),
                            (changed(Rmesh="0.01"), "triangles without thickness")):
            self.hand_off(scene, options=["--liggghts"], fails=text)

    def test_folder_that_is_used(self):
        folder = self.hand_off()
        code, _, err = run_tool(TOOLS / "lammps.py", self.here / "run", folder)
        self.assertEqual(code, 2)
        self.assertIn("--overwrite", err)
        self.assertEqual(run_tool(TOOLS / "lammps.py", self.here / "run", folder,
                                  "--overwrite")[0], 0)


#: What LAMMPS 29Sep2021 wrote for the scene of Back, one step of 10 shown; masses rounded by us.
DUMP = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff ff fm
0 1
0 1
0 1
ITEM: ATOMS id type radius mass x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz 
2 2 0.02 0.04 0.5 0.5 0.6 0 0 -1 0 0 0 0 0 -0.3924 0 0 0
1 1 0.01 0.005 0.5 0.5 0.2 1 2 3 4 5 6 10 20 30 1e-6 0 -2e-6
"""


class Back(Folder):
    def back(self, dumps, *options):
        """Hands off, puts dumps {name: text} there, reads them back."""
        if not (self.here / "to").exists():
            self.hand_off()
        for old in (self.here / "to").glob("frame.*.dump"):
            old.unlink()
        for name, text in dumps.items():
            (self.here / "to" / name).write_text(text)
        return run_tool(TOOLS / "lammps.py", "--back", self.here / "to", self.here / "out",
                        *options)

    def test_frames(self):
        code, out, err = self.back({f"frame.{k}.dump": DUMP.format(step=k) for k in (0, 10, 20)})
        self.assertEqual(code, 0, err)
        self.assertIn("3 frames, 0 to 2", out)
        run = read_run(self.here / "out")
        self.assertEqual(list(run.files), [0, 1, 2])
        f = run.frame(1)
        self.assertEqual(f["R"].tolist(), [0.01, 0.02])  # in the order of their ids
        np.testing.assert_allclose(columns(f, "vx,vy,vz")[0],
                                   np.array([1, 2, 3]) * (1 - 5e-5 * 2000), rtol=1e-15)
        np.testing.assert_allclose(f["vz"][1], -1 + 5e-5 * 9.81, rtol=1e-15)
        np.testing.assert_allclose(columns(f, "wx,wy,wz")[0],
                                   [4 - 5e-5 * 1e-6 / 2e-7, 5, 6 + 5e-5 * 2e-6 / 2e-7], rtol=1e-14)
        self.assertEqual(columns(f, "q0,q1,q2,q3").tolist(), [[1, 0, 0, 0]] * 2)
        self.assertEqual(len(run.mesh), 5)
        self.assertAlmostEqual(run.log["potential"][0], 9.81 * (0.005 * 0.2 + 0.04 * 0.6))
        self.assertEqual(run.scene["particles"].name, "particles000000.csv")

    def test_round_trip(self):
        """A dump with what the data file holds gives the frame back."""
        folder = self.hand_off()
        lines = (folder / "data.tinydem").read_text().splitlines()
        at = lines.index("Atoms")
        v = {line.split()[0]: line.split()[1:] for line in lines[lines.index("Velocities") + 2:]}
        head, rows = DUMP.format(step=0).splitlines()[:9], []
        for line in lines[at + 2:at + 4]:
            number, kind, d, rho, *x = line.split()
            R = float(d) / 2
            m = 4 / 3 * math.pi * R**3 * float(rho)
            rows.append(" ".join([number, kind, repr(R), repr(m), *x, *v[number],
                                  f"0 0 {-9.81 * m!r} 0 0 0"]))
        code, _, err = self.back({"frame.0.dump": "\n".join(head + rows) + "\n"})
        self.assertEqual(code, 0, err)
        a, b = read_run(self.here / "run").frame(), read_run(self.here / "out").frame()
        for name in HEADER.split(","):
            np.testing.assert_allclose(a[name], b[name], atol=1e-15)

    def test_mistakes(self):
        good = DUMP.format(step=10)
        for text, expected in (
                (good[:-30], ":11: expected 2 lines of 19 finite"),
                (good.replace("20 30", "20 nan"), ":11: expected 2 lines"),
                (good.replace("\n2\nITEM", "\n3\nITEM"), ":4: 3 atoms at step 10, expected 2"),
                (good.replace(" fx", " ffx"), ":9: no column fx"),
                (good.replace("1 1 0.01", "2 1 0.01"), "the ids are not 1 to 2"),
                (good.replace("\n10\n", "\n11\n"), ":2: step 11 is no multiple of Nsteps = 10"),
                (good.replace("ITEM: TIMESTEP", "TIMESTEP"), ":1: expected 'ITEM: TIMESTEP'"),
                ("", ":1: expected 'ITEM: TIMESTEP', found 'the end'")):
            with self.subTest(expected=expected):
                code, _, err = self.back({"frame.10.dump": text})
                self.assertEqual(code, 2)
                self.assertIn("frame.10.dump" + expected if expected[0] == ":" else expected, err)
                self.assertFalse(list((self.here / "out").glob("*")), "nothing is written")
        code, _, err = self.back({})
        self.assertEqual((code, "no frame.*.dump" in err), (2, True))
        code, _, err = run_tool(TOOLS / "lammps.py", "--back", self.here, self.here / "out")
        self.assertEqual((code, "handoff.json" in err), (2, True))

    def test_offset(self):
        """Frames go on with the number of the frame that was handed off."""
        self.hand_off()
        facts = self.here / "to/handoff.json"
        facts.write_text(json.dumps({**json.loads(facts.read_text()), "frame": 7}))
        self.back({"frame.10.dump": DUMP.format(step=10)})
        self.assertEqual(list(read_run(self.here / "out").files), [8])


class Geometry(unittest.TestCase):
    def test_clip_and_area(self):
        square = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], float)
        self.assertEqual(lammps.area(square), 4)
        self.assertEqual(lammps.area(lammps.clip(square, np.array([1.0, 0, 0]), 0.5)), 3)
        n = np.array([1, 1, 0]) / math.sqrt(2)
        self.assertAlmostEqual(lammps.area(lammps.clip(square, n, math.sqrt(2))), 2)
        self.assertEqual(len(lammps.clip(square, np.array([1.0, 0, 0]), 3)), 0)

    def test_particle_within_a_wall(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "floor.off"
            path.write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
            run = read_run(write_run(Path(folder) / "run", [particle("0.5,0.5,0.2")]))
            elements = read_mesh(path, [0.3])
            self.assertIn("particle 1: its centre lies within mesh element 0",
                          message_of(self, lammps.planes_of, elements, run.frame()))


if __name__ == "__main__":
    unittest.main()

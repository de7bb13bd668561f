"""Reading a run, and its pictures. By hand: cd tests && python3 -m unittest test_frames"""
import tempfile
import unittest
from pathlib import Path

import numpy as np
from tool_support import FLOOR, SCENE, TOOLS, message_of, particle, run_tool, write_run

import frames
import result


class Frames(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="tinydem_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_run_reads_back(self):
        one, two = particle("1,2,3", "0.5", "3,0,4", "0,1,0,0", "7,8,9"), particle("4,5,6")
        run = frames.read_run(write_run(self.folder, ["", one, one + two], mesh=FLOOR))
        self.assertEqual([len(f) for _, f in run.frames()], [0, 1, 2])
        frame = run.frame()
        self.assertEqual(list(frame["z"]), [3, 6])
        self.assertEqual(frames.columns(frame, "wx,wy,wz").tolist(), [[7, 8, 9], [0, 0, 0]])
        self.assertEqual(frames.columns(run.frame(0), "x,y").shape, (0, 2))
        self.assertEqual(list(frames.speed(frame)), [5, 0])
        self.assertEqual(len(run.frame(-2)), 1)
        self.assertAlmostEqual(run.time(2), 0.02)
        self.assertIn("no frame 7", message_of(self, run.frame, 7))

    def test_a_scene_has_types(self):
        path = self.folder / "s.ini"
        path.write_text("# first\n# render: --hide 1\nNmax = 1e3\nRmesh = 0.5\n"
                        "g = 0,0,-9.81 # down\n"
                        "mesh = a.off\nscheme = paper\nmus = 0.3\n")
        scene = frames.read_scene(path)
        self.assertEqual((scene["Nmax"], scene["scheme"], scene["mus"]), (1000, "paper", 0.3))
        self.assertIsInstance(scene["Nmax"], int)
        self.assertEqual(scene["Rmesh"].tolist(), [0.5])
        self.assertEqual(scene["g"].tolist(), [0, 0, -9.81])
        self.assertEqual(scene["mesh"], self.folder / "a.off")
        self.assertEqual(scene["render"], "--hide 1")
        for line, found in (("mus 3", "mus 3"), ("mus = x", "mus = x"), ("Nmax = 1.5", "1.5"),
                            ("g = 0,nan,0", "nan")):
            path.write_text("mur = 0\n" + line + "\n")
            text = message_of(self, frames.read_scene, path)
            self.assertIn(f"{path}:2: ", text)
            self.assertIn(found, text)

    def test_bad_files_are_named_with_their_line(self):
        path = self.folder / "particles000000.csv"
        good = frames.HEADER + "\n" + particle()
        for text, where in ((good + particle("1,nan,3"), ":3:"), (good + "1,2\n", ":3:"),
                            (good + particle("1,2,x"), ":3:"),
                            (good + particle()[:-1] + ",5\n", ":3:"),
                            ("x,y\n1,2\n", ":1:"), ("", ":1:"), (good + "\n" + particle(), "")):
            path.write_text(text)
            self.assertIn(f"{path}{where}", message_of(self, frames.read_frame, path))
        self.assertIn("cannot be read", message_of(self, frames.read_frame, self.folder / "no.csv"))
        message = message_of(self, frames.read_run, self.folder / "x")
        self.assertIn("no particles000000.csv", message)

    def test_a_mesh_has_elements(self):
        path = self.folder / "m.off"
        path.write_text(FLOOR)
        mesh = frames.read_mesh(path, [0.0, 0.1])
        self.assertEqual([len(e.corners) for e in mesh], [4, 3, 2, 1])
        self.assertEqual([e.group for e in mesh], [0, 1, 1, 0])
        self.assertEqual([e.radius for e in mesh], [0, 0.1, 0.1, 0])
        for bad, line in ((FLOOR.replace("4 0 1 2 3 0", "4 0 1 2 9 0"), 10),
                          (FLOOR.replace("1 1 0", "1 x 0"), 6), (FLOOR.replace("1 5\n", ""), 1),
                          (FLOOR.replace("2 4 5 1", "2 4 5 2"), 12), ("ON" + FLOOR[3:], 1)):
            path.write_text(bad)
            self.assertIn(f"{path}:{line}:", message_of(self, frames.read_mesh, path, [0, 0.1]))

    def test_meshes_move(self):
        def at(motion, t):
            scene = SCENE + f"motion = {motion}\n"
            run = frames.read_run(write_run(self.folder, [""], scene, FLOOR))
            return run.mesh_at(t)
        moved = at("1 translate 1,2,3; 0 vibrate 0,0,2 0.25", 1.0)
        np.testing.assert_allclose(moved[2].corners, [[1, 2, 4], [2, 2, 4]])
        np.testing.assert_allclose(moved[3].corners, [[1, 0, 3]])
        phase = at("0 vibrate 2,0,0 1 1.5707963267948966", 0.5)[3].corners
        np.testing.assert_allclose(phase, [[1 - 4, 0, 1]])
        # A quarter turn about the line through (1, 0, 0) along z takes (1, 1, 0) to (0, 0, 0).
        turned = at("0 rotate 1,0,0 0,0,3.141592653589793", 0.5)[0].corners
        np.testing.assert_allclose(turned[2], [0, 0, 0], atol=1e-15)
        np.testing.assert_allclose(turned[0], [1, -1, 0], atol=1e-15)
        for bad in ("0 shake 1,2,3", "0 translate 1,2", "x translate 1,2,3", "0 vibrate 1,2,3"):
            self.assertIn(bad, message_of(self, frames.read_motion, bad))

    def test_numbers_have_the_digits_that_their_error_deserves(self):
        self.assertEqual(result.text(31.234, 0.42), "31.23 +- 0.42")
        self.assertEqual(result.text(31.234, float("nan")), "31.23")
        self.assertEqual(result.mean_error([1, 2, 3])[0], 2)
        self.assertAlmostEqual(result.mean_error([1, 2, 3])[1], 1 / 3**0.5)
        share, error = result.share_error(8, 8)
        self.assertEqual(share, 1)
        self.assertAlmostEqual(error, 0.5 / 9)

    def test_a_report_keeps_its_numbers(self):
        report = result.Report(self.folder)
        report.add("height, top", 1.5, 0.1, "m", "1.4")
        report.save()
        self.assertEqual((self.folder / "result.csv").read_text(),
                         'quantity,value,error,unit,expected\n"height, top",1.5,0.1,m,"1.4"\n')


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="tinydem_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def draw(self, *options):
        return run_tool(TOOLS / "render.py", self.folder, *options)

    def colors(self, name):
        """Share of reddish, blueish pixels of a picture."""
        from PIL import Image
        rgb = np.asarray(Image.open(self.folder / name).convert("RGB")).astype(int)
        red, blue = rgb[..., 0] - rgb[..., 2], rgb[..., 2] - rgb[..., 0]
        return (red > 60).mean(), (blue > 60).mean()

    def scene_of(self, number):
        """The pixels of a picture below its label, which tells the time."""
        from PIL import Image
        image = Image.open(self.folder / f"frame{number:06d}.png").convert("RGB")
        return np.asarray(image)[60:]

    def test_a_dye_follows_the_grains(self):
        # The left one starts on the left, falls through the gate on the right.
        first = particle("-1,0,1", "0.3") + particle("1,0,1", "0.3")
        later = particle("1,0,-1", "0.3") + particle("1,0,1", "0.3")
        write_run(self.folder, [first, later])
        self.assertEqual(self.draw("--dye", "x,0", "--frames", "1")[0], 0)
        gold, blue = self.colors("frame000001.png")
        self.assertGreater(gold, 0.01)
        self.assertGreater(blue, 0.01)
        self.assertEqual(self.draw("--dye", "x,0,z,0", "--frames", "1")[0], 0)
        gold, blue = self.colors("frame000001.png")
        self.assertLess(gold, 0.001)
        self.assertGreater(blue, 0.01)

    def test_a_cut_leaves_the_large_ones(self):
        small = "".join(particle(f"{x},-1,0", "0.1") for x in (0, 1, 2))
        write_run(self.folder, [small, small + particle("1,-1,1", "0.5")])
        self.assertEqual(self.draw("--cut", "y,0", "--color", "R", "--frames", "0,1")[0], 0)
        self.assertTrue((self.scene_of(0)[:, :300] == 255).all())  # left of the scale of colours
        self.assertFalse((self.scene_of(1)[:, :300] == 255).all())

    def test_a_pattern_turns_with_its_ball(self):
        half = 0.5**0.5
        turned = particle("0,0,0", "1", q=f"{half},{half},0,0")
        write_run(self.folder, [particle("0,0,0", "1"), turned, turned])
        self.assertEqual(self.draw("--pattern", "--frames", "0,1,2")[0], 0)
        first, second, third = (self.scene_of(k) for k in range(3))
        self.assertFalse(np.array_equal(first, second))
        self.assertTrue(np.array_equal(second, third))
        self.assertEqual(self.draw("--color", "R", "--frames", "0,1")[0], 0)
        self.assertTrue(np.array_equal(self.scene_of(0), self.scene_of(1)))

    def test_options_of_the_scene_count_and_moving_meshes_move(self):
        scene = SCENE + "motion = 0 translate 5,0,0\n# render: --color R --view 270,0\n"
        write_run(self.folder, [particle(), particle()], scene, FLOOR)
        code, out, errors = self.draw("--frames", "0,1", "--animate")
        self.assertEqual((code, errors), (0, ""))
        self.assertTrue((self.folder / "animation.gif").stat().st_size > 1000)
        self.assertFalse(np.array_equal(self.scene_of(0), self.scene_of(1)))
        (self.folder / "scene.ini").write_text(SCENE + "# render: --view x\n")
        self.assertEqual(self.draw()[0], 2)

    def test_mistakes_end_with_2(self):
        write_run(self.folder, [particle()])
        for words in (["--frames", "7"], ["--color", "mass"], ["--dye", "x"], ["--dye", "q,0"],
                      ["--box", "1,2"], ["--cut", "y"], ["--hide", "a"]):
            self.assertEqual(self.draw(*words)[0], 2, words)


if __name__ == "__main__":
    unittest.main()

"""STL to OFF and back, and the shapes of the Builder. By hand: cd tests && python3 -m unittest
test_mesh_tools"""
import math
import os
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
from tool_support import FLOOR, TOOLS, message_of, particle, run_tool

import frames
import mesh_tools

PROGRAM = os.environ.get("TINYDEM", "tinydem")
TETRAHEDRON = np.array([[[0, 0, 0], [0, 1, 0], [1, 0, 0]], [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
                        [[0, 0, 0], [0, 0, 1], [0, 1, 0]],
                        [[1, 0, 0], [0, 1, 0], [0, 0, 1]]], float)


def ascii_stl(triangles):
    """The text of an ASCII STL file."""
    facets = ["facet normal 0 0 0\n outer loop\n"
              + "".join("  vertex {:.9g} {:.9g} {:.9g}\n".format(*corner) for corner in triangle)
              + " endloop\nendfacet\n" for triangle in triangles]
    return "solid part\n" + "".join(facets) + "endsolid part\n"


class MeshTools(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="tinydem_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.stl, self.off = self.folder / "part.stl", self.folder / "part.off"

    def convert(self, *words):
        return run_tool(TOOLS / "mesh_tools.py", *words)

    def test_both_kinds_of_stl_give_the_same_off(self):
        texts = []
        for write in (lambda: self.stl.write_text(ascii_stl(TETRAHEDRON)),
                      lambda: mesh_tools.write_stl(self.stl, TETRAHEDRON)):
            write()
            code, out, errors = self.convert(self.stl, self.off)
            self.assertEqual((code, errors), (0, ""))
            self.assertIn("4 triangles, 4 vertices, 0 triangles without an area", out)
            self.assertIn("box 1 x 1 x 1 from (0, 0, 0)", out)
            texts.append(self.off.read_text())
        self.assertEqual(*texts)
        corners = [e.corners for e in frames.read_mesh(self.off)]
        self.assertTrue(np.array_equal(corners, TETRAHEDRON))

    def test_there_and_back(self):
        mesh_tools.write_stl(self.stl, TETRAHEDRON)
        self.convert(self.stl, self.off, "--scale", "0.5")
        self.convert(self.off, self.stl, "--scale", "2")
        self.assertTrue(np.array_equal(mesh_tools.read_stl(self.stl), TETRAHEDRON))
        self.off.write_text(FLOOR)
        code, out, _ = self.convert(self.off, self.stl)
        self.assertEqual(code, 0)
        self.assertIn("3 triangles, 2 points and edges left out", out)

    def test_equal_corners_merge_and_flat_triangles_go(self):
        flat = [[[0, 0, 0], [1, 1, 1], [2, 2, 2]], [[0, 0, 0], [0, 0, 0], [1, 0, 0]]]
        vertices, faces, left_out = mesh_tools.merge(np.concatenate([TETRAHEDRON, flat]))
        self.assertEqual((len(vertices), len(faces), left_out), (4, 4, 2))
        off_by_little = TETRAHEDRON.copy()
        off_by_little[3] += 1e-6
        self.assertEqual(len(mesh_tools.merge(off_by_little)[0]), 7)
        self.assertEqual(len(mesh_tools.merge(off_by_little, 1e-3)[0]), 4)

    def test_a_binary_file_may_start_with_solid(self):
        mesh_tools.write_stl(self.stl, TETRAHEDRON)
        data = bytearray(self.stl.read_bytes())
        data[:5] = b"solid"
        self.stl.write_bytes(data)
        self.assertTrue(np.array_equal(mesh_tools.read_stl(self.stl), TETRAHEDRON))

    def test_malformed_files(self):
        mesh_tools.write_stl(self.stl, TETRAHEDRON)
        binary, text = self.stl.read_bytes(), ascii_stl(TETRAHEDRON)
        nan = binary[:84] + binary[84:96] + struct.pack("<f", math.nan) + binary[100:]
        lines = text.splitlines()

        def ascii_with(number, line):
            return "\n".join(lines[:number - 1] + [line] + lines[number:]).encode()
        for data, where in (
                (binary[:-1], "byte 234: "), (binary[:84], "byte 84: "), (binary[:40], "byte 40: "),
                (binary[:80] + struct.pack("<I", 9) + binary[84:], "byte 284: "),
                (nan, "byte 84: triangle 1"), (b"", "byte 0: "),
                (binary[:80] + struct.pack("<I", 0), "byte 80: has no triangles"),
                (b"garbage, but long enough to have a count: " + 60 * b"x", "byte 84: "),
                (ascii_with(4, "vertex 0 0 x"), ":4: "), (ascii_with(4, "vertex 0 0 inf"), ":4: "),
                (ascii_with(4, "vertex 0 0"), ":4: "), (ascii_with(7, "endfacet"), ":7: "),
                (ascii_with(9, "hello"), ":9: expected 'facet' or endsolid"),
                (b"solid\nendsolid\n", ":1: has no triangles"),
                ("\n".join(lines[:-1]).encode(), f":{len(lines) - 1}: expected 'endsolid'")):
            self.stl.write_bytes(data)
            message = message_of(self, mesh_tools.read_stl, self.stl)
            self.assertIn(f"{self.stl}", message)
            self.assertIn(where, message)
            self.assertIn("; try: ", message)

    def test_wrong_use(self):
        self.stl.write_text(ascii_stl(TETRAHEDRON))
        for words in ([self.stl, self.stl], [self.folder / "a.obj", self.off],
                      [self.stl, self.off, "--scale", "0"], [self.stl, self.off, "--scale", "nan"],
                      [self.folder / "none.stl"], [self.stl, self.off, "--merge", "9"],
                      [self.stl, self.folder / "none" / "x.off"]):
            self.assertEqual(self.convert(*words)[0], 2, words)
        self.assertFalse(self.off.exists())

    def test_the_builder_makes_what_it_says(self):
        mesh = mesh_tools.Builder("shapes")
        mesh.tube((0, 0, 0), (0, 0, 2), 1.0, 12, group=1)
        mesh.cone((0, 0, 2), 0.5, (0, 0, 3), 1.5, 12)
        mesh.cup((-2, -2, -1), (2, 2, 1))
        mesh.face((0, 0, 0))
        mesh.write(self.off)
        elements = frames.read_mesh(self.off)
        tube, cup = elements[:12], elements[36:41]
        self.assertEqual([len(e.corners) for e in elements], 12 * [4] + 24 * [3] + 5 * [4] + [1])
        for wall in tube:  # the middle of every wall is on the circle
            middle = wall.corners.mean(axis=0)
            self.assertAlmostEqual(np.hypot(*middle[:2]), 1.0)
            self.assertAlmostEqual(middle[2], 1.0)
            self.assertEqual(wall.group, 1)
        self.assertEqual(sum((e.corners[:, 2] == -1).all() for e in cup), 1)
        # The solver reads it: four corners must be a rectangle.
        (self.folder / "one.csv").write_text(frames.HEADER + "\n" + particle("0,0,1", "0.001"))
        run = subprocess.run([PROGRAM, self.off, self.folder / "one.csv", self.folder / "out",
                              "--Nframes", "0"], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()

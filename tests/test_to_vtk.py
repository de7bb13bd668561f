"""Files for ParaView. By hand: cd tests && python3 -m unittest test_to_vtk"""
import base64
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np
from tool_support import FLOOR, SCENE, TOOLS, particle, run_tool, write_run

try:
    import vtk  # Debian: python3-vtk9
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError:
    vtk = None

FRAMES = ["", particle("1,2,3", "0.5", "3,0,4", "0,1,0,0", "7,8,9"),
          particle("1,2,3", "0.5") + particle("4,5,6", "0.25", "0,0,-2")]


def array(element):
    """The numbers of a <DataArray> of our files, read by the words of the VTK file format."""
    raw = base64.b64decode(element.text.strip())
    size, kind = int(np.frombuffer(raw[:8], "<u8")[0]), element.get("type")
    values = np.frombuffer(raw[8:], {"Float64": "<f8", "Int64": "<i8"}[kind])
    assert size == len(raw) - 8, "the header must tell the number of bytes"
    columns = int(element.get("NumberOfComponents"))
    return values.reshape(-1, columns) if columns > 1 else values


class ToVtk(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="tinydem_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.vtk = self.folder / "vtk"

    def convert(self, scene=SCENE, *options):
        write_run(self.folder, FRAMES, scene, FLOOR)
        return run_tool(TOOLS / "to_vtk.py", self.folder, *options)

    def test_xml_says_what_the_frame_says(self):
        self.assertEqual(self.convert()[0], 0)
        piece = xml.parse(self.vtk / "particles000002.vtp").find(".//Piece")
        self.assertEqual(piece.get("NumberOfPoints"), "2")
        self.assertEqual(array(piece.find("Points/DataArray")).tolist(), [[1, 2, 3], [4, 5, 6]])
        data = {a.get("Name"): array(a) for a in piece.find("PointData")}
        self.assertEqual(sorted(data), ["R", "id", "q", "speed", "v", "w"])
        self.assertEqual(data["R"].tolist(), [0.5, 0.25])
        self.assertEqual(data["v"].tolist(), [[0, 0, 0], [0, 0, -2]])
        self.assertEqual(data["speed"].tolist(), [0, 2])
        self.assertEqual(data["id"].tolist(), [0, 1])
        self.assertEqual(data["q"].shape, (2, 4))
        times = [float(s.get("timestep")) for s in
                 xml.parse(self.vtk / "particles.pvd").iter("DataSet")]
        np.testing.assert_allclose(times, [0, 0.01, 0.02])

    def test_a_mesh_at_rest_is_written_once_and_a_moving_one_per_frame(self):
        self.convert()
        self.assertEqual(len(list(self.vtk.glob("mesh*.vtp"))), 1)
        piece = xml.parse(self.vtk / "mesh.vtp").find(".//Piece")
        counts = [piece.get(f"NumberOf{kind}") for kind in ("Verts", "Lines", "Polys")]
        self.assertEqual(counts, ["1", "1", "2"])
        data = {a.get("Name"): array(a) for a in piece.find("CellData")}
        self.assertEqual(data["group"].tolist(), [0, 1, 0, 1])  # point, edge, rectangle, triangle
        self.assertEqual(array(piece.find("Polys/DataArray[@Name='offsets']")).tolist(), [4, 7])
        self.convert(SCENE + "motion = 0 translate 0,0,1\n")
        self.assertEqual(len(list(self.vtk.glob("mesh0*.vtp"))), 3)
        points = xml.parse(self.vtk / "mesh000002.vtp").find(".//Points/DataArray")
        self.assertAlmostEqual(array(points)[0][2], 0.02)

    def test_options_and_mistakes(self):
        self.assertEqual(self.convert(SCENE, "--every", "2", "--out", self.folder / "a")[0], 0)
        self.assertEqual(len(list((self.folder / "a").glob("particles*.vtp"))), 2)
        self.assertEqual(self.convert(SCENE, "--every", "0")[0], 2)
        self.assertEqual(run_tool(TOOLS / "to_vtk.py", self.folder / "none")[0], 2)

    @unittest.skipUnless(vtk, "the vtk module is not here (Debian: python3-vtk9)")
    def test_vtk_reads_it(self):
        self.convert()

        def read(name):
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(self.vtk / name))
            reader.Update()
            return reader.GetOutput()
        data = read("particles000002.vtp")
        self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfVerts()), (2, 2))
        points = vtk_to_numpy(data.GetPoints().GetData())
        self.assertEqual(points.tolist(), [[1, 2, 3], [4, 5, 6]])
        for name, expected in (("R", [0.5, 0.25]), ("v", [[0, 0, 0], [0, 0, -2]]), ("id", [0, 1])):
            self.assertEqual(vtk_to_numpy(data.GetPointData().GetArray(name)).tolist(), expected)
        self.assertEqual(read("particles000000.vtp").GetNumberOfPoints(), 0)
        mesh = read("mesh.vtp")
        counts = mesh.GetNumberOfVerts(), mesh.GetNumberOfLines(), mesh.GetNumberOfPolys()
        self.assertEqual(counts, (1, 1, 2))
        self.assertEqual(vtk_to_numpy(mesh.GetCellData().GetArray("group")).tolist(), [0, 1, 0, 1])
        self.assertEqual(mesh.GetCell(2).GetNumberOfPoints(), 4)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""Frames as other programs read them: meshio finds the right value at each position, and VTK, if installed,
bitwise the same values.

The environment names the build (DSC_BUILD).
"""
import importlib.util
import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

import meshio
import numpy

POINT_ARRAYS = {"position", "velocity", "displacement"}
CELL_ARRAYS = {"phase", "quality", "size", "submesh"}


def has(module):
    return importlib.util.find_spec(module) is not None


class Own:
    """Points, triangles and data of one file by meshio."""

    def __init__(self, path):
        mesh = meshio.read(path)
        assert [block.type for block in mesh.cells] == ["triangle"]
        self.points, self.cells = mesh.points, mesh.cells[0].data
        self.point_data = mesh.point_data
        self.cell_data = {name: blocks[0] for name, blocks in mesh.cell_data.items()}


class Readers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.paths = []
        for name, more in (("double", ["--strategy", "cells", "--submeshes", "2"]),
                           ("float", ["--set", "real=float", "--set", "grade=1.4"])):
            frames = os.path.join(folder.name, name)
            program = os.path.join(os.environ["DSC_BUILD"], "lib", "scenes", "dsc_scene")
            subprocess.run([program, "run", "swirl", "--set", "h=0.02", "--set",
                            "steps=4", *more, "--frames", frames, "--every", "4"], check=True,
                           stdout=subprocess.DEVNULL, timeout=120)
            cls.paths += [os.path.join(frames, file) for file in sorted(os.listdir(frames))
                          if file.endswith(".vtu")]
            cls.collection = [os.path.join(frames, file) for file in os.listdir(frames)
                              if file.endswith(".pvd")][0]

    def expect_same(self, found, expected, name):
        found = numpy.asarray(found).reshape(expected.shape)
        self.assertEqual(found.dtype.newbyteorder("<"), expected.dtype, name)
        self.assertEqual(found.tobytes(), expected.tobytes(), name)

    def expect_values_in_their_places(self, own, is_first):
        """Data of triangles and vertices that follow from their positions."""
        near = 1e-12 if own.points.dtype == numpy.float64 else 1e-5
        corners = own.points[own.cells][:, :, :2].astype(float)
        sides = numpy.roll(corners, -1, 1) - corners
        areas = numpy.linalg.det(sides[:, :2])
        self.assertGreater(areas.min(), 0)
        lengths = numpy.sort(numpy.linalg.norm(sides, axis=2))
        min_sine = areas / (lengths[:, 1] * lengths[:, 2])
        quality = own.cell_data["quality"].ravel()
        self.assertLess(abs(quality - 2 / 3**0.5 * min_sine).max(), near)
        if is_first:
            distance = numpy.linalg.norm(corners.mean(axis=1) - (0.5, 0.75), axis=1)
            numpy.testing.assert_array_equal(own.cell_data["phase"].ravel(), distance < 0.15)
            x, y = numpy.pi * own.points[:, :2].astype(float).T
            velocity = [numpy.sin(x)**2 * numpy.sin(2 * y), -numpy.sin(y)**2 * numpy.sin(2 * x)]
            self.assertLess(abs(own.point_data["velocity"].T[:2] - velocity).max(), near)

    def test_by_meshio(self):
        self.assertEqual(len(self.paths), 6)
        for path in self.paths:
            own = Own(path)
            self.assertEqual(set(own.point_data), POINT_ARRAYS)
            self.assertEqual(set(own.cell_data), CELL_ARRAYS)
            self.expect_same(own.point_data["position"], own.points, "position")
            self.assertEqual(set(own.cell_data["phase"].ravel()), {0, 1})
            self.expect_values_in_their_places(own, path.endswith("_00000.vtu"))
            ways = numpy.linalg.norm(own.point_data["displacement"], axis=1)
            self.assertEqual(ways.max() > 0, not path.endswith("_00000.vtu"))
        graded = Own(self.paths[-1]).cell_data["size"]
        self.assertTrue(0.0199 < graded.min() < 0.021)
        self.assertGreater(graded.max(), 0.06)
        divided = Own(self.paths[2]).cell_data["submesh"]
        self.assertGreaterEqual(divided.max(), 1)

    def test_pressures_of_a_drop_at_rest(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(os.environ["DSC_BUILD"], "lib", "scenes", "dsc_scene")
            subprocess.run([program, "run", "static-drop", "--set", "h=0.05",
                            "--frames", folder, "--at", "0.05"], check=True,
                           stdout=subprocess.DEVNULL, timeout=120)
            (name,) = [file for file in os.listdir(folder) if file.endswith(".vtu")]
            frame = Own(os.path.join(folder, name))
        outside, inside = frame.point_data["pressure"], frame.point_data["pressure_beyond"]
        away = numpy.hypot(*(frame.points[:, :2] - 0.5).T)
        jump = inside - outside
        self.assertLess(abs(jump[abs(away - 0.25) < 0.005] - 100).max(), 0.5)  # tension / radius
        self.assertEqual(abs(jump[abs(away - 0.25) > 0.02]).max(), 0)
        self.assertLess(abs(frame.point_data["velocity"]).max(), 1e-12)

    @unittest.skipUnless(has("vtk"), "python3-vtk9 is not installed")
    def test_by_vtk(self):
        from vtk import vtkXMLUnstructuredGridReader
        from vtk.util.numpy_support import vtk_to_numpy
        for path in self.paths:
            own = Own(path)
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(path)
            reader.Update()
            self.assertEqual(reader.GetErrorCode(), 0)
            grid = reader.GetOutput()
            self.expect_same(vtk_to_numpy(grid.GetPoints().GetData()), own.points, "points")
            cells = grid.GetCells()
            self.expect_same(vtk_to_numpy(cells.GetConnectivityArray()), own.cells, "cells")
            self.assertEqual({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}, {5})
            for data, expected in ((grid.GetPointData(), own.point_data),
                                   (grid.GetCellData(), own.cell_data)):
                self.assertEqual(data.GetNumberOfArrays(), len(expected))
                for name, numbers in expected.items():
                    self.expect_same(vtk_to_numpy(data.GetArray(name)), numbers, name)

    def test_the_collection_names_its_files(self):
        root = xml.parse(self.collection).getroot()
        files = [tag.get("file") for tag in root.iter("DataSet")]
        self.assertEqual(files, [os.path.basename(path) for path in self.paths[3:]])


if __name__ == "__main__":
    unittest.main()

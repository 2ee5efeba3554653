# SPDX-License-Identifier: MIT
"""Frames that several processes write in pieces: together they are the frame of one process, number by
number, by a reader of a few lines (plots/results/vtu.py) and by VTK where it is installed.

The environment names the programs (DSC_SCENE, DSC_MPIRUN) and this project's plots (DSC_PLOTS).
"""
import importlib.util
import os
import sys
import unittest
import xml.etree.ElementTree as xml

import disks
import numpy
from launcher import Launched

sys.path.insert(0, os.environ["DSC_PLOTS"])
from results import load_frames, vtu  # noqa: E402

CELLS = ["--strategy", "cells", "--submeshes", "6"]
RUN = ["swirl", "--set", "h=0.03", "--set", "steps=4", "--every", "4", *CELLS]
RANKS = 3


def cells_of(points, corners, point_data, cell_data):
    """A row for each triangle: the numbers of its corners, from the least on, and its own; sorted."""
    names = sorted(point_data), sorted(cell_data)
    at_points = numpy.hstack([points, *(point_data[name].reshape(len(points), -1)
                                        for name in names[0])]).astype(float)
    rows = at_points[corners]
    least = numpy.lexsort((points[corners][:, :, 1], points[corners][:, :, 0]), axis=1)[:, 0]
    turned = (least[:, None] + numpy.arange(3)) % 3
    rows = numpy.take_along_axis(rows, turned[:, :, None], axis=1).reshape(len(corners), -1)
    whole = numpy.hstack([rows, *(cell_data[name].reshape(len(corners), -1)
                                  for name in names[1])]).astype(float)
    return names, whole[numpy.lexsort(whole.T[::-1])]


def cells_of_file(path):
    """Of one .vtu file, by the few lines."""
    file = vtu.Reader(path)
    piece = file.root.find("UnstructuredGrid/Piece")

    def arrays(place):
        return {tag.get("Name"): file.data(tag).reshape(-1, int(tag.get("NumberOfComponents", 1)))
                for tag in piece.find(place)}

    return cells_of(arrays("Points")["Points"], arrays("Cells")["connectivity"].reshape(-1, 3),
                    arrays("PointData"), arrays("CellData"))


def cells_by_vtk(path):
    """Of a .vtu file or a .pvtu file and its pieces."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    reader = (vtk.vtkXMLPUnstructuredGridReader if path.endswith(".pvtu")
              else vtk.vtkXMLUnstructuredGridReader)()
    reader.SetFileName(path)
    reader.Update()
    assert reader.GetErrorCode() == 0
    grid = reader.GetOutput()

    def arrays(data):
        return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
                for i in range(data.GetNumberOfArrays())}

    return cells_of(vtk_to_numpy(grid.GetPoints().GetData()),
                    vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 3),
                    arrays(grid.GetPointData()), arrays(grid.GetCellData()))


class Frames(Launched):
    def frames(self, ranks, folder, *more):
        """The files that the collection names."""
        code, _, words = self.call(ranks, "run", *RUN, *more, "--frames", folder)
        self.assertEqual((code, words), (0, []))
        root = xml.parse(self.path(f"{folder}/swirl_cells.pvd")).getroot()
        return [self.path(f"{folder}/{tag.get('file')}") for tag in root.iter("DataSet")]

    def expect_same(self, one, other, what):
        self.assertEqual(one[0], other[0], what)
        self.assertEqual(one[1].shape, other[1].shape, what)
        self.assertEqual(one[1].tobytes(), other[1].tobytes(), what)

    def pieces(self, path):
        root = xml.parse(path).getroot()
        return [os.path.join(os.path.dirname(path), tag.get("Source")) for tag in root.iter("Piece")]

    def test_pieces_are_together_the_frame_of_one_process(self):
        whole = self.frames(None, "whole")
        shared = self.frames(RANKS, "shared")
        self.assertEqual([os.path.basename(path) for path in shared],
                         [os.path.basename(path).replace(".vtu", ".pvtu") for path in whole])
        self.assertEqual(len(whole), 3)
        for one, other in zip(whole, shared, strict=True):
            names, expected = cells_of_file(one)
            self.assertEqual(names[1], ["phase", "quality", "size", "submesh"])
            parts = [cells_of_file(piece) for piece in self.pieces(other)]
            self.assertEqual(len(parts), RANKS)
            for part_names, part in parts:
                self.assertEqual(part_names, names)
                self.assertAlmostEqual(len(part), len(expected) / RANKS, delta=1)
            rows = numpy.vstack([part for _, part in parts])
            self.expect_same((names, rows[numpy.lexsort(rows.T[::-1])]), (names, expected), other)
            if importlib.util.find_spec("vtk"):
                self.expect_same(cells_by_vtk(other), (names, expected), other)
                self.expect_same(cells_by_vtk(one), (names, expected), one)
            # As the plots read it: one mesh, whose vertices are one where pieces meet.
            read = load_frames.read_frame(other)
            self.assertEqual(len(read.points), len(load_frames.read_frame(one).points))
            self.assertEqual(len(read.triangles), len(expected))
        self.assertEqual([path for _, _, path in load_frames.frame_files(self.path("shared"))
                          ["swirl", "cells"]], shared)
        wanted = {*shared, *(piece for path in shared for piece in self.pieces(path)),
                  *(self.path(f"shared/swirl_cells{name}") for name in
                    (".pvd", "_00004.submeshes.json", "_00008.submeshes.json"))}
        self.assertEqual({self.path(f"shared/{name}") for name in os.listdir(self.path("shared"))},
                         wanted)

    def test_a_full_disk_of_one_rank_ends_all_with_one_sentence(self):
        os.mkdir(self.path("f"))
        piece = f"f/swirl_cells_00004.2of{RANKS}.vtu"
        disks.lead_to_full(self.path(piece + ".part"))
        code, out, words = self.call(RANKS, "run", *RUN, "--frames", "f")
        self.assertEqual((code, out, len(words)), (1, "", 1), words)
        self.assertIn(f"{piece}: writing failed: No space left on device", words[0])
        names = os.listdir(self.path("f"))
        self.assertEqual([name for name in names if name.endswith((".part", ".pvd"))], [])
        lists = [name for name in names if name.endswith(".pvtu")]
        self.assertEqual(lists, ["swirl_cells_00000.pvtu"])
        self.assertGreater(len(load_frames.read_frame(self.path(f"f/{lists[0]}")).triangles), 0)

    def test_the_list_of_pieces_is_written_last(self):
        os.mkdir(self.path("f"))
        disks.lead_to_full(self.path("f/swirl_cells_00000.pvtu.part"))
        code, _, words = self.call(RANKS, "run", *RUN, "--frames", "f")
        self.assertEqual((code, len(words)), (1, 1), words)
        self.assertIn("f/swirl_cells_00000.pvtu: writing failed", words[0])
        self.assertEqual(sorted(os.listdir(self.path("f"))),
                         [f"swirl_cells_00000.{k}of{RANKS}.vtu" for k in range(1, RANKS + 1)])


if __name__ == "__main__":
    unittest.main()

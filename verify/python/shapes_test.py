# SPDX-License-Identifier: MIT
"""Shapes as users have them: rings, geometries of other packages, coverages, points with heights, fine
detail."""
import pathlib
import pickle
import re
import tempfile
import unittest
import warnings

import dsc
import numpy as np
from meshes import DOMAIN, H, disc


class Geometry:
    """A geometry with the interface of shapely and geopandas: `__geo_interface__`, a dictionary."""

    def __init__(self, kind, **parts):
        self.__geo_interface__ = {"type": kind, **parts}


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]


OUTER, HOLE = box(.2, .2, .6, .6), box(.4, .4, .2, .2)


def areas(shapes, **options):
    mesh = dsc.initial_complex(DOMAIN, shapes, edge_length=H, **options)
    assert not mesh.validate()
    return {phase: round(area, 12) for phase, area in mesh.areas.items() if phase}


class Shapes(unittest.TestCase):
    def test_rings_and_geometries_of_one_phase(self):
        polygon = Geometry("Polygon", coordinates=(OUTER, HOLE))
        parts = Geometry("MultiPolygon", coordinates=[[OUTER, HOLE], [box(.45, .45, .1, .1)]])
        feature = {"type": "Feature", "properties": None, "geometry": polygon.__geo_interface__}
        for given, area in [(OUTER, .36), ([OUTER, HOLE], .32), (polygon, .32), ([polygon], .32), (parts, .33),
                            (feature, .32), (polygon.__geo_interface__, .32),
                            (Geometry("FeatureCollection", features=[feature]), .32),
                            (Geometry("GeometryCollection", geometries=[polygon.__geo_interface__]), .32),
                            (Geometry("LinearRing", coordinates=OUTER), .36)]:
            self.assertEqual(areas({3: given}), {3: area})

    def test_a_frame_is_a_coverage(self):
        cells = [box(.2, .2, .3, .4), box(.5, .2, .3, .4), box(.2, .6, .6, .2)]
        features = [{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [cell]}}
                    for cell in cells]
        frame = Geometry("FeatureCollection", features=features)
        self.assertEqual(areas(frame), {1: .12, 2: .12, 3: .12})
        for one, number in zip(features, (7, 5, 7)):
            one["properties"]["phase"] = number
        self.assertEqual(areas(frame), {5: .12, 7: .24})
        features[1]["properties"]["phase"] = "seven"
        with self.assertRaisesRegex(dsc.InputError, "property phase of feature 1: not a phase: got 'seven'"):
            areas(frame)

    def test_a_mesh_comes_back_from_its_own_geojson(self):
        mesh = dsc.initial_complex(DOMAIN, {2: [OUTER, HOLE], 4: HOLE}, edge_length=H)
        again = dsc.initial_complex(DOMAIN, mesh.to_geojson(), edge_length=H)
        self.assertEqual({k: round(v, 12) for k, v in again.areas.items()},
                         {k: round(v, 12) for k, v in mesh.areas.items()})

    def test_gaps_go_to_a_neighbour(self):
        halves = {3: [(0, 0), (.5, 0), (.5, 1), (0, 1)], 7: [(.51, 0), (1, 0), (1, 1), (.51, 1)]}
        for coverage, error in (("first", None), ("longest_border", None), ("whole", "a gap between shapes")):
            if error is None:
                mesh = dsc.initial_complex(DOMAIN, halves, edge_length=H, coverage=coverage)
                self.assertAlmostEqual(mesh.areas[3] + mesh.areas[7], 1)
            else:
                with self.assertRaisesRegex(dsc.InputError, error):
                    dsc.initial_complex(DOMAIN, halves, edge_length=H, coverage=coverage)

    def test_needles_at_borders_that_do_not_meet_are_told(self):
        x = (.33, .66)
        gap = {1: [(0, 0), (x[0], 0), (x[1], 1), (0, 1)], 2: [(x[0], 0), (1, 0), (1, 1), (x[1] + 1e-3, 1)]}
        words = r"an angle of 0\.\d+ degrees at \(0\.\d+, .*\); if borders .* give border_tolerance=(0\.0\d)"
        with self.assertWarnsRegex(UserWarning, words) as told:
            dsc.initial_complex(DOMAIN, gap, edge_length=.03)
        wanted = float(re.search(words, str(told.warning))[1])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            mesh = dsc.initial_complex(DOMAIN, gap, edge_length=.03, border_tolerance=wanted)
        self.assertGreater(mesh.min_angles.min(), 10)

    def test_heights(self):
        ring = np.c_[np.array(OUTER), np.full(5, 12.5)]
        self.assertEqual(areas({1: ring}), {1: .36})
        ring[2, 2] = 13
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[1\]: points at several heights: got .* 12.5 to 13"):
            areas({1: ring})

    def test_errors_name_the_phase(self):
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[7\].*contact with shapes\[9\].* at \(.*longest_border"):
            areas({7: OUTER, 9: box(.5, .5, .4, .4)})
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[7\]\[1\], edge 0: two edges cross"):
            areas({7: [box(.05, .05, .1, .1), [(.2, .2), (.8, .8), (.8, .2), (.2, .8)]]})
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[2\]: a geometry without an area: got LineString"):
            areas({2: Geometry("LineString", coordinates=OUTER)})
        with self.assertRaisesRegex(dsc.InputError, r"domain: points of the wrong shape: got .* \(4,\)"):
            dsc.initial_complex((0, 0, 1, 1), {1: OUTER}, edge_length=H)
        with self.assertRaisesRegex(dsc.InputError, "shapes: not shapes"):
            areas(OUTER)

    def test_what_was_left_out(self):
        doubled = np.insert(disc(), 8, disc()[7] + 1e-9, 0)
        mesh = dsc.initial_complex(DOMAIN, {1: [doubled, box(.9, .9, 1e-3, 1e-3)]}, edge_length=H)
        report = mesh.input_report
        self.assertEqual((report.points, report.thinned, report.dropped), (len(doubled) + 5, 1, 1))
        self.assertLess(report.deviation, 2e-9)
        self.assertEqual(mesh.copy().input_report, report)
        self.assertEqual(pickle.loads(pickle.dumps(report)), report)
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[1\], edge 7: the edge is too short for the mesh"):
            dsc.initial_complex(DOMAIN, {1: doubled}, edge_length=H, detail="keep")

    def test_reports_are_sentences(self):
        report = dsc.initial_complex(DOMAIN, {1: [OUTER, box(.9, .9, 1e-3, 1e-3)]}, edge_length=H).input_report
        self.assertRegex(str(report), "^1 shape was left out as too small, with an area of")
        self.assertEqual(str(dsc.initial_complex(DOMAIN, {1: OUTER}, edge_length=H).input_report), "")


class Labels(unittest.TestCase):
    def test_pixels_of_grains(self):
        labels = np.array([[1, 1, 1, 1], [2, 2, 2, 3], [2, 2, 2, 2]])
        mesh = dsc.from_labels(labels, edge_length=.25)
        self.assertEqual({k: round(v, 5) for k, v in mesh.areas.items()}, {1: 4, 2: 7, 3: 1})
        self.assertEqual(mesh.points.max(axis=0).tolist(), [4, 3])
        self.assertGreater(mesh.points[mesh.triangles][mesh.phases == 1].mean(axis=(0, 1))[1], 2)  # the first row
        mesh = dsc.from_labels(labels.tolist(), DOMAIN, min_pixels=2, edge_length=.05)
        self.assertEqual({k: round(v, 6) for k, v in mesh.areas.items()}, {1: .333333, 2: .666667})
        self.assertEqual(mesh.input_report.dropped, 1)
        self.assertFalse(mesh.validate())
        mesh = dsc.from_labels(labels == 2, edge_length=.25)
        self.assertEqual({k: round(v, 5) for k, v in mesh.areas.items()}, {0: 5, 1: 7})

    def test_grey_values_are_told(self):
        rows, columns = np.mgrid[:40, :40]
        picture = (255 * np.clip((12.3 - np.hypot(rows - 19.5, columns - 20)) / 2 + .5, 0, 1)).astype(int)
        few = len(np.unique(picture)) - 2  # without those of the disc and around it
        with self.assertWarnsRegex(UserWarning, rf"{few} of {few + 2} phases have no pixel .* np\.where"):
            dsc.from_labels(picture, edge_length=2)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(set(dsc.from_labels(np.where(picture > 127, 1, 0), edge_length=2).areas), {0, 1})

    def test_what_is_refused(self):
        hidden = np.ma.masked_equal([[1, 2], [9, 9]], 9)
        for labels, options, words in [(hidden, {}, "labels: masked entries: got 2 of 4"),
                                       ([["a"]], {}, "labels: not an array of numbers"),
                                       ([[1, -1]], {}, "labels: a number out of range: got -1"),
                                       ([[1, 2.0]], {}, "labels: numbers that need not be whole: got float64"),
                                       ([1, 2], {}, r"labels: an array of another shape: got \(2,\)"),
                                       (np.zeros((4, 4, 3)), {}, r"labels: an array of another shape: got \(4, 4, 3\)"),
                                       ([[1, 2]], {"min_pixels": -1}, "min_pixels: not a count"),
                                       ([[1, 2]], {"detail": "fine"}, "detail"),
                                       (np.zeros((0, 3), int), {}, "no pixels")]:
            with self.assertRaisesRegex(dsc.InputError, words):
                dsc.from_labels(labels, edge_length=.1, **options)


class Meshio(unittest.TestCase):
    """Meshes of meshio, and objects with the same attributes."""

    def given(self, **changed):
        parts = {"points": np.array([[0, 0, 2], [1, 0, 2], [1, 1, 2], [0, 1, 2], [5, 5, 2]], float),
                 "cells": [("line", np.array([[0, 1]])), ("triangle", np.array([[0, 1, 2]])),
                           ("triangle", np.array([[0, 3, 2]]))],
                 "cell_data": {"gmsh:physical": [np.array([9]), np.array([3]), np.array([4.0])]}}
        return type("Given", (), {**parts, **changed})

    def test_triangles_and_phases(self):
        mesh = dsc.from_meshio(self.given())
        self.assertEqual(mesh.areas, {3: .5, 4: .5})
        self.assertEqual(len(mesh.points), 4)
        self.assertEqual(dsc.from_meshio(self.given(cell_data={})).areas, {1: 1})
        data = {"phase": [[0], [1], [1]], "other": [[0], [2], [2]]}
        self.assertEqual(dsc.from_meshio(self.given(cell_data=data), "other").areas, {2: 1})

    def test_lines_of_a_group_are_sides(self):
        lines = ("line", np.array([[1, 0], [0, 3], [0, 2]]))  # the last one is no edge of the boundary
        cells = [("vertex", np.array([[0]])), lines, *self.given().cells[1:]]
        data = {"gmsh:physical": [np.array([1]), np.array([9, 7, 9]), np.array([3]), np.array([4])]}
        mesh = dsc.from_meshio(self.given(cells=cells, cell_data=data, field_data={"inlet": np.array([9, 1])}))
        self.assertEqual({name: edges.tolist() for name, edges in mesh.sides.items()},
                         {"inlet": [[[0, 0], [1, 0]]], "7": [[[0, 0], [0, 1]]]})
        with self.assertRaisesRegex(dsc.InputError, "not an edge of the boundary of the triangles"):
            dsc.Mesh(mesh.points, mesh.triangles, mesh.phases, sides={"diagonal": [[0, 2]]})

    def test_there_and_back(self):
        mesh = dsc.initial_complex(DOMAIN, {2: disc()}, edge_length=H)
        cells = [type("Block", (), {"type": "triangle", "data": mesh.triangles})]
        again = dsc.from_meshio(self.given(points=mesh.points, cells=cells, cell_data={"phase": [mesh.phases]}))
        self.assertEqual(again.mesh_hash, mesh.mesh_hash)

    def test_what_is_refused(self):
        quads = [("quad", np.array([[0, 1, 2, 3]]))]
        hidden = {"phase": [[9], np.ma.masked_equal([3], 3), [4]]}
        heights = self.given().points + np.eye(5, 3, -1)
        masked = np.ma.masked_equal(self.given().points, 1)
        for changed, words in [({"cells": quads}, r"cells\[0\]: cells that are not triangles: got 1 of type 'quad'"),
                               ({"cells": []}, "no triangles"),
                               ({"cell_data": hidden}, r"cell_data\['phase'\]: masked entries: got 1 of 2"),
                               ({"points": heights}, "points at several heights"),
                               ({"points": masked}, "points: masked entries: got 4 of 12")]:
            with self.assertRaisesRegex(dsc.InputError, words):
                dsc.from_meshio(self.given(**changed))
        with self.assertRaisesRegex(dsc.InputError, "no such cell data: got 'x'; allowed: 'gmsh:physical'"):
            dsc.from_meshio(self.given(), "x")
        with self.assertRaisesRegex(dsc.InputError, "not a mesh: got 'x.msh'; allowed: what `meshio.read"):
            dsc.from_meshio("x.msh")


class Paths(unittest.TestCase):
    def test_are_taken_wherever_files_are_named(self):
        mesh = dsc.initial_complex(DOMAIN, {1: OUTER}, edge_length=H)
        with tempfile.TemporaryDirectory() as folder:
            for write in (mesh.write_svg, mesh.write_vtu, lambda path: dsc.save(path, mesh)):
                path = pathlib.Path(folder) / "file"
                write(path)
                self.assertGreater(path.stat().st_size, 100)
            self.assertEqual(dsc.load(path).mesh_hash, mesh.mesh_hash)


if __name__ == "__main__":
    unittest.main()

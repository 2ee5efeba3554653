# SPDX-License-Identifier: MIT
"""Shapes as people have them: rings, geometries of other packages, coverages, heights, detail."""
import pickle
import unittest

import dsc
import numpy as np
from meshes import DOMAIN, H, disc


class Geometry:
    """What shapely and geopandas have: the geometry as a dictionary."""

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
                            (Geometry("GeometryCollection", geometries=[polygon.__geo_interface__]), .32)]:
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

    def test_a_mesh_comes_back_from_its_own_geojson(self):
        mesh = dsc.initial_complex(DOMAIN, {2: [OUTER, HOLE], 4: HOLE}, edge_length=H)
        again = dsc.initial_complex(DOMAIN, mesh.to_geojson(), edge_length=H)
        self.assertEqual({k: round(v, 12) for k, v in again.areas.items()},
                         {k: round(v, 12) for k, v in mesh.areas.items()})

    def test_heights(self):
        ring = np.c_[np.array(OUTER), np.full(5, 12.5)]
        self.assertEqual(areas({1: ring}), {1: .36})
        ring[2, 2] = 13
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[1\]: points at several heights: got .* 12.5 to 13"):
            areas({1: ring})

    def test_errors_name_the_phase(self):
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[7\].*contact with shapes\[9\].* at \("):
            areas({7: OUTER, 9: box(.5, .5, .4, .4)})
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[7\]\[1\], edge 0: two edges cross"):
            areas({7: [box(.05, .05, .1, .1), [(.2, .2), (.8, .8), (.8, .2), (.2, .8)]]})
        with self.assertRaisesRegex(dsc.InputError, r"shapes\[2\]: a geometry without an area: got LineString"):
            areas({2: Geometry("LineString", coordinates=OUTER)})
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


if __name__ == "__main__":
    unittest.main()

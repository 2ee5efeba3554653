# SPDX-License-Identifier: MIT
"""Measures, outlines, and meshes in the formats of other packages."""
import importlib.util
import json
import unittest

import dsc
import numpy as np
from meshes import DOMAIN, H, disc, disc_mesh, swirl


def two_discs():
    """A ring of phase 1 around a disc of phase 2, and a second disc of phase 1."""
    return dsc.initial_complex(DOMAIN, {1: [disc((0.3, 0.5), 0.2), disc((0.8, 0.5), 0.1)],
                                        2: disc((0.3, 0.5), 0.1)}, edge_length=H)


class Measures(unittest.TestCase):
    def test_figures_of_phases(self):
        mesh = two_discs()
        phases, lengths = mesh.figures["phases"], mesh.figures["lengths"]
        self.assertEqual({phase: one["components"] for phase, one in phases.items()}, {0: 1, 1: 2, 2: 1})
        self.assertEqual({phase: one["holes"] for phase, one in phases.items()}, {0: 2, 1: 1, 2: 0})
        self.assertAlmostEqual(phases[0]["boundary"], 4)
        self.assertEqual(set(lengths), {(0, 1), (1, 2)})
        ring = mesh.outlines(2)[0]
        self.assertAlmostEqual(lengths[1, 2], np.hypot(*(np.roll(ring, -1, axis=0) - ring).T).sum())
        for phase, area in mesh.areas.items():
            self.assertAlmostEqual(phases[phase]["area"], area)
            self.assertAlmostEqual(dsc.area(mesh.outlines(phase)), area)
        grains = dsc.grains(mesh)
        self.assertEqual(grains["neighbours"].tolist(), [1, 2, 1])
        self.assertEqual(grains["sides"].tolist(), [1, 2, 1])
        self.assertEqual(grains["at_boundary"].tolist(), [True, False, False])
        self.assertTrue(np.allclose(grains["area"], list(mesh.areas.values()), rtol=1e-13))
        self.assertTrue(np.allclose(np.pi * grains["radius"]**2, grains["area"], rtol=1e-13))
        self.assertTrue(np.allclose(grains["perimeter"], [lengths[0, 1], sum(lengths.values()), lengths[1, 2]]))
        parts = mesh.component_of
        self.assertEqual(len(parts), len(mesh.triangles))
        self.assertEqual(len(np.unique(np.c_[parts, mesh.phases], axis=0)), 4)

    def test_distances_between_shapes(self):
        square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        beside = [(0.5, 0), (1.5, 0), (1.5, 1), (0.5, 1)]
        self.assertEqual(dsc.symmetric_difference(square, beside), 1)
        self.assertEqual(dsc.symmetric_difference([np.array(square)], [beside, beside]), 1)
        self.assertEqual(dsc.hausdorff(square, beside), 0.5)
        self.assertEqual(dsc.area(square), 1)
        self.assertEqual(dsc.area(square[::-1]), -1)
        mesh = disc_mesh()
        exact = dsc.circle((0.5, 0.75), 0.15, 1e-4)
        rough = dsc.symmetric_difference(mesh.outlines(1), exact)
        self.assertLess(dsc.symmetric_difference(mesh.outlines(1, samples=16), exact), rough / 50)
        for wrong in (square[:2], [(0, 0), (1, np.nan), (1, 1)], 3):
            with self.assertRaisesRegex(dsc.InputError, "second"):
                dsc.symmetric_difference(square, wrong)

    def test_angles_are_those_of_the_corners(self):
        mesh = two_discs()
        corners = mesh.points[mesh.triangles]
        ahead, behind = (np.roll(corners, shift, axis=1) - corners for shift in (-1, 1))
        angles = np.degrees(np.arctan2(np.linalg.det(np.stack((ahead, behind), axis=2)), (ahead * behind).sum(axis=2)))
        self.assertTrue(np.allclose(angles.min(axis=1), mesh.min_angles))

    def test_phases_may_be_numbers_of_numpy(self):
        mesh = dsc.initial_complex(DOMAIN, {np.uint32(1): disc()}, edge_length=H)
        self.assertEqual(mesh.mesh_hash, disc_mesh().mesh_hash)


class Sizes(unittest.TestCase):
    def test_are_functions_or_numbers(self):
        uniform = disc_mesh()
        for options in ({"growth": 1.3}, {"growth": 1.3, "by_distance": lambda d: H + 0.1 * d},
                        {"growth": 1.3, "by_place": lambda x, y, t, phase: 0.03 if phase else 0.1},
                        {"growth": 1.3, "on_interface": lambda x, y, t: 2 * H}):
            mesh = dsc.initial_complex(DOMAIN, {1: disc()}, edge_length=H, **options)
            self.assertLess(len(mesh.triangles), len(uniform.triangles) / 2)
            sims = [dsc.Simulation(one, edge_length=H, threads=2, **options)
                    for one in (mesh, mesh.copy())]
            for sim in sims:
                self.assertEqual(sim.step(swirl, 0, H).unreached, 0)
                self.assertEqual(sim.options["by_place"], options.get("by_place"))
            self.assertEqual(sims[0].mesh.mesh_hash, sims[1].mesh.mesh_hash)


class Interplay(unittest.TestCase):
    def test_geojson_has_polygons_with_holes(self):
        mesh = two_discs()
        made = json.loads(json.dumps(mesh.to_geojson()))
        self.assertEqual(made["type"], "FeatureCollection")
        by_phase = {one["properties"]["phase"]: one["geometry"]["coordinates"] for one in made["features"]}
        self.assertEqual({phase: sorted(len(polygon) for polygon in polygons)
                          for phase, polygons in by_phase.items()}, {0: [3], 1: [1, 2], 2: [1]})
        for polygons in by_phase.values():
            for ring in (ring for polygon in polygons for ring in polygon):
                self.assertEqual(ring[0], ring[-1])

    def test_triangulation(self):
        mesh = disc_mesh()
        triangulation = mesh.to_triangulation()
        self.assertEqual(triangulation.triangles.shape, mesh.triangles.shape)

    @unittest.skipUnless(importlib.util.find_spec("meshio"), "meshio is not installed")
    def test_meshio(self):
        mesh = disc_mesh()
        mesh.vertex_data["x"] = mesh.points[:, 0]
        made = mesh.to_meshio()
        self.assertEqual(made.cells_dict["triangle"].shape, mesh.triangles.shape)
        self.assertTrue(np.array_equal(made.point_data["x"], mesh.points[:, 0]))
        self.assertTrue(np.array_equal(made.cell_data_dict["phase"]["triangle"], mesh.phases))

    @unittest.skipUnless(importlib.util.find_spec("shapely"), "shapely is not installed")
    def test_shapely(self):
        mesh = two_discs()
        for phase, area in mesh.areas.items():
            made = mesh.to_shapely(phase)
            self.assertTrue(made.is_valid)
            self.assertAlmostEqual(made.area, area)


if __name__ == "__main__":
    unittest.main()

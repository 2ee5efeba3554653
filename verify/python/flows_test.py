# SPDX-License-Identifier: MIT
"""Flows in Python that read the interface, velocities given on a grid, and the library's flows by name."""
import os
import tempfile
import threading
import unittest
import warnings

import dsc
import numpy as np
try:
    from scipy.interpolate import RegularGridInterpolator
except ImportError:
    RegularGridInterpolator = None
from documented_test import fields
from meshes import DOMAIN, H, disc_mesh, swirl


def grown(flow, steps=10, **options):
    mesh = disc_mesh(centre=(0.5, 0.5))
    sim = dsc.Simulation(mesh, flow, edge_length=H, **options)
    dsc.run(sim, flow, H, steps)
    return mesh


class OfTheLibrary(unittest.TestCase):
    def test_the_swirl_has_the_bits_of_the_scene(self):
        for threads in (None, 1, 2, 3):
            options = {} if threads is None else {"threads": threads}
            scene = dsc.scenes.run("swirl", h=H, dt=H, steps=6, **options)
            mesh = dsc.initial_complex(DOMAIN, {1: dsc.circle((0.5, 0.75), 0.15, H)},
                                       edge_length=H)
            sim = dsc.Simulation(mesh, edge_length=H, **options)
            dsc.run(sim, dsc.swirl(), H, 6)
            dsc.run(sim, dsc.swirl(-1), H, 6)
            self.assertEqual(f"{mesh.mesh_hash:016x}", scene["mesh_hash"])

    def test_the_swirl_is_that_of_the_stream_function(self):
        for flow, velocity in (
                (dsc.swirl(), swirl),
                (dsc.swirl(2, 3), lambda x, t: 2 * np.cos(np.pi * t / 3) * swirl(x, t))):
            ends = []
            for one in (flow, velocity):
                mesh = disc_mesh()
                dsc.Simulation(mesh, edge_length=H).step(one, 0.1, H / 4)
                ends.append(mesh.outlines(1)[0])
            self.assertEqual(ends[0].shape, ends[1].shape, flow)
            self.assertLess(np.abs(ends[0] - ends[1]).max(), 1e-12, flow)

    def test_growth_opens_corners_into_arcs(self):
        square = np.array([(0.4, 0.4), (0.6, 0.4), (0.6, 0.6), (0.4, 0.6)])
        for options in ({}, {"threads": 2}):
            mesh = dsc.initial_complex(DOMAIN, {1: square}, edge_length=H)
            flow = dsc.growth({(1, 0): 1})
            sim = dsc.Simulation(mesh, flow, edge_length=H, **options)
            dsc.run(sim, flow, H / 2, 10)
            self.assertAlmostEqual(dsc.area(mesh.outlines(1, samples=16)),
                                   0.04 + 0.8 * 0.1 + np.pi * 0.1**2, delta=2e-5)


class ByPair(unittest.TestCase):
    def ended(self, edge_length=H, **given):
        """Two halves of a disc after some steps: three curves between two junctions."""
        turn = np.pi * np.linspace(0.5, 1.5, 33)
        left = np.c_[np.cos(turn), np.sin(turn)]
        halves = {1: 0.5 + 0.3 * left, 2: 0.5 - 0.3 * left}
        mesh = dsc.initial_complex(DOMAIN, halves, edge_length=edge_length)
        sim = dsc.Simulation(mesh, edge_length=edge_length, feature_degrees=180)
        dsc.run(sim, dsc.curvature_flow(**given), 5e-4, 8)
        return mesh

    def test_numbers_dicts_and_matrices_mean_the_same(self):
        values = np.array([[0, 2, 3], [2, 0, 1.5], [3, 1.5, 0]])
        by_pair = {(1, 0): 2, (0, 2): 3, (2, 1): 1.5}
        for name, other in (("tension", {"mobility": 2}), ("mobility", {"tension": {(0, 1): 1}})):
            ends = {self.ended(**{name: one}, **other).mesh_hash for one in (values, values.tolist(), by_pair)}
            self.assertEqual(len(ends), 1, name)
        self.assertEqual(self.ended(tension=2).mesh_hash, self.ended(tension=2 * np.ones((3, 3))).mesh_hash)

    def test_tensions_balance_at_junctions(self):  # Young's law: 2 * 1 * cos(angle / 2) = 1.5
        mesh = self.ended(H / 4, tension={(1, 2): 1.5})
        one, other = (mesh.outlines(phase)[0] for phase in (1, 2))
        junction = other[np.argmax(other[:, 1] - 9 * np.abs(other[:, 0] - 0.5))]
        rays = []
        for ring in (one, other):
            k = np.argmin(np.hypot(*(ring - junction).T))
            near = [ring[(k + side) % len(ring)] - junction for side in (-1, 1)]
            rays.append(max(near, key=lambda ray: abs(ray[0])))
        cosine = rays[0] @ rays[1] / np.prod([np.hypot(*ray) for ray in rays])
        self.assertAlmostEqual(np.degrees(np.arccos(cosine)), 2 * np.degrees(np.arccos(0.75)), delta=2)

    def test_grains_follow_von_neumann_and_mullins(self):  # dA/dt = pi / 3 (sides - 6)
        empty = dsc.initial_complex(DOMAIN, edge_length=H)
        seeds = np.random.default_rng(3).random((40, 2))
        centres = empty.points[empty.triangles].mean(axis=1)
        near = np.hypot(*(centres[:, None] - seeds).T).argmin(axis=0)
        mesh = dsc.Mesh(empty.points, empty.triangles, 1 + near)
        sim = dsc.Simulation(mesh, edge_length=H, feature_degrees=180, topology="change")
        dsc.run(sim, dsc.curvature_flow(), 2e-4, 50)
        before = dsc.grains(mesh)
        dsc.run(sim, dsc.curvature_flow(), 2e-5, 5)
        after = dsc.grains(mesh)
        inner = ~before["at_boundary"]
        self.assertGreater(inner.sum(), 12)
        self.assertEqual(before["sides"].tolist(), after["sides"].tolist())
        rates = (after["area"] - before["area"]) / 1e-4
        wanted = np.pi / 3 * (before["sides"] - 6)
        self.assertLess(np.abs(rates - wanted)[inner].max(), 0.05)

    def test_what_balances_at_no_junction_is_told(self):
        with self.assertWarnsRegex(UserWarning, r"phases 0, 2 and 1 .* tension of \(0, 2\) is 3, more than the sum of 1 and 1.5 "):
            dsc.curvature_flow(tension={(0, 1): 1, (1, 2): 1.5, (0, 2): 3})
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            dsc.curvature_flow(tension={(0, 1): 1, (1, 2): 1.5, (0, 2): 2.4})
            dsc.curvature_flow(tension={(0, 1): 1, (0, 2): 3})  # no tension is given for the third pair


@unittest.skipUnless(RegularGridInterpolator, "without scipy")
class OnAGrid(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    # A rotation is linear, so that no interpolation changes it.
    def test_a_rotation_is_that_of_its_formula(self):
        y, x = np.mgrid[0:1:11j, 0:1:21j]
        np.save("wind.npy", np.stack([0.5 - y, x - 0.5], axis=-1))
        mesh = disc_mesh()
        sim = dsc.Simulation(mesh, edge_length=H)
        wind = np.load("wind.npy")  # rows, columns, (u, v)
        y, x = (np.linspace(0, 1, count) for count in wind.shape[:2])
        field = RegularGridInterpolator((y, x), wind)
        dsc.run(sim, lambda points, t: field(points[:, ::-1]), 0.01, 10)
        turned = disc_mesh()
        dsc.run(dsc.Simulation(turned, edge_length=H),
                lambda points, t: np.c_[0.5 - points[:, 1], points[:, 0] - 0.5], 0.01, 10)
        (outline,), (expected,) = mesh.outlines(1), turned.outlines(1)
        self.assertLess(np.abs(outline - expected).max(), 1e-12)


class ThatSeeTheInterface(unittest.TestCase):
    def test_a_disc_grows_along_its_normals_whatever_the_threads(self):
        flow = dsc.interface_flow(lambda interface, t: 0.5 * interface.normals)
        hashes = {grown(flow, threads=threads).mesh_hash for threads in (1, 2, 3)}
        self.assertEqual(len(hashes), 1)
        mesh = grown(flow)
        distances = np.hypot(*(mesh.outlines(1)[0] - 0.5).T)
        self.assertLess(np.abs(distances - 0.25).max(), 1e-4)

    def test_a_velocity_of_places_alone_goes_the_same_way(self):
        ends = []
        for flow in (swirl, dsc.interface_flow(lambda one, t: swirl(one.positions, t))):
            mesh = disc_mesh()
            dsc.Simulation(mesh, edge_length=H).step(flow, 0, H)
            ends.append(mesh.outlines(1)[0])
        self.assertLess(np.abs(ends[0] - ends[1]).max(), 1e-12)

    def test_curvature_is_that_of_the_circle(self):
        seen = []

        def shrink(interface, t):
            seen.append(interface)
            return -interface.curvatures[:, None] * interface.normals

        dt = 2e-5
        mesh = disc_mesh()
        dsc.run(dsc.Simulation(mesh, edge_length=H), dsc.interface_flow(shrink), dt, 50)
        radius = np.sqrt(0.15**2 - 2 * 50 * dt)
        distances = np.hypot(*(mesh.outlines(1)[0] - (0.5, 0.75)).T)
        self.assertLess(np.abs(distances - radius).max(), 2e-5)
        self.assertEqual(len(seen), 50 * 4)  # rk4: once in each stage

        one = seen[0]  # its arrays may be kept
        self.assertEqual(list(vars(one)), fields("Interface"))
        every = np.arange(len(one))
        self.assertTrue(np.array_equal(one.previous[one.next], every))
        self.assertLess(np.abs(one.curvatures - 1 / 0.15).max(), 1e-2)
        self.assertAlmostEqual(one.lengths.sum(), 2 * np.pi * 0.15, delta=1e-2)
        self.assertEqual(set(one.left), {1})
        self.assertEqual(set(one.right), {0})
        for flags in (one.is_junction, one.is_feature, one.is_on_boundary, one.is_locked):
            self.assertFalse(flags.any())

    def test_arms_leave_junctions(self):
        seen = []
        middle, ends = (0.5, 0.5), ((0, 0.5), (1, 0.5), (0.5, 1))
        mesh = dsc.initial_complex(DOMAIN, edge_length=0.05, curves=[
            ([middle, ends[0]], 0, 2), ([middle, ends[1]], 1, 0), ([middle, ends[2]], 2, 1)])
        flow = dsc.interface_flow(lambda one, t: seen.append(one) or 0 * one.positions)
        self.assertEqual(dsc.Simulation(mesh, edge_length=0.05).step(flow, 0, 0.1).unreached, 0)
        one = seen[0]
        at = np.flatnonzero((one.positions == middle).all(axis=1))
        self.assertEqual(len(at), 1)
        self.assertTrue(one.is_junction[at[0]])
        self.assertEqual((one.next[at[0]], one.left[at[0]]), (-1, -1))
        arms = one.arms[one.arms[:, 0] == at[0]]
        self.assertEqual({tuple(row) for row in arms[:, 2:]}, {(0, 2), (1, 0), (2, 1)})
        self.assertTrue((np.hypot(*(one.positions[arms[:, 1]] - middle).T) < 0.06).all())
        self.assertTrue(one.is_on_boundary.any())
        curves = [curve for curve in mesh.interface_curves() if (curve.points == middle).all(axis=1).any()]
        self.assertEqual({(curve.left, curve.right) for curve in curves}, {(2, 0), (1, 0), (2, 1)})

    def test_it_is_called_by_the_thread_that_steps(self):
        threads = set()

        def flow(interface, t):
            threads.add(threading.get_ident())
            return interface.normals

        grown(dsc.interface_flow(flow), threads=2, steps=2)
        self.assertEqual(threads, {threading.get_ident()})

    def test_a_vertex_without_a_number_is_held(self):
        def flow(interface, t):
            velocities = interface.normals.copy()
            velocities[0] = np.nan
            return velocities

        sim = dsc.Simulation(disc_mesh(), edge_length=H)
        self.assertEqual(sim.step(dsc.interface_flow(flow), 0, H / 4).held, 1)


class Runs(unittest.TestCase):
    def test_progress_and_a_word_after_each_step(self):
        said = []
        sim = dsc.Simulation(disc_mesh(), edge_length=H)
        reports = dsc.run(sim, dsc.swirl(), H, 10, progress=said.append,
                          after=lambda sim, report: sim.time < 2.5 * H)
        self.assertEqual(len(reports), 3)
        self.assertAlmostEqual(sim.time, 3 * H)
        self.assertRegex(said[-1], r"^step 3 of 10, t = 0\.06, \d+ interface vertices, 0 unreached$")
        self.assertEqual((reports[-1].gave_up, reports[-1].reason), ("", ""))

    def test_a_step_that_gives_up_says_why(self):
        sim = dsc.Simulation(disc_mesh(), edge_length=H)
        report = sim.step(lambda x, t: 1e9 * swirl(x, t), 0, 1)
        self.assertEqual(report.gave_up, "too_many_sub_steps")
        self.assertRegex(report.reason, r"max_sub_steps sub-steps: vertex \d+ moves at a speed of \d")


if __name__ == "__main__":
    unittest.main()

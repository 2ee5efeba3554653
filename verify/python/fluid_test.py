# SPDX-License-Identifier: MIT
"""Fluids, and result files."""
import copy
import json
import pathlib
import pickle
import tempfile
import unittest

import dsc
import numpy as np
from meshes import disc


def bubble(**options):
    """The rising bubble of Hysing et al. (2009), case 1, at its start."""
    sizes = {"edge_length": 0.04, "growth": 1.3, "longest": 0.1}
    mesh = dsc.initial_complex(((0, 0), (1, 2)), {1: disc((0.5, 0.5), 0.25, 40)}, **sizes)
    sim = dsc.Simulation(mesh, **sizes)
    return sim, dsc.Fluid(sim, {0: (1000, 10), 1: (100, 1)}, {(0, 1): 24.5}, gravity=(0, -0.98),
                          slip={"left", "right"}, **options)


class Fluids(unittest.TestCase):
    def test_a_bubble_rises(self):
        sim, fluid = bubble()
        area = sim.mesh.areas[1]
        while fluid.time < 0.195:
            self.assertEqual(fluid.step(0.01).unreached, 0)
        self.assertAlmostEqual(sim.time, fluid.time)
        self.assertAlmostEqual(sim.mesh.areas[1], area, places=12)
        across, up = fluid.mean_velocity(1)
        self.assertAlmostEqual(across, 0, places=4)
        self.assertAlmostEqual(up, 0.0942, delta=1e-3)  # as in the README of the fluid
        velocities = fluid.velocities
        self.assertEqual(velocities.shape, sim.mesh.points.shape)
        self.assertTrue((velocities[np.isin(sim.mesh.points[:, 1], (0, 2))] == 0).all())
        inside = sim.mesh.phases == 1
        self.assertEqual(fluid.pressures.shape, sim.mesh.triangles.shape)
        self.assertGreater(fluid.pressures[inside].mean(), 24.5 / 0.25 / 2)  # Laplace's, and more
        self.assertGreater(fluid.energies["kinetic"], 0)

    def test_a_copy_continues_bitwise_identically(self):
        sim, fluid = bubble(tolerance=0.01)
        for _ in range(3):
            fluid.step(0.02)
        copies = [copy.copy(fluid), copy.deepcopy(fluid), pickle.loads(pickle.dumps(fluid))]
        with tempfile.TemporaryDirectory() as folder:
            dsc.save(pathlib.Path(folder) / "fluid", fluid)
            copies.append(dsc.load(pathlib.Path(folder) / "fluid"))
        before = fluid.velocities
        fluid.step(0.02)
        for one in copies:
            self.assertIsNot(one.simulation.mesh, sim.mesh)
            np.testing.assert_array_equal(one.velocities, before)
            one.step(0.02)
            self.assertEqual((one.time, one.simulation.mesh.mesh_hash), (fluid.time, sim.mesh.mesh_hash))
            np.testing.assert_array_equal(one.velocities, fluid.velocities)
            np.testing.assert_array_equal(one.pressures, fluid.pressures)

    def test_sides_have_names_inflows_and_forces(self):
        corners = np.array([(0, 0), (2, 1), (1.5, 2), (-.5, 1)])  # a rectangle that is turned
        mesh = dsc.initial_complex([corners, disc((.8, 1), .2, 24)], edge_length=.2,
                                   sides=[["wall", "outlet", "wall", "inlet"], "body"])
        self.assertEqual({name: len(edges) for name, edges in mesh.sides.items()},
                         {"wall": 2, "outlet": 1, "inlet": 1, "body": 24})
        np.testing.assert_array_equal(mesh.sides["outlet"], [[(2, 1), (1.5, 2)]])
        for one in (mesh.copy(), pickle.loads(pickle.dumps(mesh))):
            np.testing.assert_array_equal(one.sides["inlet"], mesh.sides["inlet"])
        sim = dsc.Simulation(mesh, edge_length=.2)
        along = np.array((2, 1)) / 5 ** .5
        fluid = dsc.Fluid(sim, {0: (1, 1)}, {}, inflow={"inlet": 2}, slip={"wall", "body"}, open="outlet",
                          inertia=False)
        on_inlet = np.abs(mesh.points @ along) < 1e-9
        self.assertGreater(on_inlet.sum(), 5)
        np.testing.assert_allclose(fluid.velocities[on_inlet], np.tile(2 * along, (on_inlet.sum(), 1)), atol=1e-12)
        self.assertGreater(np.dot(fluid.force_on("body"), along), .1)
        self.assertEqual(fluid.force_on("outlet"), (0, 0))
        again = copy.copy(fluid)  # numbers can be pickled
        self.assertEqual(again.force_on("body"), fluid.force_on("body"))
        spun = dsc.Fluid(sim, {0: (1, 1)}, {}, velocity={"body": lambda x, y, t: (1 - y, x - .8)}, inertia=False)
        on_body = np.hypot(*(mesh.points - (.8, 1)).T) < .201
        np.testing.assert_allclose(spun.velocities[on_body], ((mesh.points - (.8, 1)) @ ((0, 1), (-1, 0)))[on_body],
                                   atol=1e-12)

    def test_a_lambda_is_copied_but_not_pickled(self):
        sim, _ = bubble()
        fluid = dsc.Fluid(sim, {0: (1, 1), 1: (1, 1)}, {(0, 1): 0}, open="top", slip={"left", "right"},
                          inflow={"bottom": lambda x, y, t: x * (1 - x)})
        fluid.step(0.01)
        for again in (copy.copy, copy.deepcopy):
            other = again(fluid)
            self.assertIsNot(other.simulation.mesh, sim.mesh)
            np.testing.assert_array_equal(other.velocities, fluid.velocities)
        sentence = r"Fluid: options\['inflow'\]\['bottom'\]: cannot be pickled: got <function .*; allowed: numbers, or a f"
        for store in (pickle.dumps, lambda one: dsc.save("/dev/null", one)):
            with self.assertRaisesRegex(dsc.InputError, sentence):
                store(fluid)

    def test_a_side_has_one_condition(self):
        sim, _ = bubble()
        for options, words in [({"inflow": {"inlet": 1}}, "inflow: not a side of the domain: got 'inlet'; allowed: left,"),
                               ({"slip": "left", "open": "left"}, "two conditions on one side"),
                               ({"inflow": {"left": "x"}}, "not a number: got 'x'"),
                               ({"open": "top", "inflow": {"left": lambda x, y, t: (x, y)}}, "not a number: got "),
                               ({"velocity": {"left": 1}}, "not two numbers: got 1"),
                               ({"inflow": ["left"]}, "not a dict"),
                               ({"inflow": {"left": 1}}, "more flows into the domain than out of it")]:
            with self.assertRaisesRegex(dsc.InputError, words):
                dsc.Fluid(sim, {0: (1, 1), 1: (1, 1)}, {(0, 1): 0}, inertia=False, **options)
        outline = [(0, 0), (1, 0), (0, 1)]
        for domain, sides, words in [(outline, ["a", "b"], "2 for 1 rings"),
                                     (outline, [["a", "b"]], "2 names for 3 edges"),
                                     (outline, [3], "not a name of a side: got 3"),
                                     (outline, 3, "not names of sides: got 3"),
                                     (((0, 0), (1, 1)), "a", "names for the sides of a rectangle")]:
            with self.assertRaisesRegex(dsc.InputError, words):
                dsc.initial_complex(domain, sides=sides, edge_length=.2)

    def test_a_copy_has_no_flow_in_a_mesh_that_has_changed(self):
        sim, fluid = bubble()
        fluid.step(0.01)
        sim.step(lambda points, time: 0 * points, 0, 0.01)
        with self.assertRaisesRegex(RuntimeError, "the mesh has changed"):
            copy.copy(fluid).velocities
        _, (_, state) = fluid.__reduce__()
        with self.assertRaises(dsc.FileError):
            dsc.fluid._fluid_from(sim, state[:-1])

    def test_threads_and_a_tolerance(self):
        hashes = set()
        for threads in (1, 2):
            sim, fluid = bubble(threads=threads, tolerance=0.01)
            fluid.step(0.05)
            fluid.step(0.05)
            self.assertAlmostEqual(fluid.time, 0.1)
            hashes.add((sim.mesh.mesh_hash, fluid.velocities.tobytes()))
        self.assertEqual(len(hashes), 1)
        coarse, one = bubble()
        one.step(0.05)
        one.step(0.05)
        self.assertNotEqual(coarse.mesh.mesh_hash, sim.mesh.mesh_hash)  # which made more steps

    def test_a_drop_in_a_void_meets_the_wall(self):
        sizes = {"edge_length": 0.05}
        half = disc((0.5, 0), 0.25, 40)[:21]
        half[[0, -1], 1] = 0  # on the wall
        mesh = dsc.initial_complex(((0, 0), (1, 0.5)), curves=[(half, 1, 0)], **sizes)
        widths = []
        for angle in (60, 120):  # inside phase 1: below 90 it spreads
            sim = dsc.Simulation(mesh.copy(), **sizes)
            fluid = dsc.Fluid(sim, {0: None, 1: (1, 1)}, {(0, 1): (1, angle)},
                              slip="bottom", inertia=False)
            for _ in range(5):
                self.assertEqual(fluid.step(0.01).unreached, 0)
            x = sim.mesh.interface_curves()[0].points[:, 0]
            widths.append(np.ptp(x))
        self.assertGreater(widths[0], 0.5)
        self.assertLess(widths[1], 0.5)

    def test_knows_whether_the_mesh_has_changed(self):
        sim, fluid = bubble(inertia=False)
        with self.assertRaises(dsc.InputError):
            fluid.step(-1)
        sim.step(lambda x, t: 0 * x + (0, 1), 0, 0.01)
        with self.assertRaisesRegex(RuntimeError, "has changed since the fluid's last step"):
            fluid.velocities
        del sim  # the fluid keeps the simulation alive
        self.assertEqual(fluid.step(0.01).unreached, 0)


class Results(unittest.TestCase):
    def test_are_columns(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, rows in (("a", [{"name": "swirl", "real_time": 2}]),
                               ("b", [{"name": "grains", "real_time": 3.5, "threads": 2}])):
                path = pathlib.Path(folder) / f"{name}.json"
                path.write_text(json.dumps({"context": {}, "benchmarks": rows}), encoding="utf-8")
            read = dsc.bench.read(folder)
            self.assertEqual(list(read["name"]), ["swirl", "grains"])
            self.assertEqual(list(read["real_time"]), [2, 3.5])
            self.assertTrue(np.isnan(read["threads"][0]))
            self.assertEqual(len(dsc.bench.read(path)["file"]), 1)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""The Python module: what a user does with it, and what it refuses."""
import copy
import signal
import threading
import unittest

import dsc
import numpy as np
from meshes import H, disc, disc_mesh, swirl

class Steps(unittest.TestCase):
    def test_threads_give_the_same_bits(self):
        hashes = set()
        for threads in (1, 2, 3):
            mesh = disc_mesh()
            sim = dsc.Simulation(mesh, edge_length=H, threads=threads)
            for k in range(25):
                self.assertEqual(sim.step(swirl, H * k, H).unreached, 0)
            self.assertEqual(mesh.validate(), "")
            hashes.add(mesh.mesh_hash)
        self.assertEqual(len(hashes), 1)

    def test_a_run_ends_where_it_is_told_to(self):
        sim = dsc.Simulation(disc_mesh(), edge_length=H)
        reports = dsc.run(sim, swirl, H, 10, after=lambda sim, report: sim.time < 2.5 * H)
        self.assertEqual(len(reports), 3)
        self.assertAlmostEqual(sim.time, 3 * H)
        self.assertEqual(len(dsc.run(sim, swirl, H, 2)), 2)
        self.assertAlmostEqual(sim.time, 5 * H)

    def test_curvature_flow_keeps_areas(self):
        square = [(0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7)]
        mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: square}, edge_length=H)
        sim = dsc.Simulation(mesh, edge_length=H, corner_degrees=180)
        dsc.run(sim, dsc.curvature_flow(keep_areas_of=mesh), 1e-3, 20)
        self.assertAlmostEqual(mesh.areas[1], 0.16, places=9)
        distances = np.hypot(*(mesh.outlines(1)[0] - 0.5).T)
        self.assertLess(np.ptp(distances), 1e-3)  # it has become a disc

    def test_discs_that_meet_tell_of_it(self):
        mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: [disc((0.3, 0.5)), disc((0.7, 0.5))]},
                                   edge_length=H)
        sim = dsc.Simulation(mesh, edge_length=H, topology="change")
        events = []
        dsc.run(sim, lambda x, t: np.c_[np.sign(0.5 - x[:, 0]), 0 * x[:, 1]], H / 2, 8,
                after=lambda sim, report: events.extend(report.events))
        self.assertIn("merge", {event.kind for event in events})
        self.assertEqual(list(mesh.vertex_data), [])  # what the library notes is nobody's data
        self.assertEqual(len(mesh.outlines(1)), 1)

    def test_nothing_is_kept_alive(self):
        class Function:
            def __call__(self, x, t):
                return 0 * x

            def __del__(self):
                gone.append(True)

        gone = []
        sim = dsc.Simulation(disc_mesh(), edge_length=H, threads=2)
        for k in range(10):
            sim.step(Function(), 0, H)
        self.assertEqual(len(gone), 10)


class Arrays(unittest.TestCase):
    def test_they_are_dense_and_stay_as_they_were(self):
        mesh = disc_mesh()
        points, triangles, phases = mesh.points, mesh.triangles, mesh.phases
        self.assertIs(mesh.points, points)
        self.assertEqual((triangles.min(), triangles.max()), (0, len(points) - 1))
        self.assertEqual(len(phases), len(triangles))
        self.assertEqual(len(mesh.qualities), len(triangles))
        for array in (points, triangles, phases):
            self.assertTrue(array.flags.c_contiguous)
            with self.assertRaises(ValueError):
                array[0] = 0
        before = points.copy()
        dsc.Simulation(mesh, edge_length=H).step(swirl, 0, H)
        self.assertTrue(np.array_equal(points, before))
        self.assertFalse(mesh.points.shape == before.shape and np.array_equal(mesh.points, before))

    def test_areas_are_those_of_the_triangles(self):
        mesh = disc_mesh()
        a, b, c = np.moveaxis(mesh.points[mesh.triangles], 1, 0)
        doubled = np.cross(b - a, c - a)
        self.assertGreater(doubled.min(), 0)
        for phase, area in mesh.areas.items():
            self.assertAlmostEqual(doubled[mesh.phases == phase].sum() / 2, area, places=12)

    def test_curves_meet_at_junctions(self):
        middle = (0.5, 0.5)
        ends = ((0, 0.5), (1, 0.5), (0.5, 1))
        mesh = dsc.initial_complex(((0, 0), (1, 1)), edge_length=0.05, curves=[
            ([middle, ends[0]], 0, 2), ([middle, ends[1]], 1, 0), ([middle, ends[2]], 2, 1)])
        inside = [curve for curve in mesh.interface_curves()
                  if any(np.array_equal(point, middle) for point in curve.points)]
        self.assertEqual({(curve.left, curve.right) for curve in inside}, {(2, 0), (1, 0), (2, 1)})

    def test_a_copy_is_a_mesh_of_its_own(self):
        mesh = disc_mesh()
        other = copy.deepcopy(mesh)
        sims = [dsc.Simulation(one, edge_length=H) for one in (mesh, other)]
        sims[0].step(swirl, 0, H)
        self.assertNotEqual(mesh.mesh_hash, other.mesh_hash)
        sims[1].step(swirl, 0, H)
        self.assertEqual(mesh.mesh_hash, other.mesh_hash)


class Data(unittest.TestCase):
    def test_it_follows_the_mesh(self):
        mesh = disc_mesh()
        mesh.vertex_data["x"] = mesh.points[:, 0]
        mesh.vertex_data["place"] = mesh.points
        mesh.triangle_data["phase"] = mesh.phases
        shift = 0.05
        sim = dsc.Simulation(mesh, edge_length=H)
        report = sim.step(lambda x, t: 0 * x + (shift / H, 0), 0, H)
        self.assertEqual(report.unreached, 0)
        self.assertEqual(set(mesh.vertex_data), {"x", "place"})
        self.assertEqual(len(mesh.triangle_data["phase"]), len(mesh.triangles))
        self.assertLess(np.abs(mesh.vertex_data["x"] - mesh.points[:, 0]).max(), 2 * shift)
        self.assertTrue(np.array_equal(mesh.vertex_data["place"][:, 0], mesh.vertex_data["x"]))
        del mesh.vertex_data["x"]
        self.assertEqual(list(mesh.vertex_data), ["place"])
        with self.assertRaises(KeyError):
            mesh.vertex_data["x"]

    def test_refused(self):
        mesh = disc_mesh()
        mesh.vertex_data["one"] = np.zeros(len(mesh.points))
        for values in (np.zeros(3), 1.0, "text", np.zeros((len(mesh.points), 3))):
            with self.assertRaisesRegex(dsc.InputError, r"allowed: numbers of the shape \("):
                mesh.vertex_data["two"] = values
        for data, values in ((mesh.vertex_data, mesh.points),
                             (mesh.triangle_data, np.zeros(len(mesh.triangles)))):
            with self.assertRaisesRegex(dsc.InputError, "one"):
                data["one"] = values


class Scenes(unittest.TestCase):
    def test_a_result_is_a_dictionary(self):
        self.assertIn("swirl", dsc.scenes.names())
        results = [dsc.scenes.run("swirl", h=0.03, steps=2, threads=threads) for threads in (1, 2)]
        self.assertTrue(results[0]["holds"])
        self.assertEqual(results[0]["mesh_hash"], results[1]["mesh_hash"])
        self.assertEqual(results[0]["parameters"]["h"], 0.03)

    def test_refused(self):
        with self.assertRaisesRegex(ValueError, "unknown key: got 'hh'"):
            dsc.scenes.run("swirl", hh=0.03)
        with self.assertRaisesRegex(ValueError, "swril"):
            dsc.scenes.run("swril")


class Refused(unittest.TestCase):
    def setUp(self):
        self.mesh = disc_mesh()

    def refused(self, sentence, *arguments, error=dsc.InputError, **options):
        with self.assertRaisesRegex(error, sentence):
            dsc.Simulation(self.mesh, **({"edge_length": H} | options)).step(*arguments)
        self.assertEqual(self.mesh.validate(), "")

    def test_options(self):
        self.refused("unknown option: got 'edge'", edge=H)
        self.refused("integrator: bad value: got 'rk5'; allowed: euler, ", integrator="rk5")
        self.refused("edge_length: bad value: got 'long'", edge_length="long")
        self.refused("edge", edge_length=-1)
        self.refused("threads: bad value: got -1", threads=-1)

    def test_velocities(self):
        shape = r"numbers of the shape \(\d+, 2\)"
        for threads in (1, 2):
            for function, sentence in ((lambda x, t: 1.0, r"shape \(\); allowed: " + shape),
                                       (lambda x, t: x[1:], shape),
                                       (lambda x, t: x + 1j, "not an array of points"),
                                       (lambda x, t: None, "not an array of points"),
                                       (lambda x, t: "fast", "got 'fast'")):
                self.refused(sentence, function, 0, H, threads=threads)
            self.refused("by zero", lambda x, t: 1 / 0, 0, H, threads=threads,
                         error=ZeroDivisionError)
        self.refused("not a flow: got 3", 3, 0, H)
        self.refused("not a time step", swirl, 0, -H)

    def test_shapes(self):
        for shapes, sentence in (({1: 3}, r"shapes\[1\]"), ({"a": disc()}, "not a phase"),
                                 ({1: disc()[:2]}, ""), ({1: disc().T}, "of another shape")):
            with self.assertRaisesRegex(dsc.InputError, sentence):
                dsc.initial_complex(((0, 0), (1, 1)), shapes, edge_length=H)
        with self.assertRaisesRegex(dsc.InputError, "not a rectangle"):
            dsc.initial_complex(((0, 0),), edge_length=H)
        with self.assertRaisesRegex(dsc.InputError, "edge_length: value out of range: got 0"):
            dsc.initial_complex(((0, 0), (1, 1)))
        with self.assertRaisesRegex(dsc.InputError, "unknown option: got 'gap'; allowed: edge_length, "):
            dsc.initial_complex(((0, 0), (1, 1)), edge_length=H, gap=1)

    def test_a_velocity_that_is_no_number_holds_its_vertices(self):
        report = dsc.Simulation(self.mesh, edge_length=H).step(lambda x, t: x * np.nan, 0, H)
        self.assertEqual(report.held, report.interface_vertices)

    def test_a_mesh_has_one_simulation_and_one_step_at_a_time(self):
        sim = dsc.Simulation(self.mesh, edge_length=H)
        with self.assertRaisesRegex(dsc.InputError, "another simulation"):
            dsc.Simulation(self.mesh, edge_length=H)
        with self.assertRaisesRegex(RuntimeError, "a step of this mesh runs"):
            sim.step(lambda x, t: self.mesh.points, 0, H)
        with self.assertRaisesRegex(RuntimeError, "a step of this mesh runs"):
            sim.step(lambda x, t: sim.step(swirl, 0, H), 0, H)
        self.assertEqual(sim.step(swirl, 0, H).unreached, 0)

    def test_files(self):
        for write in (self.mesh.write_svg, self.mesh.write_vtu):
            with self.assertRaises(OSError):
                write("/no/such/folder/mesh")


class Interrupted(unittest.TestCase):
    def test_by_control_c(self):
        def function(x, t):
            signal.raise_signal(signal.SIGINT)
            return 0 * x

        mesh = disc_mesh()
        with self.assertRaises(KeyboardInterrupt):
            dsc.Simulation(mesh, edge_length=H).step(function, 0, H)
        self.assertEqual(mesh.validate(), "")

    def test_simulations_in_two_threads_do_not_disturb_each_other(self):
        def go(result):
            mesh = disc_mesh()
            sim = dsc.Simulation(mesh, edge_length=H, threads=2)
            for k in range(10):
                sim.step(swirl, H * k, H)
            result.append(mesh.mesh_hash)

        hashes = []
        threads = [threading.Thread(target=go, args=(hashes,)) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(hashes), 2)
        self.assertEqual(len(set(hashes)), 1)


class Drawn(unittest.TestCase):
    def test_a_picture_has_triangles_and_curves(self):
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib.figure import Figure
        mesh = disc_mesh()
        ax = dsc.plot(mesh, Figure().add_subplot())
        triangles, curves = ax.collections
        self.assertEqual(len(triangles.get_paths()), len(mesh.triangles))
        self.assertEqual(len(curves.get_segments()), 1)
        ax = dsc.plot(mesh, Figure().add_subplot(), values=mesh.qualities, interface=False)
        self.assertEqual(len(ax.collections), 1)


if __name__ == "__main__":
    unittest.main()

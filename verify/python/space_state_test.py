# SPDX-License-Identifier: MIT
"""Simulations in space: copies, checkpoints, files, exceptions, and what lives how long."""
import copy
import gc
import math
import pathlib
import pickle
import tempfile
import unittest
import weakref

import dsc
import numpy as np
from meshes import BOX, ball_mesh, started, turn

H = 0.1


def turn_back(points, angle):
    x, y = (points[:, :2] - 0.5).T
    c, s = math.cos(angle), math.sin(angle)
    return np.c_[0.5 + c * x + s * y, 0.5 + c * y - s * x, points[:, 2]]


class State(unittest.TestCase):
    def test_a_copy_goes_on_to_the_same_bits(self):
        for options in ({}, {"threads": 2}, {"submeshes": 2, "integrator": "euler"}):
            for again in (copy.copy, copy.deepcopy, lambda sim: pickle.loads(pickle.dumps(sim))):
                sim = started(**options)
                sim.mesh.vertex_data["x"] = sim.mesh.points[:, 0]
                other = again(sim)
                self.assertIsNot(other.mesh, sim.mesh)
                self.assertEqual((other.time, other.options), (sim.time, sim.options))
                for one in (sim, other):
                    dsc.run(one, turn, H, 2)
                self.assertEqual(sim.mesh.mesh_hash, other.mesh.mesh_hash)
                self.assertTrue(np.array_equal(sim.mesh.vertex_data["x"], other.mesh.vertex_data["x"]))

    def test_a_checkpoint_is_whole_or_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.dsc"
            sim = started()
            sim.mesh.tet_data["place"] = np.zeros((len(sim.mesh.phases), 3))
            dsc.save(path, (sim, sim.mesh))
            other, mesh = dsc.load(path)
            self.assertIs(other.mesh, mesh)
            self.assertEqual(mesh.tet_data["place"].shape, (len(mesh.phases), 3))
            for one in (sim, other):
                one.step(turn, one.time, H)
            self.assertEqual(sim.mesh.mesh_hash, mesh.mesh_hash)
            whole = path.read_bytes()
            path.write_bytes(whole[:len(whole) // 2] + b"x" + whole[len(whole) // 2 + 1:])
            with self.assertRaisesRegex(dsc.FileError, "damaged: the checksum"):
                dsc.load(path)

    def test_files_have_all_tets_and_all_faces(self):
        import meshio
        mesh = started().mesh  # some ids are free
        mesh.vertex_data["x & y"] = mesh.points
        mesh.tet_data["angle"] = mesh.min_dihedrals
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            mesh.write_vtu(folder / "mesh.vtu")
            read = meshio.read(folder / "mesh.vtu")
            self.assertEqual(dsc.from_meshio(read).mesh_hash, mesh.mesh_hash)
            self.assertTrue(np.array_equal(read.point_data["x & y"], mesh.points))
            self.assertTrue(np.array_equal(read.cell_data["angle"][0], mesh.min_dihedrals))
            count = len(mesh.interface_faces().triangles)
            for write, name in ((mesh.write_interface_vtu, "a.vtu"), (mesh.write_ply, "a.ply"), (mesh.write_stl, "a.stl")):
                write(folder / name)
                [block] = meshio.read(folder / name).cells
                self.assertEqual(len(block.data), count, name)
            faces = meshio.read(folder / "a.vtu")
            self.assertTrue(np.array_equal(faces.point_data["x & y"], faces.points))
            series = dsc.Series(folder / "run.pvd")
            dsc.run(dsc.Simulation(mesh, edge_length=H), turn, H, 2, after=lambda sim, report: series.add(sim.mesh, sim.time))
            self.assertEqual(len(list(folder.glob("run_*.vtu"))), 2)


class AfterAnException(unittest.TestCase):
    def test_the_simulation_knows_how_far_it_came(self):
        for threads in (None, 2):
            def function(x, t):
                if t > 0.35:
                    raise LookupError("enough")
                return turn(x, t)

            sim = dsc.Simulation(ball_mesh(), edge_length=H, threads=threads)
            with self.assertRaisesRegex(LookupError, "enough"):
                sim.step(function, 0, 2)
            self.assertEqual(sim.mesh.validate(), "")
            self.assertTrue(0 < sim.time <= 0.35)
            self.assertEqual(sim.report.reached, sim.time)
            self.assertGreater(sim.report.sub_steps, 0)
            self.assertEqual(sim.step(turn, sim.time, 2 - sim.time).unreached, 0)  # goes on
            points = sim.mesh.points[np.unique(sim.mesh.interface_faces().triangles)]
            back = turn_back(points, 2)
            self.assertLess(np.abs(np.linalg.norm(back - (0.5, 0.5, 0.6), axis=1) - 0.25).max(), 0.01)

    def test_a_refused_step_changes_nothing(self):
        sim = started()
        done, state = sim.report, (sim.mesh.mesh_hash, sim.time)
        for time, dt in ((math.nan, H), (7, math.nan), (7, -H)):
            with self.assertRaisesRegex(dsc.InputError, "bad time or dt"):
                sim.step(turn, time, dt)
        self.assertEqual((sim.mesh.mesh_hash, sim.time), state)
        self.assertEqual(sim.report, done)

    def test_a_step_that_gives_up_says_so(self):
        sim = dsc.Simulation(ball_mesh(), edge_length=H, max_sub_steps=3)
        reports = dsc.run(sim, lambda x, t: 5 * turn(x, t), 1, 3)
        self.assertEqual([one.gave_up for one in reports], ["too_many_sub_steps"])
        self.assertRegex(reports[0].reason, "more than max_sub_steps")
        self.assertEqual(sim.step(turn, sim.time, H).reason, "")


class Lifetimes(unittest.TestCase):
    def test_arrays_outlive_the_mesh_and_the_mesh_its_simulation(self):
        mesh = ball_mesh()
        sim = dsc.Simulation(mesh, edge_length=H, threads=2)
        sim.step(turn, 0, H)
        points, faces = mesh.points, mesh.interface_faces()
        sums = points.sum(), faces.triangles.sum()
        kept = weakref.ref(mesh)
        del mesh
        gc.collect()
        self.assertIs(sim.mesh, kept())  # the simulation keeps it
        mesh = sim.mesh
        del sim
        gc.collect()
        dsc.Simulation(mesh, edge_length=H).step(turn, 0, H)  # free for another one
        del mesh
        gc.collect()
        self.assertIsNone(kept())
        ball_mesh()  # takes the memory
        self.assertEqual((points.sum(), faces.triangles.sum()), sums)

    def test_no_function_is_kept_alive(self):
        class Function:
            def __call__(self, x, t=0):
                return turn(x, t) if t else np.linalg.norm(x - 0.5, axis=1) - 0.2

        function = Function()
        gone = weakref.ref(function)
        mesh = dsc.initial_complex(BOX, {1: function}, edge_length=H)
        sim = dsc.Simulation(mesh, edge_length=H)
        sim.step(function, 1, H)
        del function
        gc.collect()
        self.assertIsNone(gone())

    def test_a_velocity_may_step_another_simulation(self):
        other = dsc.Simulation(ball_mesh(), edge_length=H, threads=2)

        def nested(x, t):
            if other.time == 0:
                other.step(turn, 0, H)
            return turn(x, t)

        sim = dsc.Simulation(ball_mesh(), edge_length=H, threads=2)
        sim.step(nested, 0, H)
        self.assertEqual(sim.mesh.mesh_hash, other.mesh.mesh_hash)


if __name__ == "__main__":
    unittest.main()

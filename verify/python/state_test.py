# SPDX-License-Identifier: MIT
"""Copies, pickles and checkpoints; and the state after an exception."""
import copy
import pathlib
import pickle
import sys
import tempfile
import unittest

import dsc
import numpy as np
from meshes import DOMAIN, H, disc, disc_mesh, swirl


def by_place(x, y, time, phase):
    return H + 0.2 * abs(x - 0.5)


# Kinds of simulations: their flow, and their options.
KINDS = {
    "sequential": (None, {}),
    "threads": (None, {"threads": 2}),
    "topology": (None, {"topology": "change"}),
    "graded": (None, {"growth": 1.3, "by_place": by_place}),
    "growing": (dsc.growth({(1, 0): 0.3}), {"threads": 2}),
}


def begun(kind):
    flow, options = KINDS[kind]
    mesh = disc_mesh()
    mesh.vertex_data["x"] = mesh.points[:, 0]
    sim = dsc.Simulation(mesh, flow, edge_length=H, **options)
    mesh.triangle_data["place"] = np.zeros((len(mesh.triangles), 2))
    dsc.run(sim, flow or swirl, H, 5)
    return sim


class ASimulation(unittest.TestCase):
    def test_goes_on_to_the_same_bits(self):
        for kind, (flow, _) in KINDS.items():
            for again in (copy.copy, copy.deepcopy, lambda sim: pickle.loads(pickle.dumps(sim))):
                sim = begun(kind)
                other = again(sim)
                self.assertEqual(other.time, sim.time)
                self.assertEqual(other.options, sim.options)
                self.assertIsNot(other.mesh, sim.mesh)
                for one in (sim, other):
                    dsc.run(one, flow or swirl, H, 5)
                self.assertEqual(sim.mesh.mesh_hash, other.mesh.mesh_hash, kind)
                for data in ("vertex_data", "triangle_data"):
                    self.assertEqual(sorted(getattr(sim.mesh, data)), sorted(getattr(other.mesh, data)))
                    for name, values in getattr(sim.mesh, data).items():
                        self.assertTrue(np.array_equal(values, getattr(other.mesh, data)[name]))

    def test_is_written_and_read_with_its_mesh(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.dsc"
            sim = begun("sequential")
            dsc.save(path, (sim, sim.mesh, "a note"))
            other, mesh, note = dsc.load(path)
            self.assertIs(other.mesh, mesh)
            self.assertEqual(note, "a note")
            whole = path.read_bytes()
            for changed, sentence in ((whole[:20], "too short"), (whole[:-1], "incomplete"),
                                      (b"x" + whole[1:], "not a file of kind"),
                                      (whole[:-9] + b"x" + whole[-8:], "damaged: the checksum")):
                path.write_bytes(changed)
                with self.assertRaisesRegex(dsc.FileError, f"run.dsc: {sentence}"):
                    dsc.load(path)
            with self.assertRaises(OSError):
                dsc.load(path.with_name("nowhere"))
            with self.assertRaises(OSError):
                dsc.save("/no/such/folder/run", sim)

    def test_a_pickle_with_a_changed_byte_is_never_another_mesh(self):
        mesh = dsc.initial_complex(DOMAIN, {1: disc()}, edge_length=0.1)
        mesh.vertex_data["x"] = mesh.points[:, 0]
        whole = pickle.dumps(mesh)
        random = np.random.default_rng(1)
        refused = 0
        for at in random.choice(len(whole), 500, replace=False):
            changed = bytearray(whole)
            changed[at] ^= 1 << random.integers(8)
            try:
                other = pickle.loads(changed)
            except Exception:  # an error of pickle itself: its frame was damaged
                refused += 1
                continue
            self.assertEqual(other.mesh_hash, mesh.mesh_hash)
            self.assertTrue(np.array_equal(other.vertex_data["x"], mesh.vertex_data["x"]))
        self.assertGreater(refused, 490)


    def test_functions_are_copied_and_those_without_a_name_not_pickled(self):
        sim = dsc.Simulation(disc_mesh(), edge_length=H, growth=1.3, by_place=lambda x, y, t, phase: H + 0 * x)
        sim.step(swirl, 0, H)
        for again in (copy.copy, copy.deepcopy):
            other = again(sim)
            self.assertEqual(other.step(swirl, H, H), sim.step(swirl, H, H))
            self.assertEqual(other.mesh.mesh_hash, sim.mesh.mesh_hash)
            sim = other
        with self.assertRaisesRegex(dsc.InputError, r"simulation: options\['by_place'\]: cannot be pickled: got <function"):
            pickle.dumps(sim)

    def test_pickles_of_another_layout_are_refused(self):
        mesh = disc_mesh()
        made = [mesh, dsc.Simulation(mesh, edge_length=H),
                dsc.initial_complex(((0, 0, 0), (1, 1, 1)), {1: dsc.ball((.5, .5, .5), .3)}, edge_length=.25)]
        made.append(dsc.Fluid(made[1], {0: (1, 1), 1: (1, 1)}, {(0, 1): 0}))
        for one in made:
            make, (*parts, state) = one.__reduce__()
            for old, sentence in ((state[:8] + b"\1" + state[9:], "version 1 of its layout, not 4: read it with the pr"),
                                  (dsc._dsc.sealed(pickle.dumps(("a", "tuple"))), "written by another version of dsc")):
                with self.assertRaisesRegex(dsc.FileError, sentence):
                    make(*parts, old)

    def test_a_function_that_is_gone_is_told(self):
        whole = pickle.dumps(dsc.Simulation(disc_mesh(), edge_length=H, growth=1.3, by_place=by_place))
        module, function = sys.modules[by_place.__module__], by_place
        del module.by_place
        try:
            with self.assertRaisesRegex(dsc.FileError, "simulation: needs what is not here: .*by_place"):
                pickle.loads(whole)
        finally:
            module.by_place = function


class AMesh(unittest.TestCase):
    def test_is_made_of_its_arrays(self):
        mesh = disc_mesh()
        other = dsc.Mesh(mesh.points, mesh.triangles, mesh.phases)
        self.assertEqual(other.mesh_hash, mesh.mesh_hash)
        for arguments, sentence in (((mesh.points, mesh.triangles, mesh.phases[1:]), "do not match"),
                                    ((mesh.points, mesh.triangles[:, :2], mesh.phases), "do not match"),
                                    ((mesh.points, mesh.triangles - 1, mesh.phases), "triangles: a number out of range"),
                                    ((mesh.points, mesh.triangles + 1, mesh.phases), ""),
                                    ((mesh.points, mesh.triangles * 1.0, mesh.phases), "triangles: numbers that need not be whole"),
                                    ((mesh.points * np.nan, mesh.triangles, mesh.phases), "finite")):
            with self.assertRaisesRegex(dsc.InputError, sentence):
                dsc.Mesh(*arguments)

    def test_says_whether_it_has_changed(self):
        mesh = disc_mesh()
        sim = dsc.Simulation(mesh, edge_length=H)
        before = mesh.revision
        self.assertEqual(len(mesh.points), len(mesh.vertex_data.setdefault("x", mesh.points[:, 0])))
        self.assertEqual(mesh.revision, before)
        sim.step(swirl, 0, H)
        self.assertGreater(mesh.revision, before)


class AfterAnException(unittest.TestCase):
    def test_a_refused_step_changes_nothing(self):
        for threads in (1, 2):
            sim = dsc.Simulation(disc_mesh(), edge_length=H, topology="change", threads=threads)
            done = sim.step(swirl, 1, H)
            state = sim.mesh.mesh_hash, sim.time
            for time, dt in ((np.nan, H), (np.inf, H), (7, np.nan), (7, -H)):
                with self.assertRaisesRegex(dsc.InputError, "not a time step"):
                    sim.step(swirl, time, dt)
            with self.assertRaisesRegex(dsc.InputError, "dt must be positive"):
                sim.step(dsc.curvature_flow(), 7, 0)
            self.assertEqual((sim.mesh.mesh_hash, sim.time), state)
            self.assertEqual(sim.report, done)

    def test_the_simulation_knows_how_far_it_came(self):
        for threads in (1, 2):
            def function(x, t):
                if t > 2.5 * H:
                    raise ValueError("enough")
                return swirl(x, t)

            sim = dsc.Simulation(disc_mesh(), edge_length=H, threads=threads)
            sim.step(swirl, -H, H)  # its speed determines the first sub-step of the next step
            with self.assertRaisesRegex(ValueError, "enough"):
                sim.step(function, 0, 10 * H)
            self.assertEqual(sim.mesh.validate(), "")
            self.assertGreater(sim.report.sub_steps, 2)
            self.assertEqual(sim.report.reached, sim.time)
            self.assertTrue(0 < sim.time <= 2.5 * H)
            other = dsc.Simulation(disc_mesh(), edge_length=H)
            dsc.run(other, swirl, 11 * H, 1, time=-H)
            sim.step(swirl, sim.time, 10 * H - sim.time)  # goes on
            self.assertEqual(sim.report.unreached, 0)
            difference = dsc.symmetric_difference(sim.mesh.outlines(1), other.mesh.outlines(1))
            self.assertLess(difference, 1e-3)


if __name__ == "__main__":
    unittest.main()

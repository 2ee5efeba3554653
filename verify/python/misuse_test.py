# SPDX-License-Identifier: MIT
"""Mistakes in a notebook: each case raises an error with a sentence, and leaves a valid mesh."""
import copy
import pickle
import signal
import threading
import unittest

import dsc
import numpy as np
from meshes import DOMAIN, H, disc, disc_mesh, swirl


def stepped(flow, time=0.0, dt=H, **options):
    """Makes a step in a new simulation."""
    return lambda mesh: dsc.Simulation(mesh, edge_length=H, **options).step(flow, time, dt)


def interrupted(*_):
    signal.raise_signal(signal.SIGINT)
    return np.zeros((1, 2))


def raising(*_):
    raise LookupError("no velocity today")


def by_the_mesh_that_moves(use):
    """Uses the mesh inside the velocity function of its own step."""
    return lambda mesh: stepped(lambda x, t: use(mesh) and x)(mesh)


def second_simulation(mesh):
    sims = [dsc.Simulation(mesh, edge_length=H)]
    sims.append(dsc.Simulation(mesh, edge_length=H))


def two_threads_step_one_mesh(mesh):
    sim = dsc.Simulation(mesh, edge_length=H)
    raised, inside, done = [], threading.Event(), threading.Event()

    def other():
        inside.wait(10)
        try:
            sim.step(swirl, 0, H)
        except RuntimeError as error:
            raised.append(error)
        done.set()

    def slow(x, t):
        inside.set()
        done.wait(10)
        return swirl(x, t)

    thread = threading.Thread(target=other)
    thread.start()
    sim.step(slow, 0, H)
    thread.join()
    raise raised[0]


def fluid_of(**changes):
    given = {"phases": {0: (1, 1), 1: (1, 1)}, "tensions": {(0, 1): 1}} | changes
    return lambda mesh: dsc.Fluid(dsc.Simulation(mesh, edge_length=H), **given)


def graded(growth=1.3, **sizes):
    return dsc.initial_complex(DOMAIN, {1: disc()}, edge_length=H, growth=growth, **sizes)


def data(name, values, kind="vertex_data"):
    return lambda mesh: getattr(mesh, kind).__setitem__(name, values)


def masked(array, count=1):
    return np.ma.array(array, mask=np.arange(np.size(array)).reshape(np.shape(array)) < count)


INPUT = dsc.InputError
# (action on a mesh, error type, pattern of the message)
CASES = {
    "velocity of another shape": (stepped(lambda x, t: x.T), INPUT, r"got an array of the shape \(2, \d+\)"),
    "velocity of too few rows": (stepped(lambda x, t: x[:3]), INPUT, r"got an array of the shape \(3, 2\)"),
    "velocity without return": (stepped(lambda x, t: None), INPUT, "what the velocity returns.*got None"),
    "velocity of texts": (stepped(lambda x, t: [["a", "b"]] * len(x)), INPUT, "not an array of points"),
    "velocity of complex numbers": (stepped(lambda x, t: 1j * x), INPUT, "not an array of points"),
    "velocity of objects": (stepped(lambda x, t: x.astype(object)), INPUT, "not an array of points"),
    "velocity of one argument": (stepped(lambda x: x), TypeError, "positional argument"),
    "velocity that raises": (stepped(raising), LookupError, "no velocity today"),
    "velocity that raises in threads": (stepped(raising, threads=2), LookupError, "no velocity today"),
    "velocity that raises while it sees": (stepped(dsc.interface_flow(raising)), LookupError, "no velocity"),
    "velocity that is a number": (stepped(3.0), INPUT, "not a flow: got 3.0; allowed: a function"),
    "Ctrl-C in a velocity": (stepped(interrupted), KeyboardInterrupt, ""),
    "Ctrl-C in threads": (stepped(interrupted, threads=2), KeyboardInterrupt, ""),
    "step backwards": (stepped(swirl, dt=-H), INPUT, "not a time step: got time 0, dt -0.02"),
    "step of no length in time": (stepped(swirl, dt=np.nan), INPUT, "not a time step: got time 0, dt nan"),
    "step a little backwards": (stepped(swirl, dt=-1e-9), INPUT, "got time 0, dt -1e-09"),
    "step at no time": (stepped(swirl, time=np.nan), INPUT, "not a time step: got time nan, dt 0.02"),
    "step of a text": (stepped(swirl, dt="long"), TypeError, "incompatible function arguments"),
    "motion in no time": (stepped(dsc.curvature_flow(), dt=0), INPUT, "dt must be positive"),
    "tension of a phase with itself": (lambda mesh: dsc.curvature_flow({(1, 1): 2}), INPUT, "tension: not a pair of two phases"),
    "tension of a pair twice": (lambda mesh: dsc.curvature_flow({(1, 2): 2, (2, 1): 3}), INPUT, "a pair is named twice"),
    "tension of a list": (lambda mesh: dsc.curvature_flow([1, 2]), INPUT, "a number, a dict"),
    "mobility of a text": (lambda mesh: dsc.curvature_flow(mobility={(0, 1): "fast"}), INPUT, r"mobility\[\(0, 1\)\]: not a number"),
    "growth of one phase": (lambda mesh: dsc.growth({1: 1.0}), INPUT, "speeds: not a pair of two phases: got 1"),
    "growth that is a number": (lambda mesh: dsc.growth(1.0), INPUT, "speeds: not a dict: got 1.0"),
    "growth of a text": (lambda mesh: dsc.growth({(1, 0): "fast"}), INPUT, r"speeds\[\(1, 0\)\]: not a number"),
    "areas by pair": (lambda mesh: dsc.curvature_flow(keep_areas_of={(1, 0): 2}), INPUT,
                      "keep_areas_of: not a phase"),
    "areas that are a list": (lambda mesh: dsc.curvature_flow(keep_areas_of=[2]), INPUT, "a Mesh or a dict"),
    "fluid of one number": (fluid_of(phases={0: 1, 1: (1, 1)}), INPUT, r"phases\[0\]: not two numbers: got 1"),
    "fluids in a list": (fluid_of(phases=[(1, 1)]), INPUT, "phases: not a dict"),
    "tension of one phase": (fluid_of(tensions={1: 1}), INPUT, "tensions: not a pair of two phases"),
    "tension in three parts": (fluid_of(tensions={(0, 1): (1, 90, 2)}), INPUT, "tension, or .tension, angle"),
    "lopsided mobility": (lambda mesh: dsc.curvature_flow(mobility=[[0, 1], [2, 0]]), INPUT, "the matrix is not symmetric"),
    "mesh read in its step": (by_the_mesh_that_moves(lambda mesh: mesh.points), RuntimeError, "a step of this"),
    "mesh copied in its step": (by_the_mesh_that_moves(copy.copy), RuntimeError, "a step of this"),
    "mesh pickled in its step": (by_the_mesh_that_moves(pickle.dumps), RuntimeError, "a step of this"),
    "mesh simulated in its step": (by_the_mesh_that_moves(lambda mesh: dsc.Simulation(mesh, edge_length=H)),
                                   RuntimeError, "a step of this"),
    "two simulations of one mesh": (second_simulation, INPUT, "another Simulation"),
    "two threads step one mesh": (two_threads_step_one_mesh, RuntimeError, "a step of this"),
    "option that does not exist": (stepped(swirl, edges=H), INPUT, "unknown option: got 'edges'; allowed: edge_l"),
    "option of another type": (stepped(swirl, deviation="small"), INPUT, "deviation: bad value: got 'small'"),
    "option of no such choice": (stepped(swirl, integrator="rk5"), INPUT, "bad value: got 'rk5'; allowed: euler, "),
    "fewer threads than one": (stepped(swirl, threads=-1), INPUT, "threads: bad value: got -1"),
    "adaptive steps of what it sees": (stepped(dsc.interface_flow(lambda one, t: one.normals),
                                               integrator="adaptive"), INPUT, "integrator.*adaptive"),
    "what a flow returns of its sight": (stepped(dsc.interface_flow(lambda one, t: one.normals[1:])), INPUT,
                                         "what the flow returns"),
    "data of two kinds": (lambda mesh: (data("x", np.zeros(len(mesh.points)))(mesh),
                                        data("x", np.zeros(len(mesh.triangles)), "triangle_data")(mesh)),
                          INPUT, "x"),
    "domain that is none": (lambda mesh: dsc.initial_complex(((0, 0),), edge_length=H), INPUT, "not a domain"),
    "curves in a domain that is no rectangle": (
        lambda mesh: dsc.initial_complex([(0, 0), (2, 0), (0, 2)], curves=[([(0, 0), (1, 1)], 1, 2)], edge_length=H),
        INPUT, "curves in a domain that is no rectangle"),
    "mesh without an edge length": (lambda mesh: dsc.initial_complex(DOMAIN), INPUT, "out of range: got 0"),
    "mesh with an option of steps": (lambda mesh: dsc.initial_complex(DOMAIN, edge_length=H, gap=1), INPUT,
                                     "unknown option: got 'gap'; allowed: edge_length, "),
    "option out of range": (stepped(swirl, growth=7), INPUT, "growth: .*got 7"),
    "no simulation of a mesh": (lambda mesh: dsc.Simulation(mesh.points, edge_length=H), TypeError, "incompatible"),
    "writing to an array": (lambda mesh: mesh.points.fill(0), ValueError, "read-only"),
    "data of another length": (data("x", np.zeros(3)), INPUT, r"x: not one entry for each vertex.*allowed: numbers of"),
    "data of texts": (data("x", ["a"]), INPUT, "x: not one entry for each vertex"),
    "data that does not exist": (lambda mesh: mesh.triangle_data["x"], KeyError, "x"),
    "phase that is no number": (lambda mesh: dsc.initial_complex(DOMAIN, {"a": disc()}, edge_length=H),
                                INPUT, "not a phase"),
    "phase below 0": (lambda mesh: dsc.initial_complex(DOMAIN, {-1: disc()}, edge_length=H), INPUT, "not a phase"),
    "outline that crosses itself": (lambda mesh: dsc.initial_complex(DOMAIN, {1: disc()[[0, 20, 10, 30]]},
                                                                     edge_length=H), INPUT, "cross"),
    "outline with NaN": (lambda mesh: dsc.initial_complex(DOMAIN, {1: disc() * np.nan}, edge_length=H),
                         INPUT, "finite"),
    "outline that is masked": (lambda mesh: dsc.initial_complex(DOMAIN, {1: [masked(disc(), 3)]}, edge_length=H),
                               INPUT, r"shapes\[1\]: masked entries: got 3 of 96"),
    "points that are masked": (lambda mesh: dsc.Mesh(masked(mesh.points), mesh.triangles, mesh.phases), INPUT,
                               "points: masked entries: got 1 of"),
    "phases that are masked": (lambda mesh: dsc.Mesh(mesh.points, mesh.triangles, masked(mesh.phases)), INPUT,
                               "phases: masked entries"),
    "velocity that is masked": (stepped(lambda x, t: masked(swirl(x, t))), INPUT, "velocity returns: masked"),
    "data that are masked": (lambda mesh: data("x", masked(mesh.points))(mesh), INPUT, "x: masked entries"),
    "outline of ragged rows": (lambda mesh: dsc.area([[(0, 0), (1,), (1, 1)]]), INPUT, "outlines: not an array of"),
    "no outline": (lambda mesh: dsc.area([]), INPUT, "outlines: points of the wrong shape"),
    "outline of nothing": (lambda mesh: dsc.symmetric_difference(None, disc()), INPUT, "first: not an array"),
    "outlines of which one is none": (lambda mesh: dsc.hausdorff(disc(), [disc(), "x"]), INPUT, "second: "),
    "triangles of ragged rows": (lambda mesh: dsc.Mesh(mesh.points, [[0, 1, 2], [1]], [0, 0]), INPUT, "triangles: not"),
    "data of ragged rows": (data("x", [[0, 1], [1]]), INPUT, "x: not one entry for each vertex"),
    "velocity of ragged rows": (stepped(lambda x, t: [[0, 1], [1]]), INPUT, "what the velocity returns: not an array"),
    "option that is an array": (stepped(swirl, deviation=np.zeros(3)), INPUT, "deviation: bad value"),
    "phases that are advected and none": (stepped(swirl, advected_phases="all"), INPUT, "advected_phases: bad value"),
    "restored from other bytes": (lambda mesh: dsc.Simulation(mesh, edge_length=H)._compiled.restore(b"abc"),
                                  dsc.FileError, "simulation: unexpected end of data"),
    "mesh from other bytes": (lambda mesh: mesh.__reduce__()[0](b"abc"), dsc.FileError, "mesh: too short"),
    "outline outside": (lambda mesh: dsc.initial_complex(DOMAIN, {1: disc((2, 2))}, edge_length=H), INPUT, "outside"),
    "mesh of absurd size": (lambda mesh: dsc.initial_complex(DOMAIN, {}, edge_length=1e-9), INPUT, "edge_length|edge"),
    "curve of two parts": (lambda mesh: dsc.initial_complex(DOMAIN, curves=[(disc(), 1)], edge_length=H),
                           INPUT, "not a curve"),
    "curve of a phase that is none": (lambda mesh: dsc.initial_complex(DOMAIN, curves=[(disc(), 1, 0.5)],
                                                                       edge_length=H), INPUT, "not a phase"),
    "curve that is a number": (lambda mesh: dsc.initial_complex(DOMAIN, curves=[3], edge_length=H),
                               INPUT, "not a curve"),
    "growth in a simulation without its algorithm": (stepped(dsc.growth({(1, 0): 1})), INPUT, "growth_algorithm"),
    "size that is a number": (lambda mesh: graded(by_place=3), INPUT,
                              r"by_place: bad value: got 3; allowed: a function f\("),
    "size of a text": (lambda mesh: graded(by_place=lambda x, y, t, p: "long"), INPUT,
                       "result of a size function.*got 'long'"),
    "size that raises": (lambda mesh: graded(by_distance=lambda d: 1 / 0), ZeroDivisionError, "by zero"),
    "size of no argument": (lambda mesh: graded(by_distance=lambda: 1), TypeError, "positional argument"),
    "sizes without growth": (lambda mesh: graded(growth=0, by_distance=lambda d: 1), INPUT, "growth"),
    "circle without a radius": (lambda mesh: dsc.circle((0, 0), -1, 0.1), INPUT, ""),
    "scene with an unknown key": (lambda mesh: dsc.scenes.run("swirl", hh=0.03), ValueError,
                                  "unknown key: got 'hh'"),
    "scene that does not exist": (lambda mesh: dsc.scenes.run("swril"), ValueError, "swril"),
    "data with the name of the mesh's own": (lambda mesh: mesh.triangle_data.update(phase=mesh.qualities), INPUT,
                                             "triangle_data: a name that files use for the mesh itself: got 'phase'"),
    "series of another kind": (lambda mesh: dsc.Series("run.vtu"), INPUT, "a path that ends in .pvd"),
    "fluid that slips at no side, by name": (fluid_of(slip="front"), INPUT, "slip: not a side of the domain: got 'front'"),
    "fluid that slips at no side": (fluid_of(slip={"front"}), INPUT, "slip: not a side of the domain: got 'front'"),
    "fluid without a phase": (fluid_of(phases={0: (1, 1)}), INPUT, "phase|tension"),
    "fluid without gravity's second number": (fluid_of(gravity=(1,)), INPUT, r"gravity.*shape"),
    "picture in no folder": (lambda mesh: mesh.write_svg("/no/such/folder/a.svg"), OSError, "/no/such/folder/a.svg"),
}


class Misuse(unittest.TestCase):
    def test_each_case_ends_with_a_sentence(self):
        for name, (do, error, sentence) in CASES.items():
            with self.subTest(name):
                mesh = disc_mesh()
                with self.assertRaisesRegex(error, sentence):
                    do(mesh)
                self.assertEqual(mesh.validate(), "")
                self.assertEqual(dsc.Simulation(mesh, edge_length=H).step(swirl, 0, H).unreached, 0)

    def test_control_c_between_sub_steps_of_a_flow_of_the_library(self):
        mesh = disc_mesh()
        sim = dsc.Simulation(mesh, edge_length=H)
        timer = threading.Timer(0.05, signal.raise_signal, (signal.SIGINT,))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                sim.step(dsc.swirl(period=2), sim.time, 2)
        timer.join()
        self.assertEqual(mesh.validate(), "")
        self.assertGreater(sim.report.sub_steps, 0)

    def test_arrays_outlive_what_they_are_of(self):
        mesh = disc_mesh()
        sim = dsc.Simulation(mesh, edge_length=H)
        points, curve = mesh.points, mesh.interface_curves()[0]
        sums = points.sum(), curve.points.sum()
        seen = []
        sim.step(dsc.interface_flow(lambda one, t: seen.append(one) or 0 * one.normals), 0, H)
        positions = seen[0].positions.copy()
        del sim, mesh
        disc_mesh()  # takes the memory
        self.assertEqual((points.sum(), curve.points.sum()), sums)
        self.assertTrue(np.array_equal(seen[0].positions, positions))

    def test_options_are_known_by_their_names_of_the_first_release(self):
        with self.assertWarnsRegex(FutureWarning, "'corner_degrees' is now called 'feature_degrees'"):
            self.assertEqual(dsc.Simulation(disc_mesh(), edge_length=H, corner_degrees=20).options["feature_degrees"], 20)
        with self.assertWarnsRegex(FutureWarning, "'least_pixels' is now called 'min_pixels'"):
            labels = np.zeros((20, 20), int)
            labels[3, 3] = labels[8:14, 8:14] = 1
            self.assertEqual(dsc.from_labels(labels, least_pixels=4, edge_length=1).input_report.dropped, 1)

    def test_a_simulation_keeps_its_mesh(self):
        sim = dsc.Simulation(disc_mesh(), edge_length=H)
        self.assertEqual(sim.step(swirl, 0, H).unreached, 0)
        flow = dsc.curvature_flow(keep_areas_of=disc_mesh())
        self.assertEqual(sim.step(flow, 0, H * H).unreached, 0)


if __name__ == "__main__":
    unittest.main()

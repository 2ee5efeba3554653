# SPDX-License-Identifier: MIT
"""Mistakes with meshes in space: each raises an error with a sentence, and leaves a valid mesh."""
import gc
import pickle
import signal
import unittest

import dsc
import numpy as np
from meshes import BOX, ball_mesh, turn

H = 0.1


def stepped(flow, time=0.0, dt=H, **options):
    return lambda mesh: dsc.Simulation(mesh, edge_length=H, **options).step(flow, time, dt)


def raising(*_):
    raise LookupError("no velocity today")


def interrupted(*_):
    signal.raise_signal(signal.SIGINT)
    return np.zeros((1, 3))


def by_the_mesh_that_moves(use):
    return lambda mesh: stepped(lambda x, t: use(mesh) and x)(mesh)


def step_in_a_step(mesh):
    sim = dsc.Simulation(mesh, edge_length=H)
    sim.step(lambda x, t: sim.step(turn, 0, H) and x, 0, H)


def second_simulation(mesh):
    sims = [dsc.Simulation(mesh, edge_length=H)]
    sims.append(dsc.Simulation(mesh, edge_length=H))


def made(shapes, domain=((0, 0, 0), (1, 1, 1)), **options):
    return lambda mesh: dsc.initial_complex(domain, shapes, **({"edge_length": H} | options))


BALL = dsc.ball((0.5, 0.5, 0.5), 0.25)
INPUT = dsc.InputError
# (action on a mesh, error type, pattern of the message)
CASES = {
    "velocity of the plane": (stepped(lambda x, t: x[:, :2]), INPUT, r"got an array of the shape \(\d+, 2\); allowed: numbers of the shape \(\d+, 3\)"),
    "velocity of too few rows": (stepped(lambda x, t: x[1:]), INPUT, r"got an array of the shape \(\d+, 3\)"),
    "velocity without return": (stepped(lambda x, t: None), INPUT, "what the velocity returns.*got None"),
    "velocity of one argument": (stepped(lambda x: x), TypeError, "positional argument"),
    "velocity that raises": (stepped(raising), LookupError, "no velocity today"),
    "velocity that raises in threads": (stepped(raising, threads=2), LookupError, "no velocity today"),
    "velocity that is a number": (stepped(3.0), INPUT, r"not a flow: got 3.0; allowed: a function of positions \(n, 3\)"),
    "flow of the plane": (stepped(dsc.swirl()), INPUT, r"not a flow: .*a function of positions \(n, 3\)"),
    "simulation for a flow of the plane": (lambda mesh: dsc.Simulation(mesh, dsc.growth({(1, 0): 1}), edge_length=H),
                                           INPUT, "Simulation of a Mesh3: a flow that needs"),
    "Ctrl-C in a velocity": (stepped(interrupted), KeyboardInterrupt, ""),
    "Ctrl-C in threads": (stepped(interrupted, threads=2), KeyboardInterrupt, ""),
    "mesh read in its step": (by_the_mesh_that_moves(lambda mesh: mesh.points), RuntimeError, "a step of this"),
    "mesh pickled in its step": (by_the_mesh_that_moves(pickle.dumps), RuntimeError, "a step of this"),
    "mesh simulated in its step": (by_the_mesh_that_moves(lambda mesh: dsc.Simulation(mesh, edge_length=H)),
                                   RuntimeError, "a step of this"),
    "step in a step": (step_in_a_step, RuntimeError, "a step of this"),
    "two simulations of one mesh": (second_simulation, INPUT, "another Simulation"),
    "option of the plane": (stepped(turn, topology="change"), INPUT,
                            "Simulation of a Mesh3: unknown option: got 'topology'; allowed: edge_length, longest, "),
    "option out of range": (stepped(turn, layers=70), INPUT, "layers: .*got 70"),
    "option of no such choice": (stepped(turn, integrator="rk5"), INPUT, "bad value: got 'rk5'; allowed: euler, "),
    "threads of none": (stepped(turn, threads=0), INPUT, "bad number of threads: got 0"),
    "submeshes of three": (stepped(turn, submeshes=3), INPUT, "bad number of submeshes: got 3"),
    "shape that is none": (made({1: 3}), INPUT, r"shapes\[0\]: not a shape: got 3; allowed: a dsc.Shape3"),
    "shape of the plane": (made({1: [(0, 0), (1, 0), (0, 1)]}), INPUT, "not a shape"),
    "shapes that are none": (made(3), INPUT, "shapes: not shapes: got 3"),
    "shape alone": (made(BALL), INPUT, "shapes: not shapes"),
    "phase that is no number": (made([(BALL, "a")]), INPUT, r"shapes\[0\]: not a phase"),
    "shape that divides no phase": (made([(BALL, 1), (BALL, {7: 8})]), INPUT, "divides"),
    "function of several distances": (made({1: lambda x: [1, 2]}), INPUT, "not a signed distance for each point"),
    "function of a text": (made({1: lambda x: "far"}), INPUT, "what the shape returns: .*got 'far'"),
    "function that raises": (made({1: raising}), LookupError, "no velocity today"),
    "ball of a point": (lambda mesh: dsc.ball((0.5, 0.5), 1), INPUT, r"centre: .*allowed: numbers of the shape \(1, 3\)"),
    "ball of a text": (lambda mesh: dsc.ball((0, 0, 0), "a"), INPUT, "radius: not a length: got 'a'"),
    "ball of no radius": (lambda mesh: dsc.ball((0, 0, 0), np.nan), INPUT, "radius: not a length: got nan"),
    "ellipsoid that is flat": (lambda mesh: dsc.ellipsoid((0, 0, 0), (1, 1, 0)), INPUT, "radii: not a length"),
    "box inside out": (lambda mesh: dsc.box((1, 0, 0), (0, 1, 1)), INPUT, "high beyond low in each coordinate"),
    "domain that is flat": (made({1: BALL}, ((0, 0, 1), (1, 1, 1))), INPUT, "domain: no domain for a shape in space"),
    "domain of the plane": (made({1: [BALL]}, ((0, 0), (1, 1))), INPUT, "domain: no domain for a shape in space"),
    "surface in no file": (lambda mesh: dsc.closed_surface("nowhere.stl"), dsc.FileError, "nowhere.stl: cannot be read"),
    "areas of volumes": (lambda mesh: dsc.curvature_flow(keep_areas_of=mesh), INPUT, "curvature_flow: a mesh in space"),
    "torus without an axis": (lambda mesh: dsc.torus((0, 0, 0), (0, 0, 0), 1, 0.5), INPUT, "axis"),
    "surface that is open": (lambda mesh: dsc.closed_surface([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]), INPUT,
                             "surface, at .*: the surface is not closed"),
    "surface of other indices": (lambda mesh: dsc.closed_surface([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 7)]), INPUT, "7"),
    "surface without triangles": (lambda mesh: dsc.closed_surface([(0, 0, 0)]), INPUT, "no triangles"),
    "surface of four corners": (lambda mesh: dsc.closed_surface(np.eye(4, 3), [(0, 1, 2, 3)]), INPUT, "not triangles"),
    "mesh without an edge length": (made({1: BALL}, edge_length=0), INPUT, "edge_length"),
    "mesh of absurd size": (made({1: BALL}, edge_length=1e-5), INPUT, "tets|edge"),
    "mesh with an option of the plane": (made({1: BALL}, detail="thin"), INPUT,
                                         "unknown option: got 'detail'; allowed: edge_length, growth, "),
    "curves in space": (lambda mesh: dsc.initial_complex(BOX, curves=[], edge_length=H), INPUT, "curves"),
    "domain inside out": (made({1: BALL}, ((1, 1, 1), (0, 0, 0))), INPUT, "domain|side"),
    "tetrahedra of three corners": (lambda mesh: dsc.Mesh3(mesh.points, mesh.tetrahedra[:, :3], mesh.phases), INPUT,
                                    "Mesh3: arrays whose shapes do not match"),
    "tetrahedra out of range": (lambda mesh: dsc.Mesh3(mesh.points, mesh.tetrahedra + 1, mesh.phases), INPUT, ""),
    "points of the plane": (lambda mesh: dsc.Mesh3(mesh.points[:, :2], mesh.tetrahedra, mesh.phases), INPUT,
                            r"points: .*allowed: numbers of the shape \(n, 3\)"),
    "writing to an array": (lambda mesh: mesh.tetrahedra.fill(0), ValueError, "read-only"),
    "a name of the mesh's own": (lambda mesh: mesh.tet_data.update(phase=mesh.qualities), INPUT, "tet_data: a name"),
    "fluid in space": (lambda mesh: dsc.Fluid(dsc.Simulation(mesh, edge_length=H), {0: (1, 1), 1: (1, 1)}, {(0, 1): 1}),
                       INPUT, "Fluid: a mesh in space"),
    "animation in space": (lambda mesh: dsc.animate(dsc.Simulation(mesh, edge_length=H), turn, H, 2), INPUT,
                           "animate: a mesh in space"),
    "file in no folder": (lambda mesh: mesh.write_ply("/no/such/folder/a.ply"), OSError, "/no/such/folder/a.ply"),
    "restored from other bytes": (lambda mesh: dsc.Simulation(mesh, edge_length=H)._compiled.restore(b"abc"),
                                  dsc.FileError, "simulation: unexpected end of data"),
    "picture of other values": (lambda mesh: dsc.plot(mesh, values=mesh.qualities), INPUT, "one value for each vertex"),
    "grains in space": (lambda mesh: dsc.grains(mesh), INPUT, "grains: a mesh in space"),
}


class Misuse(unittest.TestCase):
    def test_each_case_ends_with_a_sentence(self):
        for name, (do, error, sentence) in CASES.items():
            with self.subTest(name):
                mesh = ball_mesh()
                with self.assertRaisesRegex(error, sentence):
                    do(mesh)
                gc.collect()
                self.assertEqual(mesh.validate(), "")
                self.assertEqual(dsc.Simulation(mesh, edge_length=H).step(turn, 0, H).unreached, 0)


if __name__ == "__main__":
    unittest.main()

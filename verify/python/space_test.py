# SPDX-License-Identifier: MIT
"""Meshes in space: the same words as in the plane, the same bits as in C++, and refusals."""
import copy
import gc
import importlib.util
import math
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import dsc
import numpy as np
from meshes import BOX, ball_mesh

H = 0.1
EXAMPLES = pathlib.Path(__file__).parents[2] / "lib" / "scenes" / "examples"


def turn(x, t):
    """About an axis through the centre of the box."""
    return np.c_[0.5 - x[:, 1], x[:, 0] - 0.5, 0 * t * x[:, 2]]


def started(steps=3, **options):
    sim = dsc.Simulation(ball_mesh(), edge_length=H, **options)
    dsc.run(sim, turn, H, steps)
    return sim


def across_faces(mesh):
    """The faces of all tets by their sorted corners, with the tets beside each: one or two."""
    beside = {}
    for t, tet in enumerate(np.sort(mesh.tetrahedra, axis=1).tolist()):
        for left_out in range(4):
            beside.setdefault(tuple(tet[:left_out] + tet[left_out + 1:]), []).append(t)
    return beside


class Bits(unittest.TestCase):
    def test_a_scene_is_the_same_as_in_c(self):
        def flow(x, t):  # that of the file, in the same order
            return np.c_[-1.5 * x[:, 1], 1.5 * x[:, 0], 0.9 * x[:, 0] * t]

        text = (EXAMPLES / "ring.toml").read_text(encoding="utf-8")
        text = text.replace(" * cos(pi*t/period)", "").replace("0.3 * x", "0.9 * x * t")
        shapes = [(dsc.torus((0.1, 0, 0), (0, 1, 1), 0.4, 0.15), 1), (dsc.ball((-0.45, -0.45, -0.6), 0.2), 2)]
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "ring.toml"
            file.write_text(text, encoding="utf-8")
            for threads in (None, 1, 2):
                mesh = dsc.initial_complex(((-1, -1, -1), (1, 1, 1)), shapes, edge_length=0.1)
                sim = dsc.Simulation(mesh, edge_length=0.1, threads=threads)
                reports = [sim.step(flow, k * 0.05, 0.05) for k in range(20)]
                other = dsc.scenes.run(file, threads=threads)
                self.assertEqual(f"{mesh.mesh_hash:016x}", other["mesh_hash"])
                self.assertEqual(len(mesh.phases), other["tets_last"])
                done = {name: sum(one.operations[name] for one in reports) for name in other["operations"]}
                self.assertEqual(done, other["operations"])
                self.assertGreater(done["interface_splits"], 0)

    def test_a_velocity_is_called_once_a_stage_by_the_thread_that_steps(self):
        calls = []

        def noted(x, t):
            calls.append((len(x), threading.get_ident()))
            return turn(x, t)

        sim = dsc.Simulation(ball_mesh(), edge_length=H, threads=2)
        report = sim.step(noted, 0, H)
        self.assertEqual(calls, [(report.interface_vertices, threading.get_ident())] * (4 * report.sub_steps))


class Shapes(unittest.TestCase):
    def test_each_has_its_volume(self):
        h = 0.05
        points = np.array([(x, y, z) for x in (0.3, 0.7) for y in (0.3, 0.7) for z in (0.3, 0.7)])
        quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        cube = [one for a, b, c, d in quads for one in ((a, b, c), (a, c, d))]
        centre = np.full(3, 0.5)
        for shape, volume, inside in (
                (dsc.ball(centre, 0.3), 4 / 3 * np.pi * 0.3**3, (0, 0, 0.29)),
                (dsc.ellipsoid(centre, (0.3, 0.2, 0.2)), 4 / 3 * np.pi * 0.3 * 0.2**2, (0.29, 0, 0)),
                (dsc.torus(centre, (0, 0, 1), 0.25, 0.12), 2 * np.pi**2 * 0.25 * 0.12**2, (0.25, 0, 0.11)),
                (dsc.box((0.3, 0.3, 0.3), (0.7, 0.7, 0.7)), 0.4**3, (0.19, 0.19, 0.19)),
                (dsc.closed_surface(points, cube), 0.4**3, (0.19, 0.19, 0.19))):
            with self.subTest(repr(shape)):
                mesh = dsc.initial_complex(BOX, {1: shape}, edge_length=h)
                self.assertEqual(mesh.validate(), "")
                self.assertAlmostEqual(mesh.volumes[1] / volume, 1, delta=0.04)
                self.assertTrue(np.all(shape([centre + inside, (0, 0, 0)]) * (-1, 1) > 0))
                again = dsc.initial_complex(BOX, {1: pickle.loads(pickle.dumps(shape))}, edge_length=h)
                self.assertEqual(again.mesh_hash, mesh.mesh_hash)

    def test_a_function_of_arrays_is_a_shape(self):
        function = dsc.initial_complex(BOX, {1: lambda x: np.linalg.norm(x - (0.5, 0.5, 0.6), axis=1) - 0.25},
                                       edge_length=H)
        self.assertEqual(function.mesh_hash, ball_mesh().mesh_hash)

    def test_a_surface_is_read_from_a_file_with_a_point_for_each_corner(self):
        import meshio
        mesh = ball_mesh()
        faces = mesh.interface_faces().triangles
        made = dsc.initial_complex(BOX, {1: dsc.closed_surface(mesh.points, faces)}, edge_length=H)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("ball.stl", "ball.ply", "ball.obj"):
                path = pathlib.Path(folder) / name
                meshio.Mesh(mesh.points[faces].reshape(-1, 3),
                            [("triangle", np.arange(faces.size).reshape(-1, 3))]).write(path)
                read = dsc.initial_complex(BOX, {1: dsc.closed_surface(path)}, edge_length=H)
                self.assertAlmostEqual(read.volumes[1], made.volumes[1], delta=1e-3)

    def test_later_shapes_count_and_may_divide_phases(self):
        one, other = dsc.ball((0.5, 0.5, 0.5), 0.35), dsc.ball((0.5, 0.5, 0.5), 0.17)
        mesh = dsc.initial_complex(BOX, [(one, 1), (other, 4)], edge_length=0.06)
        self.assertEqual(list(mesh.volumes), [0, 1, 4])
        self.assertAlmostEqual(mesh.volumes[4], 4 / 3 * np.pi * 0.17**3, delta=2e-3)

        def half(x):
            return x[:, 0] - 0.5

        mesh = dsc.initial_complex(BOX, [(one, 1), (half, {1: 2})], edge_length=0.06)
        self.assertEqual(mesh.validate(), "")
        self.assertAlmostEqual(mesh.volumes[1] / mesh.volumes[2], 1, delta=0.02)
        faces = mesh.interface_faces()
        pairs = set(zip(faces.outside.tolist(), faces.inside.tolist()))
        self.assertEqual(pairs, {(0, 1), (0, 2), (1, 2)})

    def test_a_dict_may_have_several_shapes_of_a_phase(self):
        balls = [dsc.ball((x, 0.5, 0.5), 0.15) for x in (0.25, 0.75)]
        by_dict = dsc.initial_complex(BOX, {1: balls}, edge_length=H)
        by_list = dsc.initial_complex(BOX, [(ball, 1) for ball in balls], edge_length=H)
        self.assertEqual(by_dict.mesh_hash, by_list.mesh_hash)


class Arrays(unittest.TestCase):
    def test_they_are_dense_and_stay_as_they_were(self):
        mesh = ball_mesh()
        points, tets, phases = mesh.points, mesh.tetrahedra, mesh.phases
        self.assertIs(mesh.points, points)
        self.assertEqual((points.shape[1], tets.shape[1]), (3, 4))
        self.assertEqual((points.dtype, tets.dtype, phases.dtype), (np.float64, np.int32, np.uint32))
        self.assertEqual((tets.min(), tets.max()), (0, len(points) - 1))
        self.assertEqual(len(phases), len(tets))
        for array in (points, tets, phases):
            self.assertTrue(array.flags.c_contiguous)
            with self.assertRaises(ValueError):
                array[0] = 0
        before = points.copy()
        sim = dsc.Simulation(mesh, edge_length=H)
        revision = mesh.revision
        sim.step(turn, 0, H)
        self.assertGreater(mesh.revision, revision)
        self.assertTrue(np.array_equal(points, before))
        self.assertFalse(mesh.points.shape == before.shape and np.array_equal(mesh.points, before))

    def test_measures_are_those_of_the_tets(self):
        mesh = started().mesh
        corners = mesh.points[mesh.tetrahedra]
        volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
        self.assertGreater(volumes.min(), 0)
        self.assertAlmostEqual(sum(mesh.volumes.values()), 1, places=12)
        for phase, volume in mesh.volumes.items():
            self.assertAlmostEqual(volumes[mesh.phases == phase].sum(), volume, places=12)
        self.assertGreater(mesh.qualities.min(), 0)
        self.assertLessEqual(mesh.qualities.max(), 1 + 1e-12)
        smallest = np.full(len(corners), 180.0)
        for i in range(4):  # angles between faces: 180 degrees less that of their outer normals
            for j in range(i):
                normals = []
                for one in (i, j):
                    a, b, c = np.delete(corners, one, axis=1).transpose(1, 0, 2)
                    normal = np.cross(b - a, c - a)
                    normals.append(normal * np.sign(np.sum(normal * (corners[:, one] - a), axis=1))[:, None])
                cosine = np.sum(normals[0] * normals[1], axis=1) / np.prod(np.linalg.norm(normals, axis=2), axis=0)
                smallest = np.minimum(smallest, 180 - np.degrees(np.arccos(cosine)))
        self.assertLess(np.abs(smallest - mesh.min_dihedrals).max(), 1e-4)

    def test_the_interface_is_the_faces_between_two_phases(self):
        mesh = started().mesh
        faces = mesh.interface_faces()
        wanted = {face: tets for face, tets in across_faces(mesh).items()
                  if len(tets) == 2 and mesh.phases[tets[0]] != mesh.phases[tets[1]]}
        found = {tuple(face): pair for face, pair in zip(np.sort(faces.triangles, axis=1).tolist(),
                                                         zip(faces.outside.tolist(), faces.inside.tolist()))}
        self.assertEqual(found, {face: tuple(sorted(mesh.phases[tets].tolist())) for face, tets in wanted.items()})
        a, b, c = mesh.points[faces.triangles].transpose(1, 0, 2)
        enclosed = np.sum(np.cross(a, b) * c) / 6  # by the divergence theorem: the faces look outwards
        self.assertAlmostEqual(enclosed, mesh.volumes[1], places=12)

    def test_a_mesh_is_made_of_its_arrays(self):
        mesh = started().mesh
        given = mesh.points, mesh.tetrahedra, mesh.phases
        self.assertEqual(dsc.Mesh3(*given).mesh_hash, mesh.mesh_hash)
        swapped = mesh.tetrahedra[:, [1, 0, 2, 3]]
        self.assertEqual(dsc.Mesh3(mesh.points, swapped, mesh.phases).mesh_hash, mesh.mesh_hash)
        io = mesh.to_meshio()
        io.cells.append(type(io.cells[0])("triangle", mesh.interface_faces().triangles))
        for values in io.cell_data.values():
            values.append(np.zeros(len(io.cells[1].data)))
        self.assertEqual(dsc.from_meshio(io).mesh_hash, mesh.mesh_hash)  # without the triangles


class Data(unittest.TestCase):
    def test_it_follows_the_mesh(self):
        mesh = ball_mesh()
        mesh.vertex_data["x"] = mesh.points[:, 0]
        mesh.vertex_data["place"] = mesh.points
        mesh.tet_data["material"] = mesh.phases
        sim = dsc.Simulation(mesh, edge_length=H)
        sim.step(lambda x, t: 0 * x + (0.5, 0, 0), 0, H)
        self.assertEqual((set(mesh.vertex_data), set(mesh.tet_data)), ({"x", "place"}, {"material"}))
        self.assertTrue(np.array_equal(mesh.tet_data["material"], mesh.phases))
        self.assertTrue(np.array_equal(mesh.vertex_data["place"][:, 0], mesh.vertex_data["x"]))
        self.assertLess(np.abs(mesh.vertex_data["x"] - mesh.points[:, 0]).max(), H)
        with self.assertRaisesRegex(dsc.InputError, r"allowed: numbers of the shape \(\d+,\) or \(\d+, 3\)"):
            mesh.vertex_data["y"] = mesh.points[:, :2]
        del mesh.vertex_data["x"]
        self.assertEqual(list(mesh.vertex_data), ["place"])


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
        mesh = ball_mesh()
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            mesh.write_vtu(folder / "mesh.vtu")
            self.assertEqual(dsc.from_meshio(meshio.read(folder / "mesh.vtu")).mesh_hash, mesh.mesh_hash)
            count = len(mesh.interface_faces().triangles)
            for write, name in ((mesh.write_interface_vtu, "a.vtu"), (mesh.write_ply, "a.ply"), (mesh.write_stl, "a.stl")):
                write(folder / name)
                [block] = meshio.read(folder / name).cells
                self.assertEqual(len(block.data), count, name)
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
        self.assertLess(sim.time, 1)


def turn_back(points, angle):
    x, y = (points[:, :2] - 0.5).T
    c, s = math.cos(angle), math.sin(angle)
    return np.c_[0.5 + c * x + s * y, 0.5 + c * y - s * x, points[:, 2]]


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
    "ball that reaches the sides": (made({1: dsc.ball((0.5, 0.5, 0.5), 0.6)}), INPUT, "sides of the domain|domain"),
    "ball of a point": (lambda mesh: dsc.ball((0.5, 0.5), 1), INPUT, r"centre: .*allowed: numbers of the shape \(1, 3\)"),
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


class Drawn(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("vtkmodules"), "Debian: python3-vtk9")
    @unittest.skipIf(importlib.util.find_spec("pyvista"), "pyvista draws instead")
    def test_vtk_draws_the_faces_of_the_interface(self):
        mesh = ball_mesh()
        for values in (None, mesh.points[:, 2]):
            [actor] = dsc.plot(mesh, values=values).GetActors()
            surface = actor.GetMapper().GetInput()
            self.assertEqual(surface.GetNumberOfPolys(), len(mesh.interface_faces().triangles))
            self.assertEqual(surface.GetPointData().GetScalars() is None, values is None)
        low, high = np.reshape(surface.GetBounds(), (3, 2)).T
        self.assertLess(np.abs([low - (0.25, 0.25, 0.35), high - (0.75, 0.75, 0.85)]).max(), 0.02)

    @unittest.skipUnless(importlib.util.find_spec("pyvista"), "pip install pyvista")
    def test_pyvista_draws_the_faces_of_the_interface(self):
        mesh = ball_mesh()
        plotter = dsc.plot(mesh)
        self.assertEqual(plotter.mesh.n_cells, len(mesh.interface_faces().triangles))
        dsc.plot(mesh, plotter, values=mesh.points[:, 2], opacity=0.5)
        self.assertEqual(len(plotter.actors), 3)  # with the colour bar

    def test_without_both_it_says_what_to_install(self):
        program = ("import sys; sys.modules['pyvista'] = sys.modules['vtkmodules'] = None; import dsc; "
                   "from meshes import ball_mesh; dsc.plot(ball_mesh())")
        done = subprocess.run([sys.executable, "-c", program], check=False, text=True, capture_output=True)
        self.assertRegex(done.stderr.splitlines()[-1], "^ImportError: .*pyvista or vtk.*pip install pyvista")

    def test_its_name_is_short(self):
        mesh = ball_mesh()
        self.assertRegex(repr(mesh), r"^<dsc.Mesh3: \d+ tets, \d+ vertices, phases 0, 1>$")
        self.assertRegex(repr(dsc.Simulation(mesh, edge_length=H)), r"^<dsc.Simulation: \d+ interface vertices, time 0>$")


if __name__ == "__main__":
    unittest.main()

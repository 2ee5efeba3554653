# SPDX-License-Identifier: MIT
"""Meshes in space: the same bits as in C++, shapes, arrays, data and pictures."""
import importlib.util
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock

import dsc
import numpy as np
from meshes import BOX, ball_mesh, started, turn

H = 0.1
EXAMPLES = pathlib.Path(__file__).parents[2] / "lib" / "scenes" / "examples"


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

    def test_pyvista_is_given_the_faces_of_the_interface(self):
        class Plotter:  # stands for pyvista, which is not packaged everywhere
            def __init__(self):
                self.given = []

            def add_mesh(self, surface, **style):
                self.given.append((surface, style))

        module = types.SimpleNamespace(PolyData=lambda points, faces: (points, faces), Plotter=Plotter)
        mesh = ball_mesh()
        with unittest.mock.patch.dict(sys.modules, pyvista=module):
            plotter = dsc.plot(mesh)
            self.assertIs(dsc.plot(mesh, plotter, values=mesh.points[:, 2], opacity=0.5), plotter)
        (surface, style), (_, valued) = plotter.given
        points, faces = surface
        rows = faces.reshape(-1, 4)
        wanted = mesh.points[mesh.interface_faces().triangles]
        self.assertEqual(set(rows[:, 0].tolist()), {3})
        self.assertTrue(np.array_equal(points[rows[:, 1:]], wanted))
        self.assertEqual((style["rgb"], style["scalars"].shape), (True, wanted.shape[:2]))
        self.assertEqual((valued["rgb"], valued["opacity"]), (False, 0.5))
        self.assertTrue(np.array_equal(valued["scalars"], points[:, 2]))

    def test_without_both_it_says_what_to_install(self):
        program = ("import sys; sys.modules['pyvista'] = sys.modules['vtkmodules'] = None; import dsc; "
                   "from meshes import ball_mesh; dsc.plot(ball_mesh())")
        done = subprocess.run([sys.executable, "-c", program], check=False, text=True, capture_output=True)
        self.assertRegex(done.stderr.splitlines()[-1], "^ImportError: .*pyvista or vtk.*pip install pyvista")

    def test_its_name_is_short(self):
        mesh = ball_mesh()
        self.assertRegex(repr(mesh), r"^<dsc.Mesh3: \d+ tets, \d+ vertices, phases 0, 1>$")
        sim = dsc.Simulation(mesh, edge_length=H)
        self.assertRegex(repr(sim), r"^<dsc.Simulation: \d+ interface vertices, time 0>$")
        reports = dsc.run(sim, lambda x, t: 0 * x + (0.1, 0, 0), 0.01, 2)
        self.assertRegex(repr(reports), r"^\[(<dsc.Report3: time 0.0\d, \d+ interface vertices, 0 unreached>(, )?){2}\]$")


if __name__ == "__main__":
    unittest.main()

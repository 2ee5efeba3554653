# SPDX-License-Identifier: MIT
"""The Python module: common uses, and refusals."""
import copy
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import venv
from xml.etree import ElementTree

import dsc
import numpy as np
from meshes import H, disc, disc_mesh, l_shape, swirl


class Steps(unittest.TestCase):
    def test_curvature_flow_keeps_areas(self):
        square = [(0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7)]
        mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: square}, edge_length=H)
        sim = dsc.Simulation(mesh, edge_length=H, feature_degrees=180)
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
        self.assertEqual(list(mesh.vertex_data), [])  # the library's own data are not listed
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


class AnotherDomain(unittest.TestCase):
    def test_interfaces_move_in_an_l_shape(self):
        def three(centres):
            return 1 + (centres[:, 0] > 0.3) + (centres[:, 1] > 0.3)

        growth = dsc.growth({(2, 1): 1})
        for flow, made_for in ((dsc.curvature_flow(), None), (growth, growth),
                               (lambda x, t: np.c_[x[:, 1] - 0.2, 0.3 - x[:, 0]], None)):
            mesh = l_shape(phase=three)
            sim = dsc.Simulation(mesh, made_for, edge_length=0.05, topology="change")
            before = mesh.areas
            for report in dsc.run(sim, flow, 0.004, 20):
                self.assertEqual(report.unreached, 0)
            self.assertGreater(max(abs(area - before[phase]) for phase, area in mesh.areas.items()), 1e-3)
            self.assertEqual(mesh.validate(), "")
            self.assertAlmostEqual(sum(mesh.areas.values()), 0.75, places=12)


class PolygonDomain(unittest.TestCase):
    RING = [disc(points=100, centre=(0, 0), radius=1), disc(points=50, centre=(0, 0), radius=0.4)]

    def test_rings_make_a_domain_that_clips_shapes(self):
        mesh = dsc.initial_complex(self.RING, {1: disc(points=60, centre=(0.7, 0), radius=0.6)}, edge_length=0.05)
        self.assertEqual(mesh.validate(), "")
        self.assertAlmostEqual(sum(mesh.areas.values()), np.pi * 0.84, delta=6e-3)
        self.assertGreater(mesh.qualities.min(), 0.2)
        one = {"type": "Polygon", "coordinates": [ring.tolist() for ring in self.RING]}
        self.assertEqual(dsc.initial_complex(one, edge_length=0.05).mesh_hash,
                         dsc.initial_complex(self.RING, edge_length=0.05).mesh_hash)

    def test_a_fluid_rests_between_its_walls(self):
        for slip in ((), ("other",)):
            mesh = dsc.initial_complex(self.RING, edge_length=0.1)
            sim = dsc.Simulation(mesh, edge_length=0.1)
            fluid = dsc.Fluid(sim, {0: (1, 1)}, {}, gravity=(0.3, -1), slip=slip)
            fluid.step(0.1)
            self.assertLess(np.abs(fluid.velocities).max(), 1e-12)


class Installed(unittest.TestCase):
    def test_the_version_is_that_of_the_project(self):
        project = pathlib.Path(__file__).parents[2] / "CMakeLists.txt"
        self.assertIn(f"project(dsc VERSION {dsc.__version__}", project.read_text(encoding="utf-8"))

    def test_without_its_compiled_part_it_says_how_to_build_it(self):
        with tempfile.TemporaryDirectory() as folder:
            package = shutil.copytree(pathlib.Path(dsc.__file__).parent, pathlib.Path(folder) / "dsc",
                                      ignore=shutil.ignore_patterns("_dsc*", "__pycache__"))
            for found in ("none", "_dsc.cpython-27.so"):
                if found != "none":
                    (package / found).touch()
                done = subprocess.run([sys.executable, "-c", "import dsc"], check=False, text=True,
                                      capture_output=True, env={**os.environ, "PYTHONPATH": folder})
                last = done.stderr.splitlines()[-1]
                self.assertRegex(last, rf"^ImportError: .*: got {found}; build it by `cmake .*--target dsc_python`")

    @unittest.skipUnless(importlib.util.find_spec("ensurepip"), "Debian: python3-venv")
    def test_pip_installs_a_wheel_without_a_network(self):
        build = pathlib.Path(dsc.__file__).parents[3]  # reuses this build: compiling takes minutes
        root = pathlib.Path(__file__).parents[2]
        alone = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
        with tempfile.TemporaryDirectory() as folder:
            venv.create(folder, system_site_packages=True, with_pip=True)
            python = pathlib.Path(folder) / "bin/python"
            for command in ((python, "-m", "pip", "install", "--no-index", f"--config-settings=build-dir={build}", root),
                            (python, root / "verify/python/readme.py"),
                            (python, "-c", "import dsc; print(dsc.__version__, dsc.__file__)"),
                            (python, "-m", "pip", "uninstall", "--yes", "dsc")):
                done = subprocess.run(command, check=False, text=True, capture_output=True, env=alone, cwd=folder)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                if "-c" in command:
                    self.assertIn(folder, done.stdout)
            self.assertEqual(list(pathlib.Path(folder).glob("lib/*/site-packages/dsc*")), [])


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
        doubled = np.linalg.det(np.stack((b - a, c - a), axis=1))
        self.assertGreater(doubled.min(), 0)
        for phase, area in mesh.areas.items():
            self.assertAlmostEqual(doubled[mesh.phases == phase].sum() / 2, area, places=12)

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
        mesh.triangle_data["material"] = mesh.phases
        shift = 0.05
        sim = dsc.Simulation(mesh, edge_length=H)
        report = sim.step(lambda x, t: 0 * x + (shift / H, 0), 0, H)
        self.assertEqual(report.unreached, 0)
        self.assertEqual(set(mesh.vertex_data), {"x", "place"})
        self.assertEqual(len(mesh.triangle_data["material"]), len(mesh.triangles))
        self.assertLess(np.abs(mesh.vertex_data["x"] - mesh.points[:, 0]).max(), 2 * shift)
        self.assertTrue(np.array_equal(mesh.vertex_data["place"][:, 0], mesh.vertex_data["x"]))
        del mesh.vertex_data["x"]
        self.assertEqual(list(mesh.vertex_data), ["place"])
        with self.assertRaises(KeyError):
            mesh.vertex_data["x"]


class Scenes(unittest.TestCase):
    def test_a_result_is_a_dictionary(self):
        self.assertIn("swirl", dsc.scenes.names())
        results = [dsc.scenes.run("swirl", h=0.03, steps=2, threads=threads) for threads in (1, 2)]
        self.assertTrue(results[0]["holds"])
        self.assertEqual(results[0]["mesh_hash"], results[1]["mesh_hash"])
        self.assertEqual(results[0]["parameters"]["h"], 0.03)


class Threads(unittest.TestCase):
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

    def test_neighbours_have_different_colours(self):
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib.figure import Figure
        empty = dsc.initial_complex(((0, 0), (1, 1)), edge_length=H)
        x, y = empty.points[empty.triangles].mean(axis=1).T
        squares = 1 + (8 * x).astype(int) + 8 * (8 * y).astype(int)  # one row up is plus 8
        mesh = dsc.Mesh(empty.points, empty.triangles, 7 * squares)  # taken cyclically, all colours would be equal
        drawn = dsc.plot(mesh, Figure().add_subplot(), interface=False).collections[0].get_array()
        colours = {int(phase): set(drawn[mesh.phases == phase].tolist()) for phase in np.unique(mesh.phases)}
        self.assertEqual({len(one) for one in colours.values()}, {1})
        for phase, colour in colours.items():
            beside = [phase + 7] * (phase // 7 % 8 != 0) + [phase + 56]
            for other in beside:
                self.assertNotEqual(colour, colours.get(other), (phase, other))

    def test_a_notebook_shows_it_and_its_name_is_short(self):
        empty = dsc.initial_complex(((0, 0), (1, 1)), edge_length=0.1)
        mesh = dsc.Mesh(empty.points, empty.triangles, np.arange(len(empty.triangles)))
        self.assertLess(len(repr(mesh)), 120)
        self.assertRegex(repr(mesh), r"vertices, \d+ phases 0, 1, 2, 3, 4, 5, …, \d+>$")
        self.assertRegex(disc_mesh()._repr_svg_(), r"(?s)^<\?xml.*<svg .*</svg>\s*$")

    def test_a_report_is_shown_in_a_line(self):
        report = dsc.Report(unreached=2, held=1, sub_steps=3, interface_vertices=40, reached=0.25, gave_up="",
                            events=[None, None], reason="")
        self.assertEqual(repr(report), "<dsc.Report: time 0.25, 40 interface vertices, 2 unreached, 2 events>")
        stopped = report._replace(events=[], gave_up="too_many_passes")
        self.assertEqual(str(stopped), "<dsc.Report: time 0.25, 40 interface vertices, 2 unreached, too_many_passes>")

    def test_a_series_names_each_mesh_with_its_time(self):
        with tempfile.TemporaryDirectory() as folder:
            series = dsc.Series(pathlib.Path(folder) / "one & two.pvd")
            for time in (0, 0.1):
                series.add(disc_mesh(), time)
            sets = ElementTree.parse(pathlib.Path(folder) / "one & two.pvd").findall("Collection/DataSet")
            self.assertEqual([float(one.get("timestep")) for one in sets], [0, 0.1])
            self.assertEqual({one.get("file") for one in sets} | {"one & two.pvd"}, set(os.listdir(folder)))


if __name__ == "__main__":
    unittest.main()

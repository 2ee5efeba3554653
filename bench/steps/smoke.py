#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""smoke.py DSC_BENCH: tests the program with times masked, so that changes of the schema are detected
and noise is not. Standard library only."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
FILTER = ("^(operation/edge_flip|kernel/gather_star|flow/|space/translation-3d/edges:16/|option/topology_change/speedup|"
          "(scaling|four_circles)_step/strategy:(sequential|counting)/triangles:28000/|"
          "scaling_run/strategy:(sequential|cells)/triangles:28000/(threads:[0-9]+/)?between_us:100/|"
          "scaling_step/strategy:cells/triangles:28000/submeshes:0/threads:2/modelled:1)")

# Google Benchmark's own keys of one repetition, then ours; numbers are masked by their type.
ITERATION = {
    "name": "text", "family_index": "number", "per_family_instance_index": "number",
    "run_name": "text", "run_type": "text", "repetitions": "number",
    "repetition_index": "number", "threads": "number", "iterations": "number",
    "real_time": "number", "cpu_time": "number", "time_unit": "text",
}
STEP = {**ITERATION, **dict.fromkeys((
    "us_per_step", "cpu_us_per_step", "us_per_vertex_step", "interface_vertices", "triangles",
    "min_quality", "area_error_rel", "load", "oversubscribed", "threads_used", "utilisation",
    "serial_share", "peak_memory_mb",
    "examined_per_step", "flips_per_step", "splits_per_step", "collapses_per_step"), "number")}
MODEL = {**ITERATION, **dict.fromkeys((
    "us_per_step", "modelled", "serial_share", "busy_share", "fork_join_us", "section_start_us",
    "bandwidth_of_one_gb_s", "bandwidth_of_all_gb_s", "load", "us_serial", "us_tasks", "us_starts",
    "us_all_tasks", "us_set_up", "us_hand_over", "us_clean_up", "us_driver", "us_remeshing",
    "us_velocities", "us_movement", "us_mesh_update", "us_later_colours"), "number")}
RUN = {**ITERATION, **dict.fromkeys((
    "us_per_step", "construction_us", "first_step_us", "us_per_vertex_step", "interface_vertices",
    "triangles", "min_quality", "area_error_rel", "load", "oversubscribed", "threads_used",
    "utilisation", "serial_share"), "number")}
SPACE_RUN = {**ITERATION, **dict.fromkeys((
    "us_per_step", "cpu_us_per_step", "first_step_us", "interface_vertices", "tets", "min_dihedral_deg",
    "vertex_error_h", "load", "oversubscribed", "threads_used", "utilisation", "serial_share"), "number")}
SPACE_MODEL = {**ITERATION, **dict.fromkeys((
    "us_per_step", "modelled", "serial_share", "busy_share", "fork_join_us", "section_start_us", "us_serial",
    "us_tasks", "us_starts", "load"), "number")}
OPERATION = {**ITERATION, "items_per_second": "number", "batch": "number", "label": "text"}
FLOW = {**ITERATION, "items_per_second": "number", "ratio": "number", "label": "text"}
OPTION = {**ITERATION, **dict.fromkeys((
    "ratio", "ratio_low", "ratio_high", "us_per_step", "us_per_step_without"), "number"),
    "label": "text"}
SPACE = {**ITERATION, **dict.fromkeys((
    "interface_vertices", "us_per_step", "us_per_vertex_and_sub_step", "us_per_tet_and_step", "vertices_off_h"),
    "number"), "label": "text"}
KERNEL = {**ITERATION, "items_per_second": "number", "label": "text"}
ROUNDING = 1e-9
CONTEXT = ("dsc_machine", "dsc_commit", "dsc_cores", "dsc_compiler", "dsc_build_type",
           "dsc_native", "dsc_load", "dsc_clock", "dsc_binding")


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)


def masked(row):
    return {key: "text" if isinstance(value, str) else
            "number" if isinstance(value, (int, float)) and not isinstance(value, bool) else
            "other" for key, value in row.items()}


class Schema(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "result.json")
            done = run(f"--benchmark_filter={FILTER}", "--benchmark_repetitions=2",
                       "--benchmark_min_time=0.001", "--benchmark_enable_random_interleaving=true",
                       f"--benchmark_out={path}", "--benchmark_out_format=json")
            assert done.returncode == 0, done.stdout + done.stderr
            with open(path, encoding="utf-8") as stream:
                data = json.load(stream)
        cls.context = data["context"]
        cls.rows = [row for row in data["benchmarks"] if row["run_type"] == "iteration"]

    def family(self, name):
        """The measured rows of a family."""
        rows = [row for row in self.rows
                if row["name"].split("/")[0] == name and "/modelled:" not in row["name"]]
        self.assertTrue(rows, f"no row of {name}")
        return rows

    def test_context_says_where_the_result_comes_from(self):
        for key in CONTEXT:
            self.assertIsInstance(self.context.get(key), str, key)
            self.assertTrue(self.context[key], key)
        self.assertGreaterEqual(int(self.context["dsc_cores"]), 1)
        self.assertGreaterEqual(float(self.context["dsc_load"]), 0.0)
        self.assertIn(self.context["dsc_native"], ("ON", "OFF"))

    def test_rows_have_these_keys_and_no_others(self):
        for name, schema in (("scaling_run", RUN), ("scaling_step", STEP), ("four_circles_step", STEP),
                             ("operation", OPERATION), ("kernel", KERNEL),
                             ("flow", FLOW), ("space", SPACE)):
            for row in self.family(name):
                self.assertEqual(masked(row), schema, row["name"])

    def test_modelled_rows_say_so_and_add_up(self):
        rows = [row for row in self.rows if "/modelled:1/" in row["name"]]
        self.assertTrue(rows)
        for row in rows:
            self.assertEqual(masked(row), MODEL, row["name"])
            self.assertEqual(row["modelled"], 1)
            self.assertTrue(0 < row["serial_share"] < 0.5, row)
            self.assertTrue(0 < row["busy_share"] <= 1, row)
            self.assertTrue(row["section_start_us"] >= row["fork_join_us"] > 0, row)
            self.assertTrue(row["bandwidth_of_one_gb_s"] > 0 < row["bandwidth_of_all_gb_s"], row)
            # This holds for any times: two threads need at least half of the time of all tasks, and at most all of it.
            parallel = row["us_per_step"] - row["us_serial"] - row["us_starts"]
            self.assertGreaterEqual(parallel * (1 + ROUNDING), row["us_tasks"] / 2)
            self.assertLessEqual(parallel, row["us_tasks"] * (1 + ROUNDING))
            self.assertAlmostEqual(row["us_serial"] / (row["us_serial"] + row["us_tasks"])
                                   / row["serial_share"], 1, delta=ROUNDING)
            # The parts lie within the tasks.
            self.assertAlmostEqual(row["us_tasks"] / row["us_all_tasks"], 1, delta=ROUNDING)
            parts = sum(row[key] for key in (
                "us_remeshing", "us_velocities", "us_movement", "us_mesh_update",
                "us_later_colours"))
            self.assertLessEqual(parts, row["us_all_tasks"] * (1 + ROUNDING))

    def test_names_say_what_was_run(self):
        names = {row["name"] for row in self.rows}
        cores = int(self.context["dsc_cores"])
        for family in ("scaling_step", "four_circles_step"):
            self.assertIn(f"{family}/strategy:sequential/triangles:28000/iterations:1/manual_time",
                          names)
            counting = sorted(int(re.search(r"/threads:(\d+)/", name)[1]) for name in names
                              if name.startswith(f"{family}/strategy:counting/")
                              and "/submeshes:" in name)
            self.assertEqual(counting[0], 1)
            self.assertEqual(counting[-1], cores)
        self.assertIn("operation/edge_flip/triangles:28000/manual_time", names)

    def test_what_does_not_depend_on_time_is_plausible(self):
        cores = int(self.context["dsc_cores"])
        for family, vertices in (("scaling_step", (130, 210)), ("four_circles_step", (180, 270))):
            for row in self.family(family):
                threads = re.search(r"/threads:(\d+)/", row["name"])
                over = bool(threads) and int(threads[1]) > cores
                self.assertEqual(row["oversubscribed"], int(over), row["name"])
                self.assertLess(abs(row["triangles"] / 28000 - 1), 0.1, row["name"])
                self.assertTrue(vertices[0] <= row["interface_vertices"] <= vertices[1],
                                f"{row['name']}: {row['interface_vertices']} interface vertices")
                self.assertTrue(0.05 < row["min_quality"] <= 1, row["name"])
                self.assertLess(row["area_error_rel"], 0.01, row["name"])
                self.assertEqual(row["iterations"], 1)
                # One iteration is 64 steps.
                self.assertAlmostEqual(row["real_time"] * 1e3 / row["us_per_step"], 64, delta=0.1)

    def test_threads_are_busy_for_a_part_of_the_time(self):
        for family in ("scaling_run", "scaling_step", "four_circles_step"):
            for row in self.family(family):
                threads = int((re.search(r"/threads:(\d+)/", row["name"]) or ["", 1])[1])
                self.assertTrue(1 <= row["threads_used"] <= threads, row)
                self.assertTrue(0 < row["utilisation"] <= 1 + ROUNDING, row)
                self.assertTrue(0 < row["serial_share"] <= 1 + ROUNDING, row)
                if row["threads_used"] == 1:  # it never waits
                    self.assertAlmostEqual(row["utilisation"] * threads, 1, msg=row["name"])

    def test_threads_and_repetitions_give_one_answer(self):
        for family in ("scaling_step", "four_circles_step"):
            answers = {(row["triangles"], row["interface_vertices"], row["min_quality"],
                        row["flips_per_step"], row["examined_per_step"])
                       for row in self.family(family) if "strategy:counting" in row["name"]}
            self.assertEqual(len(answers), 1, answers)


# A scene file beside its suite: a scene of the catalogue with settings of its own.
SCENE = 'scene = "zalesak"\n[options]\nh = 0.04\nsteps = 12\n'
SUITE = """[[case]]
scene = "mine.toml"
measure = "run"
h = [0.05, 0.04]
strategies = ["sequential", "cells", "active"]
threads = [1, 2]
area_error = 0.2
"""
# In three dimensions.
IN_SPACE = """[[case]]
scene = "translation-3d"
h = 0.1
set = { steps = 3 }
strategies = ["sequential", "cells", "blocks"]
rows = [{ measure = "run", threads = [1, 2] }, { measure = "model", strategies = "cells", threads = 8, submeshes = "threads" },
        { measure = "model", strategies = "cells", threads = 8, stop_after = 2 }]
"""
BAD_SUITES = {
    "": ("an empty suite",),
    "[[case]\n": ("suite.toml:1",),
    "case = 3\n": ("suite.toml:1: case", "got 3", "[[case]]"),
    '[[case]]\nmeasure = "run"\n': ("suite.toml:1", "scene"),
    '[[case]]\nscene = "swirrl"\n': ("suite.toml:2", "'swirrl'", "single-vortex"),
    '[[case]]\nscene = "no/such.toml"\n': ("suite.toml:2", "'no/such.toml'"),
    '[[case]]\nscene = "suite.toml"\n': ("suite.toml:2", "'case'"),
    '[[case]]\nscene = "swirl"\nthread = 2\n': ("suite.toml:3", "'thread'", "threads"),
    '[[case]]\nscene = "swirl"\nthreads = 0\n': ("suite.toml:3", "got 0", "from 1"),
    '[[case]]\nscene = "swirl"\nthreads = "all"\n': ("suite.toml:3", "'all'", "cores"),
    '[[case]]\nscene = "swirl"\nh = []\n': ("suite.toml:3", "h"),
    '[[case]]\nscene = "swirl"\nh = 0.1\ntriangles = 900\n': ("one of h and triangles",),
    '[[case]]\nscene = "swirl"\nname = "a/b"\n': ("suite.toml:3", "'a/b'", "letters"),
    '[[case]]\nscene = "swirl"\nmeasure = "speed"\n': ("suite.toml:3", "'speed'", "run, step"),
    '[[case]]\nscene = "swirl"\nat = 0.1\n': ("suite.toml:3", "'at'"),
    '[[case]]\nscene = "swirl"\nset = { insertion = "cubik" }\n': ("'cubik'", "linear, cubic"),
    '[[case]]\nscene = "swirl"\nset = { h = 0.1 }\n': ("suite.toml:3", "[case.set] h"),
    '[[case]]\nscene = "swirl"\nset = { real = "float" }\n': ("'float'", "double"),
    '[[case]]\nscene = "swirl"\nstrategies = "cels"\n': ("suite.toml:3", "'cels'", "cells"),
    '[[case]]\nscene = "swirl"\nstrategies = "reference"\n': ("got 'reference'", "step"),
    '[[case]]\nscene = "swirl"\nmeasure = "model"\nstrategies = "copy"\n': ("got 'copy'", "cells"),
    '[[case]]\nscene = "swirl"\nmeasure = "step"\nset = { steps = 20 }\n': ("40", "at least 80"),
    '[[case]]\nscene = "zalesak"\nmeasure = "step"\nat = "half"\n': ("zalesak", "a time"),
    '[[case]]\nscene = "swirl"\nmeasure = "option"\n': ("option = {",),
    '[[case]]\nscene = "grow-shrink"\nmeasure = "step"\n': ("suite.toml:2", "growth", "velocity"),
    '[[case]]\nscene = ["swirl", "swirl"]\n': ("two rows have the same name", "swirl_run/"),
    '[[case]]\nscene = "swirl"\nrows = [{ threads = 0 }]\n': ("suite.toml:3", "got 0"),
    '[[case]]\nscene = "enright"\nmeasure = "step"\n': ("suite.toml:3", "three dimensions", "run, model"),
    '[[case]]\nscene = "enright"\ntriangles = 9000\n': ("suite.toml:3", "triangles", "three dimensions", "submeshes"),
    '[[case]]\nscene = "enright"\nstrategies = "counting"\n': ("suite.toml:3", "counting", "blocks"),
    '[[case]]\nscene = "enright"\nsubmeshes = 3\n': ("suite.toml:3", "got 3", "power of two"),
    '[[case]]\nscene = "swirl"\nvertex_error = 1\n': ("suite.toml:3", "area_error"),
    '[[case]]\nscene = "swirl"\nstop_after = 2\n': ("suite.toml:3", "three dimensions", "steps"),
    'also = ["operations"]\n': ("suite.toml:1: also", "operation, kernel"),
}


class OwnSuite(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("mine.toml", SCENE)

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path

    def test_a_scene_file_is_measured(self):
        result = os.path.join(self.folder, "result.json")
        done = run(f"--suite={self.write('suite.toml', SUITE)}", f"--benchmark_out={result}")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(result, encoding="utf-8") as stream:
            rows = json.load(stream)["benchmarks"]
        expected = [f"mine_run/strategy:{strategy}/h:{h}{threads}/between_us:0/iterations:1/manual_time"
                    for h in ("0.05", "0.04")
                    for strategy, threads in (("sequential", ""), ("cells", "/threads:1"),
                                              ("cells", "/threads:2"), ("active", "/threads:1"),
                                              ("active", "/threads:2"))]
        self.assertEqual([row["name"] for row in rows], expected)
        for row in rows:
            self.assertEqual(masked(row), RUN, row["name"])

    def test_a_scene_in_three_dimensions_is_measured_and_modelled(self):
        result = os.path.join(self.folder, "result.json")
        done = run(f"--suite={self.write('suite.toml', IN_SPACE)}", f"--benchmark_out={result}")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(result, encoding="utf-8") as stream:
            rows = json.load(stream)["benchmarks"]
        ways = ("sequential/h:0.1", "cells/h:0.1/threads:1", "cells/h:0.1/threads:2", "blocks/h:0.1/threads:1",
                "blocks/h:0.1/threads:2", "cells/h:0.1/submeshes:8/threads:8/modelled:1",
                "cells/h:0.1/threads:8/stop_after:2/modelled:1")
        self.assertEqual([row["name"] for row in rows],
                         [f"translation-3d_run/strategy:{way}/iterations:1/manual_time" for way in ways])
        for row in rows:
            self.assertEqual(masked(row), SPACE_MODEL if "modelled" in row else SPACE_RUN, row["name"])
            self.assertTrue(0 < row.get("utilisation", 1) <= 1 + ROUNDING, row)
        model = rows[-1]
        parallel = model["us_per_step"] - model["us_serial"] - model["us_starts"]
        self.assertLessEqual(parallel, model["us_tasks"] * (1 + ROUNDING))
        self.assertGreaterEqual(parallel * (1 + ROUNDING), model["us_tasks"] / 8)
        far = self.write("far.toml", IN_SPACE.replace("h = 0.1", "h = 0.1\nvertex_error = 0"))
        done = run("--suite", far)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("6 measurements were refused", done.stderr)  # the error at the end of a part is not known

    def test_whole_runs_move_in_any_way(self):
        suite = self.write("suite.toml", """[[case]]
scene = ["three-phases", "grow-shrink", "static-drop"]
strategies = "cells"
threads = [1, 2]
set = { steps = 3 }
""")
        done = run("--suite", suite)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count("/strategy:cells/"), 6, done.stdout)

    def test_a_wrong_answer_is_not_timed(self):
        suite = self.write("suite.toml", SUITE.replace("area_error = 0.2", "area_error = 0"))
        done = run("--suite", suite)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("10 measurements were refused", done.stderr)

    def test_results_do_not_replace_the_suite(self):
        suite = self.write("suite.toml", SUITE)
        done = run("--suite", suite, f"--benchmark_out={suite}")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
        self.assertIn("--benchmark_out: the same file as --suite", done.stderr)
        with open(suite, encoding="utf-8") as stream:
            self.assertEqual(stream.read(), SUITE)

    def test_bad_suites_are_refused_with_a_sentence(self):
        for text, words in BAD_SUITES.items():
            with self.subTest(suite=text):
                done = run("--suite", self.write("suite.toml", text), "--benchmark_list_tests")
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertTrue(done.stderr.startswith("dsc_bench: "), done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                for word in ("got ", "; allowed: ", *words):
                    self.assertIn(word, done.stderr)


class Usage(unittest.TestCase):
    def assert_refused(self, argument, *words):
        done = run(argument)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        lines = done.stderr.strip().splitlines()
        self.assertTrue(lines[-1].startswith("dsc_bench: ") and lines[-1].endswith("."), lines)
        for word in words:
            self.assertIn(word, lines[-1])

    def test_unknown_arguments_are_refused(self):
        self.assert_refused("--benchmark_speed=9", "--benchmark_speed=9")
        self.assert_refused("swirl", "swirl")
        self.assert_refused("--suite", "--suite FILE")
        self.assert_refused("--suite=no/such.toml", "no/such.toml")

    def test_a_filter_that_leaves_nothing_is_refused(self):
        self.assert_refused("--benchmark_filter=no_such_row", "--benchmark_filter")

    def test_the_list_names_every_suite(self):
        done = run("--benchmark_list_tests")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("scaling_step/strategy:reference/triangles:28000",
                     "four_circles_step/strategy:counting/triangles:2800000",
                     "operation/edge_split", "operation/edge_collapse",
                     "operation/loop_subdivision", "operation/local_retriangulation",
                     "operation/laplacian_smoothing", "kernel/mesh_hash", "space/enright/edges:32"):
            self.assertIn(name, done.stdout)

    def test_help_shows_a_suite_that_is_taken(self):
        done = run("--help")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line[2:] for line in done.stdout.splitlines() if line.startswith("  ")]
        suite = lines[lines.index("[[case]]"):]
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write("\n".join(line for line in suite if "=" in line or "[[" in line
                                 if "benchmark_" not in line and "--v=" not in line))
            file.flush()
            listed = run("--suite", file.name, "--benchmark_list_tests")
        self.assertEqual(listed.returncode, 0, listed.stderr)
        self.assertEqual(len(listed.stdout.splitlines()), 10)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("smoke.py: the path of dsc_bench is missing.")
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)

# SPDX-License-Identifier: MIT
"""Tests of the pictures: small result files are made here, drawn, and their numbers checked."""
import json
import os
import re
import subprocess
import sys
import unittest

import numpy
from matplotlib.collections import PathCollection

from look import style
from mesh import frames, histograms
from parallel import per_operation, series, speedup, step_cost
from results import load, load_frames
from tests.samples import PLOTS, PUBLISHED, VTU, Case, bench, row, scene, verify
from tests.test_faults import Faults  # noqa: F401
from tests.test_flow import Flow  # noqa: F401
from tests.test_over_time import OverTime  # noqa: F401
from tests.test_page import Words  # noqa: F401  (its tests run with these)
from tests.test_parallel import Parallel  # noqa: F401
from tests.test_precision import Precision  # noqa: F401
from tests.test_speedup import SpeedUp  # noqa: F401


class Plots(Case):
    def points(self):
        path = self.write("bench.json", bench())
        found = series.rows(load.read_bench([path]))
        return {p.n: p for p in series.speedups(found)}

    # The whole report.

    def files(self):
        out, result = os.path.join(self.folder, "out"), {}
        for name in os.listdir(out):
            with open(os.path.join(out, name), "rb") as stream:
                result[name] = stream.read()
        return result

    def test_everything_is_drawn_and_embedded(self):
        status, errors, page = self.run_report(*self.inputs(), "--formats", "png")
        self.assertEqual((status, errors), (0, ""))
        names = ["speedup_scaling_of_a_circle", "granularity", "step_cost", "step_cost_per_vertex",
                 "per_operation", "precision_swirl-260", "precision_convergence",
                 "histogram_speedup-scaling_area", "frames_swirl_sequential"]
        files = self.files()
        for name in names:
            self.assertTrue(files[f"{name}.png"].startswith(b"\x89PNG"), name)
            self.assertEqual(files[f"{name}.png"][25], 3, f"{name}.png has no palette")
        self.assertEqual(page.count("data:image/webp;base64,"), len(names))
        self.assertEqual([n for n in files if n.endswith(".part")], [])
        self.assertIn("<figcaption>Swirl at the beginning and at the end", page)
        self.assertIn("the mesh is not valid", page)
        self.assertIn("All 2 checks pass.", page)
        self.assertIn("0.994864", page)  # the thesis's area ratio beside ours

    def test_the_same_results_give_the_same_bytes_in_every_format(self):
        words = self.inputs(few=True)
        self.run_report(*words)
        files = self.files()
        magic = {"html": b"<!DOCTYPE", "pdf": b"%PDF", "png": b"\x89PNG", "svg": b"<?xml"}
        self.assertEqual({n.rpartition(".")[2] for n in files}, set(magic))
        for name, data in files.items():
            self.assertTrue(data.startswith(magic[name.rpartition(".")[2]]), name)
        self.run_report(*words, "--jobs", "2")
        again = self.files()
        self.assertEqual([n for n in files if files[n] != again[n]], [])

    def test_no_format_depends_on_the_last_digits_of_the_layout(self):
        figure, grid = style.figure(3, 3, 2, 2, sharex="row")
        style.finish(figure, "A title", "A caption")
        for axes in grid.flat:
            axes.plot([1, 3], [2, 9])
        style.save(figure, self.folder, "picture", ["svg"])
        for axes in grid.flat:
            for value in axes.get_position(original=True).bounds:
                self.assertAlmostEqual(value, round(value, 6), places=12)

    def test_what_was_not_run_is_said(self):
        status, errors, page = self.run_report()
        self.assertEqual((status, errors), (0, ""))
        for sentence in ("The gate (dsc_verify) was not run.", "The benchmarks were not run.",
                         "The scenes were not run.", "No published figures were given"):
            self.assertIn(sentence, page)
        self.assertNotIn("<img", page)

    def test_works_as_a_program(self):
        done = subprocess.run([sys.executable, os.path.join(PLOTS, "report.py"), "--formats", "png",
                               "--bench", self.write("bench.json", bench()), "--out",
                               os.path.join(self.folder, "out")], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "out", "step_cost.svg")))

    def test_failed_check_is_named(self):
        path = self.write("verify.json", verify("fail"))
        page = self.run_report("--verify", path)[2]
        self.assertIn("1 of 2 checks does not pass: area drift (swirl).", page)
        self.assertIn("✗ fail", page)

    # Bad input.

    def test_truncated_json(self):
        whole = json.dumps(bench())
        self.assert_refused(["--bench", self.write("cut.json", whole[:len(whole) // 2])],
                            "cut.json", "truncated")
        self.assert_refused(["--scenes", self.write("cut.json", "{")], "cut.json")
        self.assert_refused(["--verify", self.write("cut.json", "")], "cut.json")

    def test_missing_file(self):
        self.assert_refused(["--bench", os.path.join(self.folder, "none.json")], "none.json",
                            "cannot be read")

    def test_missing_keys(self):
        data = bench()
        del data["benchmarks"][0]["real_time"]
        self.assert_refused(["--bench", self.write("b.json", data)], "real_time",
                            "strategy:sequential/triangles:28000")
        data = scene(0.01, 1e-3, 1)
        del data["strategy"]
        self.assert_refused(["--scenes", self.write("s.json", data)], "strategy")
        data = verify()
        del data["checks"][0]["limit"]
        self.assert_refused(["--verify", self.write("v.json", data)], "limit", "area drift")
        self.assert_refused(["--verify", self.write("v.json", [])], "object is expected")

    def test_bad_values(self):
        data = bench()
        data["benchmarks"][0]["real_time"] = "fast"
        self.assert_refused(["--bench", self.write("b.json", data)], "real_time", "fast")
        data = verify()
        data["histograms"][0]["counts"].pop()
        self.assert_refused(["--verify", self.write("v.json", data)], "4 edges and 2 counts")

    def test_two_machines_do_not_mix(self):
        self.assert_refused(["--bench", self.write("a.json", bench()),
                             self.write("b.json", bench(machine="another"))], "another")

    def test_bad_frames(self):
        path = self.write("frames/swirl_sequential_00000.vtu", VTU.format(x=1)[:300])
        self.assert_refused(["--frames", os.path.dirname(path)], "00000.vtu", "truncated")
        self.write("frames/swirl_sequential_00000.vtu", VTU.format(x=1).replace("3 0 4", "3 0 9"))
        self.assert_refused(["--frames", os.path.dirname(path)], "vertex outside 0 to 4")

    def test_bad_usage(self):
        self.assert_refused(["--formats", "gif"], "gif", "png, svg and pdf")
        self.assert_refused(["--nonsense"], "--nonsense")

    # Numbers.

    def test_speedup_is_ratio_of_medians(self):
        points = self.points()
        self.assertEqual(points[2].s, 110 / 55)
        self.assertEqual(points[2].u, 110 / 55 / 2)
        self.assertEqual((points[2].low, points[2].high), (110 / 60, 110 / 50))
        self.assertEqual(points[1].s, 110 / 121)
        self.assertEqual([n for n, p in points.items() if p.row.oversubscribed], [4])

    def test_oversubscribed_by_counter_or_by_cores(self):
        for counter, cores, expected in ((None, "2", [4]), (None, "4", []), (0, "2", [4]),
                                         (1, "8", [4]), (None, "", [])):
            data = bench()
            data["context"]["dsc_cores"] = cores
            for item in data["benchmarks"]:
                if counter is None or not item.get("oversubscribed"):
                    item.pop("oversubscribed", None)
                else:
                    item["oversubscribed"] = counter
            found = series.rows(load.read_bench([self.write("b.json", data)]))
            self.assertEqual([r.threads for r in found if r.oversubscribed], expected,
                             (counter, cores))

    def test_speedup_needs_a_sequential_row(self):
        data = bench()
        data["benchmarks"] = [r for r in data["benchmarks"] if "sequential" not in r["name"]]
        found = series.rows(load.read_bench([self.write("b.json", data)]))
        self.assertEqual(series.speedups(found), [])

    def test_aggregates_alone(self):
        data = bench()
        data["benchmarks"] = [
            {"name": "scaling_step/strategy:sequential/triangles:10_median", "time_unit": "ms",
             "run_name": "scaling_step/strategy:sequential/triangles:10", "real_time": 3.0,
             "run_type": "aggregate", "aggregate_name": "median"}]
        found = series.rows(load.read_bench([self.write("b.json", data)]))
        self.assertEqual([r.times for r in found], [[3000.0]])

    def test_sentences_say_the_numbers(self):
        path = self.write("bench.json", bench())
        results, published = load.read_bench([path]), load.read_published(PUBLISHED)
        text = next(speedup.draw(results, published)).details
        for part in ("55.0 µs", "110 µs", "S(2) = 2.00, U(2) = 1.00", "(thesis: 1.47)",
                     "takes 1.10 times the sequential time", "1 of 3 points are oversubscribed"):
            self.assertIn(part, text)
        steps, vertices = step_cost.draw(results, published)
        for part in ("from 110 µs to 420 µs", "to the power 0.58", "220 ms",
                     "2,000 times as long",
                     "cells with 2 threads, 55.0 µs", "omega_h, took 54.0 ms at 28,500"):
            self.assertIn(part, steps.details)
        self.assertIn("1.00 µs to 1.10 µs", vertices.details)
        text = per_operation.draw(results, published)[0].details
        for part in ("edge flip with 42.0 ns", "edge collapse with 310 ns", "2 of 2"):
            self.assertIn(part, text)

    def test_one_size_has_its_own_picture(self):
        data = bench()
        data["benchmarks"] = [r for r in data["benchmarks"] if "280000" not in r["name"]]
        results = load.read_bench([self.write("b.json", data)])
        pictures = step_cost.draw(results, load.read_published(PUBLISHED))
        self.assertEqual([p.name for p in pictures], ["step_cost"])
        labels = [t.get_text() for t in pictures[0].figure.axes[0].get_yticklabels()]
        self.assertEqual(labels[::-1][:3], ["reference", "sequential", "cells, 2 threads"])
        self.assertIn("the sequential step takes 110 µs at 28,000", pictures[0].details)

    def test_items_per_second_is_the_cost_of_an_operation(self):
        data = bench()
        data["benchmarks"] = row("operation/edge_flip", [100.0], items_per_second=2.5e7)
        found = load.read_bench([self.write("b.json", data)])
        self.assertEqual(per_operation.costs(found), [("edge flip", [40.0])])

    def test_histogram_median_and_distance(self):
        found = histograms.groups([], load.read_verify([self.write("v.json", verify())]))
        shapes = found[("speedup-scaling", "area")]
        self.assertAlmostEqual(histograms.median(shapes["sequential"]), 1 + 40 / 60)
        self.assertAlmostEqual(histograms.distance(shapes["sequential"], shapes["cells"]), 0.1)
        text = histograms.sentence("speedup-scaling", "area", shapes)
        self.assertIn("at most 10.0 % of the triangles (cells)", text)

    def test_frame_interface_and_area(self):
        path = self.write("frames/swirl_sequential_00000.vtu", VTU.format(x=1))
        frame = load_frames.read_frame(path)
        self.assertEqual(sorted(map(tuple, frames.interface(frame))), [(1, 4), (2, 4)])
        self.assertEqual(frames.areas(frame), {0: 3.0, 1: 1.0})
        later = self.write("frames/swirl_sequential_00007.vtu", VTU.format(x=1.5))
        text = frames.sentence("swirl", "sequential", [(0, None, frame),
                                                       (7, None, load_frames.read_frame(later))])
        self.assertIn("4 and 4 triangles in frames 0 and 7", text)
        shown = [(0, None, frame), (7, None, load_frames.read_frame(later))]
        self.assertEqual(frames.plain("swirl", shown), "swirl at the beginning and at the end, with "
                         "4 triangles; at the end its area is 50 % smaller.")
        self.assertIn("its area is 100 % larger", frames.plain("swirl", shown[::-1]))
        self.assertIn("its area is the same to 0.001 %", frames.plain("swirl", shown[:1] * 2))
        self.assertIn("from 1.0000 to 0.50000 (-50.000 %)", text)

    def test_of_several_strategies_one_mesh_is_drawn(self):
        for name in ("swirl_cells", "swirl_sequential", "t1_cells"):
            self.write(f"frames/{name}_00000.vtu", VTU.format(x=1))
        runs = frames.read(os.path.join(self.folder, "frames"))
        self.assertEqual([run[:2] for run in runs], [("swirl", "sequential"), ("t1", "cells")])

    def test_histograms_are_those_of_the_thesis(self):
        data = verify()
        data["histograms"] += [{**h, "scene": "swirl"} for h in data["histograms"]]
        found = load.read_verify([self.write("v.json", data)])
        self.assertEqual([p.name for p in histograms.draw([], found, {})],
                         ["histogram_speedup-scaling_area"])

    def test_events_are_drawn_with_the_frame_after_them(self):
        self.write("frames/swirl_sequential_00000.vtu", VTU.format(x=1))
        self.write("frames/swirl_sequential_00007.vtu", VTU.format(x=1.5))
        self.write("frames/swirl_sequential.pvd", """<VTKFile><Collection>
            <DataSet timestep="0" file="swirl_sequential_00000.vtu"/>
            <DataSet timestep="0.5" file="swirl_sequential_00007.vtu"/></Collection></VTKFile>""")
        line = '{"kind": "%s", "time": %s, "x": 1, "y": 0.5}\n'
        path = self.write("frames/swirl_sequential.events.jsonl",
                          line % ("merge", 0.25) + line % ("split", 0.5) + line % ("fill", 0.75))
        runs = frames.read(os.path.dirname(path))
        picture = next(frames.draw(runs))
        self.assertIn("changes of topology: 1 fill, 1 merge, 1 split", picture.details)
        first, second = picture.figure.axes[:2]
        marks = [[c for c in axes.collections if isinstance(c, PathCollection)]
                 for axes in (first, second)]
        self.assertEqual([len(found) for found in marks], [0, 2])  # one is still to come
        self.write("frames/swirl_sequential.events.jsonl", line % ("merge", 0.25) + '{"kind": ')
        self.assert_refused(["--frames", os.path.dirname(path)], "line 2", "truncated")
        self.write("frames/swirl_sequential.events.jsonl", '{"kind": "merge"}\n')
        self.assert_refused(["--frames", os.path.dirname(path)], "line 1", "time")

    def test_many_phases_are_counted_and_not_listed(self):
        path = self.write("frames/grains_sequential_00000.vtu", VTU.format(x=1))
        frame = load_frames.read_frame(path)
        count = len(frame.phases)
        frame.phases = numpy.arange(1, count + 1)
        few = frames.MANY
        frames.MANY = count - 1
        try:
            text = frames.sentence("grains", "sequential", [(0, 0.0, frame), (1, 1.0, frame)])
        finally:
            frames.MANY = few
        self.assertIn(f"{count} phases, of which {count} are left", text)

    def test_frame_names(self):
        for number in (3, 0, 12, 7):
            self.write(f"frames/swirl-zalesak_cells_{number:05d}.vtu", "")
        files = load_frames.frame_files(os.path.join(self.folder, "frames"))
        self.assertEqual([n for n, _, _ in frames.picked(files[("swirl-zalesak", "cells")])],
                         [0, 3, 12])

    def test_numbers_for_people(self):
        self.assertEqual([style.digits(v) for v in (0, 2.0, 0.0123, 1.234e-5, 28236)],
                         ["0", "2.00", "0.0123", "1.23e-5", "28,236"])
        self.assertEqual([style.duration(v) for v in (0.0094, 43, 1809, 2.5e6)],
                         ["9.40 ns", "43.0 µs", "1.81 ms", "2.50 s"])
        self.assertEqual(style.listing(["a", "b", "c"]), "a, b and c")

    def test_published_figures_hold_together(self):
        published = load.read_published(PUBLISHED)
        table = load.entry(published, "speedup", "scaling_table_10_1")
        for line in table["values"]:
            # The thesis rounds, and cuts U(2) = 0.7336 and U(3) = 0.6348 to two places.
            self.assertAlmostEqual(table["t_s"] / line["t_n"], line["S"], delta=0.006)
            self.assertAlmostEqual(line["S"] / line["n"], line["U"], delta=0.006)
        for length in ("260", "420"):
            last, ratio = (load.entry(published, "thesis", f"swirl_{length}_area_{k}")["value"]
                           for k in ("last", "ratio"))
            first = load.entry(published, "thesis", "swirl_area_first")["value"]
            self.assertAlmostEqual(last / first, ratio, places=5)


if __name__ == "__main__":
    unittest.main()

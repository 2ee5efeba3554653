# SPDX-License-Identifier: MIT
"""Tests of the report and of its pictures: small result files are made here, drawn, and their numbers
checked."""
import os
import unittest

from matplotlib.collections import PathCollection

import frames
import histograms
import operations
import step_cost
from look import saving, style
from results import load, load_frames, series
from tests.samples import PUBLISHED, VTU, Case, bench, row, scene, verify
from tests.test_gallery import Gallery  # noqa: F401  (the tests of these files run with these)
from tests.test_page import Words  # noqa: F401
from tests.test_parallel import Parallel  # noqa: F401
from tests.test_precision import Precision  # noqa: F401


class Plots(Case):
    # The whole report.

    def files(self):
        out, result = self.path("out"), {}
        for name in os.listdir(out):
            with open(os.path.join(out, name), "rb") as stream:
                result[name] = stream.read()
        return result

    def test_links_stay_and_pipes_are_written_to(self):
        os.symlink("target", self.path("link"))
        os.mkfifo(self.path("pipe"))
        reader = os.open(self.path("pipe"), os.O_RDWR)  # waits for nobody
        self.addCleanup(os.close, reader)
        for name in ("link", "pipe"):
            saving.write_bytes(self.path(name), b"data")
        self.assertTrue(os.path.islink(self.path("link")))
        with open(self.path("target"), "rb") as stream:
            self.assertEqual(stream.read(), b"data")
        self.assertFalse(os.path.isfile(self.path("pipe")))
        self.assertEqual(os.read(reader, 4), b"data")

    def test_everything_is_drawn_and_embedded(self):
        status, errors, page = self.run_report(*self.inputs(), "--formats", "png")
        self.assertEqual((status, errors), (0, ""))
        names = ["speedup_scaling_step", "granularity", "step_cost", "step_cost_per_vertex",
                 "operations", "precision_swirl-260", "precision_convergence",
                 "histogram_speedup-scaling_area", "frames_swirl_sequential"]
        files = self.files()
        for name in names:
            self.assertTrue(files[f"{name}.png"].startswith(b"\x89PNG"), name)
            self.assertEqual(files[f"{name}.png"][25], 3, f"{name}.png has no palette")
        self.assertEqual(page.count("data:image/webp;base64,"), len(names))
        self.assertEqual({n.rpartition(".")[2] for n in files}, {"png", "html"})
        for words in ("<figcaption>Swirl at the beginning and at the end", "the mesh is not valid",
                      "All 2 figures that the gate compared with limits are within them.", "0.994864"):  # the thesis's area ratio beside ours
            self.assertIn(words, page)

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

    def test_what_was_not_run_is_said(self):
        status, errors, page = self.run_report()
        self.assertEqual((status, errors), (0, ""))
        for sentence in ("The gate (dsc_verify) was not run.", "The benchmarks were not run.",
                         "The scenes were not run.", "No published figures were given"):
            self.assertIn(sentence, page)
        self.assertNotIn("<img", page)

    # Bad input; test_scripts tests files that are wrong as a whole.

    def test_missing_keys_and_bad_values_are_named(self):
        for option, data, change, words in (
                ("--bench", bench(), lambda d: d["benchmarks"][0].pop("real_time"),
                 ("real_time", "strategy:sequential/triangles:28000")),
                ("--bench", bench(), lambda d: d["benchmarks"][0].update(real_time="fast"),
                 ("real_time", "fast")),
                ("--bench", bench(), lambda d: d["benchmarks"][0].update(run_name=3), ("run_name",)),
                ("--scenes", scene(0.01, 1e-3, 1), lambda d: d.pop("strategy"), ("strategy",)),
                ("--verify", verify(), lambda d: d["checks"][0].pop("limit"),
                 ("limit", "area drift")),
                ("--verify", verify(), lambda d: d["histograms"][0]["counts"].pop(),
                 ("4 edges and 2 counts",)),
                ("--verify", verify(), lambda d: d.update(not_run=3), ("not_run", "list"))):
            change(data)
            self.assert_refused([option, self.write("bad.json", data)], "bad.json", *words)
        self.assert_refused(["--bench", self.write("a.json", bench()),
                             self.write("b.json", bench(machine="another"))], "another")
        self.assert_refused(["--formats", "gif"], "gif", "png, svg and pdf")
        path = self.write("frames/swirl_sequential_00000.vtu",
                          VTU.format(x=1).replace("3 0 4", "3 0 9"))
        self.assert_refused(["--frames", os.path.dirname(path)], "vertex is outside 0 to 4")

    # Numbers.

    def test_intervals_are_those_of_the_ranks(self):
        # Ranks of 95 % intervals as tables have them, from the sixth value on.
        for count, low, high in ((3, 1, 3), (6, 1, 6), (9, 2, 8), (12, 3, 10), (20, 6, 15),
                                 (25, 8, 18)):
            middle = (count + 1) / 2
            self.assertEqual(style.interval(range(count, 0, -1)), (low, middle, high))
        self.assertIn("75 %", style.bars_text([3, 9]))
        self.assertIn("95 %", style.bars_text([6]))

    def test_speedup_is_ratio_of_medians(self):
        points = {p.n: p for p in series.speedups(series.rows(self.read_bench(bench())))}
        self.assertEqual(points[2].s, 110 / 55)
        self.assertEqual(points[2].u, 110 / 55 / 2)
        self.assertEqual(points[2].interval, (110 / 60, 110 / 55, 110 / 50))
        self.assertEqual(points[1].s, 110 / 121)
        self.assertEqual([n for n, p in points.items() if p.row.oversubscribed], [4])
        without = self.read_bench(bench(), keep=lambda row: "sequential" not in row["name"])
        self.assertEqual(series.speedups(series.rows(without)), [])

    def test_oversubscribed_by_counter_or_by_cores(self):
        for counter, cores, expected in ((None, "2", [4]), (None, "4", []), (0, "2", [4]),
                                         (1, "8", [4]), (None, "", [])):
            def change(item, counter=counter):
                if item.pop("oversubscribed", None) and counter is not None:
                    item["oversubscribed"] = counter
            data = bench()
            data["context"]["dsc_cores"] = cores
            found = series.rows(self.read_bench(data, change=change))
            self.assertEqual([r.threads for r in found if r.oversubscribed], expected,
                             (counter, cores))

    def test_aggregates_alone(self):
        found = series.rows(self.read_bench({**bench(), "benchmarks": [
            {"name": "scaling_step/strategy:sequential/triangles:10_median", "time_unit": "ms",
             "run_name": "scaling_step/strategy:sequential/triangles:10", "real_time": 3.0,
             "run_type": "aggregate", "aggregate_name": "median"}]}))
        self.assertEqual([r.times for r in found], [[3000.0]])

    def test_sentences_say_the_numbers(self):
        published, results = load.read_published(PUBLISHED), self.read_bench(bench())
        steps, vertices = step_cost.draw(results, published)
        self.assertIn("10 times as many triangles makes a step 3.8 times as long: 420 µs in place of "
                      "110 µs", steps.sentence)
        self.assertIn("from 1.00 µs to 1.10 µs", vertices.sentence)
        self.assertIn("from 42.0 ns (edge flip) to 310 ns (edge collapse)",
                      operations.draw(results, published)[0].sentence)
        one = self.read_bench(bench(), keep=lambda row: "280000" not in row["name"])
        self.assertIn("a step of 28,000 triangles takes 110 µs", step_cost.draw(one, {})[0].sentence)

    def test_items_per_second_is_the_cost_of_an_operation(self):
        found = self.read_bench({**bench(), "benchmarks": row(
            "operation/edge_flip", [100.0], items_per_second=2.5e7)})
        self.assertEqual(operations.costs(found), [("edge flip", [40.0])])

    def test_a_step_has_its_stars_and_edits_as_a_bound(self):
        counts = {"examined_per_step": 100, "flips_per_step": 10, "splits_per_step": 2, "collapses_per_step": 1}
        step = row("scaling_step/strategy:sequential/triangles:28000", [50.0], interface_vertices=40, **counts)
        costs = [part for name, rate in (("kernel/gather_star", 2e7), ("operation/edge_flip", 1e7),
                                         ("operation/edge_split", 5e6), ("operation/edge_collapse", 2e6))
                 for part in row(name, [100.0], items_per_second=rate)]
        data = {**bench(), "benchmarks": step + costs}
        found = self.read_bench(data)
        self.assertAlmostEqual(step_cost.floor(found, series.rows(found)[0]),
                               100 * 2 / 20 + 10 / 10 + 2 / 5 + 1 / 2)
        for part in range(len(costs)):
            fewer = self.read_bench(data, lambda row: row["run_name"] != costs[part]["run_name"])
            self.assertIsNone(step_cost.floor(fewer, series.rows(fewer)[0]))

    def test_histogram_median_and_distance(self):
        found = load.read_verify([self.write("v.json", verify())])
        shapes = histograms.groups([], found)[("speedup-scaling", "area")]
        self.assertAlmostEqual(histograms.median(shapes["sequential"]), 1 + 40 / 60)
        self.assertAlmostEqual(histograms.distance(shapes["sequential"], shapes["cells"]), 0.1)
        self.assertIn("differ in at most 10.0 % of the triangles",
                      histograms.draw([], found, {})[0].sentence)
        run = load.Scene("s.json", "swirl", "cells", {"machine": "a machine", "commit": "c0ffee"}, [])
        self.assertIn("c0ffee", style.caption_text(load.scene_context(run)))
        self.assertEqual(histograms.draw([], found, {}, shown=set()), [])

    def test_histograms_of_one_edge_length_are_compared(self):
        def of(strategy, width, size):
            return load.Scene("s.json", "s", strategy, {}, [
                load.Histogram("s", strategy, "area", [0, size], [9]),
                load.Histogram("s", strategy, "quality", [0, width], [9])])

        fine, coarse = of("sequential", 1, 0.1), [of("cells", 1, 0.4), of("fixed", 1, 0.4)]
        for quantity in ("area", "quality"):
            self.assertEqual(list(histograms.groups([fine, *coarse], None)[("s", quantity)]), ["fixed", "cells"])

    def test_the_load_is_that_of_the_measurements(self):
        found = self.read_bench(bench(), change=lambda row: row.update(load=0.5))
        self.assertEqual(found.context.load, "0.50")

    def test_frame_interface_and_area(self):
        shown = [(k, None, load_frames.read_frame(self.write(f"f{k}.vtu", VTU.format(x=x))))
                 for k, x in ((0, 1), (7, 1.5))]
        frame = shown[0][2]
        self.assertEqual(sorted(map(tuple, frames.interface(frame))), [(1, 4), (2, 4)])
        self.assertEqual(frames.areas(frame), {0: 3.0, 1: 1.0})
        self.assertEqual(frames.plain("swirl", shown), "swirl at the beginning and at the end, with "
                         "4 triangles; at the end its area is 50 % smaller, by the flow and by errors together.")
        self.assertIn("its area is 100 % larger", frames.plain("swirl", shown[::-1]))
        self.assertIn("its area is the same to 0.001 %", frames.plain("swirl", shown[:1] * 2))

    def test_frames_are_found_by_their_names(self):
        for run, steps in (("swirl_cells", [3]), ("swirl_sequential", [0, 12, 3, 7]),
                           ("swirl-t1_cells", [0])):
            self.frames(run, dict.fromkeys(steps, 1))
        runs = frames.read(self.path("frames"))
        # One of several strategies is drawn, at its first, middle and last frame.
        self.assertEqual([(*run[:2], [n for n, _, _ in run[2]]) for run in runs],
                         [("swirl", "sequential", [0, 3, 12]), ("swirl-t1", "cells", [0])])

    def test_events_are_drawn_with_the_frame_after_them(self):
        folder = self.frames("swirl_sequential", {0: 1, 7: 1.5}, {0: 0, 7: 0.5})
        line = '{"kind": "%s", "time": %s, "x": 1, "y": 0.5}\n'
        self.write("frames/swirl_sequential.events.jsonl",
                   line % ("merge", 0.25) + line % ("split", 0.5) + line % ("fill", 0.75))
        picture = next(frames.draw(frames.read(folder)))
        self.assertIn("phases met or parted 3 times", picture.sentence)
        marks = [[c for c in axes.collections if isinstance(c, PathCollection)]
                 for axes in picture.figure.axes[:2]]
        self.assertEqual([len(found) for found in marks], [0, 2])  # one is still to come
        self.write("frames/swirl_sequential.events.jsonl", line % ("merge", 0.25) + '{"kind": ')
        self.assert_refused(["--frames", folder], "line 2", "truncated")

    def test_a_logarithmic_axis_has_several_ticks(self):
        for low, high in ((1200, 40000), (1200, 9000), (3100, 4900), (4100, 4900), (1, 1e4)):
            figure, (panels,) = style.figure(3, 3)
            panels[0].set(xscale="log", xlim=(low, high))
            style.finish(figure, "title", "caption")
            axis = panels[0].xaxis
            shown = [place for place in axis.get_majorticklocs() if low <= place <= high]
            labels = axis.get_major_formatter().format_ticks(shown)
            self.assertGreater(len(labels), 1, (low, high))
            self.assertTrue(all(labels), labels)
            style.plt.close(figure)

    def test_numbers_for_people(self):
        self.assertEqual([style.digits(v) for v in (0, 0.01234, 5.2e-5, 123456.0, None)],
                         ["0", "0.0123", "5.20e-5", "123,456", "–"])
        self.assertEqual([style.duration(v) for v in (0.0094, 43, 1809, 2.5e6)],
                         ["9.40 ns", "43.0 µs", "1.81 ms", "2.50 s"])
        self.assertEqual(style.listing(["a", "b", "c"]), "a, b and c")

    def test_published_figures_hold_together(self):
        published = load.read_published(PUBLISHED)
        for name in ("scaling_table_10_1", "four_circles"):
            table = load.entry(published, "speedup", name)
            for line in table["values"]:
                # The thesis rounds most figures, but truncates U(2) = 0.7336 and U(3) = 0.6348 to two places.
                self.assertAlmostEqual(table["t_s"] / line["t_n"], line["S"], delta=0.011)
                self.assertAlmostEqual(line["S"] / line["n"], line["U"], delta=0.011)
        for first, last, ratio in (("vortex_area_first", "vortex_area_last", "vortex_area_ratio"),
                                   *(("swirl_area_first", f"swirl_{n}_area_last",
                                      f"swirl_{n}_area_ratio") for n in (260, 420))):
            first, last, ratio = (load.entry(published, "thesis", k)["value"]
                                  for k in (first, last, ratio))
            self.assertAlmostEqual(last / first, ratio, places=5)


if __name__ == "__main__":
    unittest.main()

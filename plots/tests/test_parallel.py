# SPDX-License-Identifier: MIT
"""Tests of the pictures of parallel runs: modelled rows, breakdown, granularity, submeshes."""
import math
import os
import re
import warnings

import matplotlib.pyplot as plt
import numpy

from parallel import breakdown
from parallel import copies
from parallel import granularity
from results import load
from results import load_frames
from parallel import per_operation
from parallel import series
from parallel import speedup
from parallel import speedup_text
from parallel import step_cost
from look import style
from parallel import submeshes
from parallel import whole_runs
from tests.samples import PUBLISHED, VTU, Case, row

PROFILE = {"us_set_up": 1, "us_hand_over": 0, "us_clean_up": 0, "us_driver": 1,
           "us_upkeep": 10, "us_velocities": 5, "us_movement": 8, "us_mesh_update": 70,
           "us_later_colours": 5}


def name(strategy, triangles, threads=0, cells=0, family="scaling_step", modelled=False):
    text = f"{family}/strategy:{strategy}/triangles:{triangles}"
    if threads:
        text += f"/submeshes:{cells}/threads:{threads}"
    return text + ("/modelled:1" if modelled else "") + "/iterations:1/manual_time"


def model(triangles, threads, us, cells=0, **more):
    """A modelled row: two per cent of the work is serial."""
    return row(name("cells", triangles, threads, cells, modelled=True), [us], modelled=1.0,
               serial_share=0.02, busy_share=0.9, fork_join_us=0.5, section_start_us=0.8,
               bandwidth_of_one_gb_s=12.5, bandwidth_of_all_gb_s=19.0, load=0.5, **PROFILE, **more)


def parallel_bench(**context):
    rows = row(name("sequential", 28000), [100, 104, 96], load=0.5, us_per_vertex_step=0.5)
    for strategy, ones, twos in (("cells", 105, 60), ("active", 110, 70), ("copy", 900, 600)):
        rows += row(name(strategy, 28000, 1, 8), [ones], load=0.5)
        rows += row(name(strategy, 28000, 2, 8), [twos], load=0.5)
    rows += model(28000, 1, 102) + model(28000, 2, 54) + model(28000, 4, 30)
    rows += model(28000, 8, 20) + model(28000, 8, 16, cells=8) + model(28000, 16, 19)
    for triangles, us, two in ((1800, 20, 40), (7000, 40, 40 / 1.5), (28000, 80, 50)):
        family = "granularity_step"
        rows += row(name("sequential", triangles, family=family), [us])
        rows += row(name("cells", triangles, 2, family=family), [two])
    return {"context": {"dsc_machine": "a machine", "dsc_commit": "c0ffee", "dsc_cores": "2",
                        **context}, "benchmarks": rows}


def box(normal=(1.0, 0.0), low=None, high=None, side_low=None, side_high=None, work=1.0):
    return {"kind": "box", "normal": list(normal), "low": low, "high": high,
            "side_low": side_low, "side_high": side_high, "work_us": work}


# The square of VTU is [0, 2] x [0, 2]: one cut at x = 0.5 of colour 1, one at y = 0.5 of colour 2.
DIVIDED = {"colours": [
    {"regions": [box(high=0.5, work=3.0), box(low=0.5, work=5.0)]},
    {"regions": [box((0.0, 1.0), high=0.5, work=1.0), box((0.0, 1.0), low=0.5, work=0.5)]},
    {"regions": [{"kind": "whole", "work_us": 0.5}]}]}


class Parallel(Case):
    def results(self, **context):
        return load.read_bench([self.write("bench.json", parallel_bench(**context))])

    def points(self, results):
        return speedup.gather(results, {})[0]

    # Modelled rows.

    def test_modelled_rows_are_never_measured_ones(self):
        results = self.results()
        self.assertFalse(any(r.modelled for r in series.rows(results)))
        self.assertEqual({r.threads for r in series.rows(results)}, {1, 2})
        models = series.modelled(results)
        self.assertTrue(all(r.modelled and not r.oversubscribed for r in models))
        self.assertEqual({r.label for r in models}, {"cells"})
        self.assertEqual(series.speedups(models), [], "a model is no base, and has none beside it")

    def test_a_counter_alone_marks_a_modelled_row(self):
        data = parallel_bench()
        for item in data["benchmarks"]:
            for key in ("name", "run_name"):
                item[key] = item[key].replace("/modelled:1", "/kind:m")
        found = series.rows(load.read_bench([self.write("bench.json", data)]))
        self.assertEqual({r.threads for r in found}, {1, 2})

    def test_the_fastest_number_of_submeshes_is_taken(self):
        models = {r.threads: r for r in series.modelled(self.results())}
        self.assertEqual((models[8].median, models[8].submeshes), (16, 8))
        self.assertEqual(sorted(models), [1, 2, 4, 8, 16])

    def test_pictures_of_measured_rows_leave_modelled_ones_out(self):
        with_model, without = self.results(), self.results()
        without.measurements = [m for m in without.measurements if "modelled" not in m.name]
        for draw in (lambda b: step_cost.draw(b, {}), lambda b: list(granularity.draw(b)),
                     lambda b: per_operation.draw(b, {})):
            one, two = draw(with_model), draw(without)
            self.assertEqual([(p.details, p.rows) for p in one],
                             [(p.details, p.rows) for p in two])
            for picture in one + two:
                plt.close(picture.figure)
        self.assertEqual(copies.table(with_model), copies.table(without))
        self.assertEqual(list(breakdown.draw(without)), [])

    def test_modelled_rows_are_labelled(self):
        picture = next(speedup.draw(self.results(), load.read_published(PUBLISHED)))
        kind = picture.header.index("kind")
        threads = picture.header.index("threads")
        ours = [r for r in picture.rows if r[-1] != "another program"]
        self.assertEqual({r[kind] for r in ours if int(r[threads]) > 2}, {"modelled"})
        self.assertEqual(sum(r[kind] == "modelled" for r in ours), 5)
        self.assertEqual(sum(r[kind] == "measured" for r in ours), 6)
        labels = [t.get_text() for t in picture.figure.legends[0].get_texts()]
        self.assertIn("cells, modelled", labels)
        self.assertIn("trinity, published", labels)
        words = " ".join(t.get_text() for t in picture.figure.texts)
        self.assertIn("modelled, not measured", words)
        before, after = picture.details.split("Modelled, not measured: ")
        self.assertIn("S(2) = 1.67, U(2) = 0.83", before)
        self.assertNotIn("S(8)", before)
        self.assertIn("S(8) = 6.25", after)
        dashed = [l for l in picture.figure.axes[0].get_lines()
                  if l.get_markerfacecolor() == "white" and l.get_color() != style.MUTED]
        self.assertEqual([list(l.get_xdata()) for l in dashed], [[1, 2, 4, 8, 16]])
        self.assertTrue(all(l.get_linestyle() == "--" for l in dashed))

    def test_the_error_of_the_model(self):
        family = self.points(self.results())
        at = {m.n: m for m in family.models}
        self.assertAlmostEqual(speedup_text.error(at[2], family.points), 100 * (60 / 54 - 1))
        self.assertIsNone(speedup_text.error(at[4], family.points))
        self.assertIn("S(2) differs from the measured one by +11.1 %",
                      speedup_text.modelled(family))
        conditions = speedup_text.conditions(family)
        self.assertIn("12.5 GB/s for one of them, 19 GB/s for all", conditions)
        self.assertIn("800 ns", conditions)
        header, rows = speedup_text.table(family)
        line = next(r for r in rows if r[1] == "cells" and r[2] == "modelled" and r[3] == "2")
        self.assertEqual(line[header.index("model's error")], "+11.1 %")
        self.assertEqual(line[header.index("t_1 / t_s")], "1.02")
        ones = {r[1]: r[header.index("t_1 / t_s")] for r in rows if r[2] == "measured"}
        self.assertEqual(ones, {"copy": "9.00", "active": "1.10", "cells": "1.05"})

    def test_no_modelled_rows(self):
        data = parallel_bench()
        data["benchmarks"] = [r for r in data["benchmarks"] if "modelled" not in r["name"]]
        status, errors, page = self.run_report("--bench", self.write("b.json", data),
                                               "--formats", "png")
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("without modelled rows", page)
        self.assertNotIn("odelled, not measured", page)

    def test_modelled_rows_only(self):
        data = parallel_bench()
        data["benchmarks"] = [r for r in data["benchmarks"] if "sequential" in r["name"]
                              or "modelled" in r["name"]]
        family = self.points(load.read_bench([self.write("b.json", data)]))
        self.assertEqual((family.points, len(family.models)), ([], 5))
        text = speedup_text.sentence(family)
        self.assertIn("no speed-up measured here can be trusted", text)
        self.assertIn("could not be checked", text)

    def test_high_load_is_flagged(self):
        data = parallel_bench()
        for item in data["benchmarks"]:
            if "strategy:active" in item["name"]:
                item["load"] = 3.5
        family = self.points(load.read_bench([self.write("b.json", data)]))
        self.assertEqual({p.row.label for p in family.points if p.doubtful}, {"active"})
        header, rows = speedup_text.table(family)
        self.assertEqual({r[-1] for r in rows if r[1] == "active"}, {"load 3.5"})
        self.assertIn("2 of 6 points (half filled)", speedup_text.sentence(family))
        for item in data["benchmarks"]:
            item["load"] = 3.5 if "sequential" in item["name"] else 0.1
        family = self.points(load.read_bench([self.write("b.json", data)]))
        self.assertTrue(all(p.flags() == ["sequential run: load 3.5"] for p in family.points))

    # Where the time goes.

    def test_uses_add_up_to_the_time_of_all_threads(self):
        # Made by hand: 4 threads, 6 us serial, 294 us of work, 100 us wall in parallel sections.
        measurement = load.Measurement("", "", [], {}, [], {
            "serial_share": [6 / 300], "busy_share": [294 / 400]})
        made = series.Row("scaling_step", 1, "cells", 4, 0, (), [106.0], False, measurement)
        spent = breakdown.uses(made)
        for key, value in (("work", 294), ("serial", 6), ("idle", 18), ("waiting", 106)):
            self.assertAlmostEqual(spent[key], value)
        self.assertAlmostEqual(sum(spent.values()), 4 * 106)

    def test_breakdown_says_the_shares(self):
        picture = next(breakdown.draw(self.results()))
        for part in ("one thread spends 70 % of a step of 100 µs on mesh update",
                     "5.0 % on later colours and 2.0 % serially", "modelled on 16 threads"):
            self.assertIn(part, picture.details)
        self.assertEqual([(r[2], r[3]) for r in picture.rows], [
            ("1", "measured"), *((n, "modelled") for n in ("2", "4", "8", "16"))])
        plt.close(picture.figure)

    # How much work threads need.

    def test_where_threads_begin_to_pay(self):
        results = self.results()
        points = [p for p in series.speedups(series.rows(results)) if p.n > 1]
        line = granularity.judged(points, 2)
        self.assertEqual([p.s for p in line], [0.5, 1.5, 1.6])
        value, crossed = granularity.threshold(line)
        self.assertTrue(crossed)
        self.assertAlmostEqual(value, 20 * math.sqrt(2))
        self.assertEqual(granularity.threshold(line[1:]), (40, False))
        self.assertIsNone(granularity.threshold(line[:1]))
        picture = next(granularity.draw(results))
        self.assertIn("pay, S(2) > 1, from 28.3 µs of sequential work a step on",
                      picture.details)
        self.assertEqual(picture.figure.axes[0].get_xscale(), "log")
        plt.close(picture.figure)

    def test_granularity_has_its_own_picture_only(self):
        results = self.results()
        self.assertEqual([f.name for f in speedup.gather(results, {})], ["scaling_step"])
        self.assertNotIn("many sizes", step_cost.draw(results, {})[0].sentence)

    # Whole runs.

    def test_whole_runs_are_held_against_those_with_as_much_other_work(self):
        rows = []
        for between, sequential, cells in ((0, 100, 50), (1000, 130, 100)):
            of = "scaling_run/strategy:{}/triangles:28000/{}between_us:" + str(between)
            of += "/iterations:1/manual_time"
            counters = {"construction_us": 500 + between, "first_step_us": 70}
            rows += row(of.format("sequential", ""), [sequential] * 3, **counters)
            rows += row(of.format("cells", "threads:2/"), [cells, cells - 10, cells + 10],
                        **counters)
        results = load.read_bench([self.write("bench.json", {
            **parallel_bench(), "benchmarks": rows})])
        points = sorted(whole_runs.points(results), key=lambda p: whole_runs.between(p.row))
        self.assertEqual([(whole_runs.between(p.row), p.s) for p in points],
                         [(0, 2.0), (1000, 1.3)])
        self.assertEqual(series.rows(results), [])
        picture = next(whole_runs.draw(results))
        self.assertIn("2.00 (scaling of a circle", picture.sentence)
        self.assertIn("S(2) is 1.30 to 2.00", picture.details)
        self.assertIn("500 µs to 1.50 ms", picture.details)
        self.assertEqual([t.get_text() for t in picture.figure.axes[0].get_xticklabels()],
                         ["0", "1,000"])
        plt.close(picture.figure)
        self.assertEqual(list(whole_runs.draw(self.results())), [])

    # Copies.

    def test_copies_beside_work_in_place(self):
        sentence, header, rows = copies.table(self.results())
        self.assertIn("8.57 times as long as active", sentence.replace("8.18 to ", ""))
        self.assertIn("8.57 to 10.0 times as long as cells", sentence)
        line = next(r for r in rows if r[2] == "2")
        self.assertEqual(line[header.index("copy / sequential")], "6.00")
        self.assertEqual(line[header.index("copy / cells")], "10.0")

    # Submeshes.

    def frames(self, division=None):
        self.write("frames/swirl_cells_00000.vtu", VTU.format(x=1))
        path = self.write("frames/swirl_cells_00007.vtu", VTU.format(x=1.5))
        if division is not None:
            self.write("frames/swirl_cells_00007.submeshes.json", division)
        return os.path.dirname(path)

    def test_ownership(self):
        points = numpy.array([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0], [0.2, 3.0]])

        def owned(**keys):
            path = self.write("s.json", {"colours": [{"regions": [box(**keys)]}]})
            return list(submeshes.owns(load_frames.read_submeshes(path)[0][0], points))

        self.assertEqual(owned(low=0.5), [False, True, True, False])
        self.assertEqual(owned(high=0.5), [True, False, False, True])
        self.assertEqual(owned(low=0.9, high=0.4), [True, False, True, True])
        # w = nx y - ny x; for the normal (0, 1) it is -x.
        self.assertEqual(owned(side_low=0.5, side_high=2), [False, False, True, False])
        self.assertEqual(owned(normal=(0.0, 1.0), side_high=-0.4), [False, True, True, False])

    def test_a_triangle_belongs_where_all_its_vertices_do(self):
        found = submeshes.read(self.frames(DIVIDED))
        self.assertEqual([(d.scene, d.strategy, d.number) for d in found], [("swirl", "cells", 7)])
        division = found[0]
        # Triangles of the square: bottom, right, top, left; the middle vertex is at x = 1.5.
        self.assertEqual([list(submeshes.owners(c, division.frame)) for c in division.colours],
                         [[-1, 1, -1, -1], [-1, -1, 1, -1], [0, 0, 0, 0]])
        text = submeshes.sentence(division)
        for part in ("2 submeshes with 3.00 µs to 5.00 µs", "1.25 times the mean",
                     "3 of 4 triangles (75.0 %) straddle", "20.0 % of the work is left"):
            self.assertIn(part, text)
        self.assertEqual([r[:3] for r in submeshes._table(division)[1]][:3],
                         [["1", "1", "0"], ["1", "2", "1"], ["1", "straddling", "3"]])

    def test_boundaries_are_finite(self):
        path = self.write("s.json", DIVIDED)
        cuts = [submeshes.boundaries(r, 9) for c in load_frames.read_submeshes(path) for r in c]
        self.assertEqual(cuts, [[((0.5, -9), (0.5, 9))]] * 2 + [[((9, 0.5), (-9, 0.5))]] * 2
                         + [[]])

    def test_submeshes_are_drawn(self):
        picture = next(submeshes.draw(submeshes.read(self.frames(DIVIDED))))
        titles = [a.get_title(loc="left") for a in picture.figure.axes]
        self.assertIn("colour 1: 2 submeshes, 8.00 µs\n3 triangles straddle", titles)
        self.assertIn("colour 3: the whole mesh, 500 ns\n0 triangles straddle", titles)
        self.assertTrue(any(t.startswith("close-up of colour 1") for t in titles))
        self.assertIn("measured work of the submesh (µs)",
                      [a.get_ylabel() for a in picture.figure.axes])
        plt.close(picture.figure)

    def test_one_submesh_has_no_close_up(self):
        alone = {"colours": [{"regions": [{"kind": "whole", "work_us": 0}]}]}
        picture = next(submeshes.draw(submeshes.read(self.frames(alone))))
        self.assertEqual(sum("close-up" in a.get_title(loc="left")
                             for a in picture.figure.axes), 0)
        plt.close(picture.figure)

    def test_frames_without_submeshes(self):
        folder = self.frames()
        self.assertEqual(submeshes.read(folder), [])
        status, errors, page = self.run_report("--frames", folder, "--formats", "png")
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("No frame was written together with its submeshes.", page)

    def test_bad_submeshes(self):
        folder = self.frames({"colours": [{"regions": [dict(box(), kind="star")]}]})
        self.assert_refused(["--frames", folder], "star", "box or whole", "region 0 of colour 0")
        folder = self.frames({"colours": [{"regions": [box(normal=(2.0, 0.0))]}]})
        self.assert_refused(["--frames", folder], "vector of length 1")
        folder = self.frames({"colours": [{"regions": [dict(box(), low="left")]}]})
        self.assert_refused(["--frames", folder], "low", "finite number")
        self.assert_refused(["--frames", self.frames({"colours": []})], "no region")

    # The whole report.

    def test_every_picture_is_in_the_report(self):
        words = ["--bench", self.write("bench.json", parallel_bench()), "--frames",
                 self.frames(DIVIDED), "--published", PUBLISHED, "--formats", "png,svg"]
        status, errors, page = self.run_report(*words)
        self.assertEqual((status, errors), (0, ""))
        out = os.listdir(os.path.join(self.folder, "out"))
        for picture in ("speedup_scaling_of_a_circle", "breakdown_scaling_of_a_circle",
                        "granularity", "submeshes_swirl_cells", "frames_swirl_cells"):
            self.assertIn(f"{picture}.png", out)
            self.assertEqual(f"{picture}.svg" in out, "swirl" not in picture,
                             "a mesh of many triangles is no vector graphic")
        for section in ("speedup", "breakdown", "granularity", "copies", "submeshes"):
            self.assertRegex(page, f'<(section|details class="part") id="{section}">')
        self.assertIn("copy / cells", page)
        found = 0
        for line in re.findall(r"<tr>.*?</tr>", page):
            if ">cells</td>" in line and re.search(r'<td class="n[^>]*>(8|16)</td>', line):
                self.assertIn("modelled", line)
                found += 1
        self.assertGreater(found, 0)

    def test_few_figures_are_open_at_a_time(self):
        for k in range(3):  # two pictures each
            self.write(f"frames/scene{k}_cells_00000.vtu", VTU.format(x=1))
            self.write(f"frames/scene{k}_cells_00000.submeshes.json", DIVIDED)
        most, save = [], style.save

        def counting(*words, **more):
            most.append(len(plt.get_fignums()))
            return save(*words, **more)

        style.save = counting
        self.addCleanup(setattr, style, "save", save)
        plt.close("all")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.run_report("--frames", os.path.join(self.folder, "frames"), "--formats", "png")
        self.assertEqual((len(most), max(most), plt.get_fignums()), (6, 1, []))

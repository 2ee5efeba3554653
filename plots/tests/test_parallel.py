# SPDX-License-Identifier: MIT
"""Tests of the pictures of parallel runs: modelled rows, breakdown, granularity, submeshes."""
import math
import os

import numpy

import breakdown
import granularity
import operations
import speedup
import step_cost
import submeshes
from look import style
from results import load, load_frames, series
from tests.samples import DIVIDED, PUBLISHED, Case, box, name, parallel_bench, row


class Parallel(Case):
    def results(self, **changes):
        return self.read_bench(parallel_bench(), **changes)

    # Modelled rows.

    def test_modelled_rows_are_never_measured_ones(self):
        results = self.results()
        self.assertFalse(any(r.modelled for r in series.rows(results)))
        self.assertEqual({r.threads for r in series.rows(results)}, {1, 2})
        models = series.modelled(results)
        self.assertTrue(all(r.modelled and not r.oversubscribed for r in models))
        self.assertEqual(series.speedups(models), [], "a model is no base, and has none beside it")
        # Of several numbers of submeshes, the fastest is used.
        fastest = {r.threads: (r.median, r.submeshes) for r in models}
        self.assertEqual(fastest[8], (16, 8))
        self.assertEqual(sorted(fastest), [1, 2, 4, 8, 16])
        # The counter alone also marks rows as modelled.
        found = self.results(change=lambda row: row.update(
            {key: row[key].replace("/modelled:1", "/kind:m") for key in ("name", "run_name")}))
        self.assertEqual({r.threads for r in series.rows(found)}, {1, 2})

    def test_pictures_of_measured_rows_leave_modelled_ones_out(self):
        with_model = self.results()
        without = self.results(keep=lambda row: "modelled" not in row["name"])
        for draw in (lambda b: step_cost.draw(b, {}), granularity.draw,
                     lambda b: operations.draw(b, {})):
            one, two = draw(with_model), draw(without)
            self.assertEqual([(p.sentence, p.rows) for p in one], [(p.sentence, p.rows) for p in two])
        self.assertEqual(list(breakdown.draw(without)), [])

    def test_speedups_measured_and_modelled(self):
        picture = speedup.draw(self.results(), load.read_published(PUBLISHED))[1]
        kind, threads = (picture.header.index(k) for k in ("kind", "threads"))
        ours = [r for r in picture.rows if r[-1] != "another program"]
        self.assertEqual({r[kind] for r in ours if int(r[threads]) > 2}, {"modelled"})
        self.assertEqual(sum(r[kind] == "measured" for r in ours), 6)
        labels = [t.get_text() for t in picture.figure.legends[0].get_texts()]
        for label in ("cells, modelled", "trinity, published", "busy, as measured",
                      "bound by the serial share (Amdahl)"):
            self.assertIn(label, labels)
        words = " ".join(t.get_text() for t in picture.figure.texts)
        self.assertIn("modelled, not measured", words)
        self.assertIn("12.5 GB/s for one core, 19 for all", words)
        for part in ("S(2) = 1.67, S(2) / 2 = 0.83, U(2) = 0.90", "hollow points are modelled"):
            self.assertIn(part, picture.sentence)
        axes = picture.figure.axes[0]
        hollow = [l for l in axes.get_lines()
                  if l.get_markerfacecolor() == "white" and l.get_color() != style.MUTED]
        self.assertEqual([list(l.get_xdata()) for l in hollow], [[1, 2, 4, 8, 16]])
        # Measured points are not joined: each is a line of one point.
        joined = [l for l in axes.get_lines() if l.get_marker() not in ("None", "", None)
                  and len(l.get_xdata()) > 1]
        self.assertEqual(joined, hollow)
        line = next(r for r in picture.rows if r[:4] == ["28,000 triangles", "cells", "modelled", "2"])
        self.assertEqual(line[picture.header.index("model's error")], "+11.1 %")

    def test_utilisation_is_drawn_beside_s_over_n(self):
        picture = speedup.draw(self.results(), {})[1]
        lower = picture.figure.axes[1]
        busy = [y for line in lower.get_lines() if line.get_markersize() == 13 for y in line.get_ydata()]
        self.assertEqual(sorted(busy), [0.9] * 3 + [1] * 3)
        self.assertIn("$U(n)$ = busy time / ($n\\,\\cdot$ wall time)", lower.get_ylabel())
        found = {r[1]: r for r in picture.rows if r[2:4] == ["measured", "2"]}
        for name, text in (("used", "2"), ("U(n)", "0.90"), ("serial share", "10.0%")):
            self.assertEqual(found["cells"][picture.header.index(name)], text)
        share = speedup.amdahl(speedup.gather(self.results(), {})[0].points)
        self.assertEqual(share, {"cells": 0.1, "active": 0.1, "copy": 0.1})

    def test_modelled_rows_only(self):
        found = self.results(keep=lambda row: "sequential" in row["name"] or "modelled" in row["name"])
        family = speedup.gather(found, {})[0]
        self.assertEqual((family.points, len(family.models)), ([], 5))
        self.assertIn("nothing was measured with several threads", speedup.plain(family))

    def test_high_load_is_flagged(self):
        def load_of(strategy):
            return self.results(change=lambda row: row.update(
                load=3.5 if f"strategy:{strategy}" in row["name"] else 0.1))

        points = speedup.gather(load_of("active"), {})[0].points
        self.assertEqual({p.row.label for p in points if p.doubtful}, {"active"})
        points = speedup.gather(load_of("sequential"), {})[0].points
        self.assertTrue(all(p.flags() == ["sequential run: load 3.5"] for p in points))

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
        picture = next(breakdown.draw(self.results()))
        self.assertIn("is the mesh update, with 70 % of the time", picture.sentence)
        self.assertEqual([(r[2], r[3]) for r in picture.rows], [
            ("1", "measured"), *((n, "modelled") for n in ("2", "4", "8", "16"))])

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
        self.assertIn("more than 28.3 µs on one thread", granularity.draw(results)[0].sentence)
        self.assertEqual([f.name for f in speedup.gather(results, {})], ["scaling_step"])

    def test_each_strategy_has_a_symbol_of_its_own(self):
        data = parallel_bench()
        data["benchmarks"] += row(name("active", 7000, 2, family=series.GRANULARITY), [30])
        results = self.read_bench(data, lambda row: row["name"].startswith(series.GRANULARITY))
        (picture,) = granularity.draw(results)
        symbols = {line.get_marker() for line in picture.figure.axes[0].lines} - {"None", "_", "|", ""}
        self.assertEqual(symbols, {style.look("cells")[1], style.look("active")[1]})

    # Whole runs.

    def test_whole_runs_are_held_against_those_with_as_much_other_work(self):
        picture = speedup.draw(self.results(), {})[0]
        self.assertEqual(picture.name, "speedup_scaling_run")
        s, label = (picture.header.index(k) for k in ("S(n)", "strategy"))
        self.assertEqual([(r[label], r[s]) for r in picture.rows],
                         [("cells (0 µs between steps)", "2.00"), ("cells (1000 µs between steps)", "1.30")])
        self.assertEqual([p.s for p in series.undisturbed(self.results())], [2.0])

    # Submeshes.

    def divided(self, division):
        self.write("frames/swirl_cells_00007.submeshes.json", division)
        return self.frames("swirl_cells", {0: 1, 7: 1.5})

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
        (division,) = submeshes.read(self.divided(DIVIDED))
        self.assertEqual((division.scene, division.strategy, division.number), ("swirl", "cells", 7))
        # Triangles of the square: bottom, right, top, left; the middle vertex is at x = 1.5.
        self.assertEqual([list(submeshes.owners(c, division.frame)) for c in division.colours],
                         [[-1, 1, -1, -1], [-1, -1, 1, -1], [0, 0, 0, 0]])
        cuts = [submeshes.boundaries(r, 9) for c in division.colours for r in c]
        self.assertEqual(cuts, [[((0.5, -9), (0.5, 9))]] * 2 + [[((9, 0.5), (-9, 0.5))]] * 2 + [[]])
        picture = next(submeshes.draw([division]))
        self.assertIn("2 submeshes, of which the one with the most work has 1.25 times", picture.sentence)
        self.assertEqual([r[:3] for r in picture.rows][:3],
                         [["1", "1", "0"], ["1", "2", "1"], ["1", "straddling", "3"]])
        titles = [a.get_title(loc="left") for a in picture.figure.axes]
        self.assertIn("colour 1: 2 submeshes, 8.00 µs\n3 triangles on boundaries", titles)
        self.assertIn("colour 3: the whole mesh, 500 ns\n0 triangles on boundaries", titles)

    def test_frames_without_submeshes_and_bad_ones(self):
        for change, words in ((dict(kind="star"), ("star", "box or whole", "region 0 of colour 0")),
                              (dict(normal=[2.0, 0.0]), ("vector of length 1",)),
                              (dict(low="left"), ("low", "finite number"))):
            folder = self.divided({"colours": [{"regions": [{**box(), **change}]}]})
            self.assert_refused(["--frames", folder], *words)
        self.assert_refused(["--frames", self.divided({"colours": []})], "no region")
        os.remove(os.path.join(folder, "swirl_cells_00007.submeshes.json"))
        page = self.run_report("--frames", folder, "--formats", "png")[2]
        self.assertIn("No frame was written together with its submeshes.", page)

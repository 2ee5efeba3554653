# SPDX-License-Identifier: MIT
"""Tests of the page itself: findings, verdicts, tables, parts."""
import pathlib
import re

from PIL import Image

import film
import space
from page import comparison, contents, document, findings, verdicts
from results import load
from tests.samples import PUBLISHED, Case, bench, hard_cases, name, row, scene, verify


class Words(Case):
    def results(self, **change):
        found = {"bench": None, "scenes": [], "precision": [], "hard": None, "verify": None,
                 "published": load.read_published(PUBLISHED), "frames": None, "runs": [],
                 "divided": [], "files": []}
        return {**found, **change}

    def scenes(self, *runs):
        return [load.read_scene(self.write(f"s{k}.json", run)) for k, run in enumerate(runs)]

    def verify(self, change=lambda data: None):
        data = verify()
        change(data)
        return load.read_verify([self.write("verify.json", data)])

    # Five sentences.

    def test_without_results_each_sentence_says_so(self):
        for text in findings.sentences(self.results()):
            self.assertRegex(text, r"^(No|Nothing) .*\.$|^The .* was not run, so .*nothing.*\.$")
        self.assertEqual(len(findings.sentences(self.results())), 5)

    def test_lost_vertices_are_named_first(self):
        good, bad = scene(0.01, 1e-3, 1), {**scene(0.01, 1e-3, 1), "scene": "t1", "unreached": 2}
        self.assertIn("2 runs of 1 scene no triangle", findings.meshes(self.scenes(good, good)))
        self.assertEqual(findings.meshes(self.scenes(good, bad)),
                         "In 1 of 2 runs triangles were inverted or vertices did not arrive: t1.")

    def test_the_swirl_with_the_finest_edges_is_told(self):
        runs = self.scenes(scene(0.01, 1e-3, 1), {**scene(0.005, 2e-4, 2), "area_ratio": 1.002})
        text = findings.shape(runs, self.results()["published"])
        self.assertIn("ends with 0.20 % more area than it had, and 0.020 % of it in the wrong", text)
        self.assertIn("in the thesis it ended with 0.51 % less", text)
        self.assertIn("says nothing", findings.shape([], {}))

    def test_a_step_beside_the_literal_method(self):
        self.assertEqual(findings.step(self.read_bench(bench())),
                         "One time step of a growing circle in a mesh of 28,000 triangles takes 110 µs "
                         "on one thread; a literal implementation of the thesis's method takes 220 ms, "
                         "2,000 times as long.")

    def test_threads_of_whole_runs_beside_the_thesis(self):
        data = bench()
        # The finding is about whole runs, not about warm steps, which gain more.
        self.assertIn("No whole run", findings.threads(self.read_bench(data), {}))
        for strategy, threads, between, times in (("sequential", 0, 0, [300, 310, 320]),
                                                  ("sequential", 0, 5000, [900, 900, 900]),
                                                  ("cells", 2, 0, [200, 210, 190]),
                                                  ("cells", 2, 5000, [100, 100, 100]),
                                                  ("cells", 1, 0, [310, 310, 310])):
            data["benchmarks"] += row(name(strategy, 28000, threads, family="scaling_run",
                                           between_us=between), times)
        text = findings.threads(self.read_bench(data), self.results()["published"])
        self.assertEqual(text, "With 2 threads a whole run of the same scene is 1.55 times as fast "
                         "at 28,000 triangles; the thesis measured 1.47 on its own machine.")
        for one in data["benchmarks"]:
            one["load"] = 1.5
            if "threads:2" in one["name"]:
                one.update(real_time=620, us_per_step=620)
        disturbed = self.read_bench(data)
        self.assertIn("2.00 times as slow", findings.threads(disturbed, {}))
        for text in (findings.threads(disturbed, {}), findings.step(disturbed)):
            self.assertIn("other programs were busy", text)

    def test_limits_that_break_are_named(self):
        self.assertEqual(findings.limits(self.verify()),
                         "All 2 figures that the gate compared with limits are within them.")
        broken = self.verify(lambda data: data["checks"][0].update(verdict="fail"))
        self.assertIn("1 of 2 figures", findings.limits(broken))
        self.assertIn("area drift (swirl)", findings.limits(broken))
        part = self.verify(lambda data: data.update(not_run=[{"check": "other"}]))
        self.assertIn("; 1 check of the gate was not run.", findings.limits(part))

    # The table of verdicts.

    def table(self, **change):
        header, rows, classes = verdicts.verdicts(self.results(**change))
        return {row[header.index("what")]: row[0] for row in rows}, rows, classes

    def test_what_was_not_run_has_no_verdict(self):
        found, rows, classes = self.table()
        self.assertEqual(set(found.values()), {"not run"})
        self.assertEqual(set(classes.values()), {"open"})
        self.assertGreaterEqual(len(rows), 5)

    def test_failures_come_first(self):
        bad = hard_cases()
        bad[0]["holds"] = False
        _, rows, _ = self.table(hard=bad, verify=self.verify())
        self.assertEqual([row[0] for row in rows],
                         ["✗ fail"] + ["✓ pass"] * 2 + ["not run"] * 3)
        self.assertEqual(rows[0][2], "1 of 2 hold")

    def test_a_row_shows_the_worst_of_its_scenes(self):
        def more(data):
            drift = data["checks"][0]
            drift["description"] = "area against the exact one"
            data["checks"] += [{**drift, "scene": "near", "measured": 9e-5},
                               *({**drift, "scene": scene, "measured": value, "limit": 20,
                                  "sense": ">=", "check": "least angle"}
                                 for scene, value in (("a", 40), ("b", 25), ("c", 30)))]
        found, rows, _ = self.table(verify=self.verify(more))
        self.assertIn("Area against the exact one, 2 scenes", found)
        self.assertIn(["✓ pass", "Area against the exact one, 2 scenes", "9.00e-5 (near)",
                       "at most 1.00e-4"], rows)
        self.assertIn(["25 (b)", "at least 20"], [row[2:] for row in rows])

    def test_a_broken_limit_is_the_worst_of_its_scenes(self):
        def more(data):
            data["checks"].append({**data["checks"][0], "scene": "t1", "measured": None,
                                   "verdict": "fail"})
        _, rows, _ = self.table(verify=self.verify(more))
        self.assertEqual(rows[0][::2], ["✗ fail", "– (t1)"])

    def test_a_refused_benchmark_fails(self):
        found, _, _ = self.table(bench=self.read_bench(bench()))
        self.assertEqual(found["Answers checked before they were timed"], "✗ fail")

    # The comparison.

    def test_each_figure_stands_beside_its_band(self):
        def more(data):
            one = {"verdict": "pass", "unit": "1", "sense": "<="}
            data["checks"] = [
                {**one, "check": "area_ratio", "scene": "t1", "measured": 0.0045, "limit": 0.005},
                {**one, "check": "parallel_area_histogram", "scene": "swirl", "measured": 0.05,
                 "limit": 0.03, "verdict": "fail", "strategy": "cells"},
                {**one, "check": "parallel_min_quality", "scene": "swirl", "measured": 0.4,
                 "limit": 0.26, "sense": ">=", "strategy": "active"},
                {**one, "check": "reference_area", "scene": "swirl", "measured": None,
                 "limit": 0.01, "verdict": "fail"}]
        text = comparison.section(self.results(verify=self.verify(more)))
        for words in ("Against the exact shape: 1 scene, all limits hold.", "0.0045 of 0.0050",
                      "0.050 of 0.030, cells", "0.40, at least 0.26, active", "– of 0.010",
                      "against the sequential run: 1 scene, 1 with a limit that is broken."):
            self.assertIn(words, text)
        self.assertEqual(comparison.section(self.results()), "")

    # Tables.

    def test_cells_have_values_in_one_unit(self):
        for text, value in (("117 µs", 117e-6), ("1.18 ms", 1.18e-3), ("2,800,000", 2.8e6),
                            ("1/128", 1 / 128), ("-0.5 %", -0.5), ("+11.1 %", 11.1),
                            ("2.5e-4", 2.5e-4), ("0 in 19 runs", 0), ("–", None),
                            ("✓ pass", None), ("cells", None), ("swirl 2", None)):
            found = document.value_of(text)
            self.assertEqual(found is None, value is None, text)
            if value is not None:
                self.assertAlmostEqual(found, value, msg=text)

    def test_columns_of_numbers_carry_values(self):
        text = document.table(["name", "time", ""], [["a", "2.00 ms", "x"], ["b", "30 µs", ""],
                                                     ["c", "–", "3"]])
        self.assertEqual(re.findall(r'data-v="([^"]*)"', text), ["0.002", "3e-05", "NaN"])
        self.assertEqual(text.count('aria-sort="none"><button type="button">'), 3)
        self.assertIn(">remarks</button>", text)

    def test_texts_are_escaped(self):
        text = document.table(["<a>"], [["<b>"]], name='"c"') + document.paragraph("<d>")
        for word in ("<a>", "<b>", '""c""', "<d>"):
            self.assertNotIn(word, text)

    # Parts.

    def test_a_film_has_its_place(self):
        Image.new("RGB", (12, 8)).save(self.write("out/bubbles.webp", ""))
        text = film.section(pathlib.Path(self.path("out")))
        for word in ("data:image/webp;base64,", "max-width:12px"):
            self.assertIn(word, text)
        self.assertEqual(film.section(pathlib.Path(self.folder)), "")

    def test_three_dimensions_have_their_place(self):
        self.assertEqual(space.section(self.path("out")), "")
        self.write("out/enright-16.json", {
            "parameters": {"h": 0.0625}, "interface_vertices_max": 1234, "sd_rel_last": 0.06,
            "sd_rel_half": 0.2, "volume_ratio": 1.017, "vertex_error_rms": 0.00625, "unreached": 0,
            "min_dihedral_deg_ever": 0.8, "cpu_s": 1.9, "us_per_vertex_and_sub_step": 20.0})
        Image.new("RGB", (8, 8)).save(self.path("out/enright.png"))
        text = space.section(self.path("out"))
        for word in ("data:image/webp;base64,", "1/16", "1,234", "6.000 %", "0.100 h", "El Topo",
                     "CPU time against vertices"):
            self.assertIn(word, text)

    def test_the_gallery_has_its_place(self):
        self.write("out/gallery/section.html", "<p>drawn</p>")
        found = contents.build(self.results(), {}, self.path("out"))
        self.assertEqual([words[0] for words in found[:4]], ["found", "compared", "frames", "thesis"])
        self.assertEqual(found[3][2], "<p>drawn</p>")
        self.assertNotIn("thesis", [w[0] for w in contents.build(self.results(), {}, "out")])

    def test_results_are_linked(self):
        words = ["--hard", self.write("out/hard.json", hard_cases()),
                 "--verify", self.write("elsewhere.json", verify()), "--formats", "png"]
        page = self.run_report(*words)[2]
        self.assertIn('<a href="hard.json">hard.json</a>', page)
        self.assertNotIn('href="../', page)
        self.assertIn("<li>elsewhere.json</li>", page)

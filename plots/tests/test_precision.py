# SPDX-License-Identifier: MIT
"""Tests of the diagrams of error against time, of the orders of convergence and of the table of
hard cases, with made-up results whose answers are known."""
import math

from accuracy import convergence
from accuracy import hard_cases
from results import load
from accuracy import precision
from accuracy import precision_data as data
from accuracy import precision_text
from tests.samples import PUBLISHED, Case
from tests.samples import hard_cases as cases
from tests.samples import precision_run, precision_runs


class Precision(Case):
    def read(self, *runs):
        return [data.read(self.write(f"p{k}.json", run)) for k, run in enumerate(runs)]

    def lines(self, *runs):
        return next(iter(data.flows(self.read(*runs)).values()))

    # Numbers.

    def test_time_between_points_is_straight_in_logarithms(self):
        line = self.lines(precision_run("swirl-260", "default", 0.02, 1e-2, 1),
                          precision_run("swirl-260", "default", 0.01, 1e-4, 100))["default"]
        self.assertAlmostEqual(data.time_at(line, 1e-3), 10)
        self.assertAlmostEqual(data.time_at(line, 1e-2), 1)
        self.assertIsNone(data.time_at(line, 2e-2))
        self.assertIsNone(data.time_at(line, 9e-5))

    def test_time_to_an_error_counts_points_below_it(self):
        line = self.lines(precision_run("swirl-260", "default", 0.02, 1e-2, 1),
                          precision_run("swirl-260", "default", 0.01, 1e-4, 100))["default"]
        self.assertAlmostEqual(data.time_to(line, 1e-3), 10)
        self.assertAlmostEqual(data.time_to(line, 0.5), 1)
        self.assertIsNone(data.time_to(line, 9e-5))

    def test_a_line_that_turns_back_passes_at_the_least_time(self):
        errors = ((0.04, 1e-2, 1), (0.02, 1e-3, 10), (0.01, 1e-2, 100))
        line = self.lines(*(precision_run("swirl-260", "default", *e) for e in errors))["default"]
        self.assertAlmostEqual(data.time_at(line, 10 ** -2.5), 10 ** 0.5)

    def test_orders_are_fitted_with_their_spread(self):
        lines = self.lines(*precision_runs())
        for method, expected in (("default", 2), ("euler", 1), ("fourth order", 4)):
            order = data.order(lines[method])
            for value in (order.fitted, order.low, order.high):
                self.assertAlmostEqual(value, expected)
            self.assertEqual(order.sizes, 4)
        # Orders 1, 2 and 3 from size to size: the least squares line through four points.
        uneven = self.lines(*(precision_run("swirl-260", "default", 2.0 ** -k, 2.0 ** -e, 1)
                              for k, e in ((1, 0), (2, 1), (3, 3), (4, 6))))["default"]
        order = data.order(uneven)
        self.assertEqual((round(order.low, 9), round(order.high, 9)), (1, 3))
        self.assertAlmostEqual(order.fitted, (-1.5 * 0 - 0.5 * 1 + 0.5 * 3 + 1.5 * 6) / 5)
        self.assertIsNone(data.order(uneven[:3]))

    def test_lines_run_from_coarse_to_fine_and_the_default_comes_first(self):
        lines = self.lines(*reversed(precision_runs()))
        self.assertEqual(list(lines), ["default", "euler", "fourth order", "markers, cubic"])
        self.assertEqual([r.h for r in lines["euler"]], [0.04, 0.02, 0.01, 0.005])

    def test_flows_have_their_order(self):
        flows = data.flows(self.read(*(precision_run(f, "default", 0.01, 1e-3, 1) for f in (
            "zalesak", "another", "swirl-260", "single-vortex-8"))))
        self.assertEqual(list(flows), ["single-vortex-8", "swirl-260", "zalesak", "another"])

    def test_lengths_for_people(self):
        self.assertEqual([data.length(h) for h in (0.0078125, 0.01, 0.04, 0.123, 1 / 96)],
                         ["1/128", "0.01", "0.04", "0.123", "1/96"])

    # Others beside ours.

    def test_peers_belong_to_their_flow_and_are_relative(self):
        published = load.read_published(PUBLISHED)

        def found(flow):
            return {p.tool: p.points for p in data.peers(flow, published)}

        area = published["single_vortex"]["area_exact"]
        self.assertEqual(sorted(found("single-vortex-8")), ["Basilisk", "Gerris", "isoAdvector",
                                                            "level set 512²", "official 2D DSC"])
        self.assertIn((5.24e-4 / area, 11.4), found("single-vortex-8")["Basilisk"])
        self.assertEqual(found("single-vortex-2")["Basilisk"], [(1.42e-4 / area, 0.37)])
        self.assertEqual(found("swirl-260"), {"official 2D DSC": [(0.054, 12.1), (0.0136, 67.8)]})
        self.assertEqual(found("swirl-420"), {"official 2D DSC": [(0.085, 20), (0.0204, 128)]})
        self.assertEqual(found("zalesak"), {"official 2D DSC": [(1e-6, 103)],
                                            "Basilisk": [(1.13e-2, 2.3)]})
        self.assertEqual(found("vortex-square"), {})
        self.assertEqual(found("unheard-of"), {})
        self.assertEqual(data.peers("swirl-260", {}), [])

    def test_errors_without_a_time_are_marks(self):
        published = load.read_published(PUBLISHED)
        labels = {m.label: m.errors for m in data.marks("single-vortex-8", published)}
        self.assertEqual(len(labels["volume of fluid 128²"]), 4)
        self.assertAlmostEqual(min(labels["volume of fluid 128²"]), 1.07e-3 / 0.0706858, places=6)
        self.assertEqual(data.marks("single-vortex-2", published), [])
        (thesis,) = data.marks("swirl-420", published)
        self.assertAlmostEqual(thesis.errors[0], 1 - 0.9698673)
        self.assertEqual(data.marks("zalesak", published)[0].errors, (8.74e-3, 1.09e-2, 8.38e-2))

    # Sentences.

    def test_sentence_compares_at_the_error_of_a_peer(self):
        lines = self.lines(*precision_runs())
        # Peers: 0.0136 after 67.8 s is within 0.016 to 0.00025; ours 16e-3 at 1/16 s.
        text = precision_text.sentence(lines, data.peers("swirl-260",
                                                         load.read_published(PUBLISHED)))
        mine = 0.0625 * 0.016 / 0.0136
        self.assertIn("At an error of 0.0136, that of official 2D DSC after 67.8 s, the default "
                      f"takes {mine * 1e3:.1f} ms, {67.8 / mine:.0f} times less", text)
        self.assertIn("bare markers at h = 0.005 err by 2.50e-4 in 40.0 ms, the mesh by 2.50e-4 "
                      "in 4.00 s", text)

    def test_sentence_says_where_we_are_slower(self):
        slow = data.Peer("other", points=[(1e-3, 0.1)])
        text = precision_text.against_peers(self.lines(*precision_runs())["default"], [slow])
        self.assertTrue(text.endswith("the default takes 1.00 s, 10 times as much"), text)

    def test_sentence_where_all_of_ours_are_better(self):
        rough = data.Peer("other", points=[(0.5, 7), (0.9, 3)])
        text = precision_text.against_peers(self.lines(*precision_runs())["default"], [rough])
        self.assertEqual(text, "Already at h = 0.04 the default errs by 0.0160 after 62.5 ms, "
                               "where other errs by 0.500 after 7.00 s")

    def test_sentence_out_of_range(self):
        fine = data.Peer("other", points=[(1e-9, 7)])
        text = precision_text.against_peers(self.lines(*precision_runs())["default"], [fine])
        self.assertIn("reaches 2.50e-4 in 4.00 s; other, with 1.00e-9", text)

    def test_what_others_print_is_not_compared_in_time(self):
        printed = data.Peer("other", False, [(1e-3, 0.1)])
        line = self.lines(*precision_runs())["default"]
        self.assertEqual(precision_text.against_peers(line, [printed]), "")

    def test_the_fastest_of_ours_is_named(self):
        # The fourth-order line begins below all of the default: its first point counts.
        text = precision_text.among_ours(self.lines(*precision_runs()))
        self.assertEqual(text, "of the 2 methods that reach 2.50e-4 at the end, fourth order "
                               "is the fastest: 188 ms, 21 times less than the default")

    def test_the_default_is_fastest_where_it_is(self):
        runs = precision_runs()
        for run in runs:
            if run["method"] == "fourth order":
                run["sd_rel_last"] = 10 * run["parameters"]["h"] ** 2
        text = precision_text.among_ours(self.lines(*runs))
        self.assertIn("none is faster than the default (4.00 s) by more than a tenth, and fourth "
                      "order takes 3.0 times as long", text)

    def test_broken_runs_are_named_and_crossed_out(self):
        runs = precision_runs()
        runs[5]["unreached"] = 3
        picture = precision.draw(self.read(*runs), {})[0]
        self.assertIn("In 1 run a triangle was inverted or a vertex did not arrive: euler.",
                      picture.details)
        crosses = [line for axes in picture.figure.axes for line in axes.lines
                   if line.get_marker() == "x"]
        self.assertEqual(len(crosses), 2)  # at the end and half-way
        self.assertEqual(list(crosses[0].get_xdata()), [10 * 0.02])

    def test_without_the_default_nothing_is_claimed(self):
        runs = [r for r in precision_runs() if r["method"] != "default"]
        picture = precision.draw(self.read(*runs), load.read_published(PUBLISHED))[0]
        self.assertIn("the default method was not run", picture.details)

    # Pictures.

    def test_each_group_has_its_row_and_each_moment_its_column(self):
        picture = precision.draw(self.read(*precision_runs()), {})[0]
        self.assertEqual(len(picture.figure.axes), 4)
        for axes in picture.figure.axes:
            self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        drawn = [sorted(t.get_text() for t in axes.get_legend().get_texts())
                 for axes in picture.figure.axes if axes.get_legend()]
        self.assertEqual(drawn, [["default", "fourth order", "markers, cubic"],
                                 ["default", "euler"]])
        self.assertEqual(len(picture.rows), 16)

    def test_nothing_lies_outside(self):
        picture = precision.draw(self.read(*precision_runs()), load.read_published(PUBLISHED))[0]
        for axes in picture.figure.axes:
            (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
            for line in axes.lines:
                if line.get_transform() == axes.transData:
                    for x, y in zip(*line.get_data()):
                        self.assertTrue(left < x < right and low < y < high, (x, y))

    def test_default_is_thicker_than_all_others(self):
        axes = precision.draw(self.read(*precision_runs()), {})[0].figure.axes[0]
        widths = sorted(line.get_linewidth() for line in axes.lines)
        self.assertGreater(widths[-1], 1.9 * widths[-2])

    def test_looks_of_a_panel_differ_in_colour_and_marker(self):
        groups = (("default", "euler", "centred", "midpoint", "adaptive"),
                  ("default", "linear insertion", "coarsening by length", "never coarsened"),
                  ("default", "fourth order", "float", "thesis's choice", "literal reference"))
        for names in groups:
            looks = [precision.LOOKS[name] for name in names]
            for part in zip(*looks):
                self.assertEqual(len(set(part)), len(names), names)

    def test_without_a_half_there_is_one_column(self):
        runs = [precision_run("zalesak", "default", h, h ** 4, 1 / h) for h in (0.02, 0.01)]
        picture = precision.draw(self.read(*runs), load.read_published(PUBLISHED))[0]
        self.assertEqual(len(picture.figure.axes), 1)
        self.assertIn("Already at h = 0.02", picture.details)

    def test_convergence_says_orders(self):
        picture = convergence.draw(self.read(*precision_runs()))[0]
        self.assertIn("2.0 (2.0 to 2.0; default) and 4.0 (4.0 to 4.0; fourth order)",
                      picture.details)
        self.assertIn(["swirl 260", "fourth order", "T/2", "4.00", "4.00", "4.00", "4"],
                      picture.rows)
        guides = [line for line in picture.figure.axes[0].lines
                  if len(line.get_xdata()) == 2]
        slopes = sorted(math.log(y[1] / y[0]) / math.log(x[1] / x[0])
                        for x, y in (g.get_data() for g in guides))
        self.assertAlmostEqual(slopes[0], 2)
        self.assertAlmostEqual(slopes[1], 4)

    def test_convergence_needs_four_sizes(self):
        runs = [r for r in precision_runs() if r["parameters"]["h"] > 0.005]
        self.assertEqual(convergence.draw(self.read(*runs)), [])

    # Bad input.

    def test_bad_results_are_refused(self):
        good = precision_run("swirl-260", "default", 0.01, 1e-3, 1)
        for change, words in (({"cpu_s": "fast"}, ("cpu_s", "fast")), ({"cpu_s": 0}, ("cpu_s",)),
                              ({"flow": 3}, ("flow",)), ({"parameters": {}}, ("'h'",)),
                              ({"sd_rel_last": None}, ("sd_rel_last",))):
            path = self.write("bad.json", {**good, **change})
            self.assert_refused(["--precision", path], "bad.json", *words)
        self.assert_refused(["--precision", self.write("cut.json", "{")], "cut.json", "truncated")

    # Hard cases.

    def test_hard_cases_are_a_table(self):
        page = self.run_report("--hard", self.write("hard.json", cases()))[2]
        self.assertIn("All 2 hard cases hold.", page)
        self.assertIn("refused: coordinates collide", page)
        self.assertIn("unreached 0, largest 0.00250", page)

    def test_a_hard_case_that_fails_is_named(self):
        failing = cases()
        failing[1].update(holds=False, failures=["1 inverted"], held=0, gave_up="", inverted=1,
                          error=0.5, error_is="area lost")
        text = hard_cases.table(hard_cases.read(self.write("hard.json", failing)))
        self.assertIn("1 of 2 hard cases does not hold: needle.", text)
        self.assertIn("✗ fails", text)
        self.assertIn("kept; fails: 1 inverted", text)
        self.assertIn(">inverted 1, area lost 0.500<", text)

    def test_bad_hard_cases_are_refused(self):
        self.assert_refused(["--hard", self.write("h.json", {})], "h.json", "list of cases")
        missing = cases()
        del missing[1]["holds"]
        self.assert_refused(["--hard", self.write("h.json", missing)], "holds", "case 1")
        self.assert_refused(["--hard", self.write("h.json", "[")], "h.json", "truncated")
        page = self.run_report("--hard", self.write("h.json", []))[2]
        self.assertIn("The list of hard cases is empty", page)

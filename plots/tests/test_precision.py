# SPDX-License-Identifier: MIT
"""Tests of the diagrams of error against time, of the orders of convergence and of the table of
hard cases, with made-up results whose answers are known."""
import math

import convergence
import precision
from page import hard_cases
from results import load
from results import precision_data as data
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
        errors = ((0.02, 1e-2, 1), (0.01, 1e-4, 100))
        line = self.lines(*(precision_run("swirl-260", "default", *e) for e in errors))["default"]
        self.assertAlmostEqual(data.time_at(line, 1e-3), 10)
        self.assertAlmostEqual(data.time_at(line, 1e-2), 1)
        self.assertIsNone(data.time_at(line, 2e-2))
        self.assertIsNone(data.time_at(line, 9e-5))
        # If a line crosses an error several times, the shortest time counts.
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

    def test_lines_and_flows_have_their_order(self):
        lines = self.lines(*reversed(precision_runs()))
        self.assertEqual(list(lines), ["default", "euler", "fourth order", "markers, cubic"])
        self.assertEqual([r.h for r in lines["euler"]], [0.04, 0.02, 0.01, 0.005])
        flows = data.flows(self.read(*(precision_run(f, "default", 0.01, 1e-3, 1) for f in (
            "zalesak", "another", "swirl-260", "single-vortex-8"))))
        self.assertEqual(list(flows), ["single-vortex-8", "swirl-260", "zalesak", "another"])
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
        self.assertEqual(found("swirl-420"), {"official 2D DSC": [(0.085, 20), (0.0204, 128)]})
        self.assertEqual(found("zalesak"), {"official 2D DSC": [(1e-6, 103)],
                                            "Basilisk": [(1.13e-2, 2.3)]})
        self.assertEqual(found("unheard-of"), {})
        self.assertEqual(data.peers("swirl-260", {}), [])
        marks = {m.label: m.errors for m in data.marks("single-vortex-8", published)}
        self.assertEqual(len(marks["volume of fluid 128²"]), 4)
        self.assertAlmostEqual(min(marks["volume of fluid 128²"]), 1.07e-3 / 0.0706858, places=6)
        (thesis,) = data.marks("swirl-420", published)
        self.assertAlmostEqual(thesis.errors[0], 1 - 0.9698673)

    def test_the_sentence_compares_at_the_error_of_a_peer(self):
        lines = self.lines(*precision_runs())
        # Peers: 0.0136 after 67.8 s is within 0.016 to 0.00025; ours 16e-3 at 1/16 s.
        text = precision.plain(lines, data.peers("swirl-260", load.read_published(PUBLISHED)))
        mine = 0.0625 * 0.016 / 0.0136
        self.assertIn("at an error of 0.0136, that of official 2D DSC after 67.8 s, the default "
                      f"takes {mine * 1e3:.1f} ms, {67.8 / mine:.0f} times less", text)
        slow = precision.plain(lines, [data.Peer("other", points=[(1e-3, 0.1)])])
        self.assertIn("the default takes 1.00 s, 10 times as much", slow)
        # Published times are not compared with ours.
        printed = precision.plain(lines, [data.Peer("other", False, [(1e-3, 0.1)])])
        self.assertIn("with edges of length 0.005 the default errs by 2.50e-4 after 4.00 s", printed)
        self.assertIn("was not run", precision.plain({"euler": lines["euler"]}, []))

    # Pictures.

    def test_broken_runs_are_named_and_crossed_out(self):
        runs = precision_runs()
        runs[5]["unreached"] = 3
        picture = precision.draw(self.read(*runs), {})[0]
        self.assertIn("a vertex did not arrive with euler.", picture.sentence)
        crosses = [line for axes in picture.figure.axes for line in axes.lines
                   if line.get_marker() == "x"]
        self.assertEqual(len(crosses), 2)  # at the end and half-way
        self.assertEqual(list(crosses[0].get_xdata()), [10 * 0.02])

    def test_each_group_has_its_row_and_each_moment_its_column(self):
        picture = precision.draw(self.read(*precision_runs()), load.read_published(PUBLISHED))[0]
        self.assertEqual(len(picture.figure.axes), 4)
        for axes in picture.figure.axes:
            self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
            (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
            for line in axes.lines:
                if line.get_transform() == axes.transData:
                    for x, y in zip(*line.get_data()):
                        self.assertTrue(left < x < right and low < y < high, (x, y))
        drawn = [t.get_text() for axes in picture.figure.axes if axes.get_legend()
                 for t in axes.get_legend().get_texts()]
        self.assertEqual([drawn.count(m) for m in ("default", "euler", "fourth order")], [2, 1, 1])
        self.assertEqual(len(picture.rows), 16)
        runs = [precision_run("zalesak", "default", h, h ** 4, 1 / h) for h in (0.02, 0.01)]
        self.assertEqual(len(precision.draw(self.read(*runs), {})[0].figure.axes), 1)
        exact = precision_run("zalesak", "default", 0.01, 0, 1)
        self.assertEqual(precision.draw(self.read(exact), {}), [])  # no logarithm shows it

    def test_looks_of_a_panel_differ_in_colour_and_marker(self):
        groups = (("default", "euler", "centred", "midpoint", "adaptive"),
                  ("default", "linear insertion", "coarsening by length", "never coarsened"),
                  ("default", "fourth order", "float", "thesis's choice", "literal reference"))
        for names in groups:
            for part in zip(*(precision.LOOKS[name] for name in names)):
                self.assertEqual(len(set(part)), len(names), names)

    def test_convergence_says_orders(self):
        picture = convergence.draw(self.read(*precision_runs()))[0]
        self.assertIn("divide the error of the default by 4.0 (swirl 260)", picture.sentence)
        self.assertIn(["swirl 260", "fourth order", "T/2", "4.00", "4.00", "4.00", "4"],
                      picture.rows)
        guides = [line for line in picture.figure.axes[0].lines if len(line.get_xdata()) == 2]
        slopes = sorted(math.log(y[1] / y[0]) / math.log(x[1] / x[0])
                        for x, y in (g.get_data() for g in guides))
        self.assertAlmostEqual(slopes[0], 2)
        self.assertAlmostEqual(slopes[1], 4)
        few = [r for r in precision_runs() if r["parameters"]["h"] > 0.005]
        self.assertEqual(convergence.draw(self.read(*few)), [])

    def test_bad_results_are_refused(self):
        good = precision_run("swirl-260", "default", 0.01, 1e-3, 1)
        for change, words in (({"cpu_s": "fast"}, ("cpu_s", "fast")), ({"cpu_s": 0}, ("cpu_s",)),
                              ({"parameters": {}}, ("'h'",))):
            path = self.write("bad.json", {**good, **change})
            self.assert_refused(["--precision", path], "bad.json", *words)

    # Hard cases.

    def test_hard_cases_are_a_table(self):
        failing = cases()
        self.assertIn("All 2 hard cases hold.", hard_cases.table(failing))
        failing[1].update(holds=False, failures=["1 inverted"], held=0, gave_up="", inverted=1,
                          error=0.5, error_is="area lost")
        text = hard_cases.table(hard_cases.read(self.write("hard.json", failing)))
        for words in ("1 of 2 hard cases does not hold: needle.", "✗ fails", "✓ holds",
                      "kept; fails: 1 inverted", ">inverted 1, area lost 0.500<",
                      "refused: coordinates collide", "unreached 0, largest 0.00250"):
            self.assertIn(words, text)
        missing = cases()
        del missing[1]["holds"]
        self.assert_refused(["--hard", self.write("h.json", missing)], "holds", "case 1")
        page = self.run_report("--hard", self.write("h.json", []))[2]
        self.assertIn("The list of hard cases is empty", page)

# SPDX-License-Identifier: MIT
"""The judgement of speed: limits, verdicts, counts, and messages."""
import json
import math
import os
import random
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import benchmark_json  # noqa: E402
import callgrind  # noqa: E402
import compare  # noqa: E402
import counting  # noqa: E402
import judgement  # noqa: E402
import timing  # noqa: E402
import workloads  # noqa: E402
from judgement import Verdict  # noqa: E402


class Times(unittest.TestCase):
    def test_the_narrowest_interval_decides_for_either_truth(self):
        """No program of the same speed is called slower, and none that is slower by 5 % is missed."""
        half = math.sqrt(judgement.SLOWDOWN)
        for truth, expected in ((1, Verdict.NOT_SLOWER), (1.05, Verdict.SLOWER)):
            for off in (1 / half, 1, half):
                value = truth * (1 + 0.98 * (off - 1))
                ratio = judgement.Ratio(value, value / half * 1.0001, value * half / 1.0001)
                self.assertTrue(ratio.is_narrow)
                self.assertEqual(ratio.verdict, expected, value)

    def test_verdicts(self):
        for value, low, high, expected in (
                (1.000, 0.980, 1.020, Verdict.NOT_SLOWER),
                (1.020, 0.999, 1.045, Verdict.NOT_SLOWER),
                (1.030, 1.005, 1.055, Verdict.SLOWER),
                (1.050, 1.026, 1.075, Verdict.SLOWER),
                (1.500, 1.030, 3.000, Verdict.SLOWER),
                (0.500, 0.100, 1.024, Verdict.NOT_SLOWER),
                (1.000, 0.970, 1.030, Verdict.UNDECIDED),
                (1.060, 1.020, 1.100, Verdict.UNDECIDED),
                (1.000, 0.000, math.inf, Verdict.UNDECIDED)):
            self.assertEqual(judgement.Ratio(value, low, high).verdict, expected, (value, low, high))

    def test_the_load_of_the_machine_leaves_the_ratio_of_pairs_alone(self):
        """From the middle on the machine is half as fast; the new program is slower by 4 %."""
        pairs = [(time, 1.04 * time) for time in [1000.0] * 15 + [2000.0] * 15]
        ratio = judgement.median_ratio(pairs)
        for value in (ratio.value, ratio.low, ratio.high):
            self.assertAlmostEqual(value, 1.04)
        self.assertEqual(ratio.verdict, Verdict.SLOWER)

    def test_a_few_pairs_of_nonsense_do_not_move_it(self):
        pairs = [(1000.0, 1000.0 + i % 7) for i in range(40)] + [(1000.0, 9000.0)] * 4
        self.assertLess(judgement.median_ratio(pairs).high, 1.01)

    def test_fewer_pairs_than_bound_an_interval_are_undecided(self):
        ratio = judgement.median_ratio([(1000.0, 2000.0)] * 14)
        self.assertEqual((ratio.value, ratio.low, ratio.high), (2, 0, math.inf))
        self.assertEqual(ratio.verdict, Verdict.UNDECIDED)
        self.assertEqual(judgement.median_ratio([(1000.0, 2000.0)] * 15).verdict, Verdict.SLOWER)

    def test_too_few_or_bad_times(self):
        for pairs in ([], [(1, 1)] * 4, [(1, 1)] * 5 + [(1, 0)], [(1, 1)] * 5 + [(1, float("nan"))],
                      [(1, 1)] * 5 + [(float("inf"), 1)]):
            with self.assertRaises(ValueError):
                judgement.median_ratio(pairs)


    def test_the_rank_is_that_of_the_sign_test(self):
        """At most 3 heads or 3 tails of 15 tosses have a chance of 3.5 %, 4 of 11.8 %."""
        self.assertEqual(judgement.rank_of_bounds(15, 0.95), 3)
        self.assertEqual(judgement.rank_of_bounds(20, 0.95), 5)
        self.assertEqual(judgement.rank_of_bounds(100, 0.95), 39)
        self.assertIsNone(judgement.rank_of_bounds(14))
        self.assertEqual(judgement.rank_of_bounds(15), 0)
        self.assertGreater(judgement.rank_of_bounds(3000), 1300)


class Procedure(unittest.TestCase):
    def measure(self, runs, max_pairs, max_seconds=1e9):
        return timing.measure(runs, max_pairs, max_seconds, lambda _: None, random.Random(1))

    def test_pairs_end_where_all_is_decided_or_time_is_over(self):
        source = random.Random(1)
        alike = (lambda: {"time": 1.0},) * 2
        wild = (lambda: {"time": source.choice((1.0, 2.0))},) * 2
        found = self.measure({"alike": alike, "wild": wild}, 50)
        self.assertEqual((found["alike"].count, found["wild"].count), (15, 50))
        self.assertEqual(self.measure({"wild": wild}, 50, 0)["wild"].count, timing.AT_ONCE)

    def test_which_comes_first_is_drawn(self):
        """If the second run of each pair is always slower, it is the new program's in half of the pairs."""
        order = []
        runs = {"run": (lambda: order.append(0) or {"time": 1.0 + len(order) % 2},
                        lambda: order.append(1) or {"time": 1.0 + len(order) % 2})}
        self.measure(runs, 200)
        first = order[2::2]
        self.assertTrue(0.4 < sum(first) / len(first) < 0.6)


class Numbers(unittest.TestCase):
    base = judgement.Counts(instructions=1_000_000_000, allocations=12_000, steps=40)

    def judged(self, instructions=1.0, allocations=0):
        new = judgement.Counts(int(self.base.instructions * instructions),
                               self.base.allocations + allocations, self.base.steps)
        return (judgement.more_instructions(self.base, new)[1],
                judgement.more_allocations(self.base, new)[1])

    def test_limits(self):
        self.assertEqual(self.judged(), (False, False))
        self.assertEqual(self.judged(instructions=1.005, allocations=3), (False, False))
        self.assertEqual(self.judged(instructions=1.02), (True, False))
        self.assertEqual(self.judged(allocations=40), (False, True))
        self.assertEqual(self.judged(instructions=0.5, allocations=-4000), (False, False))

    def test_a_file_of_callgrind(self):
        text = ["events: Ir\n", "fn=(1) main\n", "cfn=(2) malloc\n", "calls=3 0\n", "1 30\n",
                "cfn=(3) free\n", "calls=9 0\n", "1 30\n", "fn=(4) other\n", "cfn=(2)\n",
                "calls=4 0\n", "2 1\n", "cfn=(5) calloc@@GLIBC_2.2.5\n", "calls=1 0\n",
                "fn=(2)\n", "cfn=(6) malloc'2\n", "calls=2 0\n", "totals: 123456\n"]
        self.assertEqual(callgrind.parse(text), (123456, 10))
        for cut in ([], text[:-1], ["nonsense"]):
            with self.assertRaises(callgrind.NotCounted):
                callgrind.parse(cut)


class WhatIsCounted(unittest.TestCase):
    workload = workloads.ALL[0]

    def counted(self, programs, known):
        """Counts of two programs, of which only those in `known` have the function of a step."""
        def counts_of(program, _, within):
            if within and program not in known:
                raise callgrind.NotCalled(program)
            return judgement.Counts(100 if within else 1000, 0, 1)

        with mock.patch.object(counting, "counts_of", counts_of):
            return counting.of_both(programs, self.workload)

    def test_steps_of_both_or_whole_runs_of_both(self):
        for known, instructions, what in (("ab", 100, "steps"), ("a", 1000, "whole run"),
                                          ("b", 1000, "whole run"), ("", 1000, "whole run")):
            base, new, told = self.counted(("a", "b"), known)
            self.assertEqual((base.instructions, new.instructions, told),
                             (instructions, instructions, what))


class Summary(unittest.TestCase):
    def test_exit_codes_and_names(self):
        for verdicts, code in (("nn", 0), ("ns", 1), ("nu", 3), ("su", 1)):
            rows = [{"name": f"figure {i}", "verdict": {"n": Verdict.NOT_SLOWER, "s": Verdict.SLOWER,
                                                        "u": Verdict.UNDECIDED}[v].value}
                    for i, v in enumerate(verdicts)]
            text, found = compare.summary(rows, 1)
            self.assertEqual(found, code)
            self.assertEqual("undecided" in text and "figure 1" in text, "u" in verdicts)


class Form(unittest.TestCase):
    def test_of_google_benchmark(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "base.json")
            benchmark_json.write(path, "dsc_scene", {"swirl/step": [1.5, 2.5]}, {"pairs": 2})
            with open(path, encoding="utf-8") as stream:
                data = json.load(stream)
            self.assertEqual(os.listdir(folder), ["base.json"])
        self.assertEqual([entry["real_time"] for entry in data["benchmarks"]], [1.5, 2.5])
        for key in ("name", "run_name", "run_type", "real_time", "cpu_time", "time_unit",
                    "iterations", "repetitions", "repetition_index", "threads"):
            self.assertIn(key, data["benchmarks"][0])


if __name__ == "__main__":
    unittest.main()

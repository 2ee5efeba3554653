# SPDX-License-Identifier: MIT
"""The judgement of speed, with synthetic times: it must not cry wolf on a busy machine, and must
catch what is slower."""
import json
import os
import random
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import benchmark_json  # noqa: E402
import callgrind  # noqa: E402
import judgement  # noqa: E402
import workloads  # noqa: E402

PAIRS = 15
FIGURES = 3 * len(workloads.ALL)  # that are judged at once


def busy_pair(source, slowdown):
    """Both of a pair meet the same load of the machine, which drifts, and each one a load of its own:
    a few per cent of jitter, and in one run of five something that takes half as long again."""
    shared = 1 + 0.3 * source.random()

    def time():
        burst = 0.5 * source.random() if source.random() < 0.2 else 0
        return shared * (1 + abs(source.gauss(0, 0.01)) + burst)

    return 1000 * time(), 1000 * slowdown * time()


def pairs_of(seed, slowdown=1.0):
    source = random.Random(seed)
    return [busy_pair(source, slowdown) for _ in range(PAIRS)]


class Times(unittest.TestCase):
    def test_no_alarm_in_fifty_runs_of_unchanged_code(self):
        alarms = [(run, figure) for run in range(50) for figure in range(FIGURES)
                  if judgement.ratio_of_medians(pairs_of(f"{run} {figure}"),
                                                resamples=400).is_slower]
        self.assertEqual(alarms, [])

    def test_a_slowdown_is_caught_twenty_times_of_twenty(self):
        """In at least one of the figures, all of which are slower."""
        for run in range(20):
            caught = [figure for figure in range(FIGURES)
                      if judgement.ratio_of_medians(
                          pairs_of(f"slower {run} {figure}", 1.12), resamples=400).is_slower]
            self.assertTrue(caught, run)

    def test_the_interval_holds_the_true_ratio(self):
        for seed in range(40):
            ratio = judgement.ratio_of_medians(pairs_of(seed, 1.08))
            self.assertLessEqual(ratio.low, 1.08 * 1.02)
            self.assertGreaterEqual(ratio.high, 1.08 / 1.02)
            self.assertLessEqual(ratio.low, ratio.value)
            self.assertLessEqual(ratio.value, ratio.high)

    def test_a_faster_program_raises_no_alarm(self):
        self.assertFalse(judgement.ratio_of_medians(pairs_of(3, 0.5)).is_slower)

    def test_a_small_but_certain_difference_is_none(self):
        pairs = [(1000 + i, 1.03 * (1000 + i)) for i in range(PAIRS)]
        self.assertFalse(judgement.ratio_of_medians(pairs).is_slower)
        pairs = [(base, 1.06 * base) for base, _ in pairs]
        self.assertTrue(judgement.ratio_of_medians(pairs).is_slower)

    def test_too_few_or_bad_times(self):
        for pairs in ([], [(1, 1)] * 4, [(1, 1)] * 5 + [(1, 0)], [(1, 1)] * 5 + [(1, float("nan"))],
                      [(1, 1)] * 5 + [(float("inf"), 1)]):
            with self.assertRaises(ValueError):
                judgement.ratio_of_medians(pairs)


class Numbers(unittest.TestCase):
    base = judgement.Counts(instructions=1_000_000_000, allocations=12_000, steps=40)

    def judged(self, instructions=1.0, allocations=0):
        new = judgement.Counts(int(self.base.instructions * instructions),
                               self.base.allocations + allocations, self.base.steps)
        return (judgement.more_instructions(self.base, new)[1],
                judgement.more_allocations(self.base, new)[1])

    def test_limits(self):
        self.assertEqual(self.judged(), (False, False))
        self.assertEqual(self.judged(instructions=1.001, allocations=3), (False, False))
        self.assertEqual(self.judged(instructions=1.021), (True, False))
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

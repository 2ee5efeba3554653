# SPDX-License-Identifier: MIT
"""Times of a busy machine, synthetic ones with a memory: how often the interval holds the truth, and how
often the whole procedure, pairs as many as it takes, finds what is slower and nothing else."""
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import judgement  # noqa: E402
import timing  # noqa: E402
import workloads  # noqa: E402
from judgement import Verdict  # noqa: E402
from tests.noise import Machine  # noqa: E402

FIGURES = 3 * len(workloads.ALL)  # that are judged at once
MOST = 300


def silent(_):
    pass


def measured(seed, slowdown, most_pairs=MOST, **noise):
    source = random.Random(seed)
    machine = Machine(source, **noise)
    runs = {"run": (machine.program(), machine.program(slowdown))}
    return timing.measure(runs, most_pairs, 1e9, silent, source)["run"].times["time"]


def verdict(seed, slowdown, **noise):
    return judgement.median_ratio(measured(seed, slowdown, **noise)).verdict


def so_many_pairs(source, count, slowdown):
    """However soon they would be decided."""
    machine = Machine(source)
    pairs = []
    for _ in range(count):
        times = [0, 0]
        for which in source.sample((0, 1), 2):
            times[which] = machine.time((1, slowdown)[which])
        pairs.append(tuple(times))
    return pairs


class Coverage(unittest.TestCase):
    def share_that_holds(self, slowdown, count, confidence, runs=600):
        source = random.Random(f"{slowdown} {count}")
        held = 0
        for _ in range(runs):
            ratio = judgement.median_ratio(so_many_pairs(source, count, slowdown), confidence)
            held += ratio.low <= slowdown <= ratio.high
        return held / runs

    def test_the_interval_holds_the_true_ratio_as_often_as_it_says(self):
        """Order statistics are steps: it may hold more often, by the chance of one rank."""
        for slowdown in (1, 1.05, 0.8):
            for count in (20, 60):
                for confidence in (0.9, 0.99):
                    with self.subTest(slowdown=slowdown, count=count, confidence=confidence):
                        held = self.share_that_holds(slowdown, count, confidence)
                        self.assertGreater(held, confidence - 3 * (0.1 * 0.9 / 600) ** 0.5)
                        self.assertLess(held, confidence + (1 - confidence) * 0.9 + 0.02)

    def test_the_rank_is_that_of_the_sign_test(self):
        """At most 3 heads or 3 tails of 15 tosses have a chance of 3.5 %, 4 of 11.8 %."""
        self.assertEqual(judgement.rank_of_bounds(15, 0.95), 3)
        self.assertEqual(judgement.rank_of_bounds(20, 0.95), 5)
        self.assertEqual(judgement.rank_of_bounds(100, 0.95), 39)
        self.assertIsNone(judgement.rank_of_bounds(14))
        self.assertEqual(judgement.rank_of_bounds(15), 0)
        self.assertGreater(judgement.rank_of_bounds(3000), 1300)


class Procedure(unittest.TestCase):
    def test_no_alarm_in_fifty_runs_of_unchanged_code(self):
        found = [verdict(f"{run} {figure}", 1) for run in range(50) for figure in range(FIGURES)]
        self.assertEqual({v for v in found if v == Verdict.SLOWER}, set())
        self.assertLess(found.count(Verdict.UNDECIDED), len(found) / 50)

    def test_a_slowdown_of_five_per_cent_is_caught_by_each_figure_twenty_times_of_twenty(self):
        for figure in range(FIGURES):
            found = [verdict(f"slower {run} {figure}", judgement.SLOWDOWN) for run in range(20)]
            self.assertEqual(set(found), {Verdict.SLOWER}, figure)

    def test_a_quiet_machine_needs_few_pairs(self):
        quiet = {"jitter": 0.003, "drift": 0.01, "bursts": 0.02}
        for slowdown in (1, judgement.SLOWDOWN):
            self.assertLessEqual(len(measured(1, slowdown, **quiet)), 20)

    def test_more_noise_needs_more_pairs(self):
        numbers = [len(measured(1, 1, jitter=jitter)) for jitter in (0.003, 0.02, 0.05)]
        self.assertEqual(numbers, sorted(set(numbers)))

    def test_what_cannot_be_told_is_undecided(self):
        for slowdown in (1, 1.02, judgement.SLOWDOWN):
            pairs = measured("loud", slowdown, most_pairs=40, jitter=0.4)
            self.assertEqual(len(pairs), 40)
            self.assertEqual(judgement.median_ratio(pairs).verdict, Verdict.UNDECIDED)

    def test_time_ends_it_too(self):
        machine = Machine(random.Random(1), jitter=0.4)
        runs = {"run": (machine.program(), machine.program())}
        self.assertEqual(timing.measure(runs, MOST, 0, silent)["run"].count, timing.AT_ONCE)

    def test_what_is_decided_is_run_no_more(self):
        source = random.Random(1)
        quiet = Machine(source, jitter=0.001, drift=0.01, bursts=0)
        loud = Machine(source, jitter=0.4)
        found = timing.measure({"quiet": (quiet.program(), quiet.program()),
                                "loud": (loud.program(), loud.program())}, 50, 1e9, silent, source)
        self.assertEqual((found["quiet"].count, found["loud"].count), (15, 50))

    def test_which_comes_first_is_drawn(self):
        """Where the second of two is always slower, it is the new one half of the time."""
        order = []
        runs = {"run": (lambda: order.append(0) or {"time": 1.0 + len(order) % 2},
                        lambda: order.append(1) or {"time": 1.0 + len(order) % 2})}
        timing.measure(runs, 200, 1e9, silent, random.Random(1))
        first = order[2::2]
        self.assertTrue(0.4 < sum(first) / len(first) < 0.6)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""Every scene by 1, 2, 3, 4 and 8 processes on 1 and 2 threads; and ends that nobody has asked for."""
import os
import signal
import time
import unittest

from launcher import Launched
from processes import children, is_running

CELLS = ["--strategy", "cells", "--submeshes", "8"]
BEGINNING = ["--stop-after", "8"]  # interrupted: exit code 1
LONG = ["--set", "h=0.01", "--set", "steps=100000", "--set", "dt=0.0005"]


class EveryScene(Launched):
    def test_same_bits_for_any_number(self):
        _, listed, _ = self.call(None, "list")
        for scene in (line.split()[0] for line in listed.splitlines()):
            alone = self.result(None, scene, *BEGINNING, *CELLS, code=1)
            for ranks in (1, 2, 3, 4, 8):
                for threads in ("1", "2"):
                    result = self.result(ranks, scene, *BEGINNING, *CELLS, "--threads", threads,
                                         code=1)
                    self.expect_same(result, alone, f"{scene}, {ranks} ranks, {threads} threads")


class Ends(Launched):
    def run_until_a_checkpoint(self):
        process = self.start(3, "run", "swirl", *LONG, *CELLS, "--checkpoint", "in/c",
                             "--every", "5", "--json", "r.json")
        begin = time.monotonic()
        while not os.path.exists(self.path("in/c")):
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic() - begin, 60)
            time.sleep(0.05)
        return process

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("in"))

    def end_of(self, process):
        begin = time.monotonic()
        _, errors = process.communicate(timeout=60)
        self.assertLess(time.monotonic() - begin, 30)
        return [line for line in errors.splitlines() if line.startswith("dsc_scene: ")]

    def expect_to_go_on(self):
        os.rename(self.path("in/c"), self.path("before"))
        with_one = self.result(None, "--resume", "before", "--stop-after", "40", code=1)
        with_two = self.result(2, "--resume", "before", "--stop-after", "40", code=1)
        self.expect_same(with_one, with_two, "resumed")

    def test_one_that_is_killed_ends_all_within_seconds(self):
        process = self.run_until_a_checkpoint()
        ranks = children(process.pid)
        self.assertEqual(len(ranks), 3)
        os.kill(ranks[1], signal.SIGKILL)
        self.end_of(process)
        self.assertNotEqual(process.returncode, 0)
        time.sleep(1)
        for rank in ranks:
            self.assertFalse(is_running(rank), "still there")
        self.assertFalse(os.path.exists(self.path("r.json")))
        self.assertEqual(os.listdir(self.path("in")), ["c"])
        self.expect_to_go_on()

    def test_an_interruption_ends_all_after_the_same_step(self):
        process = self.run_until_a_checkpoint()
        os.kill(children(process.pid)[2], signal.SIGINT)  # one of them alone
        words = self.end_of(process)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(len(words), 1, words)
        self.assertIn("interrupted after step", words[0])
        self.assertIn("--resume in/c", words[0])
        self.assertTrue(os.path.exists(self.path("r.json")))
        self.expect_to_go_on()

    def test_a_full_disk_of_one_ends_all_with_one_sentence(self):
        process = self.run_until_a_checkpoint()
        # At once, for the run goes on: the first rank writes, and finds no folder.
        os.rename(self.path("in"), self.path("gone"))
        words = self.end_of(process)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(len(words), 1, words)
        self.assertIn("in/c", words[0])
        self.assertEqual(os.listdir(self.folder), ["gone"])


if __name__ == "__main__":
    unittest.main()

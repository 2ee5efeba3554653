# SPDX-License-Identifier: MIT
"""A sweep of 200 runs that is killed five times and goes on: no run is lost and none is run twice.

A run that was killed in its middle is begun again. What is run twice would be one that is begun
although it has a result, or that ends twice; the log of attempts and the results at each kill show
whether there is one. DSC_KILL_SEED chooses when to kill; it is printed."""
import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from tests.support import Project

RUNS, KILLS, JOBS = 200, 5, 2
TABLE = f'''
[[run]]
name = "small"
command = ["bash", "-c", "echo {{i}} >> begun; sleep 0.05; echo {{i}} > {{out}}/result.json"]
with = {{ i = {{ lines_of = ["seq", "{RUNS}"] }} }}
'''


class Killed(unittest.TestCase):
    def check(self, *options):
        seed = int(os.environ.get("DSC_KILL_SEED") or random.SystemRandom().randrange(10 ** 6))
        print(f"DSC_KILL_SEED={seed}", flush=True)
        source = random.Random(seed)
        project = Project(self)
        project.table(TABLE)
        for _ in range(KILLS):
            before, lines = set(project.results()), len(project.attempts())
            self.kill_after(project, options, len(before) + source.randint(1, RUNS // (KILLS + 1)),
                            source.uniform(0, 0.1))
            self.assertLessEqual(before, set(project.results()))
            self.check_nothing_twice(project, before, lines)
        before, lines = set(project.results()), len(project.attempts())
        self.assertLess(len(before), RUNS)  # each kill has hit a sweep that was not at its end
        done = project.sweep("--jobs", str(JOBS), *options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.check_nothing_twice(project, before, lines)

        results = project.results()
        self.assertEqual(sorted(r["result"] for r in results.values()), list(range(1, RUNS + 1)))
        attempts = project.attempts()
        ended = [line["key"] for line in attempts if line["event"] == "done"]
        self.assertEqual(len(ended), len(set(ended)))
        begun = project.begun()
        self.assertEqual(len(begun), RUNS)
        again = sum(begun.values()) - RUNS
        self.assertLessEqual(again, KILLS * JOBS)  # those that were in their middle
        # The commands' own count: a run is logged before it begins.
        witness = (project.root / "begun").read_text().split()
        self.assertLessEqual(len(witness), sum(begun.values()))
        print(f"{RUNS} runs, killed {KILLS} times: {RUNS - len(results)} lost, "
              f"{len(ended) - len(set(ended))} run twice; {again} begun again because they were "
              "killed", flush=True)

    def kill_after(self, project, options, count, seconds):
        """As soon as there are so many results, and a little later."""
        process = subprocess.Popen(project.words("--jobs", str(JOBS), *options),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env=project.environment, cwd=project.root,
                                   start_new_session=True)
        while len(list(project.out.glob("*/*/*.json"))) < count:
            self.assertIsNone(process.poll(), "the sweep has ended before it was killed")
            time.sleep(0.01)
        time.sleep(seconds)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()

    def check_nothing_twice(self, project, before, lines):
        """What had a result when the sweep began is in none of the lines that it has added."""
        had = {path.rpartition("/")[2].removesuffix(".json") for path in before}
        since = {line["key"] for line in project.attempts()[lines:]}
        self.assertEqual(had & since, set())

    def test_in_a_plain_loop(self):
        self.check("--plain")

    @unittest.skipUnless(shutil.which("snakemake"), "no Snakemake (Debian: snakemake)")
    def test_by_snakemake(self):
        self.check()


if __name__ == "__main__":
    unittest.main()

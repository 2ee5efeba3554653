# SPDX-License-Identifier: MIT
"""The same table by Snakemake, on this machine and by the profile for Slurm with a stand-in for
it."""
import os
import shutil
import signal
import subprocess
import time
import unittest

from tests.support import Project
from tests.test_sweep import SOME, WATCHED, overlapping

# Runs the job's script in the background, as a queue would, and prints its number.
SBATCH = '''#!/bin/bash
echo "$@" >> "$SBATCH_LOG"
setsid bash "${@: -1}" >/dev/null 2>&1 &
echo $!
'''


@unittest.skipUnless(shutil.which("snakemake"), "no Snakemake (Debian: snakemake)")
class BySnakemake(unittest.TestCase):
    def setUp(self):
        self.project = Project(self)

    def test_a_failed_run_is_named_and_the_others_go_on(self):
        (self.project.root / "answer").write_text("something is wrong\n")
        self.project.table(SOME)
        done = self.project.sweep()
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("by Snakemake", done.stdout)
        self.assertIn("failed: some: i=3\n  exit code 7\n", done.stdout)
        self.assertIn("| something is wrong", done.stdout)
        self.assertIn("3 done (0 of them before), 1 failed, 0 not run", done.stdout)
        done = self.project.sweep()
        self.assertEqual(done.returncode, 1)
        self.assertEqual(set(self.project.begun().values()), {1})

    def test_timed_runs_are_alone(self):
        self.project.table(WATCHED)
        done = self.project.sweep("--jobs", "4", "--batch", "1")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(len(self.project.results()), 7)
        self.assertEqual(overlapping(list(self.project.results().values())), [])

    def test_an_interrupted_sweep_leaves_whole_results(self):
        self.project.table('[[run]]\nname = "a"\ncommand = ["sleep", "{s}"]\n'
                           'with = {s = [0.01, 30]}\n')
        process = subprocess.Popen(self.project.words("--jobs", "2", "--batch", "1"), text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   env=self.project.environment)
        while len(self.project.results()) < 1 or len(self.project.begun()) < 2:
            time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
        self.assertIn("interrupted", process.communicate()[1])
        self.assertEqual(process.returncode, 130)
        self.assertEqual(len(self.project.results()), 1)
        for _ in range(100):  # the job is told to end when Snakemake has gone
            if not os.listdir(self.project.out / "here/running"):
                break
            time.sleep(0.1)
        self.assertEqual(os.listdir(self.project.out / "here/running"), [])

    def test_the_profile_for_slurm(self):
        """What is asked of sbatch, and that a job finds its plan; no cluster is at hand."""
        folder = self.project.root / "bin"
        folder.mkdir()
        (folder / "sbatch").write_text(SBATCH)
        (folder / "sbatch").chmod(0o755)
        log = self.project.root / "sbatch.log"
        self.project.environment.update(PATH=f"{folder}:{os.environ['PATH']}", SBATCH_LOG=str(log))
        self.project.table(WATCHED)
        done = self.project.sweep("--profile", "slurm", "--jobs", "2")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(len(self.project.results()), 7)
        asked = log.read_text().splitlines()
        self.assertEqual(sum("--exclusive" in line for line in asked), 1)
        self.assertGreater(len(asked), 1)
        self.assertTrue(all("--cpus-per-task=1 " in line for line in asked), asked)
        # What a node has done is not done again, on whichever node.
        self.project.environment["DSC_SWEEP_MACHINE"] = "another node"
        self.assertIn("7 done (7 of them before)", self.project.sweep("--profile", "slurm").stdout)


if __name__ == "__main__":
    unittest.main()

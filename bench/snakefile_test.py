# SPDX-License-Identifier: MIT
"""Many runs of a suite by Snakemake: locally, and by the profile for Slurm with a fake sbatch."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

BENCH = pathlib.Path(__file__).resolve().parent
SUITE = """[[case]]
scene = "mine.toml"
area_error = 0.2
rows = [
    { measure = "run", threads = [1, 2] },
    { measure = "result", h = [0.06, 0.05], seeds = [1, 2], set = { insertion = "linear" }, strategies = "active", threads = 2 },
]
"""
SCENE = 'scene = "zalesak"\n[options]\nh = 0.05\nsteps = 12\n'
# Runs the job's script in the background, as a queue would, and prints its number.
SBATCH = """#!/bin/bash
echo "$@" >> "$SBATCH_LOG"
setsid bash "${@: -1}" >/dev/null 2>&1 &
echo $!
"""


@unittest.skipUnless(shutil.which("snakemake"), "no Snakemake (Debian: snakemake)")
class BySnakemake(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "runs"
        (self.folder / "mine.toml").write_text(SCENE, encoding="utf-8")

    def snakemake(self, *words, suite=SUITE, **environment):
        (self.folder / "suite.toml").write_text(suite, encoding="utf-8")
        return subprocess.run(
            ["snakemake", "-s", BENCH / "Snakefile", *words, "--config", "suite=suite.toml",
             "out=runs", "repeats=2", f"build={os.environ['DSC_BUILD']}",
             f"python={sys.executable}"],
            cwd=self.folder, env={**os.environ, **environment}, capture_output=True, text=True,
            check=False, timeout=300)

    def assert_complete(self):
        with open(self.out / "bench.json", encoding="utf-8") as stream:
            rows = [row["name"].split("/iter")[0] for row in json.load(stream)["benchmarks"]]
        names = [f"mine_run/strategy:{who}/between_us:0" for who in (
            "sequential/h:0.05", "cells/h:0.05/threads:1", "cells/h:0.05/threads:2")]
        self.assertEqual(sorted(rows), sorted(2 * names))
        results = list((self.out / "results").iterdir())
        self.assertEqual(len(results), 4)
        for path in results:
            result = json.loads(path.read_text(encoding="utf-8"))
            parameters = result["parameters"]
            self.assertEqual((result["strategy"], result["threads"]), ("active", 2))
            self.assertEqual(parameters["insertion"], "linear")
            self.assertIn(f"h={parameters['h']}_", path.name)
            self.assertIn(f"seed={parameters['seed']}_", path.name)
        self.assertTrue((self.out / "report" / "index.html").exists())

    def test_every_run_is_made_once(self):
        done = self.snakemake("--cores", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_complete()
        self.assertIn("Nothing to be done", self.snakemake("--cores", "2").stderr)

        lost = next((self.out / "results").iterdir())
        lost.unlink()
        (self.out / "report" / "index.html").unlink()
        before = {path: path.stat().st_mtime_ns for path in self.out.glob("*/*.json")}
        self.assertEqual(self.snakemake("--cores", "2").returncode, 0)
        self.assert_complete()
        self.assertEqual({p: p.stat().st_mtime_ns for p in self.out.glob("*/*.json") if p != lost},
                         before)

    def test_timed_rows_are_alone(self):
        done = self.snakemake("--cores", "4", "--dry-run")
        self.assertEqual(done.returncode, 0, done.stderr)
        jobs = [job for job in done.stdout.split("\nrule ") if job.startswith("time:")]
        self.assertEqual(len(jobs), 6)
        for job in jobs:
            self.assertIn("threads: 4", job)

    def test_a_run_that_fails_is_named_and_the_others_go_on(self):
        wrong = SUITE.replace("area_error = 0.2", "area_error = 0")
        done = self.snakemake("--cores", "2", "--keep-going", suite=wrong)
        self.assertEqual(done.returncode, 1)
        self.assertIn("mine_run_strategy_sequential", done.stderr)
        self.assertEqual(len(list((self.out / "results").iterdir())), 4)
        logs = [path.read_text(encoding="utf-8") for path in (self.out / "log").iterdir()]
        self.assertEqual(sum("the area is off by" in log for log in logs), 6)

    def test_a_bad_suite_is_refused(self):
        for suite, word in ((SUITE.replace("zalesak", "x").replace("linear", "cubik"), "'cubik'"),
                            ("[[case]", "suite.toml:1")):
            done = self.snakemake("--cores", "2", suite=suite)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(word, done.stderr)
            self.assertFalse(self.out.exists())

    def test_a_cluster(self):
        sbatch = self.folder / "sbatch"
        sbatch.write_text(SBATCH, encoding="utf-8")
        sbatch.chmod(0o755)
        log = self.folder / "sbatch.log"
        done = self.snakemake("--profile", BENCH / "slurm", "--jobs", "4", "--latency-wait", "20",
                              PATH=f"{self.folder}:{os.environ['PATH']}", SBATCH_LOG=str(log))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_complete()
        jobs = log.read_text(encoding="utf-8").splitlines()
        self.assertEqual(sum("--exclusive" in job for job in jobs), 6)
        self.assertGreaterEqual(len(jobs), 10)
        time.sleep(0.5)  # the last job's shell ends after its result has been written


if __name__ == "__main__":
    unittest.main()

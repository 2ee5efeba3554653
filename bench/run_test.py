# SPDX-License-Identifier: MIT
"""bench/run.sh refuses what it does not know, before it does anything."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent


class Usage(unittest.TestCase):
    def setUp(self):
        # A copy of the scripts alone: what was not refused would fail to configure here.
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for file in ("bench/run.sh", "verify/setup.sh"):
            (self.folder / file).parent.mkdir()
            shutil.copy(ROOT / file, self.folder / file)
        (self.folder / "mine.toml").touch()

    def call(self, *words):
        return subprocess.run([self.folder / "bench/run.sh", *words], cwd=self.folder, check=False,
                              capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})

    def test_bad_usage(self):
        for words, expected in ((["--frobnicate"], "'--frobnicate'"), (["swirl"], "'swirl'"),
                                (["--quick", "--benchmark_speed=9"], "'--benchmark_speed=9'"),
                                (["--benchmark_out=x.json"], "dsc_bench --benchmark_out=x.json"),
                                (["--only", "speed"], "speedup, precision, hard or gallery"),
                                (["--only"], "a value is missing"),
                                (["--suite=no.toml"], "'no.toml'"),
                                (["--suite", "mine.toml", "--only", "hard"], "--only hard")):
            done = self.call(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertIn(expected, done.stderr)
            for word in ("got '", "; allowed: "):
                self.assertIn(word, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["bench", "mine.toml", "verify"])

    def test_help(self):
        done = self.call("--help")
        self.assertEqual(done.returncode, 0)
        for word in ("--suite FILE", "--only WHAT", "--quick"):
            self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main()

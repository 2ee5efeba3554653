# SPDX-License-Identifier: MIT
"""Bad options of bench/run.sh are refused before anything is done; and the build that it makes."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent


class Usage(unittest.TestCase):
    def setUp(self):
        # A copy of the scripts only: options that are not refused would fail at configuration.
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for file in ("bench/run.sh", "verify/setup.sh"):
            (self.folder / file).parent.mkdir()
            shutil.copy(ROOT / file, self.folder / file)
        (self.folder / "mine.toml").touch()

    def call(self, *words, path=os.environ["PATH"]):
        return subprocess.run([self.folder / "bench/run.sh", *words], cwd=self.folder, check=False,
                              capture_output=True, text=True,
                              env={**os.environ, "LC_ALL": "C", "PATH": path})

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

    def test_builds_the_python_module_too(self):
        # Programs that do nothing, and a cmake that fails to build.
        for name, text in (("dpkg-query", "echo installed"), ("python3", ""),
                           ("cmake", 'echo "$*" >> cmake.log; [[ $1 != --build ]]')):
            program = self.folder / "bin" / name
            program.parent.mkdir(exist_ok=True)
            program.write_text(f"#!/usr/bin/env bash\n{text}\n", encoding="utf-8")
            program.chmod(0o755)
        for words, expected in ((["--quick"], True), ([], True), (["--only", "hard"], False)):
            done = self.call(*words, path=f"{self.folder / 'bin'}{os.pathsep}{os.environ['PATH']}")
            self.assertEqual(done.returncode, 1, done.stderr)
            built = (self.folder / "cmake.log").read_text(encoding="utf-8").splitlines()[-1]
            self.assertEqual("dsc_module" in built.split(), expected, built)

    def test_help(self):
        done = self.call("--help")
        self.assertEqual(done.returncode, 0)
        for word in ("--suite FILE", "--only WHAT", "--quick"):
            self.assertIn(word, done.stdout)


if __name__ == "__main__":
    unittest.main()

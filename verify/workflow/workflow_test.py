# SPDX-License-Identifier: MIT
"""The example of a gate for other projects: a copy of it in an empty folder builds against the
installed library, passes, and fails where it has to."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

ROOM = os.path.dirname(os.path.abspath(__file__))
BUILD = os.environ["DSC_BUILD"]


class Project(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.prefix = os.path.join(cls.folder.name, "dsc")
        subprocess.run(["cmake", "--install", BUILD, "--prefix", cls.prefix], check=True,
                       capture_output=True)
        cls.project = os.path.join(cls.folder.name, "project")
        shutil.copytree(os.path.join(ROOM, "project"), cls.project)
        cls.git("init", "-q")
        cls.git("add", ".")
        cls.git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "-qm", "first")

    @classmethod
    def git(cls, *arguments):
        subprocess.run(["git", *arguments], cwd=cls.project, check=True, capture_output=True)

    def gate(self, *arguments, prefix=None):
        return subprocess.run(["./gate.sh", prefix or self.prefix, *arguments], cwd=self.project,
                              capture_output=True, text=True, check=False)

    def path(self, *names):
        return os.path.join(self.project, *names)

    def test_1_it_passes(self):
        done = self.gate()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(self.path("build/gate/verify.json"), encoding="utf-8") as stream:
            rows = json.load(stream)["checks"]
        self.assertEqual({row["verdict"] for row in rows}, {"pass"})
        self.assertIn("limits.inverted", {row["check"] for row in rows})
        self.assertIn("symmetric_difference", {row["check"] for row in rows})
        for name in ("verify.xml", "tests.xml"):
            xml.parse(self.path("build/gate", name))

    def test_2_it_is_compared_with_a_base_commit(self):
        """With so few runs, no verdict about times is given."""
        done = self.gate("HEAD", "--pairs", "5")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"program/whole run, CPU +.* UNDECIDED")
        self.assertRegex(done.stdout, "program/instructions +(1.0000|0.9999)|not counted|installed")
        for name in ("base.json", "new.json"):
            with open(self.path("build/gate", name), encoding="utf-8") as stream:
                self.assertEqual(len(json.load(stream)["benchmarks"]), 5)

    def test_3_a_limit_that_does_not_hold(self):
        with open(self.path("scenes/shear.toml"), encoding="utf-8") as stream:
            text = stream.read()
        with open(self.path("scenes/shear.toml"), "w", encoding="utf-8") as stream:
            stream.write(text.replace("min = 15", "min = 59"))
        done = self.gate()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("failed: limits", done.stdout)
        self.assertTrue(os.listdir(self.path("build/gate/failures")))

    def test_4_no_library(self):
        done = self.gate(prefix=self.path("none"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("no dsc is installed", done.stderr)


if __name__ == "__main__":
    unittest.main()

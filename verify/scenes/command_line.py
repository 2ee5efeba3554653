# SPDX-License-Identifier: MIT
"""Common parts of the tests of command lines: a bad call must end with code 2 (1 if the run had begun) and
one sentence on stderr that says what is wrong, the value and what is allowed; and it must leave no
half-written file.

The environment names the build (DSC_BUILD).
"""
import os
import resource
import signal
import subprocess
import tempfile
import unittest

BUILD = os.environ["DSC_BUILD"]
SCENE = os.path.join(BUILD, "lib", "scenes", "dsc_scene")
VERIFY = os.path.join(BUILD, "verify", "dsc_verify")
HARD = os.path.join(BUILD, "verify", "dsc_hard")
ROOM = os.path.dirname(os.path.abspath(__file__))
SUITES = os.path.join(os.path.dirname(ROOM), "suites")
SHORT = ["--set", "h=0.05", "--set", "steps=4"]
PROMPTLY = 120  # seconds; bad calls must end at once


def limited_to(size):
    """Limits the size of files to this many bytes, which looks like a full disk to a program."""
    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return prepare


class CommandLine(unittest.TestCase):
    program = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def call(self, *arguments, prepare=None):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              timeout=PROMPTLY, cwd=self.folder, preexec_fn=prepare, check=False)

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self):
        return sorted(name for _, _, names in os.walk(self.folder) for name in names)

    def expect_refusal(self, *arguments, words=(), code=(2,), prepare=None):
        """Expects one sentence that contains all of the words, and no new files."""
        before = self.files()
        done = self.call(*arguments, prepare=prepare)
        self.assertIn(done.returncode, code, f"{arguments}: {done.stderr}")
        lines = done.stderr.strip().splitlines()
        self.assertEqual(len(lines), 1, f"{arguments}: not one sentence: {done.stderr!r}")
        name = os.path.basename(self.program)
        self.assertTrue(lines[0].startswith(name + ": "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(self.files(), before, f"{arguments} left something behind")
        return done

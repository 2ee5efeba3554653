# SPDX-License-Identifier: MIT
"""A file that is empty, cut off, or of another kind: every program that draws says so in one sentence
that names the file, and leaves nothing behind."""
import contextlib
import io
import json
import os
import subprocess
import sys
import tempfile
import unittest

import over_time
import speedup

from tests.samples import (PLOTS, VTU, Case, bench, faults, hard_cases, mutants, scene, verify)
from tests.test_over_time import RESULT, SERIES

WHOLE = {"--bench": bench(), "--scenes": scene(0.01, 1e-3, 1), "--verify": verify(),
         "--hard": hard_cases(), "--faults": faults(), "--mutants": mutants()}
FOREIGN = {
    "empty": b"", "blank": b" \n", "nothing": b"null", "number": b"7", "text": b'"a text"',
    "list": b"[[1, 2]]", "list of texts": b'["a", "b"]', "object": b'{"a": 1}',
    "page": b"<!DOCTYPE html><title>not found</title>", "table": SERIES.encode(),
    "picture": b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "wide text": "h\u00e9".encode("utf-16"),
    "nesting": b"[" * 100000,
}


class Report(Case):
    def write_bytes(self, name, data):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as stream:
            stream.write(data)
        return path

    def assert_refused_file(self, option, path):
        with self.subTest(option=option, file=os.path.basename(path)):
            self.assert_refused([option, path], os.path.basename(path))

    def test_foreign_files(self):
        for option in (*WHOLE, "--precision"):
            for kind, data in FOREIGN.items():
                self.assert_refused_file(option, self.write_bytes(f"{kind}.json", data))

    def test_files_of_another_option(self):
        for option in (*WHOLE, "--precision"):
            for other, data in WHOLE.items():
                if other != option:
                    path = self.write(f"of{other}.json", data)
                    self.assert_refused_file(option, path)

    def test_cut_off_files(self):
        for option, data in WHOLE.items():
            whole = json.dumps(data).encode()
            for length in (1, len(whole) // 3, len(whole) - 1):
                self.assert_refused_file(option, self.write_bytes("cut.json", whole[:length]))

    def test_a_folder_or_nothing_in_place_of_a_file(self):
        for option in (*WHOLE, "--precision"):
            self.assert_refused_file(option, self.folder)
            self.assert_refused_file(option, os.path.join(self.folder, "none.json"))

    def test_frames(self):
        whole = VTU.format(x=1).encode()
        for kind, data in {**FOREIGN, "cut": whole[:-20], "half": whole[:len(whole) // 2]}.items():
            path = self.write_bytes("frames/swirl_sequential_00000.vtu", data)
            with self.subTest(kind=kind):
                self.assert_refused(["--frames", os.path.dirname(path)], "00000.vtu")

    def test_published_figures(self):
        for kind, data in FOREIGN.items():
            path = self.write_bytes("published/peers.json", data)
            with self.subTest(kind=kind):
                self.assert_refused(["--published", os.path.dirname(path)], "peers.json")


class OneFile(unittest.TestCase):
    """Programs that draw one picture of a file."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, data):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as stream:
            stream.write(data)
        return path

    def assert_refused(self, name, *words, program=over_time):
        errors = io.StringIO()
        out = os.path.join(self.folder, "picture.png")
        with contextlib.redirect_stderr(errors):
            status = program.main([*words, "--out", out])
        self.assertEqual(status, 2, errors.getvalue())
        self.assertEqual(errors.getvalue().count("\n"), 1, errors.getvalue())
        self.assertTrue(errors.getvalue().startswith(f"{program.__name__}.py: "), errors.getvalue())
        self.assertIn(name, errors.getvalue())
        self.assertFalse(os.path.exists(out))

    def test_series(self):
        bad = {**FOREIGN, "cut": SERIES[:-20].encode(), "header": SERIES.split("\n")[0].encode(),
               "words": SERIES.replace("110", "many").encode()}
        del bad["table"]
        for kind, data in bad.items():
            with self.subTest(kind=kind):
                self.assert_refused("s.csv", self.write("s.csv", data))

    def test_results(self):
        series = self.write("s.csv", SERIES.encode())
        whole = json.dumps(RESULT).encode()
        for kind, data in {**FOREIGN, "cut": whole[:-1]}.items():
            with self.subTest(kind=kind):
                self.assert_refused("r.json", series, "--json", self.write("r.json", data))

    def test_benchmarks(self):
        whole = json.dumps(bench()).encode()
        for kind, data in {**FOREIGN, "cut": whole[:-1]}.items():
            with self.subTest(kind=kind):
                self.assert_refused("b.json", self.write("b.json", data), program=speedup)


class Gallery(unittest.TestCase):
    def test_a_program_that_is_none(self):
        with tempfile.TemporaryDirectory() as folder:
            silent = os.path.join(folder, "silent")
            with open(silent, "w", encoding="utf-8") as stream:
                stream.write("#!/bin/sh\nexit 0\n")
            os.chmod(silent, 0o755)
            for program in (os.path.join(folder, "none"), folder, silent):
                done = subprocess.run(
                    [sys.executable, os.path.join(PLOTS, "gallery", "make.py"), "--scene", program,
                     "--out", os.path.join(folder, "out")], capture_output=True, text=True,
                    check=False)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertNotIn("Traceback", done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertTrue(done.stderr.startswith("make.py: "), done.stderr)


if __name__ == "__main__":
    unittest.main()

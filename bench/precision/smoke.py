#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""smoke.py DSC_PRECISION: tests the program and the common properties of its results, not
their times. Standard library only."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
FLOW = "single-vortex-2"
NEEDED = {"flow": str, "flow_title": str, "method": str, "group": str, "scene": str,
          "parameters": dict, "strategy": str, "sd_rel_last": float, "sd_rel_half": float,
          "area_ratio": float, "cpu_s": float, "repetitions": int, "commit": str,
          "machine": str}


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)


class Precision(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = os.path.join(folder.name, "results")

    def results(self):
        found = {}
        for name in os.listdir(self.out):
            self.assertTrue(name.endswith(".json"), name)  # no partly written file is left
            with open(os.path.join(self.out, name), encoding="utf-8") as stream:
                found[name] = json.load(stream)
        return found

    def test_list_names_flows_and_methods(self):
        done = run("list")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for word in ("single-vortex-2", "single-vortex-8", "swirl-260", "swirl-420", "zalesak",
                     "vortex-square", "default", "euler", "linear insertion", "float"):
            self.assertIn(f"  {word} ", done.stdout)

    def test_results_have_their_schema_and_errors_fall(self):
        methods = ("default", "markers, cubic", "linear insertion")
        words = [word for m in methods for word in ("--method", m)]
        done = run("run", "--quick", "--flow", FLOW, *words, "--out", self.out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        found = self.results()
        for name, data in found.items():
            for key, kind in NEEDED.items():
                self.assertIsInstance(data[key], kind, f"{name}: {key}")
            self.assertGreater(data["cpu_s"], 0)
        for method in methods:
            line = sorted((d["parameters"]["h"], d["sd_rel_last"], d["sd_rel_half"])
                          for d in found.values() if d["method"] == method)
            self.assertEqual(len(line), 2, method)
            for fine, coarse in zip(line, line[1:]):
                # Second order: a quarter for half the edge; less than a half in any case.
                self.assertLess(fine[1], 0.5 * coarse[1], method)
                self.assertLess(fine[2], 0.5 * coarse[2], method)
        default = {d["parameters"]["h"]: d for d in found.values() if d["method"] == "default"}
        for d in found.values():
            if d["method"] == "linear insertion":
                self.assertEqual(d["parameters"]["insertion"], "linear")
                self.assertGreater(d["sd_rel_half"], default[d["parameters"]["h"]]["sd_rel_half"])

    def test_exact_shapes_are_shared_rightly(self):
        # If the exact shape is a polygon, each size has its own: with that of another size, the
        # error would be 1e-3 instead of 1e-6.
        done = run("run", "--quick", "--flow", "zalesak", "--method", "default", "--out", self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = self.results()
        self.assertEqual(len(found), 2)
        for data in found.values():
            self.assertLess(data["sd_rel_last"], 2e-6)
            self.assertIsNone(data["sd_rel_half"])

    def test_bad_usage(self):
        def refused(words, *parts):
            done = run(*words)
            self.assertEqual(done.returncode, 2, words)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            for part in parts:
                self.assertIn(part, done.stderr)

        refused(("run", "--flow", "nonsense", "--out", self.out), "--flow", "nonsense", "swirl-260")
        refused(("run", "--method", "magic", "--out", self.out), "--method", "magic", "euler")
        refused(("run",), "--out")
        refused(("jump",), "jump")
        refused(("run", "--out", "/proc/nothing"), "--out", "/proc/nothing")
        self.assertFalse(os.path.exists(self.out))


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()

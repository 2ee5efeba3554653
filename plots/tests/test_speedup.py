# SPDX-License-Identifier: MIT
"""S(n) and U(n) from a result of dsc_bench alone."""
import contextlib
import io
import os
import subprocess
import sys

import speedup as program
from parallel import speedup
from results import load
from tests.samples import PLOTS, Case, bench, row


def own_suite(strategies=("sequential", "cells")):
    """A scene that is named by its edge lengths: strategies differ in the triangles they count."""
    rows = []
    for h, us in (("0.02", 100), ("0.01", 400)):
        for strategy in strategies:
            for threads in (1, 2) if strategy == "cells" else (0,):
                words = f"/threads:{threads}" if threads else ""
                name = f"mine_run/strategy:{strategy}/h:{h}{words}/between_us:0/iterations:1/manual_time"
                rows += row(name, [us * k / max(threads, 1) for k in (1, 1.1, 0.9)],
                            us_per_step=us / max(threads, 1), triangles=1000 + threads)
    return {**bench(), "benchmarks": rows}


class SpeedUp(Case):
    def call(self, *words):
        errors, printed = io.StringIO(), io.StringIO()
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(printed):
            status = program.main(list(words))
        return status, errors.getvalue(), printed.getvalue()

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_draws_in_every_format(self):
        result = self.write("mine.json", own_suite())
        for form, start in {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}.items():
            out = self.path(f"picture.{form}")
            status, errors, printed = self.call(result, "--out", out)
            self.assertEqual((status, errors), (0, ""))
            self.assertIn(out, printed)
            self.assertIn("S(2) = 2.00, U(2) = 1.00", printed)
            with open(out, "rb") as stream:
                self.assertTrue(stream.read().startswith(start))

    def test_sizes_are_those_of_the_suite(self):
        found = speedup.gather_runs(load.read_bench([self.write("mine.json", own_suite())]))
        self.assertEqual([family.name for family in found], ["mine_run"])
        self.assertEqual({p.row.size for p in found[0].points}, {"h = 0.02", "h = 0.01"})
        self.assertEqual(len(found[0].points), 4)

    def test_several_families_become_several_pictures(self):
        both = own_suite()
        both["benchmarks"] += bench()["benchmarks"]
        result = self.write("both.json", both)
        self.assertEqual(self.call(result, "--out", self.path("p.svg"))[0], 0)
        names = ["p-mine_run.svg", "p-scaling_step.svg"]
        self.assertEqual(sorted(n for n in os.listdir(self.folder) if n.endswith("svg")), names)
        self.assertEqual(self.call(result, "--out", self.path("one.svg"), "--case", "mine_run")[0], 0)
        self.assertTrue(os.path.exists(self.path("one.svg")))

    def test_bad_usage_is_refused(self):
        result = self.write("mine.json", own_suite())
        alone = self.write("alone.json", own_suite(["sequential"]))
        for words, expected in (((result, "--out", self.path("p.gif")), "p.gif"),
                                ((alone, "--out", self.path("p.pdf")), "alone.json"),
                                ((self.path("no.json"), "--out", self.path("p.pdf")), "no.json"),
                                ((self.write("cut.json", "{"), "--out", self.path("p.pdf")),
                                 "cut.json"),
                                ((result, "--out", self.path("p.pdf"), "--case", "other"),
                                 "mine_run")):
            status, errors, printed = self.call(*words)
            self.assertEqual((status, printed, errors.count("\n")), (2, "", 1), errors)
            self.assertTrue(errors.startswith("speedup.py: "), errors)
            self.assertIn(expected, errors)

    def test_help(self):
        done = subprocess.run([sys.executable, os.path.join(PLOTS, "speedup.py"), "--help"],
                              check=True, capture_output=True, text=True)
        for word in ("--out", "--case", "S(n)", "U(n)"):
            self.assertIn(word, done.stdout)

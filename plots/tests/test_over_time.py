# SPDX-License-Identifier: MIT
"""The picture of a run over time."""
import contextlib
import io
import json
import math
import os
import tempfile
import unittest

import matplotlib.pyplot as plt

import over_time

SERIES = """step,time,triangles,phases,sd_rel,interface_length,min_angle_deg,collapses,flips,smoothed,splits,events,wall_us
0,0,100,2,0.001,4,30,0,0,0,0,0,0
10,0.5,110,2,0.002,4.5,25,40,20,30,10,0,1000
14,0.7,90,1,0.003,5,20,8,12,16,4,1,400
"""
RESULT = {"scene": "swirl", "strategy": "cells", "machine": "a machine", "commit": "c0ffee",
          "threads": 2}


class OverTime(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path

    def call(self, *arguments):
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            status = over_time.main(list(arguments))
        return status, errors.getvalue()

    def test_draws_in_every_format(self):
        series = self.write("s.csv", SERIES)
        result = self.write("r.json", json.dumps(RESULT))
        for form, start in {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}.items():
            out = os.path.join(self.folder, f"picture.{form}")
            self.assertEqual(self.call(series, "--json", result, "--out", out), (0, ""))
            with open(out, "rb") as stream:
                self.assertTrue(stream.read().startswith(start))

    def test_counts_between_rows_are_those_of_one_step(self):
        columns = over_time.read(self.write("s.csv", SERIES))
        line = over_time.between(columns, "collapses")
        self.assertEqual([count for _, count in line], [4, 2])
        self.assertAlmostEqual(line[1][0], 0.6)

    def test_panels_say_what_they_show(self):
        columns = over_time.read(self.write("s.csv", SERIES))
        figure = over_time.picture(columns, *over_time.words(columns, RESULT))
        self.addCleanup(plt.close, figure)
        titles = [axes.get_title(loc="left") for axes in figure.axes]
        self.assertIn("error against the exact shape", titles)
        texts = " ".join(text.get_text() for text in figure.texts)
        for fact in ("swirl over time, cells", "a machine", "c0ffee", "14 steps", "2 threads"):
            self.assertIn(fact, texts)
        columns["sd_rel"] = [math.nan] * 3
        other = over_time.picture(columns, "a title", "a caption")
        self.addCleanup(plt.close, other)
        titles = [axes.get_title(loc="left") for axes in other.axes]
        self.assertIn("length of the interface", titles)

    def test_bad_files(self):
        out = os.path.join(self.folder, "p.png")
        lines = SERIES.splitlines()
        for text, word in (("", "no column"), ("\n".join(lines[:2]) + "\n", "1 rows"),
                           (SERIES.replace("110", "x"), "'triangles'"),
                           (SERIES.replace("events", "other"), "'events'")):
            status, errors = self.call(self.write("s.csv", text), "--out", out)
            self.assertEqual(status, 2)
            self.assertIn(word, errors)
            self.assertEqual(errors.count("\n"), 1)
        good = self.write("s.csv", SERIES)
        for arguments in ((good, "--out", out + ".gif"), (good + "x", "--out", out),
                          (good, "--out", out, "--json", good)):
            status, errors = self.call(*arguments)
            self.assertEqual((status, errors.count("\n")), (2, 1))
        self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""The programs on the guide's pages print and draw what the pages show."""
import contextlib
import io
import os
import pathlib
import runpy
import tempfile
import unittest

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

GUIDE = pathlib.Path(__file__).parents[2] / "lib" / "guide"
LARGEST = 0.05  # limit on the RMS difference of pictures, because fonts may differ


class Tour(unittest.TestCase):
    def test_programs_do_what_the_pages_say(self):
        here = os.getcwd()
        for name, page in [("swirl", "python.md"), ("grains", "python.md"), ("mullins", "python.md"),
                           ("conduction", "python.md"), ("space", "python.md"), ("shapes", "shapes.md")]:
            page = (GUIDE / page).read_text(encoding="utf-8")
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                printed = io.StringIO()
                os.chdir(folder)
                try:
                    with contextlib.redirect_stdout(printed):
                        runpy.run_path(str(GUIDE / "tour" / f"{name}.py"))
                    drawn, kept = (plt.imread(path)[:, :, :3] for path in (
                        f"{name}.png", GUIDE / "tour" / f"{name}.png"))
                finally:
                    os.chdir(here)
                    plt.close("all")
                self.assertIn(f"It prints `{printed.getvalue().strip()}`", page)
                self.assertEqual(drawn.shape, kept.shape)
                self.assertLess(np.sqrt(np.mean((drawn - kept)**2)), LARGEST)


if __name__ == "__main__":
    unittest.main()

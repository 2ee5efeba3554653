# SPDX-License-Identifier: MIT
"""The picture of a flow."""
import contextlib
import io
import os
import tempfile
import unittest

import matplotlib.pyplot as plt

import flow
from tests.samples import VTU

VELOCITY = ('<PointData><DataArray Name="velocity" NumberOfComponents="3" format="ascii">'
            "0 0 0  0 0 0  0 0 0  0 0 0  3 4 0</DataArray></PointData>\n<CellData>")


class Flow(unittest.TestCase):
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
            status = flow.main(list(arguments))
        return status, errors.getvalue()

    def frame(self, step):
        return self.write(f"bubbles_cells_{step:05}.vtu",
                          VTU.format(x=1).replace("<CellData>", VELOCITY))

    def test_draws_in_every_format(self):
        paths = [self.frame(step) for step in (0, 7)]
        for form, start in {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}.items():
            out = os.path.join(self.folder, f"picture.{form}")
            self.assertEqual(self.call(*paths, "--out", out), (0, ""))
            with open(out, "rb") as stream:
                self.assertTrue(stream.read().startswith(start))

    def test_panels_have_one_scale(self):
        shown = [flow.read(self.frame(step)) for step in (0, 7)]
        figure = flow.picture(shown)
        self.addCleanup(plt.close, figure)
        panels = figure.axes[:2]
        self.assertEqual([axes.get_title(loc="left") for axes in panels], ["step 0", "step 7"])
        for axes in panels:
            self.assertEqual(axes.collections[0].get_clim(), (0, 5))
            self.assertEqual(len(axes.collections[1].get_segments()), 2, "edges of the interface")

    def test_what_is_no_flow_is_said(self):
        still = self.write("swirl_cells_00000.vtu", VTU.format(x=1))
        out = os.path.join(self.folder, "picture.png")
        status, errors = self.call(still, "--out", out)
        self.assertEqual(status, 2)
        self.assertIn("no velocity", errors)
        status, errors = self.call(self.frame(0), "--out", "picture.bmp")
        self.assertEqual(status, 2)
        self.assertIn(".png", errors)

# SPDX-License-Identifier: MIT
"""The gallery, from the thesis's figures to the page, with a program that replaces dsc_scene."""
import contextlib
import html
import io
import os
import pathlib
import re
import sys

import gallery
from gallery import build, figures, layout, make, runs
from gallery.figures import Figure, Histogram, Row
from gallery.runs import Plan
from results import load
from tests.samples import PUBLISHED, VTU, Case

PROGRAM = '''#!{python}
import json, os, sys
words = sys.argv[1:]
if words == ["list"]:
    sys.exit(print("swirl   turns; keys: h"))
if words[1] == "broken":
    sys.exit("dsc_scene: 1 triangle was inverted")
given = {{name: words[words.index(name) + 1] for name in words if name.startswith("--")}}
with open(given["--json"], "w") as file:
    json.dump({{"scene": words[1], "steps": 10, "strategy": "sequential", "triangles_first": 4,
               "triangles_last": 6, "area_ratio": 0.99, "sd_last": 0.01, "area_exact_last": 0.5,
               "sd_rel_last": 0.02, "inverted": 0, "unreached": 0, "machine": "a machine",
               "commit": "c0ffee",
               "parameters": {{"h": 0.5, "dt": 0.1, "integrator": "rk4", "insertion": "cubic"}}}}, file)
if "--series" in words:
    os.makedirs(given["--frames"])
    with open(given["--series"], "w") as file:
        file.write("step,triangles\\n")
        for step in range(0, 11, int(given["--every"])):
            file.write(f"{{step}},{{4 + step}}\\n")
            with open(f"{{given['--frames']}}/{{words[1]}}_sequential_{{step:05}}.vtu", "w") as frame:
                frame.write({frame!r})
'''


def images(text):
    """The alternative texts of a page's pictures."""
    return [html.unescape(alt) for alt in re.findall(r'<img alt="([^"]*)"', text)]


class Gallery(Case):
    ROW = Row(Plan("swirl"), (0, 5, 10), area_ratio="swirl_260_area_ratio", near=(0, 0, 1))

    def blocks(self, *table):
        self.addCleanup(setattr, figures, "FIGURES", figures.FIGURES)
        figures.FIGURES = table
        program = runs.Program(self.program(), self.folder)
        return build.blocks(program, load.read_published(PUBLISHED))

    def program(self):
        path = self.write("dsc_scene", PROGRAM.format(python=sys.executable, frame=VTU.format(x=1)))
        os.chmod(path, 0o755)
        return path

    def test_the_table_names_figures_steps_and_entries_that_exist(self):
        published = load.read_published(PUBLISHED)
        self.assertEqual([figure.number for figure in figures.FIGURES],
                         list(published["thesis"]["figures"]))
        for row in (p for figure in figures.FIGURES for p in figure.parts if isinstance(p, Row)):
            if row.triangles:
                found = load.entry(published, "thesis", row.triangles)["values"]
                self.assertEqual(tuple(v["step"] for v in found), row.steps)
            if row.area_ratio:
                self.assertIn("value", load.entry(published, "thesis", row.area_ratio))

    def test_frames_and_ratios_of_ours_to_the_thesis_s(self):
        (block,), failures = self.blocks(Figure("10.11", (self.ROW,)))
        self.assertEqual(failures, [])
        self.assertEqual([p.sentence for p in block.pictures], [
            "Step 0: 4 triangles.", "Step 5: 4 triangles.", "Step 10: 4 triangles.",
            "A part of step 10, 1 of the domain wide."])
        self.assertEqual(block.rows[0], ("last area / first area", "0.9948639", "0.9900000",
                                         "0.99511"))
        self.assertEqual(block.rows[1][1:], ("0.00514", "0.0100", "1.95"))
        self.assertIn("difference with the exact shape is 0.0200 of", block.ours[0])
        self.assertEqual(block.notes, ["dsc_scene run swirl: h = 0.5, dt = 0.1, rk4, cubic "
                                       "insertion, sequential."])

    def test_histograms_are_of_the_frame(self):
        (block,), failures = self.blocks(Figure("10.17", (Histogram(Plan("swirl"), 10),)))
        self.assertEqual((failures, len(block.pictures)), ([], 1))
        self.assertIn("have an area of at least", block.ours[0])

    def test_a_run_that_fails_is_said(self):
        (block,), failures = self.blocks(Figure("10.3", (Row(Plan("broken"), (0,)),)))
        self.assertEqual(len(failures), 1)
        self.assertIn("ended with 1: dsc_scene: 1 triangle was inverted", block.ours[0])

    def test_few_pictures_stand_in_one_row(self):
        for count, rows in ((0, 0), (5, 1), (6, 2)):
            pictures = [layout.Picture("p.webp", b"", "A & B.", row="ab"[k % 2]) for k in range(count)]
            text = layout.block_html(layout.Block("10.1", "A <title>", "", "", [], pictures=pictures))
            self.assertEqual(text.count("display:grid"), rows)
            self.assertEqual(images(text), ["A & B."] * count)
            self.assertIn("10.1: A &lt;title&gt;</h3>", text)

    def test_the_command_and_the_report_s_section(self):
        out = pathlib.Path(self.path("report"))
        self.assertEqual(gallery.section(out), "")
        self.blocks(Figure("10.1", (Row(Plan("swirl"), (0, 10)),)))
        words = ["--scene", self.program(), "--out", str(out / "gallery")]
        self.assertEqual(make.main(words), 0)
        for text in ((out / "gallery" / "gallery.html").read_text(encoding="utf-8"),
                     gallery.section(out)):
            self.assertEqual(images(text), ["Step 0: 4 triangles.", "Step 10: 4 triangles."])
        self.assertTrue((out / "gallery" / "figure-10.1-step-10.webp").is_file())
        self.blocks(Figure("10.1", (Row(Plan("broken"), (0,)),)))
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(make.main(words), 1)
            for program in (words[1] + "x", self.folder, "/bin/true"):
                self.assertEqual(make.main(["--scene", program, *words[2:]]), 2)
        self.assertEqual(errors.getvalue().count("make.py: "), 4)

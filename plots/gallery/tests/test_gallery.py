# SPDX-License-Identifier: MIT
"""The gallery from the thesis's facts to the page."""
import contextlib
import html.parser
import io
import pathlib
import tempfile
import unittest
from unittest import mock

import gallery
from gallery import build, busy, compare, figures, layout, make, runs, thesis
from gallery.figures import Figure, Histogram, Row
from gallery.runs import Plan
from gallery.tests import samples


class Page(html.parser.HTMLParser):
    """What a page shows; fails on tags that are not closed."""

    def __init__(self, text):
        super().__init__()
        self.open, self.images, self.sources, self.links, self.text = [], [], [], [], ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        kept = {"img": self.images, "source": self.sources, "a": self.links}
        kept.get(tag, []).append(dict(attrs))
        if tag not in ("img", "source", "meta", "link", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise AssertionError(f"</{tag}> closes another tag")

    def handle_data(self, data):
        self.text += data


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.facts = thesis.Facts()

    def builder(self, takes_times=True, **more):
        program = runs.Program(samples.program(str(self.folder), takes_times), self.folder / "runs")
        return build.Builder(program, self.facts, **more)


class FactsOfTheThesis(unittest.TestCase):
    facts = thesis.Facts()

    def test_every_figure_has_a_place_in_the_thesis_s_order(self):
        numbers = [f"10.{k}" for k in range(1, 18)]
        numbers.insert(12, "Table 10.1")
        self.assertEqual(self.facts.numbers(), numbers)
        self.assertEqual([figure.number for figure in figures.FIGURES], numbers)
        for number in numbers:
            self.assertIn(number.lower(), self.facts.figure(number).source)

    def test_the_numbers_agree_with_each_other(self):
        value = self.facts.value
        self.assertAlmostEqual(value("vortex_area_last") / value("vortex_area_first"),
                               value("vortex_area_ratio"), 6)
        for steps in ("260", "420"):
            self.assertAlmostEqual(value(f"swirl_{steps}_area_last") / value("swirl_area_first"),
                                   value(f"swirl_{steps}_area_ratio"), 6)
        for entry in ("scaling_table_10_1", "four_circles"):
            item = self.facts.entry(entry)
            for row in item["values"]:
                self.assertAlmostEqual(item["t_s"] / row["t_n"], row["S"], delta=0.011)
                self.assertAlmostEqual(row["S"] / row["n"], row["U"], delta=0.011)

    def test_the_table_names_steps_and_entries_that_exist(self):
        for figure in figures.FIGURES:
            for part in figure.parts:
                if isinstance(part, Row):
                    if part.triangles:
                        self.assertEqual(tuple(self.facts.triangles(part.triangles)), part.steps)
                    if part.area_ratio:
                        self.facts.value(part.area_ratio)
                elif isinstance(part, Histogram):
                    if part.triangles:
                        self.assertEqual(self.facts.value(part.triangles), 28236)
                else:
                    self.facts.entry(part.entry)


class Built(InFolder):
    ROW = Row(Plan("swirl"), (0, 5, 10), area_ratio="swirl_260_area_ratio")

    def test_frames_at_the_steps_that_were_asked_for(self):
        block = self.builder().block(Figure("10.11", (self.ROW,)))
        self.assertEqual([p.sentence for p in block.pictures], [
            "Step 0: 4 triangles.", "Step 5: 4 triangles.", "Step 10: 4 triangles.",
            "The run in motion, in 11 frames."])

    def test_the_nearest_frames_where_times_cannot_be_asked_for(self):
        block = self.builder(takes_times=False).block(Figure("10.11", (self.ROW,)))
        self.assertEqual(block.pictures[1].sentence,
                         "Step 4 (the frame nearest to step 5): 4 triangles.")

    def test_ratios_are_ours_to_the_thesis_s(self):
        block = self.builder().block(Figure("10.11", (self.ROW,)))
        self.assertEqual(block.rows[0], ("last area / first area", "0.9948639", "0.9900000",
                                         "0.99511"))
        self.assertEqual(block.rows[1][1:], ("0.00514", "0.0100", "1.95"))
        self.assertEqual(compare.ratio(858, 884), "0.971")
        self.assertIn("difference with the exact shape is 0.0200 of", block.ours[0])
        self.assertEqual(block.notes, ["dsc_scene run swirl: h = 0.5, dt = 0.1, rk4, cubic "
                                       "insertion, sequential."])
        run = self.builder().program.run(Plan("swirl"))
        self.assertIn("rk4, its own insertion,", compare.conditions(run, "its own"))

    def test_counts_beside_the_thesis_s(self):
        row = Row(Plan("translation"), (0, 120, 240, 360), triangles="translation_triangles")
        block = self.builder(quick=True).block(Figure("10.1", (row,)))
        self.assertEqual(block.rows, [("triangles at step 0", "884", "4", "0.00452")])
        self.assertIn("1.50 times as many (the thesis's: 1.48 times)", block.ours[0])
        self.assertFalse(any(picture.still for picture in block.pictures))

    def test_a_missing_scene_is_said_to_be_missing_and_is_no_failure(self):
        builder = self.builder()
        block = builder.block(Figure("10.2", (Row(Plan("translation-phase"), (0,)),)))
        self.assertEqual((block.pictures, builder.failures), ([], []))
        self.assertIn("translation-phase is missing", block.ours[0])

    def test_a_run_that_fails_is_a_failure(self):
        builder = self.builder()
        block = builder.block(Figure("10.3", (Row(Plan("broken"), (0,)),)))
        self.assertEqual(len(builder.failures), 1)
        self.assertIn("ended with 1: dsc_scene: 1 triangle was inverted", block.ours[0])

    def test_histograms(self):
        part = Histogram("area", (("one", Plan("swirl")),), "histogram_triangles_sequential")
        block = self.builder().block(Figure("10.13", (part,)))
        self.assertEqual(block.rows, [("triangles, one", "28,236", "4", "1.42e-4")])
        self.assertIn("median area is 1.50 domain units², 0.923 times the mean; 50", block.ours[0])
        part = Histogram("area", (("one", Plan("swirl")),), frame=10)
        block = self.builder().block(Figure("10.17", (part,)))
        self.assertEqual(block.rows, [])  # the thesis gives no number to compare with
        self.assertIn("median area is 0.248 domain units², 1.00 times", block.ours[0])

    def test_threads_are_timed_where_nobody_else_uses_the_cores(self):
        part = figures.Times("swirl", "four_circles", "four")
        for share, cores, ours in ((0.0, 4, ("3.69", "1.00", "0.271")),
                                   (0.9, 4, ("3.69", "–", "–")), (0.0, 2, ("3.69", "–", "–"))):
            with mock.patch("gallery.busy.share", return_value=share), \
                    mock.patch("os.cpu_count", return_value=cores):
                block = self.builder().block(Figure("Table 10.1", (part,)))
            self.assertEqual(block.rows[0], ("four: t_s, sequential", "225 s", "200 ms", "8.89e-4"))
            self.assertEqual(block.rows[1], ("four: S(4) = t_s / t_4", *ours))
            self.assertEqual("others used 90" in block.notes[0], share > 0)
        self.assertTrue(0 <= busy.share(0.01) <= 1)

    def test_equal_plans_are_run_once(self):
        builder = self.builder()
        first = builder.program.run(Plan("swirl"), (0,))
        self.assertIs(builder.program.run(Plan("swirl")), first)
        self.assertIsNot(builder.program.run(Plan("swirl", threads=2)), first)


class Pages(InFolder):
    def block(self, *pictures):
        return layout.Block("10.1", "10.1", "A <title>", "shows", "source", ["ours"], ["note"],
                            list(pictures), [])

    def test_pictures_have_words_and_animations_stop_for_those_who_want_it(self):
        page = Page(layout.fragment([self.block(
            layout.Picture("a.webp", b"still", "A & B."),
            layout.Picture("b.webp", b"moving", "Moves.", still=b"stands"))]))
        self.assertEqual([image["alt"] for image in page.images], ["A & B.", "Moves."])
        self.assertEqual([source["media"] for source in page.sources],
                         ["(prefers-reduced-motion: no-preference)"])
        self.assertEqual(page.sources[0]["srcset"], layout._uri(b"moving"))
        self.assertEqual(page.images[1]["src"], layout._uri(b"stands"))
        self.assertIn("A <title>", page.text)
        self.assertEqual(page.open, [])

    def test_few_pictures_stand_in_one_row(self):
        for count, rows in ((0, []), (5, [5]), (6, [3, 3])):
            pictures = [layout.Picture(f"{k}.webp", b"", "", row=k % 2) for k in range(count)]
            self.assertEqual([len(row) for row in layout.grids(pictures)], rows)

    def test_within_the_budget_still_pictures_come_first(self):
        pictures = [layout.Picture("moving.webp", b"m" * 30_000, "Moves.", still=b"s" * 3_000),
                    layout.Picture("still.webp", b"t" * 30_000, "Stands.")]
        text = layout.fragment([self.block(*pictures)], "gallery/", budget=60_000)
        self.assertLessEqual(len(text), 60_000)
        page = Page(text)
        self.assertEqual([image["alt"] for image in page.images], ["Stands."])
        self.assertEqual([link["href"] for link in page.links], ["gallery/moving.webp"])
        self.assertEqual(len(Page(layout.fragment([self.block(*pictures)])).images), 2)

    def test_the_command_and_the_report_s_section(self):
        table = (Figure("10.1", (Row(Plan("swirl"), (0, 10), moves=False),)),)
        self.addCleanup(setattr, figures, "FIGURES", figures.FIGURES)
        figures.FIGURES = table
        out = self.folder / "report"
        self.assertIsNone(gallery.section({}, out))
        program = samples.program(str(self.folder), True)
        self.assertEqual(make.main(["--scene", program, "--out", str(out / "gallery")]), 0)
        whole = Page((out / "gallery" / "gallery.html").read_text(encoding="utf-8"))
        self.assertEqual((len(whole.images), whole.open), (2, []))
        self.assertIn("c0ffee", whole.text)
        self.assertEqual(len(Page(gallery.section({}, out)).images), 2)
        self.assertTrue((out / "gallery" / "figure-10.1-step-10.webp").is_file())
        figures.FIGURES = (Figure("10.1", (Row(Plan("broken"), (0,)),)),)
        other = self.folder / "other"
        self.assertIn("was inverted", Page(gallery.section({"scene": program}, other)).text)
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(make.main(["--scene", program, "--out", str(other)]), 1)
            self.assertEqual(make.main(["--scene", program + "x", "--out", str(other)]), 2)
        self.assertEqual(errors.getvalue().count("\n"), 2)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""Reading frames, and drawing them."""
import io
import os
import struct
import tempfile
import unittest

import numpy
from PIL import Image, ImageColor

from gallery import animation, charts, mesh
from gallery.shared import style, vtu
from gallery.tests import samples

FORMS = [dict(form="ascii")] + [
    dict(form=form, encoding=encoding, compressed=compressed, header=header)
    for form, encoding in (("binary", "base64"), ("appended", "raw"), ("appended", "base64"))
    for compressed in (False, True) for header in "QI"]


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "frame.vtu")

    def read(self, data):
        with open(self.path, "wb") as file:
            file.write(data)
        return vtu.read(self.path)

    def test_every_form_holds_the_same_mesh(self):
        for form in FORMS:
            with self.subTest(**form):
                frame = self.read(samples.vtu(**form))
                numpy.testing.assert_array_equal(frame.points, samples.POINTS[:, :2])
                numpy.testing.assert_array_equal(frame.triangles.ravel(), samples.CORNERS)
                numpy.testing.assert_array_equal(frame.phases, samples.PHASES)
                numpy.testing.assert_array_equal(frame.values["value"], samples.VALUES)

    def test_a_file_cut_anywhere_is_no_mesh(self):
        for form in FORMS:
            data = samples.vtu(**form)
            for size in range(0, len(data) - len("</VTKFile>\n"), 29):
                with self.assertRaises(vtu.BadFrame):
                    self.read(data[:size])

    def test_bad_meshes(self):
        good = samples.vtu().decode()
        for old, new in (("0 1 4", "0 1 5"), ("5 5 5 5", "5 5 5 9"), ("0 1 1 0<", "0 1 1<"),
                         ("0.0 1.0 1.0 0.0 0.5<", "0.0 1.0<"), ('"phase"', '"faze"')):
            self.assertIn(old, good)
            with self.assertRaises(vtu.BadFrame):
                self.read(good.replace(old, new, 1).encode())
        packed = samples.vtu("appended", compressed=True)
        with self.assertRaisesRegex(vtu.BadFrame, "vtkLZ4"):
            self.read(packed.replace(b"vtkZLib", b"vtkLZ4"))
        sizes = struct.pack("<3Q", 2, 24, 16)  # of the values: 24 and 16 bytes
        self.assertIn(sizes, packed)
        with self.assertRaisesRegex(vtu.BadFrame, "length that it names"):
            self.read(packed.replace(sizes, struct.pack("<3Q", 2, 24, 8)))
        for form in ({}, {"compressed": True}, {"encoding": "base64"}):
            whole = samples.vtu("appended", **form)
            with self.assertRaisesRegex(vtu.BadFrame, "ends too early|Incorrect padding"):
                self.read(whole[:whole.index(b"\n</App") - 2]
                          + b"</AppendedData></VTKFile>\n")
        with self.assertRaisesRegex(vtu.BadFrame, "cannot be read"):
            vtu.read(self.path + "x")


class Pictures(unittest.TestCase):
    def setUp(self):
        self.frame = vtu.Frame(samples.POINTS[:, :2], samples.CORNERS.reshape(-1, 3),
                               samples.PHASES, {"value": samples.VALUES})

    def near(self, image, x, y, colour):
        """Whether the pixel at a place of the domain has about that colour."""
        pixel = image.getpixel((round(x * (image.width - 1)), round((1 - y) * (image.height - 1))))
        return max(abs(a - b) for a, b in zip(pixel, ImageColor.getrgb(colour))) < 12

    def test_interface_lies_between_phases(self):
        self.assertEqual(sorted(map(tuple, mesh.interface(self.frame).tolist())), [(1, 4), (3, 4)])

    def test_phases_and_interface_are_where_they_should_be(self):
        image = mesh.draw(self.frame, 400)
        self.assertEqual(image.size, (400, 400))
        for x, y, colour in ((0.5, 0.15, style.PHASE_FILLS[0]), (0.85, 0.5, style.PHASE_FILLS[1]),
                             (0.5, 0.85, style.PHASE_FILLS[1]), (0.15, 0.5, style.PHASE_FILLS[0]),
                             (0.75, 0.25, style.INTERFACE), (0.25, 0.75, style.INTERFACE)):
            self.assertTrue(self.near(image, x, y, colour), (x, y))

    def test_a_window_shows_a_part(self):
        image = mesh.draw(self.frame, 60, window=(0.8, 0.4, 0.2))
        self.assertTrue(self.near(image, 0.5, 0.5, style.PHASE_FILLS[1]))
        self.assertEqual(image.size, (60, 60))
        image = mesh.draw(self.frame, 60, window=(0.1, 0.4, 0.2))
        self.assertTrue(self.near(image, 0.95, 0.5, style.PHASE_FILLS[0]))

    def test_values_are_the_lightness_of_red(self):
        fills = mesh.value_fills(self.frame, numpy.array([0.5, 0.5, 1, 1, 0.5]))
        self.assertEqual(fills[0], "#ff0101")  # a value of 1/2: pure red
        self.assertEqual(mesh.value_fills(self.frame, numpy.zeros(5)), ["#000000"] * 4)
        self.assertEqual(mesh.value_fills(self.frame, numpy.full(5, 2.0)), ["#ffffff"] * 4)

    def test_animations_loop_and_are_small(self):
        frames = []
        for k in range(60):
            points = self.frame.points.copy()
            points[4] = 0.5, 0.2 + 0.01 * k
            frames.append(vtu.Frame(points, self.frame.triangles, self.frame.phases, {}))
        data, still, count = animation.animate(frames)
        self.assertLessEqual(len(data), animation.LARGEST)
        with Image.open(io.BytesIO(data)) as image:
            self.assertEqual((image.info["loop"], image.format), (0, "WEBP"))
            self.assertEqual((image.n_frames, count), (24, 24))
            image.seek(23)
            last = image.convert("RGB")
        self.assertTrue(self.near(last, 0.85, 0.5, style.PHASE_FILLS[1]))
        self.assertTrue(self.near(last, 0.5, 0.79, style.INTERFACE))
        with Image.open(io.BytesIO(still)) as image:
            self.assertEqual((image.size, image.n_frames), ((220, 220), 1))
        self.assertIsNone(animation.animate(frames, largest=10))
        few = animation.animate(frames, largest=len(data) - 1)
        self.assertLess(few[2], count)
        self.assertIsNone(animation.animate([self.frame]))

    def test_both_ends_are_among_the_frames_picked(self):
        self.assertEqual(animation.picked(100, 4), [0, 33, 66, 99])
        self.assertEqual(animation.picked(3, 30), [0, 1, 2])
        self.assertEqual(animation.picked(0, 30), [])

    def test_charts(self):
        # 1 in [0, 1), 2 in [1, 2), 1 in [2, 4)
        one = {"edges": [0, 1, 2, 4], "counts": [1, 2, 1]}
        self.assertAlmostEqual(charts.median(**one), 1.5)
        self.assertEqual(charts.areas(self.frame, bins=2),
                         {"edges": [0, 0.125, 0.25], "counts": [0, 4]})
        self.assertAlmostEqual(charts.mean(**one), (0.5 + 3 + 3) / 4)
        other = {"edges": [0, 1, 2, 4], "counts": [2, 1, 1]}
        self.assertAlmostEqual(charts.largest_gap(one, other), 0.25)
        for data in (charts.histogram("area", [("one", one), ("other", other)]),
                     charts.shaded(self.frame, self.frame.values["value"], "a title")):
            with Image.open(io.BytesIO(data)) as image:
                self.assertEqual(image.format, "WEBP")
                self.assertGreater(len(image.convert("RGB").getcolors(1 << 20)), 10)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""The page of made-up results as a browser shows it. Needs Chromium, its driver and python3-selenium."""
import os
import shutil
import tempfile
import unittest

from selenium.webdriver.common.keys import Keys

from tests.browser import FOCUS, OVERFLOWS, UNREADABLE, Browser
from tests.samples import Case

WIDTHS = (400, 1000, 1600)


class Page(Case):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(shutil.which("chromedriver"), shutil.which("chromium"))
        cls.addClassCleanup(cls.browser.close)
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = cls.page = place.name

    def setUp(self):
        super().setUp()
        if self.page == self.place:  # drawn once, by the first test
            self.folder = self.place
            status, errors, _ = self.run_report(*self.inputs(), "--formats", "png")
            self.assertEqual((status, errors), (0, ""))
            Page.page = os.path.join(self.folder, "out", "index.html")

    def test_opens_from_disk_without_network_or_error(self):
        self.browser.show(self.page)
        self.browser.unfold()
        pictures = self.browser.ask(
            "return Array.from(document.images, (i) => [i.alt, i.complete && i.naturalWidth > 0]);")
        self.assertGreater(len(pictures), 0)
        self.assertEqual([alt for alt, loaded in pictures if not loaded], [])
        self.assertEqual([alt for alt, _ in pictures if not alt], [])
        others = self.browser.ask(
            "return performance.getEntriesByType('resource').map((e) => e.name)"
            ".filter((n) => !n.startsWith('data:'));")
        self.assertEqual(others, [])
        self.assertEqual(self.browser.errors(), [])

    def test_can_be_sent_on(self):
        self.assertLess(os.path.getsize(self.page), 5e6)
        folder = os.path.dirname(self.page)
        sizes = [os.path.getsize(os.path.join(place, name))
                 for place, _, names in os.walk(folder) for name in names]
        self.assertLess(sum(sizes), 25e6)

    def test_every_link_leads_somewhere(self):
        self.browser.show(self.page)
        links = self.browser.ask(
            "return Array.from(document.links, (a) => a.getAttribute('href'));")
        self.assertGreater(len(links), 5)
        for link in links:
            if link.startswith("#"):
                self.assertTrue(self.browser.ask(
                    "return !!document.getElementById(arguments[0]);", link[1:]), link)
            else:
                self.assertTrue(os.path.isfile(os.path.join(os.path.dirname(self.page), link)),
                                link)

    def test_fits_and_can_be_read_at_every_width(self):
        for width in WIDTHS:
            for dark in (False, True):
                with self.subTest(width=width, dark=dark):
                    self.browser.show(self.page, width, dark)
                    self.assertEqual(self.browser.ask(OVERFLOWS), [])
                    self.browser.unfold()
                    self.assertEqual(self.browser.ask(OVERFLOWS), [])
                    self.assertEqual(self.browser.ask(UNREADABLE), [])

    def test_the_keyboard_reaches_everything_in_order(self):
        self.browser.show(self.page)
        first = self.browser.tab()
        self.assertEqual(first["place"], 0)
        for place in range(1, min(first["count"], 120)):
            now = self.browser.tab()
            self.assertIsNotNone(now, f"no focus at {place}")
            self.assertEqual(now["place"], place, now["name"])
            self.assertTrue(now["seen"], f"the focus cannot be seen on {now['name']}")

    def test_tables_sort_by_enter(self):
        self.browser.show(self.page)
        self.browser.unfold()
        column = """
            const head = Array.from(document.querySelectorAll("th.n")).find((h) => new Set(
              Array.from(h.closest("table").tBodies[0].rows, (r) => r.cells[h.cellIndex].dataset.v)
              ).size > 2);
            window.head = head;
            head.querySelector("button").focus();"""
        values = ("return Array.from(head.closest('table').tBodies[0].rows, "
                  "(r) => Number(r.cells[head.cellIndex].dataset.v)).filter((v) => !isNaN(v));")
        sense = ("return Array.from(head.parentElement.cells, (h) => [h === head, "
                 "h.getAttribute('aria-sort')]);")
        self.browser.ask(column)
        before = self.browser.ask(values)
        for direction, backwards in (("ascending", False), ("descending", True)):
            self.browser.press(Keys.ENTER)
            self.assertEqual(self.browser.ask(values), sorted(before, reverse=backwards))
            for mine, said in self.browser.ask(sense):
                self.assertEqual(said, direction if mine else "none")
        self.assertEqual(self.browser.ask(FOCUS)["name"].split()[0], "BUTTON")

    def test_a_link_opens_the_part_it_leads_to(self):
        closed = "return document.querySelector('details.part:not([open])').id;"
        opened = "return document.getElementById(arguments[0]).open;"
        self.browser.show(self.page)
        part = self.browser.ask(closed)
        self.browser.ask("document.querySelector(`nav a[href='#${arguments[0]}']`).focus();", part)
        self.browser.press(Keys.ENTER)
        self.assertTrue(self.browser.ask(opened, part))
        self.browser.show(f"{self.page}#{part}")
        self.assertTrue(self.browser.ask(opened, part))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""The section of what the tests notice: seeded faults and mutants."""
import re

from page import faults as section
from tests.samples import Case, faults, mutants


class Faults(Case):
    def page(self, *words):
        return self.run_report(*words)[2]

    def read(self, change=lambda found: None):
        data = faults()
        change(data["faults"])
        return section.read(self.write("faults.json", data))

    def test_without_results_it_says_so(self):
        page = self.page("--formats", "png")
        self.assertIn(section.NOT_RUN, page.replace("&#x27;", "'"))

    def test_each_fault_has_a_row_with_its_test_and_time(self):
        text = section.table(self.read())
        rows = re.findall(r"<td[^>]*>([^<]*)</td>", text)
        self.assertEqual(rows[:7], ["early-end", "io", "limit", "A file ends early.", "hashes",
                                    "crashed", "4.0 s"])
        self.assertIn("quality: Histogram.Bins", rows)
        self.assertRegex(text, r'<td class="[^"]*bad"[^>]*>nothing</td>')

    def test_the_sentence_counts_and_names_what_nothing_caught(self):
        self.assertIn("The tests caught 2 of 3 seeded faults, 1 of them the tests of the fault&#x27;s "
                      "own room, in 2.1 CPU seconds at the median; nothing caught all-wrong.",
                      section.table(self.read()))
        good = section.table(self.read(lambda found: found.pop("all-wrong")))
        self.assertIn("at the median.", good)
        self.assertNotIn("nothing", good)

    def test_mutants_are_counted_by_room(self):
        text = section.mutants_table(section.read_mutants(self.write("m.json", mutants())))
        self.assertIn("Of 4 mutants, small changes made by rule, the tests caught 2; 1 cannot be told "
                      "from the original, and 1 survives: a score of 67 %.", text)
        rows = re.findall(r"<td[^>]*>([^<]*)</td>", text)
        self.assertEqual(rows, ["base", "2", "1", "1", "0", "100 %", "io", "2", "1", "0", "1", "50 %"])

    def test_both_are_part_of_the_page(self):
        page = self.page("--faults", self.write("faults.json", faults()), "--mutants",
                         self.write("mutants.json", mutants()), "--formats", "png")
        self.assertIn('id="faults"', page)
        self.assertIn("2 of 3 seeded faults", page)
        self.assertIn("a score of 67 %", page)

    def test_empty_lists_prove_nothing(self):
        self.assertIn("proves nothing", section.table({}))
        self.assertIn("proves nothing", section.mutants_table([]))

    def test_entries_without_what_is_shown_are_refused(self):
        for key in ("room", "says", "cpu_s", "caught_by", "test", "own"):
            data = faults()
            del data["faults"]["bin-dropped"][key]
            self.assert_refused(["--faults", self.write("f.json", data)], key, "bin-dropped")
        data = mutants()
        del data["mutants"]["0b"]["killed_by"]
        self.assert_refused(["--mutants", self.write("m.json", data)], "killed_by", "0b")

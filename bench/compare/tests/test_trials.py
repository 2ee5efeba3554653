# SPDX-License-Identifier: MIT
"""The trials of the comparison: the lines that they quote are in the sources, and the table counts."""
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import seeded  # noqa: E402
import trials  # noqa: E402


def row(kind, slower=(), undecided=()):
    return {"kind": kind, "slower": list(slower), "undecided": list(undecided), "seconds": 2.0,
            "load": 1.0}


class Sources(unittest.TestCase):
    def test_the_end_of_a_step_is_where_it_is_quoted(self):
        text = (seeded.PROJECT / seeded.FILE).read_text(encoding="utf-8")
        slow = seeded.with_line(text)
        self.assertEqual(slow.count("seeded::slow_down("), 1)
        self.assertIn("return report;", slow[slow.index(seeded.LINE):][:100])

    def test_other_sources_are_refused(self):
        for text in ("", 2 * seeded.END):
            with self.assertRaises(seeded.CannotSeed):
                seeded.with_line(text)

    def test_names_of_variants_have_one_length(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "program")
            program.write_text("", encoding="utf-8")
            names = {seeded.variant(program, pathlib.Path(folder), kind, 7).name
                     for kind in seeded.KINDS}
            self.assertEqual({len(name) for name in names}, {len("plain-0007")})
            for kind, amount in (("other", 1), ("delay", 10_000), ("delay", -1)):
                with self.assertRaises(seeded.CannotSeed):
                    seeded.variant(program, pathlib.Path(folder), kind, amount)


class Table(unittest.TestCase):
    def test_caught_by_the_figure_that_was_made_slower(self):
        self.assertTrue(trials.is_caught(row("delay", ["swirl/steps, CPU"])))
        self.assertFalse(trials.is_caught(row("delay", ["swirl/instructions"])))
        self.assertFalse(trials.is_caught(row("count", ["swirl/allocations a step"])))
        self.assertTrue(trials.is_caught(row("alloc", ["swirl/allocations a step"])))
        self.assertFalse(trials.is_caught(row("plain", ["swirl/steps, CPU"])))

    def test_what_else_is_slower_is_a_false_alarm(self):
        found = trials.table([row("plain"), row("plain", ["swirl/steps, CPU"]),
                              row("delay", ["swirl/steps, CPU", "swirl/instructions"]),
                              row("delay", undecided=["swirl/steps, CPU"])])
        self.assertEqual((found["plain"]["runs"], found["plain"]["false_alarms"]), (2, 1))
        self.assertEqual((found["delay"]["caught"], found["delay"]["false_alarms"],
                          found["delay"]["undecided"]), (1, 1, 1))

    def test_the_promise(self):
        good = [row("plain"), row("count", ["swirl/instructions"])]
        self.assertTrue(trials.is_kept(trials.table(good)))
        for bad in (row("plain", ["swirl/step, median"]), row("count"),
                    row("count", ["swirl/step, median"])):
            self.assertFalse(trials.is_kept(trials.table([*good, bad])))

    def test_the_plan_has_all_of_them_once(self):
        found = list(trials.plan(2, 3))
        self.assertEqual(len(found), len(set(found)))
        self.assertEqual(sum(kind == "plain" for kind, _ in found), 3)
        self.assertEqual(sum(kind == "delay" for kind, _ in found), 2)

    def test_what_was_done_is_not_done_again(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "trials.json")
            trials.Record(path).add(row("plain"))
            again = trials.Record(path)
            self.assertTrue(again.is_done("plain", 0))
            self.assertFalse(again.is_done("plain", 1))
            self.assertFalse(again.is_done("count", 0))
            self.assertEqual(os.listdir(folder), ["trials.json"])


if __name__ == "__main__":
    unittest.main()

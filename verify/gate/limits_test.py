# SPDX-License-Identifier: MIT
"""Each limit stands in the ratio to its measurement that its note states: one that has been loosened,
or that a measurement nearly touches, is noticed without a run. After a run of the gate, whose result
DSC_GATE_RESULT names, the measurements themselves are compared. Standard library only."""
import json
import os
import pathlib
import re
import unittest

LIMITS = pathlib.Path(__file__).parent / "limits.json"
NUMBER = r"(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?)"
# In the order in which they are looked for: of several the first is the measurement.
MEASURED = ("measured " + NUMBER, "up to " + NUMBER, "orders had " + NUMBER, "runs had " + NUMBER)
WRITTEN = "when this was written"
# By how much a measurement may have moved since, over itself.
MOVED = 0.1
# Rounding errors are not compared with each other.
ROUNDING = 1e-12
# What a note says of the ratio of limit to measurement, and the least and largest that may be meant.
# Limits are rounded to one or two digits, away from the measurement.
STATED = (("kept from", 1.02, 1.9), ("half as much again", 1.4, 1.9), ("a tenth above", 1.05, 1.2),
          ("a tenth below", 0.8, 0.95), ("less 15 %", 0.8, 0.9))
# Of a requirement: it may be met by a wide margin, but not by any.
REQUIRED = (1.02, 3.0)


def entries():
    limits = json.loads(LIMITS.read_text(encoding="utf-8"))["limits"]
    for check, scenes in limits.items():
        for scene, entry in scenes.items():
            yield f"{check}, {scene}", entry["value"], entry["note"]


def measured(note):
    """The measurement that a note names, or None."""
    for words in MEASURED:
        if found := re.search(words, note):
            return float(found.group(1))
    return None


def problem(value, note):
    """What is wrong with the limit, or nothing."""
    if note.startswith("required") and value in (0, 1):
        return ""  # a count: nothing may be inverted, all threads give one result
    found = measured(note)
    if found is None:
        return "no measurement is named"
    if abs(found) <= ROUNDING:
        return "" if 0 <= value <= ROUNDING else "the limit of a rounding error is larger than that"
    ratio = value / found
    for words, least, most in STATED:
        if words in note:
            return "" if least <= ratio <= most else f"{ratio:.3g} times {found}, said to be {words}"
    if not note.startswith("required"):
        return "the note states no ratio"
    least, most = REQUIRED
    ratio = max(ratio, 1 / ratio)  # of lower limits as well
    return "" if least <= ratio <= most else f"{ratio:.3g} times from {found}"


class Limits(unittest.TestCase):
    def test_stand_in_the_ratio_that_they_state(self):
        count = 0
        for name, value, note in entries():
            count += 1
            with self.subTest(name):
                self.assertEqual(problem(value, note), "")
        self.assertGreater(count, 300)

    @unittest.skipUnless("DSC_GATE_RESULT" in os.environ, "after a run of the gate")
    def test_measurements_are_those_of_the_last_run(self):
        result = json.loads(pathlib.Path(os.environ["DSC_GATE_RESULT"]).read_text(encoding="utf-8"))
        for row in result["checks"]:
            noted = measured(row["note"])
            if WRITTEN in row["note"] and noted is not None and abs(noted) > ROUNDING:
                with self.subTest(f"{row['check']}, {row['scene']}"):
                    self.assertAlmostEqual(row["measured"] / noted, 1, delta=MOVED)

    def test_a_wrong_one_is_noticed(self):
        good = "measured 0.004 when this was written, half as much again"
        self.assertEqual(problem(0.006, good), "")
        for value, note in ((0.06, good), (0.00401, good), (0.003, good), (0.006, "by guess"),
                            (1e-6, "required; measured 8e-15 when this was written"),
                            (1e-3, "required of the method"),
                            (0.501, "required; measured 0.5 when this was written"),
                            (1e-9, "any two of 51 sequential runs differ by up to 0; a tenth above")):
            self.assertNotEqual(problem(value, note), "", note)


if __name__ == "__main__":
    unittest.main()

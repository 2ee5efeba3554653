# SPDX-License-Identifier: MIT
"""The rules by which mutants are made, the sample, the list of those that nothing can tell from the
original, and how their results are counted."""
import pathlib
import unittest

import mutants
import programs
import score
import trials

ROOT = pathlib.Path(__file__).resolve().parents[2]


def of_line(line):
    return [(rule, changed) for rule, _, changed in mutants.changes_in(line)]


class Rules(unittest.TestCase):
    def test_conditions(self):
        self.assertEqual(of_line("    if (a < b && c) {"),
                         [("condition negated", "!(a < b && c)"), ("< to <=", "a <= b && c"),
                          ("&& to ||", "a < b || c")])
        self.assertEqual(of_line("    for (int i = 0; i < n; ++i) {")[1], ("< to <=", "i <= n"))

    def test_values(self):
        self.assertEqual(of_line("    return 2 * x;"),
                         [("* to +", "2 + x"), ("number one more", "3 * x")])
        self.assertEqual(of_line("    const double x = a - b;"), [("- to +", "a + b")])

    def test_calls(self):
        self.assertEqual(of_line("    list.clear();"), [("call left out", "")])
        self.assertEqual(of_line("    list.reserve(3 + n);"), [])
        self.assertEqual(of_line("    throw InputError(x);"), [])

    def test_what_the_compiler_evaluates_has_none(self):
        self.assertEqual(of_line("    constexpr int n = 3 + 4;"), [])

    def test_switches(self):
        text = "int f(int a) {\n    return a + 1;\n}\n"
        numbered = list(enumerate(mutants.candidates_in("lib/dsc/x/f.cpp", text), 1))
        self.assertEqual(mutants.with_switches(text, numbered), mutants.INCLUDE +
                         "int f(int a) {\n    return (::dsc::mutant::on(2) ? (a + 2) : "
                         "(::dsc::mutant::on(1) ? (a - 1) : (a + 1)));\n}\n")

    def test_equal_lines_have_keys_of_their_own(self):
        found = list(mutants.candidates_in("lib/dsc/x/f.cpp", "    f();\n    f();\n"))
        self.assertEqual(len({mutant.key for mutant in found}), 2)


class Sample(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = mutants.candidates(ROOT)

    def test_is_of_all_rooms(self):
        self.assertGreater(len(self.found), 5000)
        drawn = mutants.sample(self.found, 1000, "1")
        self.assertEqual(len({mutant.key for mutant in drawn}), 1000)
        self.assertEqual({mutant.room for mutant in drawn}, {mutant.room for mutant in self.found})
        self.assertTrue({mutant.room for mutant in drawn} <= set(programs.OWN))

    def test_stays_where_other_lines_change(self):
        drawn = mutants.sample(self.found, 500, "1")
        fewer = [mutant for mutant in self.found if mutant.room != "io"]
        again = set(mutants.sample(fewer, 500, "1"))
        self.assertTrue({mutant for mutant in drawn if mutant.room != "io"} <= again)
        self.assertNotEqual(drawn, mutants.sample(self.found, 500, "2"))

    def test_equivalent_ones_are_in_the_sources(self):
        there = {mutant.says for mutant in self.found}
        for says, why in mutants.read_equivalent().items():
            with self.subTest(says):
                self.assertTrue(says in there, "the sources have no such line, or no such change of it")
                self.assertGreater(len(why), 20)

    def test_all_test_programs_are_asked(self):
        names = programs.test_targets(ROOT)
        for name in ("test_base", "test_parallel", "test_hashes"):
            self.assertIn(name, names)
        self.assertNotIn("test_hard_long", names)


class Results(unittest.TestCase):
    def test_rounds_double(self):
        tests = [trials.Test("p", str(k), 0.09) for k in range(20)]
        self.assertEqual([len(one) for one in trials.rounds_of(tests)], [3, 6, 11])
        slow = [trials.Test("p", "a", 9), trials.Test("p", "b", 9)]
        self.assertEqual([len(one) for one in trials.rounds_of(slow)], [1, 1])

    def test_score(self):
        survives = {"killed_by": None, "tried": ["a"], "left": 0, "equivalent": None}
        entries = [{"killed_by": "io", "how": "failed", "own": True},
                   {"killed_by": "hashes", "how": "did not end", "own": False},
                   survives, {**survives, "tried": []}, {**survives, "left": 3},
                   {**survives, "equivalent": "It is the same."}]
        self.assertAlmostEqual(score.share(entries), 2 / 5)
        found = score.counts(entries)
        self.assertEqual([found[key] for key in ("caught", "equivalent", "survivors", "not reached",
                                                 "not all tried", "by time", "broad", "own")],
                         [2, 1, 3, 1, 1, 1, 1, 1])


if __name__ == "__main__":
    unittest.main()

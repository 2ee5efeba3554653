# SPDX-License-Identifier: MIT
"""The table of seeded faults and the list of equivalent mutants fit the sources, and the sources know
nothing of them."""
import os
import pathlib
import re
import subprocess
import unittest

import faults
import mutants

HERE = pathlib.Path("verify/faults")
# Spelt so that this file does not contain them.
SWITCH = re.compile("fault" + "::on|DSC_" + "FAULT|fault" + r"/switch\.h")


class Table(unittest.TestCase):
    table = faults.read_table()

    def test_entries_are_well_formed(self):
        self.assertGreaterEqual(len(self.table), 60)
        self.assertEqual({fault.kind for fault in self.table}, set(faults.KINDS))
        self.assertEqual(len({fault.name for fault in self.table}), len(self.table))
        for fault in self.table:
            self.assertIn(fault.form, ("expression", "statement", "text") if fault.is_cpp else ("text",))
            self.assertIn("FAULT", fault.faulty if fault.is_cpp and fault.form == "text" else "FAULT")
            self.assertNotEqual(fault.faulty, fault.sought, fault.name)

    def test_each_is_found_once_and_none_overlaps_with_another(self):
        faults.texts_with(self.table)
        for fault in self.table:
            if not fault.is_cpp:
                fault.place_in((faults.ROOT / fault.file).read_text(encoding="utf-8"))

    def test_rooms_have_tests_and_a_turn(self):
        for fault in self.table:
            self.assertIn(fault.room, faults.OWN)
            self.assertLessEqual(set(fault.also), set(faults.all_tests()), fault.name)
        text = "".join((faults.ROOT / folder / "CMakeLists.txt").read_text(encoding="utf-8")
                       for folder in ("verify", "lib/scenes"))
        built = re.findall(r"(?:dsc_add_tests|add_executable)\((\w+)", text)
        self.assertEqual([name for name in faults.targets(faults.all_tests()) if name not in built], [])
        counts = [sum(fault.room in some for fault in self.table) for some in faults.tenths(self.table)]
        self.assertEqual(sum(counts), len(self.table))
        self.assertLess(max(counts), 2 * min(counts))


class Mutants(unittest.TestCase):
    def of_line(self, line):
        return [(rule, changed) for rule, _, changed in mutants.changes_in(line)]

    def test_are_made_by_rule(self):
        self.assertEqual(self.of_line("    if (a < b && c) {"),
                         [("condition negated", "!(a < b && c)"), ("< to <=", "a <= b && c"),
                          ("&& to ||", "a < b || c")])
        self.assertEqual(self.of_line("    return 2 * x;"),
                         [("* to +", "2 + x"), ("number one more", "3 * x")])
        self.assertEqual(self.of_line("    list.clear();"), [("call left out", "")])
        for line in ("    list.reserve(3 + n);", "    throw InputError(x);", "    constexpr int n = 3 + 4;"):
            self.assertEqual(self.of_line(line), [])

    def test_equivalent_ones_are_in_the_sources(self):
        there = {mutant.says for mutant in mutants.candidates()}
        self.assertEqual([says for says in mutants.read_equivalent() if says not in there], [])


class Sources(unittest.TestCase):
    def test_an_unknown_option_is_refused_before_anything_is_done(self):
        for options in (["--colour"], ["predicates"], ["--own", "-x"]):
            done = subprocess.run([faults.ROOT / "verify/faults.sh", *options], text=True, timeout=10,
                                  capture_output=True, check=False, stdin=subprocess.DEVNULL)
            self.assertEqual((done.returncode, done.stdout), (2, ""), options)
            self.assertIn(options[-1], done.stderr)

    def test_have_no_switch(self):
        files = [file for file in faults.files_of(faults.ROOT) if not file.is_relative_to(HERE)
                 and file.suffix in (".h", ".cpp", ".txt", ".cmake", ".in")]
        self.assertGreater(len(files), 500)
        for file in files:
            text = (faults.ROOT / file).read_text(encoding="utf-8", errors="replace")
            self.assertIsNone(SWITCH.search(text), f"{file} knows of seeded faults")

    def test_the_library_has_no_symbol_of_it(self):
        symbols = subprocess.run(["nm", "--demangle", os.environ["DSC_BUILD"] + "/lib/dsc/libdsc.a"], text=True,
                                 capture_output=True, check=True).stdout
        self.assertIn("dsc::Simulation<double>::step", symbols)
        self.assertNotIn("dsc::fault", symbols)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: MIT
"""The table of seeded faults fits the sources, and the sources know nothing of it."""
import os
import pathlib
import re
import subprocess
import unittest

import catalogue
import overlay
import programs
import run

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path("verify/faults")
# Spelt so that this file does not contain them.
SWITCH = re.compile("fault" + "::|DSC_" + "FAULT|fault" + r"/fault\.h")
LEAST = 60


class Table(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.faults = catalogue.read_table()  # throws where an entry or a name is wrong

    def test_has_faults_of_all_kinds(self):
        self.assertGreaterEqual(len(self.faults), LEAST)
        self.assertEqual({fault.kind for fault in self.faults}, set(catalogue.KINDS))

    def test_each_is_found_once(self):
        for fault in self.faults:
            with self.subTest(fault.name):
                catalogue.place_of(fault, (ROOT / fault.file).read_text(encoding="utf-8"))

    def test_each_changes_something(self):
        for fault in self.faults:
            with self.subTest(fault.name):
                self.assertNotEqual(fault.faulty.split(), fault.parts[1].split())
                if fault.is_cpp and fault.form == "text":
                    self.assertIn("FAULT", fault.faulty)

    def test_none_overlaps_with_another(self):
        for file in {fault.file for fault in self.faults if fault.is_cpp}:
            mine = [fault for fault in self.faults if fault.file == file]
            text = overlay.with_switches((ROOT / file).read_text(encoding="utf-8"), mine)
            for fault in mine:
                asked = fault.faulty.count("FAULT") if fault.form == "text" else 1
                self.assertEqual(text.count(f'on("{fault.name}")'), asked)

    def test_rooms_have_tests(self):
        for fault in self.faults:
            self.assertIn(fault.room, programs.OWN)
            self.assertLessEqual(set(fault.also), set(programs.all_names()), fault.name)
        text = "".join((ROOT / folder / "CMakeLists.txt").read_text(encoding="utf-8")
                       for folder in ("verify", "lib/scenes"))
        built = re.findall(r"(?:dsc_add_tests|add_executable)\((\w+)", text)
        self.assertEqual([name for name in programs.targets() if name not in built], [])

    def test_each_has_its_turn(self):
        sets = run.tenths(self.faults)
        self.assertEqual(sorted(room for some in sets for room in some),
                         sorted({fault.room for fault in self.faults}))
        counts = [sum(fault.room in some for fault in self.faults) for some in sets]
        self.assertLess(max(counts), 2 * min(counts))

    def test_their_own_tests_alone_are_built(self):
        self.assertEqual(programs.targets(["sizes", "flows", "limits", "gate"]),
                         ["test_sizes", "test_figures", "dsc_verify"])
        self.assertLess(len(programs.targets(["plots", "passes"])), len(programs.targets()))


class Program(unittest.TestCase):
    def test_an_unknown_option_is_refused_before_anything_is_done(self):
        for options in (["--colour"], ["predicates"], ["--own", "-x"]):
            done = subprocess.run([ROOT / "verify/faults.sh", *options], text=True, timeout=10,
                                  capture_output=True, check=False, stdin=subprocess.DEVNULL)
            self.assertEqual((done.returncode, done.stdout), (2, ""), options)
            self.assertIn(options[-1], done.stderr)


class Sources(unittest.TestCase):
    def test_have_no_switch(self):
        count = 0
        for file in overlay.files_of(ROOT):
            if file.is_relative_to(HERE) or file.suffix not in (".h", ".cpp", ".txt", ".cmake", ".in"):
                continue
            count += 1
            text = (ROOT / file).read_text(encoding="utf-8", errors="replace")
            self.assertIsNone(SWITCH.search(text), f"{file} knows of seeded faults")
        self.assertGreater(count, 500)

    def test_the_library_has_no_symbol_of_it(self):
        symbols = subprocess.run(["nm", "--demangle", os.environ["DSC_LIBRARY"]], text=True,
                                 capture_output=True, check=True).stdout
        self.assertIn("dsc::Simulation<double>::step", symbols)
        self.assertNotIn("dsc::fault", symbols)

    def test_the_switch_would_be_seen(self):
        text = catalogue.read_table()[0].with_switch()
        self.assertIsNotNone(SWITCH.search(text))


if __name__ == "__main__":
    unittest.main()

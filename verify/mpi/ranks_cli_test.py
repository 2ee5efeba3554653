# SPDX-License-Identifier: MIT
"""Several processes share the work of a run: the same bits, one voice, one end."""
import os
import shutil
import unittest
import unittest.mock

import disks
import launcher
from launcher import SHORT, Launched

CELLS = ["--strategy", "cells", "--submeshes", "6"]


class Ranks(Launched):
    def test_the_result_is_that_of_one_process(self):
        alone = self.result(None, "swirl", *SHORT, *CELLS)
        self.assertNotIn("ranks", alone)
        for ranks in (1, 3):
            result = self.result(ranks, "swirl", *SHORT, *CELLS)
            self.expect_same(result, alone, f"{ranks} ranks")
            self.assertEqual(result["ranks"], ranks)
            self.assertEqual(result["bytes_per_step"] > 0, ranks > 1)
            times = result["rank_us_per_step"]
            self.assertEqual(sorted(times), ["repeat", "tell", "wait", "work"])
            for name, value in times.items():
                self.assertEqual(value > 0, ranks > 1, f"{name} of {ranks} ranks")
            whole = 1e6 * result["wall_s"] / result["steps"]
            self.assertLessEqual(sum(times.values()), whole)

    def test_messages_longer_than_any_before_come_whole(self):
        fine = ["grains", "--set", "h=0.01", "--stop-after", "2", *CELLS]
        result = self.result(3, *fine, code=1)
        self.expect_same(result, self.result(None, *fine, code=1), "long messages")
        self.assertGreater(result["bytes_per_step"], 100_000)  # of some messages

    def test_one_of_them_speaks(self):
        code, out, words = self.call(2, "list")
        self.assertEqual((code, words), (0, []))
        self.assertEqual(out.count("speedup-four-circles"), 1)
        code, out, words = self.call(2, "run", "swirl", *SHORT)
        self.assertEqual((code, words), (0, []))
        self.assertEqual(out.count("swirl (cells, 1 thread)"), 1, "cells are the choice")

    def test_what_cannot_be_shared_is_refused(self):
        for strategy in ("sequential", "reference", "copy"):
            code, out, words = self.call(2, "run", "swirl", *SHORT, "--strategy", strategy)
            self.assertEqual((code, out, len(words)), (2, "", 1), words)
            for word in ("--strategy", f"'{strategy}' in 2 processes", "cells"):
                self.assertIn(word, words[0])
        code, out, words = self.call(1, "run", "swirl", *SHORT, "--strategy", "sequential")
        self.assertEqual((code, words), (0, []))

    def test_a_program_without_mpi_says_so(self):
        alone = self.path("dsc_scene")  # nothing beside it
        shutil.copy(launcher.SCENE, alone)
        with unittest.mock.patch.object(launcher, "SCENE", alone):
            code, out, words = self.call(2, "run", "swirl", *SHORT)
            self.assertEqual((code, out, len(words)), (2, "", 1), words)
            self.assertIn("built without MPI: got 2 processes", words[0])
            self.assertEqual(self.call(1, "run", "swirl", *SHORT)[0], 0)

    def test_what_only_one_of_them_knows_ends_all(self):
        code, out, words = self.call(3, "run", "swirl", *SHORT, "--json", "none/r.json")
        self.assertEqual((code, out, len(words)), (2, "", 1), words)
        self.assertIn("none/r.json", words[0])
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_checkpoint_goes_on_in_any_number(self):
        whole = self.result(None, "grains", *SHORT, *CELLS)
        self.result(2, "grains", *SHORT, *CELLS, "--checkpoint", "c", "--stop-after", "2", code=1)
        for ranks in (None, 1, 3):
            self.expect_same(self.result(ranks, "--resume", "c"), whole, f"{ranks} ranks")

    def test_a_damaged_checkpoint_is_refused_by_all(self):
        self.result(2, "swirl", *SHORT, *CELLS, "--checkpoint", "c", "--stop-after", "2", code=1)
        with open(self.path("c"), "r+b") as stream:
            stream.truncate(1000)
        for ranks in (None, 2):
            code, out, words = self.call(ranks, "run", "--resume", "c", "--json", "r.json")
            self.assertEqual((code, out, len(words)), (1, "", 1), words)
            self.assertIn("c: is incomplete", words[0])
        self.assertEqual(os.listdir(self.folder), ["c"])

    def test_a_full_device_ends_all_with_one_sentence(self):
        disks.lead_to_full(self.path("c.part"))
        code, out, words = self.call(2, "run", "swirl", *SHORT, "--checkpoint", "c", "--every", "2")
        self.assertEqual((code, out, len(words)), (1, "", 1), words)
        self.assertIn("c: writing failed: No space left on device", words[0])
        self.assertEqual(os.listdir(self.folder), [])

    def test_files_are_those_of_one_process(self):
        outputs = ["--frames", "f", "--events", "e", "--edits", "d", "--series", "s",
                   "--outlines", "o"]
        contents = []
        for ranks in (None, 2):
            self.result(ranks, "drop-and-pool", *SHORT, *CELLS, *outputs)
            read = {}
            for folder, _, names in os.walk(self.folder):
                for name in names:
                    path = os.path.join(folder, name)
                    if not name.endswith(("vtu", ".pvd")):  # see frames_test.py
                        with open(path, "rb") as stream:
                            read[os.path.relpath(path, self.folder)] = stream.read()
                    os.remove(path)
            contents.append(read)
        self.assertEqual(sorted(contents[0]), sorted(contents[1]))
        for name, bytes_alone in contents[0].items():
            if name == "s":  # times are among its columns
                self.assertEqual(len(bytes_alone.splitlines()), len(contents[1][name].splitlines()))
            elif not name.endswith(".submeshes.json"):  # has times as well
                self.assertEqual(bytes_alone, contents[1][name], name)


if __name__ == "__main__":
    unittest.main()

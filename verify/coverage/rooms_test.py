# SPDX-License-Identifier: MIT
"""The shares of each room from gcovr's JSON, and what is too little."""
import contextlib
import io
import json
import pathlib
import tempfile
import unittest

import rooms


def line(number, count, *branches):
    return {"line_number": number, "count": count,
            "branches": [{"count": taken, "fallthrough": False, "throw": False} for taken in branches],
            "gcovr/noncode": False}


def file(name, *lines):
    return {"file": name, "lines": list(lines)}


class Rooms(unittest.TestCase):
    def run_on(self, *files):
        with tempfile.TemporaryDirectory() as folder:
            path, out = pathlib.Path(folder) / "c.json", pathlib.Path(folder) / "c.md"
            path.write_text(json.dumps({"files": list(files)}))
            with contextlib.redirect_stdout(io.StringIO()) as said, \
                    contextlib.redirect_stderr(io.StringIO()) as complained:
                code = rooms.main([str(path), "--out", str(out)])
            return code, said.getvalue() + complained.getvalue(), \
                out.read_text() if out.exists() else ""

    def test_shares_of_each_room(self):
        found = rooms.by_room(rooms.files_of({"files": [
            file("lib/dsc/base/a.h", line(1, 3, 2, 1), line(2, 0)),
            file("lib/dsc/base/b.cpp", line(1, 1)),
            file("lib/dsc/io/c.cpp", line(5, 7, 7, 0)),
            file("lib/thesis/d.cpp", line(1, 1)),
            file("lib/scenes/e.cpp", line(1, 0))]}))
        self.assertEqual(found["base"], rooms.Counts(3, 2, 2, 2))
        self.assertEqual(found["io"], rooms.Counts(1, 1, 2, 1))
        self.assertEqual(found["thesis"], rooms.Counts(1, 1))
        self.assertEqual(found["all"], rooms.Counts(5, 4, 4, 3))

    def test_lines_without_code_do_not_count(self):
        brace = {**line(2, 0), "gcovr/noncode": True}
        found = rooms.by_room(rooms.files_of({"files": [
            file("lib/dsc/base/a.h", line(1, 1), brace)]}))
        self.assertEqual(found["all"].lines, 1)

    def test_enough_is_0_and_too_little_1(self):
        good = [line(number, 1, 1, 1) for number in range(19)]
        self.assertEqual(self.run_on(file("lib/dsc/io/a.cpp", *good, line(20, 0)))[0], 0)
        self.assertEqual(self.run_on(file("lib/dsc/io/a.cpp", *good, line(20, 0), line(21, 0)))[0], 1)
        half = [line(number, 1, 1, 0) for number in range(6)]
        self.assertEqual(self.run_on(file("lib/dsc/io/a.cpp", *good, *half))[0], 1)

    def test_what_is_not_run_is_listed(self):
        _, _, text = self.run_on(file("lib/dsc/io/a.cpp", line(3, 0), line(4, 0), line(7, 0),
                                      line(9, 2, 0, 2)))
        self.assertIn("| lib/dsc/io/a.cpp | 3-4, 7 | 9 |", text)

    def test_nothing_proves_nothing(self):
        code, said, _ = self.run_on(file("lib/scenes/a.cpp", line(1, 1)))
        self.assertEqual(code, 2)
        self.assertIn("no line of lib/dsc/ is in it", said)


if __name__ == "__main__":
    unittest.main()

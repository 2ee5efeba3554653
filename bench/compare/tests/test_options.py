# SPDX-License-Identifier: MIT
"""The comparison of two sets of options, with a program that stands for dsc_scene."""
import contextlib
import io
import json
import os
import stat
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import options  # noqa: E402

# Its quality is that of --set quality; it refuses all else but the scene of the test.
PROGRAM = f"""#!{sys.executable}
import json, sys
words = sys.argv[1:]
settings = dict(word.split("=") for flag, word in zip(words, words[1:]) if flag == "--set")
if words[:2] != ["run", "mine"] or set(settings) - {{"h", "quality"}}:
    print("unknown key", file=sys.stderr)
    sys.exit(2)
with open(words[words.index("--json") + 1], "w") as stream:
    json.dump({{"triangles_last": 100 / float(settings["h"]), "steps": 4, "cpu_s": 1, "step_us_median": 2,
               "min_quality_last": float(settings["quality"]), "sd_rel_last": None}}, stream)
"""


class Options(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program, self.json = (os.path.join(folder.name, name) for name in ("program", "out.json"))
        with open(self.program, "w", encoding="utf-8") as stream:
            stream.write(PROGRAM)
        os.chmod(self.program, stat.S_IRWXU)

    def call(self, *words):
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            return options.main([self.program, "mine", *words, "--json", self.json])

    def test_each_side_gets_its_own_options_and_the_common_ones(self):
        self.assertEqual(self.call("--set", "h=0.5", "--a", "quality=0.4", "--b", "quality=0.3", "--no-counts",
                                   "--pairs", "5"), 0)
        with open(self.json, encoding="utf-8") as stream:
            rows = {row["name"]: row for row in json.load(stream)["figures"]}
        self.assertEqual([rows["triangles_last"][side] for side in "ab"], [200, 200])
        self.assertEqual([rows["min_quality_last"][side] for side in "ab"], [0.4, 0.3])
        self.assertAlmostEqual(rows["min_quality_last"]["ratio"], 0.75)
        self.assertEqual(rows["steps, CPU, us"]["ratio"], 1)
        self.assertEqual(rows["steps, CPU, us"]["pairs"], 5)
        self.assertNotIn("sd_rel_last", rows)

    def test_what_the_program_refuses_is_an_error(self):
        with self.assertRaisesRegex(RuntimeError, "unknown key"):
            self.call("--a", "height=1", "--no-counts")

    def test_bad_calls(self):
        for words in ((), ("--a", "quality"), ("--a", "quality=1", "--pairs", "2")):
            with self.assertRaises(SystemExit) as refused:
                self.call(*words)
            self.assertEqual(refused.exception.code, 2)


if __name__ == "__main__":
    unittest.main()

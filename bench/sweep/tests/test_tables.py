# SPDX-License-Identifier: MIT
"""Tables, the runs that they stand for, their keys, and how they are shared out."""
import os
import pathlib
import tempfile
import unittest

from tests.support import ROOM, Project

import placeholders
import plan
import runs
import table as tables
from errors import TableError
from trees import Tree

HERE = Tree("abc", "abc", "abc", "/source", "/source/build", True, True)
THERE = Tree("def", "def", "def", "/other", "/other/build", True, False)


class OneTable(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read(self, text):
        path = self.folder / "table.toml"
        path.write_text(text, encoding="utf-8")
        return tables.read(str(path), str(self.folder))

    def runs(self, text, **trees):
        return runs.expand(self.read(text), {".": HERE, **trees})


class Expansion(OneTable):
    def test_all_combinations_in_order(self):
        found = self.runs('[[run]]\nscene = "swirl"\nset = {h = [0.02, 0.01]}\nstrategy = "cells"\n'
                          'threads = [1, 2]\nrepeats = 2\n')
        self.assertEqual([run.what for run in found[:3]],
                         ["swirl: swirl h=0.02 cells threads=1",
                          "swirl: swirl h=0.02 cells threads=1 repeat 2",
                          "swirl: swirl h=0.02 cells threads=2"])
        self.assertEqual(len(found), 8)
        self.assertEqual(len({run.key for run in found}), 8)
        self.assertEqual([run.cores for run in found[:3]], [1, 1, 2])

    def test_the_command_of_a_scene(self):
        run, = self.runs('[[run]]\nscene = "swirl"\nset = {h = 0.02}\nseed = 7\n'
                         'strategy = "active"\nsubmeshes = 4\nthreads = 2\n')
        self.assertEqual(" ".join(run.command),
                         "{build}/lib/scenes/dsc_scene run swirl --set h=0.02 --set seed=7 "
                         "--strategy active --threads 2 --submeshes 4 --json {out}/result.json")

    def test_a_run_of_two_rows_is_one(self):
        row = '[[run]]\nname = "{}"\nscene = "swirl"\nset = {{h = {}}}\n'
        found = self.runs(row.format("a", "[0.02, 0.01]") + row.format("b", "0.01"))
        self.assertEqual(len(found), 2)

    def test_a_sequential_run_has_one_thread(self):
        found = self.runs('[[run]]\nscene = "swirl"\nstrategy = ["sequential", "cells"]\n'
                          'threads = [1, 2]\n')
        self.assertEqual(len(found), 3)

    def test_cases_stay_together(self):
        found = self.runs('[[run]]\nscene = "swirl"\ncases = [{h = 1, dt = 2}, {h = 3, dt = 4}]\n'
                          'set = {steps = [5, 6]}\n')
        self.assertEqual([run.identity["values"] for run in found][1:3],
                         [{"h": "1", "dt": "2", "steps": "6"}, {"h": "3", "dt": "4", "steps": "5"}])
        with self.assertRaises(TableError):
            self.runs('[[run]]\nscene = "swirl"\ncases = [{h = 1}]\nset = {h = 2}\n')

    def test_values_that_a_command_prints(self):
        found = self.runs('[[run]]\nname = "a"\ncommand = ["echo", "{word}"]\n'
                          'with = {word = {lines_of = ["printf", "x y\\nz\\n"]}}\n')
        self.assertEqual([run.command for run in found], [("echo", "x y"), ("echo", "z")])

    def test_braces(self):
        self.assertEqual(placeholders.put_in("{{a}} {a} {out}", {"a": "{1}"}),
                         "{{a}} {{1}} {out}")
        self.assertEqual(placeholders.fill("{{a}} {{1}} {out}", {"out": "o"}), "{a} {1} o")


class Keys(OneTable):
    """A key is all that a result depends on."""
    row = ('[[run]]\nname = "{name}"\nscene = "{scene}"\nset = {{h = {h}}}\ncommit = "{commit}"\n'
           '{more}')
    usual = {"name": "a", "scene": "swirl", "h": 0.01, "commit": ".", "more": ""}

    def key(self, **changed):
        run, *_ = self.runs(self.row.format(**{**self.usual, **changed}), there=THERE)
        return run.key

    def test_what_changes_it(self):
        keys = [self.key()] + [self.key(**changed) for changed in (
            {"scene": "zalesak"}, {"h": 0.02}, {"commit": "there"}, {"more": "seed = 1"},
            {"more": "timed = true"}, {"more": "timed = true\nrepeats = 2"},
            {"more": 'strategy = "cells"'}, {"more": 'strategy = "cells"\nthreads = 2'},
            {"more": 'strategy = "cells"\nsubmeshes = 9'},
            {"more": 'strategy = "cells"\nangle = "shape"'})]
        # The first of two repeats is the one of a single repeat: more repeats keep what is there.
        self.assertEqual(keys[5], keys[6])
        del keys[6]
        self.assertEqual(len(set(keys)), len(keys))

    def test_what_does_not(self):
        for changed in ({"name": "b"}, {"h": "1e-2"}, {"more": "timeout = 5"}):
            self.assertEqual(self.key(**changed), self.key(), changed)

    def test_the_content_of_a_scene_file_and_of_what_it_names(self):
        scene, outline = self.folder / "mine.toml", self.folder / "outline.csv"

        def key(text, points):
            scene.write_text(text)
            outline.write_text(points)
            return self.key(scene="./mine.toml")

        keys = [key('[[shape]]\npoints = "outline.csv"\n', "0 0"),
                key('[[shape]]\npoints = "outline.csv"\n# changed\n', "0 0"),
                key('[[shape]]\npoints = "outline.csv"\n', "0 1")]
        self.assertEqual(len(set(keys)), 3)
        self.assertEqual(key('[[shape]]\npoints = "outline.csv"\n', "0 0"), keys[0])


class BadTables(OneTable):
    def test_what_is_wrong_and_where(self):
        scene, command = '[[run]]\nscene = "swirl"\n', '[[run]]\nname = "a"\ncommand = ["x"]\n'
        for text, words in (
                ("[[run", "not a TOML file"), ("", "a table without a row"),
                ("speed = 1\n" + scene, "unknown key"), (scene + "sead = 1\n", "unknown key"),
                (scene + 'command = ["x"]\n', "a row runs one thing"),
                ('[[run]]\nname = "a"\n', "a row runs one thing"),
                (scene + "threads = 0\n", "too small"), (scene + "threads = 1.5\n", "wrong type"),
                (scene + "threads = []\n", "an empty list"), (scene + "timed = 1\n", "wrong type"),
                (scene + "set = {h = true}\n", "wrong type"), (scene + "set = {h = []}\n", "empty"),
                (scene + "timeout = nan\n", "too small"), (scene + scene, "two rows of one name"),
                (scene + "files = ['a']\n", "another kind"),
                (command + "set = {h = 1}\n", "another kind"),
                ('[[run]]\ncommand = ["x"]\n', "a row needs a name"),
                ('[[run]]\nname = "a/b"\ncommand = ["x"]\n', "a row needs a name"),
                ('[[run]]\nname = "a"\nscene = "no/such.toml"\n', "no such scene file"),
                ('[[run]]\nname = "a"\ncommand = ["{word}"]\n', "unknown placeholder"),
                (command + "with = {w = {lines_of = ['false']}}\n", "gives no values"),
                (command + "with = {w = {lines_of = ['no-such-program']}}\n", "cannot be run"),
                ("native = 1\n" + scene, "wrong type")):
            with self.subTest(text=text):
                with self.assertRaisesRegex(TableError, words) as caught:
                    self.runs(text)
                self.assertIn("table.toml", str(caught.exception))
                self.assertIn("allowed", str(caught.exception))

    def test_a_bad_table_runs_nothing(self):
        project = Project(self)
        project.table("[[run")
        done = project.sweep()
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, "^sweep.sh: .*not a TOML file")
        self.assertFalse(project.out.exists())


class Shipped(unittest.TestCase):
    def test_tables_can_be_read(self):
        root = ROOM.parents[1]
        names = sorted(os.listdir(ROOM / "tables"))
        self.assertGreaterEqual(len(names), 7)
        for name in names:
            table = tables.read(str(ROOM / "tables" / name), str(root))
            trees = {commit: HERE for row in table.rows for commit in row.commits}
            self.assertGreater(len(runs.expand(table, trees)), 1, name)
            self.assertTrue(table.about, name)


class Shares(OneTable):
    def test_long_jobs_first_and_every_run_in_one(self):
        for count, jobs in ((1, 1), (7, 2), (200, 2), (1000, 64), (3, 8)):
            sizes = plan.sizes(count, jobs)
            self.assertEqual(sum(sizes), count)
            self.assertEqual(sizes[:-1], sorted(sizes[:-1], reverse=True))
            self.assertLessEqual(sizes[0], max(1, -(-count // jobs)))

    def test_timed_runs_of_a_row_are_one_job_alone(self):
        found = self.runs('[[run]]\nscene = "swirl"\nset = {h = [1, 2, 3]}\ntimed = true\n'
                          'repeats = 4\n[[run]]\nname = "b"\nscene = "zalesak"\n'
                          'set = {h = [1, 2, 3]}\n')
        chunks = plan.chunks(found, 2)
        self.assertEqual([chunk.timed for chunk in chunks], [False] * (len(chunks) - 1) + [True])
        self.assertTrue(chunks[-1].alone)
        repeats = [run.identity["repeat"] for run in chunks[-1].runs]
        self.assertEqual(repeats, sorted(repeats))  # they take turns
        self.assertEqual(sorted(run.key for chunk in chunks for run in chunk.runs),
                         sorted(run.key for run in found))


if __name__ == "__main__":
    unittest.main()

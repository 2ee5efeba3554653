# SPDX-License-Identifier: MIT
"""The report: medians and quartiles of the right runs, machines and commits apart, orders and
speed-ups of made-up results, and pictures of them."""
import itertools
import json
import pathlib
import tempfile
import unittest

from tests.support import ROOM  # noqa: F401  (puts the room on the path)

import collect
import records
import speedups
from errors import SweepError

COUNTER = itertools.count()


def scene(h, wall_s, strategy="sequential", threads=1, machine="one", commit="abc", error=None,
          **more):
    """A result; its error is h squared unless another is given."""
    values = {"h": str(h), **{key: str(value) for key, value in more.pop("values", {}).items()}}
    identity = {"scene": "swirl", "strategy": strategy, "threads": threads, "values": values,
                "repeat": next(COUNTER), "timed": True, **more}
    return {"format": 1, "key": f"{next(COUNTER):020}", "row": "a", "what": f"a: h={h}",
            "identity": identity, "commit": commit, "again": "cd x && y", "others_busy": 0.01,
            "wall_s": wall_s, "cpu_s": wall_s, "problem": None,
            "last_words": {"stdout": ["word <b>"], "stderr": []},
            "machine": {"name": machine, "model": f"CPU of {machine}", "cores": 2}, "files": {},
            "result": {"commit": commit, "parameters": {"h": h}, "sd_rel_last": error or h * h,
                       "cpu_s": wall_s, "wall_s": wall_s, "triangles_first": round(2 / h ** 2),
                       "triangles_last": round(2 / h ** 2)}}


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, some, suffix=".json"):
        for record in some:
            folder = self.folder / record["machine"]["name"] / record["commit"]
            path = folder / (record["key"] + suffix)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(json.dumps(record))

    def groups(self, some):
        self.write(some)
        return records.read([self.folder])

    def test_medians_and_quartiles(self):
        group, = self.groups([scene(0.1, t) for t in (5, 1, 4, 2, 3)])
        point, = records.points(group)
        self.assertEqual(point.spread("wall_s"), records.Spread(3, 2, 4, 5))
        self.assertIsNone(point.spread("no_such_figure"))

    def test_seeds_are_a_spread_and_settings_are_not(self):
        group, = self.groups(
            [scene(0.1, 1, seed=s, error=e) for s, e in (("1", 1), ("2", 3), ("3", 2))]
            + [scene(0.1, 1, error=9, values={"integrator": "euler"})])
        errors = [p.spread("sd_rel_last").median for p in records.points(group)]
        self.assertEqual(sorted(errors), [2, 9])

    def test_machines_and_commits_are_never_put_together(self):
        groups = self.groups([scene(0.1, t, machine=m, commit=c) for t, m, c in (
            (1, "one", "abc"), (100, "two", "abc"), (10000, "one", "def"))])
        self.assertEqual([(g.machine, g.commit, len(g.records)) for g in groups],
                         [("one", "abc", 1), ("one", "def", 1), ("two", "abc", 1)])
        self.assertEqual([records.points(g)[0].spread("wall_s").median for g in groups],
                         [1, 10000, 100])

    def test_a_speed_up_is_of_one_machine_and_one_problem(self):
        some = [scene(0.1, t) for t in (4, 6, 8)]
        some += [scene(0.1, t, "cells", 2) for t in (2, 3, 4)]
        some += [scene(0.1, 1, "cells", 2, machine="two"), scene(0.1, 1, "cells", 2, commit="def"),
                 scene(0.2, 1, "cells", 2), scene(0.1, 1, "cells", 2, values={"steps": 9})]
        beside = [scene(0.1, 1, "cells", 2), scene(0.1, 3)]
        for record in beside:
            del record["identity"]["timed"]
        found = [s for g in self.groups(some + beside) for s in speedups.find(records.points(g))]
        self.assertEqual([(s.s, s.low, s.high) for s in found], [(6 / 3, 6 / 3.5, 6 / 2.5)])

    def test_orders(self):
        import errors_drawn
        group, = self.groups([scene(h, 1 / h, error=7 * h ** p, values={"insertion": p})
                              for h in (0.1, 0.05, 0.02, 0.01) for p in (1, 2, 3)])
        lines = errors_drawn.lines(records.points(group))["swirl"]
        orders = [errors_drawn.order(line).fitted for line in lines.values()]
        self.assertEqual([round(order, 6) for order in orders], [1, 2, 3])

    def test_the_page(self):
        some = [scene(h, (1 + 0.1 * k) / h / s, strategy, s, machine=m)
                for h in (0.1, 0.05, 0.02, 0.01) for k in range(3) for m in ("one", "two")
                for strategy, s in (("sequential", 1), ("cells", 2)) if m == "one" or h == 0.1]
        command = scene(1, 1)
        del command["identity"]["scene"]
        self.write(some + [command])
        failed = scene(0.5, 1)
        failed["problem"] = "exit code 3"
        failed["last_words"]["stderr"] = ["the <last> words"]
        self.write([failed], ".failed.json")
        path, lead = collect.build([self.folder], self.folder / "report", 1)
        self.assertIn("32 runs on 2 machines at 1 commit", lead)
        text = pathlib.Path(path).read_text("utf-8")
        for words in ("CPU of one", "CPU of two", "exit code 3", "the &lt;last&gt; words",
                      "cd x &amp;&amp; y", "falls with h to the power 2.0", "word &lt;b&gt;",
                      "The largest speed-up in swirl is 2.00"):
            self.assertIn(words, text)
        pictures = {p.name for p in (self.folder / "report").glob("*.png")}
        self.assertEqual(pictures, {f"group1_swirl_{what}.png" for what in (
            "error_against_time", "order", "speedup_over_threads", "speedup_over_sizes")}
            | {"group2_swirl_speedup_over_threads.png"})

    def test_precision_runs_are_drawn_by_the_report_s_own_pictures(self):
        record = scene(1, 1)
        del record["identity"]["scene"]
        record["result"] = None
        record["files"] = {f"{h}.json": {
            "flow": "zalesak", "flow_title": "Zalesak's disc", "method": "default",
            "group": "default", "parameters": {"h": h}, "sd_rel_last": h, "cpu_s": 1 / h}
            for h in (0.1, 0.05)}
        group, = self.groups([record])
        self.assertEqual([(r.h, r.error) for r in collect.precision_runs(group)],
                         [(0.1, 0.1), (0.05, 0.05)])
        self.assertEqual([p.name for p in collect.pictures(group, "x")], ["x_precision_zalesak"])

    def test_files_that_are_no_results(self):
        with self.assertRaisesRegex(SweepError, "no result in"):
            collect.build([self.folder], self.folder / "report", 1)
        self.write([scene(0.1, 1)])
        path, = self.folder.glob("*/*/*.json")
        for text, words in (("", "not whole JSON"), ('{"a": 1}', "no key 'format'"),
                            ('{"format": 2}', "format 2"), ("[1]", "an object is expected")):
            path.write_text(text)
            with self.assertRaisesRegex(SweepError, words):
                collect.main([str(self.folder)])

    def test_a_folder_that_was_copied_counts_once(self):
        self.write([scene(0.1, 1)])
        group, = records.read([self.folder, self.folder])
        self.assertEqual(len(group.records), 1)


if __name__ == "__main__":
    unittest.main()

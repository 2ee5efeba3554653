# SPDX-License-Identifier: MIT
"""Every script, called as by a user; a file that is empty, truncated or of another kind is refused in one
sentence that names it, and no output is left."""
import argparse
import contextlib
import importlib
import io
import itertools
import json
import os
import struct
import subprocess
import sys
import unittest

from PIL import Image

import flow
import history
import over_time
import space
import speedup
from results import load, series
from tests.samples import (BUBBLE, DIVIDED, PLOTS, RESULT, SERIES, VTU, Case, bench, hard_cases,
                           own_suite, parallel_bench, precision_run, precision_runs, row, scene, verify)

MAGIC = {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}
FOREIGN = {
    "empty": b"", "nothing": b"null", "text": b'"a text"', "list": b"[[1, 2]]",
    "object": b'{"a": 1}', "page": b"<!DOCTYPE html><title>not found</title>",
    "picture": b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "wide text": "h\u00e9".encode("utf-16"),
    "nesting": b"[" * 100000,
}
JSON = {"--bench": bench(), "--scenes": scene(0.01, 1e-3, 1), "--verify": verify(),
        "--hard": hard_cases(),
        "--precision": precision_run("swirl-260", "default", 0.01, 1e-3, 1)}


class Scripts(Case):
    def call(self, program, *words):
        errors, printed = io.StringIO(), io.StringIO()
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(printed):
            status = importlib.import_module(program).main(list(words))
        return status, errors.getvalue(), printed.getvalue()

    def bubbles(self):
        """The folder of two frames, and their files."""
        folder = self.frames("bubbles_cells", {0: 1, 7: 1}, {0: 0, 7: 7})
        return folder, [os.path.join(folder, f"bubbles_cells_{step:05}.vtu") for step in (0, 7)]

    def files(self):
        """{script: its files}"""
        threads = [self.write("parallel.json", parallel_bench())]
        shape = verify()["histograms"][0]
        errors = [self.write(f"p{k}.json", run) for k, run in enumerate(precision_runs())]
        folder, flows = self.bubbles()
        self.write("frames/bubbles_cells_00007.submeshes.json", DIVIDED)
        reports = [self.write(f"v{k}.json", {**verify(), "commit": f"c0ffee{k}"}) for k in range(3)]
        return {**dict.fromkeys(("speedup", "step_cost", "breakdown", "granularity"),
                                threads),
                "operations": [self.write("bench.json", bench())],
                "history": reports,
                "histograms": [self.write("s.json", scene(
                    0.01, 1e-3, 1, histograms={"area": shape}))],
                "precision": errors, "convergence": errors, "flow": flows, "frames": [folder],
                "space": [self.surface()], "submeshes": [folder], "over_time": [self.write("s.csv", SERIES)],
                "rising_bubble": [self.write("r.json", BUBBLE)]}

    def test_each_draws_in_one_of_the_formats_and_says_what_the_picture_shows(self):
        for (program, files), form in zip(self.files().items(), itertools.cycle(MAGIC)):
            with self.subTest(program=program):
                status, errors, printed = self.call(program, *files, "--out", self.path(f"p.{form}"))
                self.assertEqual((status, errors), (0, ""))
                for line in printed.splitlines():
                    name, _, sentence = line.partition(": ")
                    with open(name, "rb") as stream:
                        self.assertTrue(stream.read().startswith(MAGIC[form]))
                    self.assertGreater(len(sentence), 20)

    def test_each_has_help_with_its_call(self):
        for program in (*self.files(), "film", "report", "gallery/make"):
            done = subprocess.run([sys.executable, os.path.join(PLOTS, program + ".py"), "--help"],
                                  check=True, capture_output=True, text=True)
            for word in (f"usage: {os.path.basename(program)}.py ", "--out",
                         "Exit 0 done; 2 bad usage"):
                self.assertIn(word, done.stdout)

    def test_several_families_become_several_pictures(self):
        both = own_suite()
        both["benchmarks"] += bench()["benchmarks"]
        result = self.write("both.json", both)
        self.assertEqual(self.call("speedup", result, "--out", self.path("p.svg"))[0], 0)
        self.assertEqual(sorted(n for n in os.listdir(self.folder) if n.endswith("svg")),
                         ["p-speedup_mine_run.svg", "p-speedup_scaling_step.svg"])
        printed = self.call("speedup", result, "--out", self.path("one.svg"), "--case", "mine_run")[2]
        self.assertIn("S(2) = 2.00, S(2) / 2 = 1.00", printed)
        self.assertTrue(os.path.exists(self.path("one.svg")))

    def test_sizes_are_those_of_the_suite(self):
        found = speedup.gather_runs(load.read_bench([self.write("mine.json", own_suite())]))
        self.assertEqual([family.name for family in found], ["mine_run"])
        self.assertEqual({p.row.size for p in found[0].points}, {"h = 0.02", "h = 0.01"})
        self.assertEqual(len(found[0].points), 4)

    def test_whole_runs_are_modelled_too(self):
        suite = own_suite()
        suite["benchmarks"] += row("mine_run/strategy:cells/h:0.01/between_us:0/threads:8/modelled:1/iterations:1/"
                                   "manual_time", [100], us_per_step=100, modelled=1)
        results = load.read_bench([self.write("mine.json", suite)])
        (family,) = speedup.gather_runs(results)
        self.assertEqual(len(family.points), 4)
        self.assertEqual([(p.n, p.s) for p in family.models], [(8, 4)])
        self.assertIn("hollow points are modelled and not measured", speedup.plain(family))
        self.assertEqual({r.modelled for r in series.whole_runs(results)}, {False})

    def test_steps_of_the_history_are_found_between_their_commits(self):
        def report(commit, drift, angle):
            checks = [{"check": name, "scene": "swirl", "measured": value, "limit": 1, "verdict": "pass"}
                      for name, value in (("drift", drift), ("angle", angle), ("rounding", drift * 1e-15))]
            return self.write(f"{commit}.json", {"machine": "m", "commit": commit, "checks": checks})

        files = [report("a", 0.1, 20), report("b", 0.1005, 20), report("c", 0.2, 19.9), report("d", 0.2, None)]
        lines = {line.check: line for line in history.lines_of([load.read_verify([path]) for path in files])}
        self.assertEqual({name: line.steps for name, line in lines.items()},
                         {"drift": [2], "angle": [], "rounding": []})
        status, errors, printed = self.call("history", *files, "--only", "swirl", "--out", self.path("h.png"))
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("1 step of more than a hundredth in 1 of 3 figures; the largest is 49.8 % in drift of "
                      "swirl, from b to c", printed)
        self.assertIn("no report has a figure of zalesak",
                      self.call("history", *files, "--only", "zalesak", "--out", self.path("h.png"))[1])

    def test_a_flow_has_one_scale(self):
        figure = flow.picture([flow.read(path) for path in self.bubbles()[1]]).figure
        panels = figure.axes[:2]
        self.assertEqual([axes.get_title(loc="left") for axes in panels], ["step 0", "step 7"])
        for axes in panels:
            self.assertEqual(axes.collections[0].get_clim(), (0, 5))
            self.assertEqual(len(axes.collections[1].get_segments()), 2, "edges of the interface")

    def test_a_film_has_all_frames_in_order(self):
        out = self.path("film.webp")
        self.assertEqual(self.call("film", self.bubbles()[0], "--out", out),
                         (0, "", f"{out}: bubbles in 2 frames.\n"))
        with Image.open(out) as film:
            self.assertEqual((film.n_frames, film.info["loop"]), (2, 0))
        status, errors, _ = self.call("film", self.folder, "--out", out)
        self.assertEqual(status, 2)
        self.assertIn("frames of 0 runs, where one is needed", errors)

    def surface(self):
        """The folder of a run in three dimensions: a tetrahedron as dsc_scene writes it."""
        head = ("ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n")
        points = struct.pack("<12d", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
        faces = b"".join(struct.pack("<B3i", 3, *face)
                         for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)))
        path = self.write("space/s.pvd", '<DataSet timestep="0.5" part="0" file="s_00000.vtu"/>')
        with open(os.path.join(os.path.dirname(path), "s_00000.ply"), "wb") as stream:
            stream.write(head.encode() + points + faces)
        return os.path.dirname(path)

    def test_a_surface_is_drawn_from_behind_to_the_front(self):
        folder = self.surface()
        given = argparse.Namespace(files=[folder])
        (picture,) = space.draw(given)
        axes = picture.figure.axes[0]
        self.assertEqual(axes.get_title(loc="left"), "t = 0.5")
        self.assertEqual(len(axes.collections[0].get_paths()), 4)
        with open(os.path.join(folder, "s_00000.ply"), "ab") as stream:
            stream.write(b"more")
        status, errors, _ = self.call("space", folder, "--out", self.path("p.png"))
        self.assertEqual((status, errors.count("\n")), (2, 1))
        self.assertIn("is not whole", errors)

    def test_a_run_over_time(self):
        columns = over_time.read(self.write("s.csv", SERIES))
        line = over_time.between(columns, "collapses")
        self.assertEqual([count for _, count in line], [4, 2])
        self.assertAlmostEqual(line[1][0], 0.6)
        figure = over_time.picture(columns, RESULT).figure
        self.assertIn("error against the exact shape",
                      [axes.get_title(loc="left") for axes in figure.axes])
        texts = " ".join(text.get_text() for text in figure.texts)
        for fact in ("swirl over time, cells", "a\N{NO-BREAK SPACE}machine", "c0ffee", "14 steps",
                     "2 threads"):
            self.assertIn(fact, texts)
        columns["sd_rel"] = [float("nan"), float("nan"), 0.01]  # one point has no line
        (line,) = next(axes for axes in over_time.picture(columns, None).figure.axes
                       if axes.get_title(loc="left") == "error against the exact shape").lines
        self.assertEqual(line.get_marker(), "o")
        columns["sd_rel"] = [float("nan")] * 3
        figure = over_time.picture(columns, None).figure
        self.assertIn("length of the interface",
                      [axes.get_title(loc="left") for axes in figure.axes])

    # What cannot be drawn.

    def refuse(self, program, name, *words, out="p.png"):
        status, errors, printed = self.call(program, *words, "--out", self.path(out))
        self.assertEqual((status, printed, errors.count("\n")), (2, "", 1), errors)
        self.assertTrue(errors.startswith(f"{program}.py: "), errors)
        self.assertIn(name, errors)
        self.assertFalse(os.path.exists(self.path(out)))

    def test_what_a_script_refuses(self):
        result = self.write("mine.json", own_suite())
        self.refuse("speedup", "p.gif", result, out="p.gif")
        self.refuse("film", "p.gif", self.bubbles()[0], out="p.gif")
        self.refuse("speedup", "mine_run", result, "--case", "other")
        self.refuse("speedup", "alone.json", self.write("alone.json", own_suite(["sequential"])))
        self.refuse("speedup", "no.json", self.path("no.json"))
        self.refuse("breakdown", "mine.json has nothing", result)
        self.refuse("flow", "no velocity",
                    self.write("still.vtu", VTU.format(x=1).replace("velocity", "speed")))
        self.refuse("rising_bubble", "result of swirl", self.write("other.json", RESULT))
        cases = {"over_time": SERIES, "speedup": json.dumps(bench()), "flow": VTU.format(x=1)}
        for program, whole in cases.items():
            foreign = {**FOREIGN, "cut": whole[:-20].encode(), "half": whole[:len(whole) // 2].encode()}
            for kind, data in foreign.items():
                with self.subTest(program=program, kind=kind):
                    self.refuse(program, "bad.vtu", self.write("x/bad.vtu", data))
        series = self.write("s.csv", SERIES)
        for text, word in ((SERIES.replace("110", "x"), "no number"),
                           (SERIES.replace("events", "other"), "'events'")):
            self.refuse("over_time", word, self.write("bad.csv", text))
        self.refuse("over_time", "s.csv", series, "--json", series)

    def test_what_the_report_refuses(self):
        for option, data in JSON.items():
            whole = json.dumps(data).encode()
            files = {**FOREIGN, "cut": whole[:-1], "half": whole[:len(whole) // 2],
                     **{f"of{other}": json.dumps(others).encode() for other, others in JSON.items()
                        if other != option}}
            for kind, content in files.items():
                with self.subTest(option=option, kind=kind):
                    self.assert_refused([option, self.write("x/bad.json", content)], "bad.json")
            self.assert_refused([option, self.path("none.json")], "none.json", "cannot be read")
        for kind, data in FOREIGN.items():
            path = self.write("published/peers.json", data)
            with self.subTest(kind=kind):
                self.assert_refused(["--published", os.path.dirname(path)], "peers.json")

    def test_a_machine_with_matplotlib_alone(self):
        """Without meshio frames cannot be read, and the message says so."""
        for missing, program, words in (("meshio", "flow", self.bubbles()[1]),
                                        ("matplotlib", "speedup", ["x.json"])):
            done = subprocess.run(
                [sys.executable, "-c", f"import sys; sys.modules['{missing}'] = None; import {program}; "
                 f"sys.exit({program}.main({words + ['--out', self.path('p.png')]!r}))"],
                cwd=PLOTS, capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(f"has no {missing}", done.stderr)
            self.assertIn(f"python3-{missing}", done.stderr)
        done = subprocess.run(
            [sys.executable, "-c", "import runpy, sys; sys.modules['matplotlib'] = None; "
             "sys.argv = ['speedup.py', '--help']; runpy.run_path('speedup.py', run_name='__main__')"],
            cwd=PLOTS, env={**os.environ, "PYTHONPATH": PLOTS}, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("speedup.py FILE.json", done.stdout)


if __name__ == "__main__":
    unittest.main()

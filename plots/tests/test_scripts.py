# SPDX-License-Identifier: MIT
"""Every script that draws one kind of picture, as a user calls it; a file that is empty, cut off, or of
another kind is refused in one sentence that names it, and leaves nothing behind."""
import contextlib
import importlib
import io
import json
import os
import subprocess
import sys
import unittest

import matplotlib.pyplot as plt
from PIL import Image

import flow
import over_time
import speedup
from results import load
from tests.samples import (DIVIDED, PLOTS, RESULT, SERIES, VTU, Case, bench, hard_cases, own_suite,
                           parallel_bench, precision_run, precision_runs, scene, verify)

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
        plt.close("all")
        return status, errors.getvalue(), printed.getvalue()

    def path(self, name):
        return os.path.join(self.folder, name)

    def write_bytes(self, name, data):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "wb") as stream:
            stream.write(data)
        return self.path(name)

    def frame(self, step=0):
        self.write(f"frames/bubbles_cells_{step:05}.submeshes.json", DIVIDED)
        return self.write(f"frames/bubbles_cells_{step:05}.vtu", VTU.format(x=1))

    def files(self):
        """{script: its files}"""
        threads = [self.write("parallel.json", parallel_bench())]
        shape = verify()["histograms"][0]
        errors = [self.write(f"p{k}.json", run) for k, run in enumerate(precision_runs())]
        frame = self.frame()
        return {**dict.fromkeys(("speedup", "step_cost", "breakdown", "granularity"),
                                threads),
                "operations": [self.write("bench.json", bench())],
                "histograms": [self.write("s.json", scene(
                    0.01, 1e-3, 1, histograms={"area": shape}))],
                "precision": errors, "convergence": errors, "flow": [frame],
                "frames": [os.path.dirname(frame)], "submeshes": [os.path.dirname(frame)],
                "over_time": [self.write("s.csv", SERIES)]}

    def test_each_draws_and_says_what_the_picture_shows(self):
        for program, files in self.files().items():
            with self.subTest(program=program):
                status, errors, printed = self.call(program, *files, "--out", self.path("p.svg"))
                self.assertEqual((status, errors), (0, ""))
                for line in printed.splitlines():
                    name, _, sentence = line.partition(": ")
                    with open(name, "rb") as stream:
                        self.assertTrue(stream.read().startswith(MAGIC["svg"]))
                    self.assertGreater(len(sentence), 20)

    def test_each_has_help_with_its_call(self):
        for program in self.files():
            done = subprocess.run([sys.executable, os.path.join(PLOTS, program + ".py"), "--help"],
                                  check=True, capture_output=True, text=True)
            for word in (f"usage: {program}.py ", "--out", "Exit 0 done; 2 bad usage"):
                self.assertIn(word, done.stdout)

    def test_every_format(self):
        result = self.write("mine.json", own_suite())
        for form, start in MAGIC.items():
            out = self.path(f"picture.{form}")
            status, errors, printed = self.call("speedup", result, "--out", out)
            self.assertEqual((status, errors), (0, ""))
            self.assertIn("S(2) = 2.00, S(2) / 2 = 1.00", printed)
            with open(out, "rb") as stream:
                self.assertTrue(stream.read().startswith(start))

    def test_several_families_become_several_pictures(self):
        both = own_suite()
        both["benchmarks"] += bench()["benchmarks"]
        result = self.write("both.json", both)
        self.assertEqual(self.call("speedup", result, "--out", self.path("p.svg"))[0], 0)
        self.assertEqual(sorted(n for n in os.listdir(self.folder) if n.endswith("svg")),
                         ["p-speedup_mine_run.svg", "p-speedup_scaling_step.svg"])
        self.assertEqual(self.call("speedup", result, "--out", self.path("one.svg"), "--case",
                                   "mine_run")[0], 0)
        self.assertTrue(os.path.exists(self.path("one.svg")))

    def test_sizes_are_those_of_the_suite(self):
        found = speedup.gather_runs(load.read_bench([self.write("mine.json", own_suite())]))
        self.assertEqual([family.name for family in found], ["mine_run"])
        self.assertEqual({p.row.size for p in found[0].points}, {"h = 0.02", "h = 0.01"})
        self.assertEqual(len(found[0].points), 4)

    def test_a_flow_has_one_scale(self):
        figure = flow.picture([flow.read(self.frame(step)) for step in (0, 7)]).figure
        panels = figure.axes[:2]
        self.assertEqual([axes.get_title(loc="left") for axes in panels], ["step 0", "step 7"])
        for axes in panels:
            self.assertEqual(axes.collections[0].get_clim(), (0, 5))
            self.assertEqual(len(axes.collections[1].get_segments()), 2, "edges of the interface")
        plt.close(figure)

    def test_a_film_has_all_frames_in_order(self):
        folder = os.path.dirname(self.frame())
        self.frame(7)
        self.write("frames/bubbles_cells.pvd", "<VTKFile><Collection>" + "".join(
            f'<DataSet timestep="{step}" part="0" file="bubbles_cells_{step:05}.vtu"/>'
            for step in (0, 7)) + "</Collection></VTKFile>")
        out = self.path("film.webp")
        self.assertEqual(self.call("film", folder, "--out", out),
                         (0, "", f"{out}: bubbles in 2 frames.\n"))
        with Image.open(out) as film:
            self.assertEqual((film.n_frames, film.info["loop"]), (2, 0))
        status, errors, _ = self.call("film", self.folder, "--out", out)
        self.assertEqual(status, 2)
        self.assertIn("frames of 0 runs, where one is needed", errors)

    def test_a_run_over_time(self):
        columns = over_time.read(self.write("s.csv", SERIES))
        line = over_time.between(columns, "collapses")
        self.assertEqual([count for _, count in line], [4, 2])
        self.assertAlmostEqual(line[1][0], 0.6)
        figure = over_time.picture(columns, *over_time.words(columns, RESULT))
        self.assertIn("error against the exact shape",
                      [axes.get_title(loc="left") for axes in figure.axes])
        texts = " ".join(text.get_text() for text in figure.texts)
        for fact in ("swirl over time, cells", "a machine", "c0ffee", "14 steps", "2 threads"):
            self.assertIn(fact, texts)
        columns["sd_rel"] = [float("nan")] * 3
        figure = over_time.picture(columns, "a title", "a caption")
        self.assertIn("length of the interface",
                      [axes.get_title(loc="left") for axes in figure.axes])
        plt.close("all")

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
        self.refuse("speedup", "mine_run", result, "--case", "other")
        self.refuse("speedup", "alone.json", self.write("alone.json", own_suite(["sequential"])))
        self.refuse("speedup", "no.json", self.path("no.json"))
        self.refuse("breakdown", "mine.json has nothing", result)
        self.write("frames/still_cells_00000.vtu", VTU.format(x=1).replace("velocity", "speed"))
        self.refuse("flow", "no velocity", self.path("frames/still_cells_00000.vtu"))
        cases = {"over_time": SERIES, "speedup": json.dumps(bench()), "flow": VTU.format(x=1)}
        for program, whole in cases.items():
            foreign = {**FOREIGN, "cut": whole[:-20].encode(), "half": whole[:len(whole) // 2].encode()}
            for kind, data in foreign.items():
                with self.subTest(program=program, kind=kind):
                    self.refuse(program, "bad.vtu", self.write_bytes("x/bad.vtu", data))
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
                    self.assert_refused([option, self.write_bytes("x/bad.json", content)], "bad.json")
            self.assert_refused([option, self.path("none.json")], "none.json", "cannot be read")
        for kind, data in FOREIGN.items():
            path = self.write_bytes("published/peers.json", data)
            with self.subTest(kind=kind):
                self.assert_refused(["--published", os.path.dirname(path)], "peers.json")

    def test_a_machine_with_matplotlib_alone(self):
        """No frame can be read without meshio, and that is said."""
        for missing, program, words in (("meshio", "flow", [self.frame()]),
                                        ("matplotlib", "speedup", ["x.json"])):
            done = subprocess.run(
                [sys.executable, "-c", f"import sys; sys.modules['{missing}'] = None; import {program}; "
                 f"sys.exit({program}.main({words + ['--out', self.path('p.png')]!r}))"],
                cwd=PLOTS, capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(f"has no {missing}", done.stderr)
            self.assertIn(f"python3-{missing}", done.stderr)


if __name__ == "__main__":
    unittest.main()

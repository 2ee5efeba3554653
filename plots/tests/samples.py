# SPDX-License-Identifier: MIT
"""Small made-up result files that the tests of the pictures draw, and the case they share."""
import contextlib
import io
import json
import os
import tempfile
import unittest

import report
from look import style

PLOTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PUBLISHED = os.path.join(PLOTS, "..", "reference", "published")

# One square of four triangles around a middle vertex; the right triangle is of phase 1.
VTU = """<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="4">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0  2 0 0  2 2 0  0 2 0  {x} 1 0</DataArray></Points>
<Cells><DataArray Name="connectivity" format="ascii">0 1 4 1 2 4 2 3 4 3 0 4</DataArray>
<DataArray Name="offsets" format="ascii">3 6 9 12</DataArray>
<DataArray Name="types" format="ascii">5 5 5 5</DataArray></Cells>
<CellData><DataArray Name="phase" format="ascii">0 1 0 0</DataArray></CellData>
</Piece></UnstructuredGrid></VTKFile>
"""


def row(name, times_us, **counters):
    """The rows that Google Benchmark writes for one benchmark with repetitions."""
    rows = [{"name": name, "run_name": name, "run_type": "iteration", "repetition_index": i,
             "iterations": 20, "threads": 1, "real_time": t, "cpu_time": t, "time_unit": "us",
             **counters, **({"us_per_step": t} if "/triangles" in name else {})}
            for i, t in enumerate(times_us)]
    return rows + [{"name": name + "_mean", "run_name": name, "run_type": "aggregate",
                    "aggregate_name": "mean", "real_time": 1e9, "time_unit": "us"}]


def bench(machine="a machine", commit="c0ffee"):
    rows = row("scaling_step/strategy:sequential/triangles:28000/iterations:20/manual_time",
               [100, 130, 110], interface_vertices=100, us_per_vertex_step=1.1)
    rows += row("scaling_step/strategy:sequential/triangles:280000/iterations:20/manual_time",
                [400, 440, 420], interface_vertices=400, us_per_vertex_step=1.0)
    rows += row("scaling_step/strategy:reference/triangles:28000/iterations:1", [220000])
    for threads, times in ((1, [120, 125, 121]), (2, [60, 55, 50]), (4, [80, 70, 90])):
        rows += row(f"scaling_step/strategy:cells/triangles:28000/submeshes:8/threads:{threads}"
                    "/iterations:20/manual_time", times, oversubscribed=int(threads > 2))
    rows += row("operation/edge_flip", [0.040, 0.044, 0.042])
    rows += row("operation/edge_collapse", [0.3, 0.31, 0.32])
    rows.append({"name": "scaling_step/strategy:copy/triangles:28000", "error_occurred": True,
                 "error_message": "the mesh is not valid"})
    return {"context": {"date": "2020-01-01", "dsc_machine": machine, "dsc_commit": commit,
                        "dsc_cores": "2", "dsc_compiler": "g++", "dsc_build_type": "Release",
                        "dsc_load": "0.1"}, "benchmarks": rows}


def scene(h, error, seconds, **more):
    return {"scene": "swirl", "parameters": {"h": h, "steps": 260, "insertion": "cubic"},
            "strategy": "sequential", "triangles_last": 4000, "area_ratio": 0.9999,
            "sd_rel_last": error, "sd_rel_half": None, "cpu_s": seconds, "inverted": 0,
            "unreached": 0, "machine": "a machine", "commit": "c0ffee", **more}


def precision_run(flow, method, h, error, seconds, group="default", half=None, **more):
    return {"flow": flow, "flow_title": flow.replace("-", " "), "method": method, "group": group,
            "parameters": {"h": h}, "sd_rel_last": error, "sd_rel_half": half, "cpu_s": seconds,
            "inverted": 0, "unreached": 0, "gave_up": None, "machine": "a machine",
            "commit": "c0ffee", **more}


def precision_runs():
    """Second order by the default, fourth by another method, first by Euler, which costs half."""
    sizes = [0.04, 0.02, 0.01, 0.005]
    runs = []
    for method, group, order, cost in (("default", "default", 2, 1), ("euler", "time", 1, 0.5),
                                       ("fourth order", "other", 4, 3),
                                       ("markers, cubic", "markers", 2, 0.01)):
        runs += [precision_run("swirl-260", method, h, 10 * h ** order, cost * (0.01 / h) ** 2,
                               group, 20 * h ** order) for h in sizes]
    return runs


def hard_cases():
    return [{"name": "offset", "asked": "1e12", "unreached": 0, "values": {"largest": 2.5e-3},
             "what_happened": "refused: coordinates collide", "holds": True},
            {"name": "needle", "asked": "1e-9 wide", "what_happened": "kept", "holds": True}]


def faults():
    """As verify/faults.sh writes them: one by a test of its room, one by another, one by nothing."""
    said = {"room": "quality", "kind": "limit", "slow": []}
    return {"baseline": {"quality": 0.2}, "faults": {
        "bin-dropped": {**said, "says": "A bin is dropped.", "caught_by": "quality", "how": "failed",
                        "test": "Histogram.Bins", "cpu_s": 0.3, "own": True},
        "early-end": {**said, "room": "io", "says": "A file ends early.", "caught_by": "hashes",
                      "how": "crashed", "test": "", "cpu_s": 4, "own": False},
        "all-wrong": {**said, "says": "All is wrong.", "caught_by": None, "cpu_s": 60.5}}}


def mutants():
    said = {"killed_by": None, "equivalent": None}
    return {"reached": {}, "mutants": {
        "0a": {**said, "room": "io", "killed_by": "io"}, "0b": {**said, "room": "io"},
        "0c": {**said, "room": "base", "killed_by": "base"},
        "0d": {**said, "room": "base", "equivalent": "Nobody can tell."}}}


def verify(verdict="pass"):
    def shape(strategy, counts):
        return {"scene": "speedup-scaling", "strategy": strategy, "quantity": "area",
                "edges": [0, 1, 2, 3], "counts": counts}

    return {"machine": "a machine", "commit": "c0ffee", "checks": [
        {"check": "area drift", "scene": "swirl", "measured": 1e-5, "limit": 1e-4,
         "verdict": verdict, "unit": "1", "sense": "<="},
        {"check": "same bits", "scene": "swirl", "measured": True, "limit": True,
         "verdict": "pass", "unit": ""}],
        "histograms": [shape("sequential", [10, 60, 30]), shape("cells", [20, 50, 30])]}


class Case(unittest.TestCase):
    def setUp(self):
        # Nobody looks at these pictures.
        for name in ("PNG_DPI", "MESH_DPI"):
            self.addCleanup(setattr, style, name, getattr(style, name))
            setattr(style, name, 40)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, data):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(data if isinstance(data, str) else json.dumps(data))
        return path

    def run_report(self, *words):
        """Exit status, error text, page text."""
        errors = io.StringIO()
        out = os.path.join(self.folder, "out")
        with contextlib.redirect_stderr(errors):
            status = report.main(["--jobs", "1", *words, "--out", out])
        page = os.path.join(out, "index.html")
        text = ""
        if os.path.exists(page):
            with open(page, encoding="utf-8") as stream:
                text = stream.read()
        return status, errors.getvalue(), text

    def assert_refused(self, words, *expected):
        status, errors, page = self.run_report(*words)
        self.assertEqual(status, 2)
        self.assertEqual(errors.count("\n"), 1, errors)
        self.assertTrue(errors.startswith("report.py: ") and errors.endswith(".\n"), errors)
        for word in expected:
            self.assertIn(word, errors)
        self.assertEqual(page, "", "a refused input must leave no report")

    def inputs(self, few=False):
        """The words of a whole report, or of one with a picture of each kind."""
        self.write("frames/swirl_sequential_00000.vtu", VTU.format(x=1))
        self.write("frames/swirl_sequential_00007.vtu", VTU.format(x=1.5))
        self.write("frames/swirl_sequential.pvd", '<VTKFile><Collection><DataSet timestep="0.5" '
                   'file="swirl_sequential_00007.vtu"/></Collection></VTKFile>')
        words = ["--hard", self.write("hard.json", hard_cases()),
                 "--frames", os.path.join(self.folder, "frames"), "--published", PUBLISHED,
                 "--verify", self.write("verify.json", verify())]
        if few:
            return words
        return [*words, "--bench", self.write("bench.json", bench()),
                "--scenes", self.write("one.json", scene(0.01, 1e-3, 0.5)),
                self.write("two.json", scene(0.005, 2e-4, 2.0)),
                "--precision", *(self.write(f"precision/{k}.json", run)
                                 for k, run in enumerate(precision_runs()))]

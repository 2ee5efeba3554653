# SPDX-License-Identifier: MIT
"""Small made-up result files that the tests of the pictures draw, and the case they share."""
import contextlib
import io
import json
import os
import tempfile
import unittest

import report
from look import saving, style
from results import load

PLOTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PUBLISHED = os.path.join(PLOTS, "..", "reference", "published")

# One square of four triangles around a middle vertex; the right triangle is of phase 1.
VTU = """<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="4">
<PointData><DataArray type="Float64" Name="velocity" NumberOfComponents="3" format="ascii">
0 0 0  0 0 0  0 0 0  0 0 0  3 4 0</DataArray></PointData>
<CellData><DataArray type="UInt32" Name="phase" format="ascii">0 1 0 0</DataArray></CellData>
<Points><DataArray type="Float64" Name="Points" NumberOfComponents="3" format="ascii">
0 0 0  2 0 0  2 2 0  0 2 0  {x} 1 0</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 4 1 2 4 2 3 4 3 0 4</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5 5 5 5</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
"""
# A file of `dsc_scene run --series`, and the result of the run.
SERIES = """step,time,triangles,phases,sd_rel,interface_length,min_angle_deg,collapses,flips,smoothed,splits,events,wall_us
0,0,100,2,0.001,4,30,0,0,0,0,0,0
10,0.5,110,2,0.002,4.5,25,40,20,30,10,0,1000
14,0.7,90,1,0.003,5,20,8,12,16,4,1,400
"""
RESULT = {"scene": "swirl", "strategy": "cells", "machine": "a machine", "commit": "c0ffee",
          "threads": 2}
# The figures of a run of the scene rising-bubble.
BUBBLE = {"scene": "rising-bubble", "cpu_s": 3.0, "rise_velocity_max": 0.2417, "centre_last": 1.08,
          "circularity_last": 0.92, "machine": "a machine", "commit": "c0ffee"}
PROFILE = {"us_set_up": 1, "us_hand_over": 0, "us_clean_up": 0, "us_driver": 1,
           "us_remeshing": 10, "us_velocities": 5, "us_movement": 8, "us_mesh_update": 70,
           "us_later_colours": 5}


def box(normal=(1.0, 0.0), low=None, high=None, side_low=None, side_high=None, work=1.0):
    return {"kind": "box", "normal": list(normal), "low": low, "high": high,
            "side_low": side_low, "side_high": side_high, "work_us": work}


# The square of VTU divided: at x = 0.5 in colour 1, at y = 0.5 in colour 2.
DIVIDED = {"colours": [
    {"regions": [box(high=0.5, work=3.0), box(low=0.5, work=5.0)]},
    {"regions": [box((0.0, 1.0), high=0.5, work=1.0), box((0.0, 1.0), low=0.5, work=0.5)]},
    {"regions": [{"kind": "whole", "work_us": 0.5}]}]}


def name(strategy, triangles, threads=0, cells=0, family="scaling_step", **more):
    text = f"{family}/strategy:{strategy}/triangles:{triangles}"
    if threads:
        text += f"/submeshes:{cells}/threads:{threads}"
    return text + "".join(f"/{k}:{v}" for k, v in more.items()) + "/iterations:1/manual_time"


def row(name, times_us, **counters):
    """The rows that Google Benchmark writes for one benchmark with repetitions."""
    rows = [{"name": name, "run_name": name, "run_type": "iteration", "repetition_index": i,
             "iterations": 20, "threads": 1, "real_time": t, "cpu_time": t, "time_unit": "us",
             **counters, **({"us_per_step": t} if "/triangles" in name else {})}
            for i, t in enumerate(times_us)]
    return rows + [{"name": name + "_mean", "run_name": name, "run_type": "aggregate",
                    "aggregate_name": "mean", "real_time": 1e9, "time_unit": "us"}]


def bench(machine="a machine", commit="c0ffee"):
    rows = row(name("sequential", 28000), [100, 130, 110], interface_vertices=100,
               us_per_vertex_step=1.1)
    rows += row(name("sequential", 280000), [400, 440, 420], interface_vertices=400,
                us_per_vertex_step=1.0)
    rows += row(name("reference", 28000), [220000])
    for threads, times in ((1, [120, 125, 121]), (2, [60, 55, 50]), (4, [80, 70, 90])):
        rows += row(name("cells", 28000, threads, 8), times, oversubscribed=int(threads > 2))
    rows += row("operation/edge_flip", [0.040, 0.044, 0.042])
    rows += row("operation/edge_collapse", [0.3, 0.31, 0.32])
    rows.append({"name": "scaling_step/strategy:copy/triangles:28000", "error_occurred": True,
                 "error_message": "the mesh is not valid"})
    return {"context": {"date": "2020-01-01", "dsc_machine": machine, "dsc_commit": commit,
                        "dsc_cores": "2", "dsc_compiler": "g++", "dsc_build_type": "Release",
                        "dsc_load": "0.1"}, "benchmarks": rows}


def model(triangles, threads, us, cells=0, **more):
    """A modelled row: two per cent of the work is serial."""
    return row(name("cells", triangles, threads, cells, modelled=1), [us], modelled=1.0,
               serial_share=0.02, busy_share=0.9, fork_join_us=0.5, section_start_us=0.8,
               bandwidth_of_one_gb_s=12.5, bandwidth_of_all_gb_s=19.0, load=0.5, **PROFILE, **more)


def parallel_bench(**context):
    rows = row(name("sequential", 28000), [100, 104, 96], load=0.5, us_per_vertex_step=0.5)
    for strategy, ones, twos in (("cells", 105, 60), ("active", 110, 70), ("copy", 900, 600)):
        rows += row(name(strategy, 28000, 1, 8), [ones], load=0.5, utilisation=1, threads_used=1)
        rows += row(name(strategy, 28000, 2, 8), [twos], load=0.5, utilisation=0.9, threads_used=2,
                    serial_share=0.1)
    rows += model(28000, 1, 102) + model(28000, 2, 54) + model(28000, 4, 30)
    rows += model(28000, 8, 20) + model(28000, 8, 16, cells=8) + model(28000, 16, 19)
    for triangles, us, two in ((1800, 20, 40), (7000, 40, 40 / 1.5), (28000, 80, 50)):
        family = "granularity_step"
        rows += row(name("sequential", triangles, family=family), [us])
        rows += row(name("cells", triangles, 2, family=family), [two])
    for between, sequential, cells in ((0, 100, 50), (1000, 130, 100)):
        of = {"family": "scaling_run", "between_us": between}
        counters = {"construction_us": 500 + between, "first_step_us": 70}
        rows += row(name("sequential", 28000, **of), [sequential] * 3, **counters)
        rows += row(name("cells", 28000, 2, **of), [cells, cells - 10, cells + 10], **counters)
    return {"context": {"dsc_machine": "a machine", "dsc_commit": "c0ffee", "dsc_cores": "2",
                        **context}, "benchmarks": rows}


def own_suite(strategies=("sequential", "cells")):
    """A scene named by its edge lengths, with strategies that differ in their numbers of triangles."""
    rows = []
    for h, us in (("0.02", 100), ("0.01", 400)):
        for strategy in strategies:
            for threads in (1, 2) if strategy == "cells" else (0,):
                words = f"/threads:{threads}" if threads else ""
                rows += row(f"mine_run/strategy:{strategy}/h:{h}{words}/between_us:0/iterations:1/"
                            "manual_time", [us * k / max(threads, 1) for k in (1, 1.1, 0.9)],
                            us_per_step=us / max(threads, 1), triangles=1000 + threads)
    return {**bench(), "benchmarks": rows}


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
    """Second order for the default, fourth for another method, first for Euler, which costs half."""
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
        # The tests need no resolution.
        for name in ("PNG_DPI", "MESH_DPI"):
            self.addCleanup(setattr, saving, name, getattr(saving, name))
            setattr(saving, name, 40)
        self.addCleanup(style.plt.close, "all")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, data):
        """Writes bytes, a text or data as JSON, and returns the path."""
        if not isinstance(data, bytes):
            data = (data if isinstance(data, str) else json.dumps(data)).encode("utf-8")
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "wb") as stream:
            stream.write(data)
        return self.path(name)

    def read_bench(self, data, keep=lambda row: True, change=lambda row: None):
        rows = [row for row in data["benchmarks"] if keep(row)]
        for row in rows:
            change(row)
        return load.read_bench([self.write("bench.json", {**data, "benchmarks": rows})])

    def frames(self, run, middles, times=()):
        """The folder of a run's frames, {step: x of the middle vertex} and {step: time}."""
        for step, x in middles.items():
            self.write(f"frames/{run}_{step:05}.vtu", VTU.format(x=x))
        if times:
            self.write(f"frames/{run}.pvd", "<VTKFile><Collection>" + "".join(
                f'<DataSet timestep="{time}" part="0" file="{run}_{step:05}.vtu"/>'
                for step, time in times.items()) + "</Collection></VTKFile>")
        return self.path("frames")

    def run_report(self, *words):
        """Exit status, error text, page text."""
        errors = io.StringIO()
        out = self.path("out")
        with contextlib.redirect_stderr(errors):
            try:
                status = report.main(["--jobs", "1", *words, "--out", out])
            except SystemExit as end:  # by argparse
                status = end.code
        page = os.path.join(out, "index.html")
        text = ""
        if os.path.exists(page):
            with open(page, encoding="utf-8") as stream:
                text = stream.read()
        return status, errors.getvalue(), text

    def assert_refused(self, words, *expected):
        status, errors, page = self.run_report(*words)
        self.assertEqual(status, 2)
        last = errors.splitlines()[-1]
        self.assertTrue(last.startswith("report.py: ") and last.endswith("."), errors)
        for word in expected:
            self.assertIn(word, errors)
        self.assertEqual(page, "", "a refused input must leave no report")

    def inputs(self, few=False):
        """The words of a whole report, or of one with a picture of each kind."""
        words = ["--hard", self.write("hard.json", hard_cases()), "--published", PUBLISHED,
                 "--frames", self.frames("swirl_sequential", {0: 1, 7: 1.5}, {7: 0.5}),
                 "--verify", self.write("verify.json", verify())]
        if few:
            return words
        return [*words, "--bench", self.write("bench.json", bench()),
                "--scenes", self.write("one.json", scene(0.01, 1e-3, 0.5)),
                self.write("two.json", scene(0.005, 2e-4, 2.0)),
                "--precision", *(self.write(f"precision/{k}.json", run)
                                 for k, run in enumerate(precision_runs()))]

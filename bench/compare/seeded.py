# SPDX-License-Identifier: MIT
"""Variants of dsc_scene that are slower by a known amount, to try the comparison on.

A copy of the sources gets one more line at the end of a step, which does nothing unless the name of the
program says so (seeded/slowdown.h.in). So one build is all variants: the unchanged program is a copy of
the file named `plain-0000`, a slower one a copy named `delay-0040`, of as many letters, for the length of
a name moves the stack."""
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
FILE = "lib/dsc/algorithm/simulation.cpp"
HEADER = "lib/seeded/slowdown.h"
# The end of Simulation::step_along, and what stands there in the copy.
END = """        report.interface_vertices = count_on_interface<Real>(complex_, to_sweep_);
    }
"""
LINE = "    seeded::slow_down(report.interface_vertices);\n"
KINDS = ("plain", "count", "delay", "alloc")


class CannotSeed(Exception):
    """Why."""


def with_line(text):
    if text.count(END) != 1:
        raise CannotSeed(f"{FILE}: the end of a step is there {text.count(END)} times, not once: "
                         "seeded.py quotes lines that have changed")
    return '#include "seeded/slowdown.h"\n' + text.replace(END, END + LINE)


def build(folder, jobs):
    """The program, built as bench/compare.sh builds the two that it compares."""
    sys.path.insert(0, str(PROJECT / "verify/faults"))
    import overlay  # pylint: disable=import-outside-toplevel,import-error

    source, build_folder = folder / "source", folder / "build"
    overlay.make(PROJECT, source, [], instead={
        FILE: with_line((PROJECT / FILE).read_text(encoding="utf-8")),
        HEADER: (HERE / "seeded/slowdown.h.in").read_text(encoding="utf-8")})
    launcher = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER")
    configure = ["cmake", "--preset", "release", "-B", str(build_folder), "-D", "DSC_NATIVE=OFF", "-D",
                 "DSC_STRICT=OFF"]
    configure += ["-D", f"CMAKE_CXX_COMPILER_LAUNCHER={launcher}"] if launcher else []
    for command in (configure, ["cmake", "--build", str(build_folder), "--parallel", str(jobs),
                                "--target", "dsc_scene"]):
        done = subprocess.run(command, cwd=source, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise CannotSeed(f"{' '.join(command)} ended with {done.returncode}:\n"
                             f"{done.stdout}{done.stderr}")
    return build_folder / "lib/scenes/dsc_scene"


def variant(program, folder, kind, amount=0):
    """The path of a copy that is slower by that."""
    if kind not in KINDS or not 0 <= amount <= 9999:
        raise CannotSeed(f"no such slowdown: got {kind} {amount}; allowed: {', '.join(KINDS)}, 0 to 9999")
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{kind}-{amount:04d}"
    shutil.copy2(program, path)
    return path

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""growth.py --program PROGRAM --out FILE: how does the work of a step grow with the mesh?

Counts the instructions of a few steps of a growing circle, and of nothing else, in meshes of 28,000,
280,000 and 2,800,000 triangles, and fits exponents: of instructions against triangles, and of
instructions for each vertex of the interface against triangles. A step works along the interface,
which is as long as the root of the number of triangles, so the former should be near 0.5 and the
latter near 0. The latter is held to a limit: a loop over the whole mesh breaks it even if it takes a
single instruction for each triangle. The program is a build of dsc_scene that valgrind knows all
instructions of; bench/compare.sh --growth makes it. Exit: 0 within the limit, 1 above it, 2 bad usage
or nothing could be counted. Standard library only."""
import argparse
import dataclasses
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

import benchmark_json
import callgrind
from workloads import STEP

SIZES = (28_000, 280_000, 2_800_000)
STEPS = 8
WAY = 0.3       # of a step, in edge lengths
# Of instructions for each vertex of the interface against triangles, fitted and between neighbours.
# Measured: -0.02 to -0.01, for what is done once in a step weighs less in a larger mesh. A loop of one
# instruction for each triangle makes it 0.12 between the two largest meshes.
MOST = 0.08


@dataclasses.dataclass(frozen=True)
class Row:
    triangles: int
    vertices: float     # of the interface, in the mean of the steps
    instructions: float  # of a step

    @property
    def each(self):
        return self.instructions / self.vertices


@dataclasses.dataclass(frozen=True)
class Fit:
    """y = factor * x ** exponent, by least squares of the logarithms."""
    exponent: float
    low: float      # the least and the greatest exponent between two neighbours
    high: float


def fit(points):
    """Of [(x, y)], positive and of at least two different x."""
    if len({x for x, _ in points}) < 2 or any(x <= 0 or y <= 0 for x, y in points):
        raise ValueError(f"no exponent can be fitted to {points}")
    logs = sorted((math.log(x), math.log(y)) for x, y in points)
    slope = statistics.linear_regression(*zip(*logs)).slope
    between = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(logs, logs[1:]) if b[0] > a[0]]
    return Fit(slope, min(between), max(between))


def of_step(rows):
    return fit([(row.triangles, row.instructions) for row in rows])


def of_vertex(rows):
    return fit([(row.triangles, row.each) for row in rows])


def is_too_much(rows):
    """Between neighbours as well: what grows with the mesh shows in the largest first."""
    found = of_vertex(rows)
    return max(found.exponent, found.high) > MOST


def edge_length(triangles):
    """Of equilateral triangles that fill the unit square."""
    return math.sqrt(4 / (math.sqrt(3) * triangles))


def scene(triangles, steps):
    h = edge_length(triangles)
    return (f'scene = "speedup-scaling"\n[options]\nh = {h!r}\ndt = {WAY * h!r}\nsteps = {steps}\n'
            "[measure]\nshape = false\n")


def measure(program, triangles, steps=STEPS):
    """One Row. Raises NotCounted."""
    with tempfile.TemporaryDirectory() as folder:
        path, result = os.path.join(folder, "scene.toml"), os.path.join(folder, "result.json")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(scene(triangles, steps))
        instructions, _ = callgrind.count([program, "run", path, "--json", result], within=STEP)
        with open(result, encoding="utf-8") as stream:
            found = json.load(stream)
    if found["steps"] != steps:
        raise callgrind.NotCounted(f"{found['steps']} steps were made, not {steps}")
    return Row(found["triangles_first"],
               (found["interface_vertices_first"] + found["interface_vertices_last"]) / 2,
               instructions / steps)


def write(path, rows):
    data = {"steps": STEPS, "rows": [{**dataclasses.asdict(row), "instructions_a_vertex": row.each}
                                     for row in rows],
            "of_step": dataclasses.asdict(of_step(rows)),
            "of_vertex": {**dataclasses.asdict(of_vertex(rows)), "limit": MOST}}
    benchmark_json.replace(path, data)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", required=True, help="JSON file")
    parser.add_argument("--sizes", type=int, nargs="+", default=list(SIZES), metavar="TRIANGLES")
    arguments = parser.parse_args(argv)
    if not os.access(arguments.program, os.X_OK):
        parser.error(f"not a program: got '{arguments.program}'; allowed: a build of dsc_scene")
    if len(set(arguments.sizes)) < 2 or min(arguments.sizes) < 1000:
        parser.error(f"--sizes: got {arguments.sizes}; allowed: two and more, each at least 1000")
    if not callgrind.is_installed():
        print("instructions are not counted: valgrind is not installed", file=sys.stderr)
        return 2
    rows = []
    print("triangles  interface vertices  instructions a step  and a vertex", flush=True)
    for triangles in sorted(set(arguments.sizes)):
        rows.append(measure(arguments.program, triangles))
        row = rows[-1]
        print(f"{row.triangles:9}  {row.vertices:18.1f}  {row.instructions:19.0f}  {row.each:12.0f}",
              flush=True)
    write(arguments.out, rows)
    step, vertex = of_step(rows), of_vertex(rows)
    print(f"instructions of a step grow with triangles to the power of {step.exponent:.3f} "
          f"(between neighbours {step.low:.3f} to {step.high:.3f})")
    print(f"and for each vertex of the interface to the power of {vertex.exponent:.3f} "
          f"({vertex.low:.3f} to {vertex.high:.3f}), of which {MOST} is allowed")
    if is_too_much(rows):
        print("a step does work that grows with the mesh")
        return 1
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (callgrind.NotCounted, OSError, ValueError, KeyError, subprocess.SubprocessError) as error:
        print(f"growth.py: {error}", file=sys.stderr)
        sys.exit(2)

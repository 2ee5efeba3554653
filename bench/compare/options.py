#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""options.py PROGRAM SCENE --a KEY=VALUE... --b KEY=VALUE...: two sets of options of a scene, compared.

PROGRAM is dsc_scene; SCENE is a scene of its catalogue or a scene file; KEY=VALUE is as for `--set`, and
`--set` is for both. Prints the figures of both runs, the instructions and allocations of their steps if
valgrind is installed (which takes fifty times as long as a run), and the ratio of their times, b over a,
from runs in pairs in random order (judgement.py). --json FILE writes all of these. Exit: 0 done, 2 bad usage
or a run that failed. Standard library only."""
import argparse
import functools
import os
import sys

import benchmark_json
import callgrind
import counting
import judgement
import timing
import workloads

FIGURES = ("triangles_last", "interface_vertices_last", "area_ratio", "sd_rel_half", "sd_rel_last",
           "min_quality_last", "min_angle_deg_last", "median_angle_deg_last", "sub_steps", "unreached",
           "inverted")


def parse_arguments(words=None):
    parser = argparse.ArgumentParser(
        prog="options.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="PROGRAM")
    parser.add_argument("scene", metavar="SCENE")
    for name, what in (("a", "the first set"), ("b", "the second set"), ("set", "for both")):
        parser.add_argument(f"--{name}", nargs="+", default=[], metavar="KEY=VALUE", help=what)
    parser.add_argument("--pairs", type=int, default=60, help="largest number of pairs (default 60)")
    parser.add_argument("--minutes", type=float, default=5, help="of all pairs (default 5)")
    parser.add_argument("--no-times", action="store_true")
    parser.add_argument("--no-counts", action="store_true")
    parser.add_argument("--json", metavar="FILE", help="the results")
    arguments = parser.parse_args(words)
    if not os.access(arguments.program, os.X_OK):
        parser.error(f"not a program: got '{arguments.program}'; allowed: dsc_scene")
    if not arguments.a and not arguments.b:
        parser.error("nothing to compare: got neither --a nor --b")
    for word in (*arguments.a, *arguments.b, *arguments.set):
        if "=" not in word:
            parser.error(f"--a, --b and --set: got '{word}'; allowed: KEY=VALUE")
    if arguments.pairs < judgement.FEWEST_PAIRS:
        parser.error(f"--pairs: got {arguments.pairs}; allowed: {judgement.FEWEST_PAIRS} and more")
    return arguments


def sides_of(arguments):
    return tuple(timing.Side(arguments.program, tuple(
        word for setting in (*arguments.set, *own) for word in ("--set", setting)))
                 for own in (arguments.a, arguments.b))


def row(name, a, b, note=""):
    """A line of the table, and its entry in the results. The ratio has no meaning without a positive base."""
    ratio = b / a if a > 0 else None
    print(f"{name:26}{a:16.8g}{b:16.8g}{'' if ratio is None else f'{ratio:10.4f}'}{note}", flush=True)
    return {"name": name, "a": a, "b": b, "ratio": ratio}


def figures(sides, scene):
    a, b = (timing.result_of(side, scene)[1] for side in sides)
    return [row(name, a[name], b[name]) for name in FIGURES
            if isinstance(a.get(name), (int, float)) and isinstance(b.get(name), (int, float))]


def counts(sides, workload):
    a, b, what = counting.of_both(sides, workload)
    return [row(f"instructions, {what}", a.instructions, b.instructions),
            row("allocations a step", a.allocations / a.steps, b.allocations / b.steps)]


def times(sides, workload, arguments):
    found = timing.measure(
        {workload.name: tuple(functools.partial(lambda side: timing.run(side, workload.timed)[0], side)
                              for side in sides)},
        arguments.pairs, 60 * arguments.minutes, lambda text: print(text, file=sys.stderr))
    rows = []
    for figure, pairs in sorted(found[workload.name].times.items()):
        ratio = judgement.median_ratio(pairs)
        middle = len(pairs) // 2
        a, b = (sorted(pair[which] for pair in pairs)[middle] for which in (0, 1))
        rows.append(row(f"{figure}, us", a, b, f", of pairs {ratio.value:.3f} ({ratio.low:.3f} to "
                                               f"{ratio.high:.3f}, {len(pairs)} pairs)"))
        rows[-1].update(ratio=ratio.value, low=ratio.low, pairs=len(pairs),
                        high=ratio.high if ratio.low > 0 else None)
    return rows


def main(words=None):
    arguments = parse_arguments(words)
    sides = sides_of(arguments)
    workload = workloads.Workload(arguments.scene, arguments.scene, arguments.scene)
    print(f"{'':26}{'a':>16}{'b':>16}{'b / a':>10}")
    rows = figures(sides, arguments.scene)
    if not arguments.no_counts:
        try:
            if not callgrind.is_installed():
                raise callgrind.NotCounted("valgrind is not installed")
            rows += counts(sides, workload)
        except callgrind.NotCounted as error:
            print(f"not counted: {error}")
    if not arguments.no_times:
        rows += times(sides, workload, arguments)
    if arguments.json:
        benchmark_json.replace(arguments.json, {
            "program": arguments.program, "scene": arguments.scene, "set": arguments.set,
            "a": arguments.a, "b": arguments.b, "figures": rows})
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, OSError, ValueError) as error:
        print(f"options.py: {error}", file=sys.stderr)
        sys.exit(2)

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py --base PROGRAM --new PROGRAM --out DIR: is the new program slower than the base?

Counts the instructions and allocations of fixed runs if valgrind is installed; runs both programs in pairs,
in random order, until their times differ significantly or are equal within the limit. judgement.py explains
the rules. The programs are two builds of dsc_scene, made by bench/compare.sh, or with --bare any two
programs without arguments. Writes base.json, new.json (all times) and compare.json (the results). Exit: 0
not slower, 1 slower, 2 bad usage or nothing could be measured, 3 undecided. Standard library only."""
import argparse
import functools
import os
import re
import sys
import time

import benchmark_json
import callgrind
import counting
import judgement
import timing
import workloads
from judgement import Verdict


def told(name, columns, verdict):
    """A line of the table."""
    loud = "" if verdict == Verdict.NOT_SLOWER else f"   {verdict.value.upper()}"
    return f"{name:34} {columns}{loud}"


def judge_counts(sides, selected):
    """(line, row of compare.json) for each count."""
    for workload in selected:
        base, new, what = counting.of_both(sides, workload)
        ratio, is_slower = judgement.more_instructions(base, new)
        more, are_more = judgement.more_allocations(base, new)
        for figure, value, columns, slower in (
                ("instructions", ratio,
                 f"{ratio:8.4f}   {base.instructions} to {new.instructions}", is_slower),
                ("allocations a step", more,
                 f"{more:+8.2f}   {base.allocations} to {new.allocations}", are_more)):
            verdict = Verdict.SLOWER if slower else Verdict.NOT_SLOWER
            name = f"{workload.name}/{figure}"
            yield (told(name, columns + ("" if what == "steps" else f", {what}"), verdict),
                   {"name": name, "of": what, "value": value, "verdict": verdict.value})


def judge_times(found):
    """The same for each time."""
    for workload, pairs in sorted(found.items()):
        for figure, times in sorted(pairs.times.items()):
            ratio = judgement.median_ratio(times)
            name = f"{workload}/{figure}"
            columns = f"{ratio.value:6.3f}  {ratio.low:.3f} to {ratio.high:<6.3f} {len(times):5}"
            yield (told(name, columns, ratio.verdict),
                   {"name": name, "pairs": len(times), "verdict": ratio.verdict.value,
                    "value": ratio.value, "low": ratio.low,
                    "high": ratio.high if ratio.low > 0 else None})


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--base", required=True)
    parser.add_argument("--new", required=True)
    parser.add_argument("--out", required=True, help="folder for base.json, new.json and compare.json")
    parser.add_argument("--filter", default="", help="a regular expression for workloads")
    parser.add_argument("--pairs", type=int, default=300, help="largest number of pairs")
    parser.add_argument("--minutes", type=float, default=10, help="largest duration of all pairs")
    parser.add_argument("--no-times", action="store_true")
    parser.add_argument("--no-counts", action="store_true")
    parser.add_argument("--bare", action="store_true",
                        help="compare any two programs, run without arguments")
    arguments = parser.parse_args()
    try:
        pattern = re.compile(arguments.filter)
    except re.error as error:
        parser.error(f"--filter: {error}: got '{arguments.filter}'")
    known = (workloads.BARE,) if arguments.bare else workloads.ALL
    arguments.selected = [w for w in known if pattern.search(w.name)]
    if not arguments.selected:
        names = ", ".join(w.name for w in known)
        parser.error(f"--filter: no such workload: got '{arguments.filter}'; allowed: {names}")
    if arguments.pairs < judgement.FEWEST_PAIRS:
        parser.error(f"--pairs: got {arguments.pairs}; allowed: {judgement.FEWEST_PAIRS} and more")
    if not arguments.minutes > 0:
        parser.error(f"--minutes: got {arguments.minutes}; allowed: more than 0")
    for program in (arguments.base, arguments.new):
        if not os.access(program, os.X_OK):
            parser.error(f"not a program: got '{program}'; allowed: two builds of dsc_scene")
    return arguments


def measure(sides, arguments):
    """{workload: Pairs}; the times themselves go to base.json and new.json."""
    def one(side, scene):
        return timing.run(side, scene)[0]

    found = timing.measure(
        {w.name: tuple(functools.partial(one, side, w.timed) for side in sides)
         for w in arguments.selected},
        arguments.pairs, 60 * arguments.minutes, lambda text: print(text, file=sys.stderr))
    for which, name in enumerate(("base", "new")):
        benchmark_json.write(
            os.path.join(arguments.out, name + ".json"), sides[which].program,
            {f"{workload}/{figure}": [pair[which] for pair in times]
             for workload, pairs in sorted(found.items())
             for figure, times in sorted(pairs.times.items())},
            {"pairs": {workload: pairs.count for workload, pairs in sorted(found.items())}})
    return found


def summary(rows, seconds):
    """The last line, and the exit code."""
    def having(verdict):
        return [row["name"] for row in rows if row["verdict"] == verdict.value]

    slower, undecided = having(Verdict.SLOWER), having(Verdict.UNDECIDED)
    text = (f"{len(rows)} figures in {seconds:.0f} s, {len(slower)} slower (limits: "
            f"{judgement.TIME_LIMIT} in time, {judgement.INSTRUCTIONS_LIMIT} in instructions, "
            f"{judgement.ALLOCATIONS_LIMIT} allocations more in a step)")
    if undecided:
        text += (f"\n{len(undecided)} undecided, their intervals reach across the limit and are too "
                 f"wide: {', '.join(undecided)}")
    return text, 1 if slower else 3 if undecided else 0


def main():
    arguments = parse_arguments()
    sides = (timing.Side(arguments.base), timing.Side(arguments.new))
    os.makedirs(arguments.out, exist_ok=True)
    rows = []
    begin = time.monotonic()

    def show(found):
        for line, row in found:
            print(line, flush=True)
            rows.append(row)

    if not arguments.no_counts:
        if callgrind.is_installed():
            print("counts of steps: new / base, and the two")
            try:
                show(judge_counts(sides, arguments.selected))
            except callgrind.NotCounted as error:
                print(f"not counted: {error}")
        else:
            print("instructions are not counted: valgrind is not installed")
    if not arguments.no_times:
        found = measure(sides, arguments)
        print(f"times, new / base: median of the pairs' ratios and its interval "
              f"({100 * judgement.CONFIDENCE:g} %), pairs")
        show(judge_times(found))
    if not rows:
        print("nothing was measured", file=sys.stderr)
        return 2
    seconds = time.monotonic() - begin
    text, code = summary(rows, seconds)
    print(text)
    benchmark_json.replace(os.path.join(arguments.out, "compare.json"),
                           {"base": arguments.base, "new": arguments.new, "seconds": seconds,
                            "code": code, "figures": rows})
    return code


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, OSError, ValueError) as error:
        print(f"compare.py: {error}", file=sys.stderr)
        sys.exit(2)

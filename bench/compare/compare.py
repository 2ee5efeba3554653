#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py --base PROGRAM --new PROGRAM --out DIR: is the new program slower than the base?

Runs both in pairs, in random order, and judges their times; counts the instructions and allocations
of fixed runs where valgrind is installed. The programs are two builds of dsc_scene, which
bench/compare.sh makes before it calls this, or with --bare any two that take no arguments. Exit: 0 not
slower, 1 slower, 2 bad usage or nothing could be measured. Standard library only."""
import argparse
import json
import os
import random
import re
import resource
import subprocess
import sys
import tempfile

import benchmark_json
import callgrind
import judgement
import workloads


def run_bare(program):
    """One run of any program: microseconds of CPU time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program], capture_output=True, text=True, check=False,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise RuntimeError(f"{program} ended with {done.returncode}: {done.stderr.strip()}")
    cpu = (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime)
    return {"whole run, CPU": cpu * 1e6}, 1


def run(program, arguments):
    """One run: microseconds of CPU time as a whole, of a step (median, wall time), and the steps."""
    if arguments is None:
        return run_bare(program)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "result.json")
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([program, "run", *arguments, "--json", path], capture_output=True,
                              text=True, check=False,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        # 1: the run broke an invariant, which another test judges.
        if done.returncode not in (0, 1) or not os.path.exists(path):
            raise RuntimeError(f"{program} run {' '.join(arguments)} ended with {done.returncode}: "
                               f"{done.stderr.strip()}")
        with open(path, encoding="utf-8") as stream:
            result = json.load(stream)
    cpu = (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime)
    return {"whole run, CPU": cpu * 1e6,
            "steps, CPU": result["cpu_s"] * 1e6 / max(result["steps"], 1),
            "step, median": result["step_us_median"]}, result["steps"]


def measure_pairs(programs, selected, pairs, say):
    """{workload/figure: [(base, new)]}."""
    source = random.Random()
    times = {}
    for workload in selected:
        for program in programs:
            run(program, workload.timed)  # warms up the disk's cache
    for i in range(pairs):
        say(f"pair {i + 1} of {pairs}")
        for workload in source.sample(selected, len(selected)):
            found = {}
            for which in source.sample((0, 1), 2):
                found[which], _ = run(programs[which], workload.timed)
            for figure, base in found[0].items():
                times.setdefault(f"{workload.name}/{figure}", []).append((base, found[1][figure]))
    return dict(sorted(times.items()))


def counts_of(program, workload):
    if workload.counted is None:
        run_bare(program)
        return judgement.Counts(*callgrind.count([program]), steps=1)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.toml")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(workload.counted)
        _, steps = run(program, [path])
        return judgement.Counts(*callgrind.count([program, "run", path]), steps)


def judge_times(times):
    """Lines of a table, each with whether it is slower."""
    for name, pairs in times.items():
        ratio = judgement.ratio_of_medians(pairs)
        yield (f"{name:36} {ratio.value:8.3f}   {ratio.low:.3f} to {ratio.high:.3f}"
               f"{'   SLOWER' if ratio.is_slower else ''}", ratio.is_slower)


def judge_counts(programs, selected):
    for workload in selected:
        base, new = (counts_of(program, workload) for program in programs)
        ratio, is_slower = judgement.more_instructions(base, new)
        yield (f"{workload.name + '/instructions':36} {ratio:8.4f}   {base.instructions} to "
               f"{new.instructions}{'   SLOWER' if is_slower else ''}", is_slower)
        more, is_slower = judgement.more_allocations(base, new)
        yield (f"{workload.name + '/allocations a step':36} {more:+8.2f}   {base.allocations} to "
               f"{new.allocations}{'   SLOWER' if is_slower else ''}", is_slower)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--base", required=True)
    parser.add_argument("--new", required=True)
    parser.add_argument("--out", required=True, help="folder for base.json and new.json")
    parser.add_argument("--filter", default="", help="a regular expression for workloads")
    parser.add_argument("--pairs", type=int, default=15)
    parser.add_argument("--no-times", action="store_true")
    parser.add_argument("--no-counts", action="store_true")
    parser.add_argument("--bare", action="store_true",
                        help="the two are programs of any kind, which are run without arguments")
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
    for program in (arguments.base, arguments.new):
        if not os.access(program, os.X_OK):
            parser.error(f"not a program: got '{program}'; allowed: two builds of dsc_scene")
    return arguments


def main():
    arguments = parse_arguments()
    programs = (arguments.base, arguments.new)
    os.makedirs(arguments.out, exist_ok=True)
    verdicts = []

    def show(rows):
        for line, is_slower in rows:
            print(line, flush=True)
            verdicts.append(is_slower)

    if not arguments.no_counts:
        if callgrind.is_installed():
            print("counts: new / base, and the two")
            try:
                show(judge_counts(programs, arguments.selected))
            except callgrind.NotCounted as error:
                print(f"not counted: {error}")
        else:
            print("instructions are not counted: valgrind is not installed")
    if not arguments.no_times:
        times = measure_pairs(programs, arguments.selected, arguments.pairs,
                              lambda text: print(text, file=sys.stderr))
        print(f"times: ratio of the medians of {arguments.pairs} pairs, new / base, and its interval "
              f"({100 * judgement.CONFIDENCE:g} %, bootstrap)")
        show(judge_times(times))
        for which, name in enumerate(("base", "new")):
            benchmark_json.write(os.path.join(arguments.out, name + ".json"), programs[which],
                                 {key: [pair[which] for pair in pairs]
                                  for key, pairs in times.items()}, {"pairs": arguments.pairs})
    if not verdicts:
        print("nothing was measured", file=sys.stderr)
        return 2
    slower = sum(verdicts)
    print(f"{len(verdicts)} figures, {slower} slower (limits: {judgement.TIME_LIMIT} in time, "
          f"{judgement.INSTRUCTIONS_LIMIT} in instructions, {judgement.ALLOCATIONS_LIMIT} "
          "allocations more in a step)")
    return 1 if slower else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, OSError, ValueError) as error:
        print(f"compare.py: {error}", file=sys.stderr)
        sys.exit(2)

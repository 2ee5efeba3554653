#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""trials.py [--folder DIR] [--program PROGRAM] [--runs N] [--unchanged N]: does the comparison keep its promise?

Builds a copy of the working tree whose steps can be made slower by known amounts (seeded.py), finds the
amounts for each workload by measurement, and runs compare.py as anybody would: N times each on a step with 2 %
more instructions, one that takes 5 % more time in hardly any more instructions, and one that allocates
once, and N times on two copies of the unchanged program. A seeded run compares one workload, the five in
turn; those of more instructions and of allocations leave out times, which do not decide them. Runs of
unchanged code compare everything. An interrupted call goes on where it stopped. Writes
DIR/trials.json and prints its table. Exit: 0 all seeded ones were caught and nothing else, 1 not so, 2 bad
usage or nothing was measured. Standard library only."""
import argparse
import dataclasses
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

import benchmark_json
import callgrind
import counting
import judgement
import seeded
import timing
import workloads

HERE = pathlib.Path(__file__).resolve().parent
PAIRS_OF_CALIBRATION = 60
TRIAL_OF_DELAY = 0.4  # of a step: the slope is found where the noise matters least


@dataclasses.dataclass(frozen=True)
class Kind:
    says: str
    figures: tuple    # by which it counts as caught
    options: tuple = ()  # of compare.py


KINDS = {
    "count": Kind("2 % more instructions", ("instructions",), ("--no-times",)),
    "delay": Kind("5 % more time", ("step, median", "steps, CPU", "whole run, CPU")),
    "alloc": Kind("one allocation a step", ("allocations a step",), ("--no-times",)),
    "plain": Kind("unchanged", ()),
}


class Programs:
    """Copies of one program: the base, and what is compared with it. Their paths are of one length."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.base = seeded.variant(program, folder / "base", "plain")

    def new(self, kind, amount=0):
        return seeded.variant(self.program, self.folder / "next", kind, amount)


def amount_of_instructions(programs, workload, wanted=0.02, trial=100):
    def count(program):
        return counting.counts_of(str(program), workload, workloads.STEP).instructions

    base = count(programs.base)
    amount = round(trial * wanted / (count(programs.new("count", trial)) / base - 1))
    return amount, count(programs.new("count", amount)) / base


def ratio_of_steps(base, new, workload, pairs=PAIRS_OF_CALIBRATION):
    """Of the CPU time of steps, by so many pairs."""
    def step(program):
        return {"step": timing.run(str(program), workload.timed)[0]["steps, CPU"]}

    found = timing.Pairs()
    for i in range(pairs):
        first, second = (base, new) if i % 2 else (new, base)
        times = {first: step(first)}
        times[second] = step(second)
        found.add(times[base], times[new])
    return judgement.median_ratio(found.times["step"]).value


def amount_of_time(programs, workload, wanted=judgement.SLOWDOWN - 1):
    """By two steps: one to see the order, one where the noise is a small part of what is measured."""
    rough = 200
    slope = (ratio_of_steps(programs.base, programs.new("delay", rough), workload, 15) - 1) / rough
    trial = max(1, min(9999, round(TRIAL_OF_DELAY / slope)))
    slope = (ratio_of_steps(programs.base, programs.new("delay", trial), workload) - 1) / trial
    return round(wanted / slope)


def calibrate(programs, say):
    found = {}
    for workload in workloads.ALL:
        count, ratio = amount_of_instructions(programs, workload)
        delay = amount_of_time(programs, workload)
        found[workload.name] = {"count": count, "delay": delay, "alloc": 1}
        say(f"{workload.name}: {count}/16 turns a vertex for 2 % of instructions ({ratio:.4f}), "
            f"{delay}/16 divisions for 5 % of time")
    return found


def trial(programs, kind, workload, amount, folder):
    """One run of compare.py."""
    out = folder / "out"
    command = [sys.executable, str(HERE / "compare.py"), "--base", str(programs.base),
               "--new", str(programs.new(kind, amount)), "--out", str(out), *KINDS[kind].options]
    command += ["--filter", f"^{workload}$"] if workload else []
    load = os.getloadavg()[0]
    begin = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    seconds = time.monotonic() - begin
    if done.returncode not in (0, 1, 3):
        raise RuntimeError(f"compare.py ended with {done.returncode}: {done.stderr.strip()}")
    with open(out / "compare.json", encoding="utf-8") as stream:
        figures = json.load(stream)["figures"]

    def having(verdict):
        return [row["name"] for row in figures if row["verdict"] == verdict.value]

    return {"kind": kind, "workload": workload or "all", "amount": amount, "code": done.returncode,
            "seconds": seconds, "load": load, "slower": having(judgement.Verdict.SLOWER),
            "undecided": having(judgement.Verdict.UNDECIDED), "figures": figures}


def is_caught(row):
    return any(name.split("/")[1] in KINDS[row["kind"]].figures for name in row["slower"])


def beside(row):
    """Alarms of figures that were not made slower."""
    # More time in a step makes all times longer; instructions and allocations take some themselves.
    return [name for name in row["slower"] if name.split("/")[1] not in KINDS[row["kind"]].figures]


def table(rows):
    """{kind: what became of its runs}, in the order of KINDS."""
    found = {}
    for kind, of_kind in KINDS.items():
        some = [row for row in rows if row["kind"] == kind]
        if some:
            found[kind] = {
                "says": of_kind.says, "runs": len(some), "caught": sum(map(is_caught, some)),
                "false_alarms": sum(bool(beside(row)) for row in some),
                "undecided": sum(bool(row["undecided"]) and not row["slower"] for row in some),
                "seconds_median": statistics.median(row["seconds"] for row in some),
                "seconds_most": max(row["seconds"] for row in some),
                "load_median": statistics.median(row["load"] for row in some)}
    return found


def is_kept(found):
    return all(row["false_alarms"] == 0 and (kind == "plain" or row["caught"] == row["runs"])
               for kind, row in found.items())


def told(found):
    yield (f"{'what':22} {'runs':>4} {'caught':>6} {'false alarms':>12} {'undecided':>9} "
           f"{'seconds':>7} {'most':>5} {'load':>5}")
    for kind, row in found.items():
        caught = "-" if kind == "plain" else row["caught"]
        yield (f"{row['says']:22} {row['runs']:4} {caught:>6} {row['false_alarms']:12} "
               f"{row['undecided']:9} {row['seconds_median']:7.0f} {row['seconds_most']:5.0f} "
               f"{row['load_median']:5.1f}")


def plan(runs, unchanged):
    """(kind, number) of all trials, mixed, so that each kind meets all hours."""
    wanted = {kind: unchanged if kind == "plain" else runs for kind in KINDS}
    for i in range(max(wanted.values())):
        for kind, count in wanted.items():
            if i < count:
                yield kind, i


class Record:
    """What is known so far, in a file."""

    def __init__(self, path):
        self.path = path
        self.data = {"amounts": None, "trials": []}
        if path.exists():
            self.data = json.loads(path.read_text(encoding="utf-8"))

    def write(self):
        self.data["table"] = table(self.data["trials"])
        benchmark_json.replace(str(self.path), self.data)

    def add(self, row):
        self.data["trials"].append(row)
        self.write()

    def is_done(self, kind, number):
        return number < sum(row["kind"] == kind for row in self.data["trials"])


def parse_arguments(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", type=pathlib.Path,
                        default=seeded.PROJECT / "build/compare/seeded")
    parser.add_argument("--program", type=pathlib.Path, help="a build by seeded.py, in place of a new one")
    parser.add_argument("--runs", type=int, default=20, help="of each seeded slowdown")
    parser.add_argument("--unchanged", type=int, default=50, help="runs of unchanged code")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the build")
    arguments = parser.parse_args(argv)
    if min(arguments.runs, arguments.unchanged) < 0 or arguments.runs + arguments.unchanged == 0:
        parser.error("--runs and --unchanged: allowed: 0 and more, not both 0")
    return arguments


def main(argv):
    arguments = parse_arguments(argv)
    if not callgrind.is_installed():
        print("trials.py: valgrind is not installed (Debian: valgrind)", file=sys.stderr)
        return 2
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)

    def say(text):
        print(text, file=sys.stderr, flush=True)

    program = arguments.program or seeded.build(folder, arguments.jobs)
    programs = Programs(program, folder)
    record = Record(folder / "trials.json")
    if record.data["amounts"] is None:
        record.data["amounts"] = calibrate(programs, say)
        record.write()
    for kind, number in plan(arguments.runs, arguments.unchanged):
        if record.is_done(kind, number):
            continue
        workload = None if kind == "plain" else workloads.ALL[number % len(workloads.ALL)].name
        amount = record.data["amounts"][workload][kind] if workload else 0
        row = trial(programs, kind, workload, amount, folder)
        record.add(row)
        say(f"{kind} {number + 1} ({row['workload']}): {', '.join(row['slower']) or 'nothing'} slower, "
            f"{len(row['undecided'])} undecided, {row['seconds']:.0f} s, load {row['load']:.1f}")
    found = table(record.data["trials"])
    print("\n".join(told(found)))
    return 0 if is_kept(found) else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (callgrind.NotCounted, seeded.CannotSeed, RuntimeError, OSError, ValueError) as error:
        print(f"trials.py: {error}", file=sys.stderr)
        sys.exit(2)

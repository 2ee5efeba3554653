#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Many runs from one table, side by side, each once. bench/sweep.sh calls this."""
import argparse
import os
import sys
import time

import batch
import machine
import plain
import plan
import runs
import table as tables
import trees
import workflow
from errors import Interrupted, SweepError
from store import Store

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EPILOGUE = """Exit: 0 every run has a result, 1 some have failed or were not run, 2 nothing could be
run, 130 interrupted. sweep.sh list TABLE.toml shows the runs; sweep.sh collect DIR... makes the
report."""


def parse_arguments(argv):
    parser = argparse.ArgumentParser(prog="sweep.sh", description=__doc__, epilog=EPILOGUE)
    parser.add_argument("table", metavar="TABLE.toml")
    parser.add_argument("--out", metavar="DIR",
                        help="where the results are (default build/sweep/TABLE)")
    parser.add_argument("--jobs", type=int, metavar="N", default=machine.cores(),
                        help="cores of this machine, or jobs that a cluster has at a time")
    parser.add_argument("--profile", metavar="P",
                        help="of Snakemake: slurm, or the folder of your own")
    parser.add_argument("--plain", action="store_true", help="a plain loop in place of Snakemake")
    parser.add_argument("--batch", type=int, metavar="N", help="runs of one job of Snakemake")
    parser.add_argument("--retry-failed", action="store_true",
                        help="those that failed before as well")
    parser.add_argument("--no-build", action="store_true", help="with the programs as they are")
    options = parser.parse_args(argv)
    for name in ("jobs", "batch"):
        value = getattr(options, name)
        if value is not None and value < 1:
            parser.error(f"--{name}: got {value}; allowed: 1 and more")
    if options.plain and options.profile:
        parser.error("--plain is of this machine alone; allowed: --plain or --profile")
    return options


def say(text):
    print(f"== {text}", flush=True)


class Sweep:
    """A table, its runs and their results."""

    def __init__(self, path, out=None, of_any_machine=False):
        self.table = tables.read(path, ROOT)
        names = {name for row in self.table.rows for name in row.commits}
        self.trees = {name: trees.find(name, ROOT, self.table.native) for name in sorted(names)}
        self.runs = runs.expand(self.table, self.trees)
        folder = out or os.path.join(ROOT, "build", "sweep", self.table.name)
        self.store = Store(folder, machine.name(), of_any_machine)

    def build(self, due):
        """What the runs that are due need."""
        rows = {run.row for run in due}
        for name, tree in self.trees.items():
            mine = [row for row in self.table.rows if name in row.commits and row.name in rows
                    and any(run.commit == tree.label and run.row == row.name for run in due)]
            targets = {target for row in mine for target in row.targets}
            commands = list(dict.fromkeys(row.prepare for row in mine if row.prepare))
            if mine:
                trees.prepare(tree, ROOT, targets, [list(words) for words in commands], say)

    def outcomes(self):
        """(runs with a result, runs that failed, runs that have neither)"""
        done = [run for run in self.runs if self.store.is_done(run)]
        failed = [run for run in self.runs if self.store.has_failed(run)]
        known = {run.key for run in done + failed}
        return done, failed, [run for run in self.runs if run.key not in known]


def print_failures(failed, store):
    for run in failed:
        record = store.failure(run)
        print(f"\nfailed: {record['what']}\n  {record['problem']}\n  {record['again']}")
        words = record["last_words"]["stderr"] or record["last_words"]["stdout"]
        for line in words[-5:]:
            print(f"  | {line}")


def run_all(options):
    if options.profile:
        workflow.need_program()
    sweep = Sweep(options.table, options.out, bool(options.profile))
    due = plan.due(sweep.runs, sweep.store, options.retry_failed)
    before = len(sweep.outcomes()[0])
    with_engine = not options.plain and (bool(options.profile) or workflow.program() is not None)
    where = f"by the profile {options.profile}" if options.profile else \
        f"on {options.jobs} cores of {sweep.store.machine}, " + (
            "by Snakemake" if with_engine else "in a plain loop")
    say(f"{len(sweep.runs)} runs in {sweep.table.name}, {len(due)} due, {where}")
    stop = batch.stop_on_signals()
    began, words = time.monotonic(), []
    if due:
        if not options.no_build:
            sweep.build(due)
        began = time.monotonic()
        chunks = plan.chunks(due, options.jobs, options.batch)
        if with_engine:
            code, words = workflow.call(chunks, sweep.store, options.jobs, options.retry_failed,
                                        options.profile, stop.is_set)
            words = words if code != 0 else []
        else:
            plain.loop(chunks, sweep.store, options.jobs, options.retry_failed, stop.is_set,
                       lambda outcome, run: print(f"{outcome}  {run.what}", flush=True))
    done, failed, missing = sweep.outcomes()
    print_failures(failed, sweep.store)
    if missing:
        print(f"\nnot run: {len(missing)}, the first is {missing[0].what}")
        print("\n".join(f"  | {line}" for line in words))
    say(f"{len(done)} done ({before} of them before), {len(failed)} failed, "
        f"{len(missing)} not run; {time.monotonic() - began:.1f} s; results in "
        f"{sweep.store.folder}")
    if failed and not options.retry_failed:
        print("What has failed is run again with --retry-failed.")
    return 1 if failed or missing else 0


def list_runs(argv):
    parser = argparse.ArgumentParser(prog="sweep.sh list", description="The runs of a table.")
    parser.add_argument("table", metavar="TABLE.toml")
    parser.add_argument("--out", metavar="DIR", help="where the results are")
    options = parser.parse_args(argv)
    sweep = Sweep(options.table, options.out)
    for run in sweep.runs:
        state = "done" if sweep.store.is_done(run) else \
            "failed" if sweep.store.has_failed(run) else "due"
        print(f"{state:6}  {run.key}  {run.commit}  {run.what}")
    return 0


def collect_results(argv):
    import collect  # only this needs matplotlib
    return collect.main(argv)


def main(argv):
    try:
        commands = {"list": list_runs, "collect": collect_results}
        if argv and argv[0] in commands:
            return commands[argv[0]](argv[1:])
        return run_all(parse_arguments(argv))
    except SweepError as error:
        print(f"sweep.sh: {error}", file=sys.stderr)
        return 2
    except Interrupted:
        print("sweep.sh: interrupted; the same command goes on from what is there", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

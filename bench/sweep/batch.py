#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""batch.py PLAN NUMBER: the runs of one job, one after the other; those that have a result are
skipped.

A run that fails is recorded and the others go on. Exit: 0 all have been tried, 1 it was stopped."""
import json
import signal
import sys
import threading

import execute
import machine
import runs
from errors import Interrupted
from store import Store


def stop_on_signals():
    """An event that is set by the first signal to end; a second Ctrl-C ends this at once. Further
    signals of the other kind do not: one comes for each thread of a Snakemake that has been
    killed."""
    stop = threading.Event()

    def on_signal(number, _):
        stop.set()
        if number == signal.SIGINT:
            signal.signal(number, signal.SIG_DFL)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, on_signal)
    return stop


def main():
    path, number = sys.argv[1:]
    with open(path, encoding="utf-8") as stream:
        plan = json.load(stream)
    stop = stop_on_signals()
    store = Store(plan["folder"], plan["machine"] or machine.name(), plan["of_any_machine"])
    for data in plan["chunks"][int(number)]["runs"]:
        run = runs.from_json(data)
        try:
            outcome = execute.run_once(run, store, stop.is_set, plan["again"])
        except Interrupted:
            return 1
        if outcome != "skipped":
            print(f"{outcome}  {run.what}", flush=True)
        if stop.is_set():
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

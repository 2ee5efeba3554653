#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the tests on each seeded fault, until one of them catches it.

The copy of the project with the switches and its build are in DIR/source and DIR/build; verify/faults.sh
makes both. Results are kept in DIR/faults.json as they come, so that a run that was interrupted goes
on where it stopped; faults that nothing has caught are tried again. DIR/faults.md is the table."""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import zlib

import catalogue
import programs
import table

SLOWER = 2          # a test that takes this many times its CPU time, and...
SPARE_S = 10        # ...this long besides, does not end
MEMORY = 6 << 30    # bytes
LONGEST_PAUSE_S = 0.5
RACES = ("race", "shared state")
TRIES_OF_RACES = 3  # not each run of a test shows one


def call(program, fault, cpu_s, wall_s=None):
    """(how it ended, which test, CPU seconds, output); it ends by passing or failing, it crashes, or
    it does not end."""
    environment = {**os.environ, "OMP_WAIT_POLICY": "passive", **dict(program.environment)}
    environment.pop("DSC_FAULT", None)
    if fault is not None and fault.is_cpp:
        environment["DSC_FAULT"] = fault.name
    limits = ["prlimit", f"--cpu={cpu_s}:{cpu_s + 5}", f"--as={MEMORY}", "--core=0"]
    with tempfile.TemporaryFile("w+", errors="replace") as stream:
        process = subprocess.Popen([*limits, *program.command], cwd=program.folder, env=environment,
                                   stdin=subprocess.DEVNULL, stdout=stream,
                                   stderr=subprocess.STDOUT, process_group=0)
        code, spent, timed_out = wait(process, wall_s or 60 + 10 * cpu_s)
        stream.seek(0)
        output = stream.read()
    if code == 0:
        return "passed", "", spent, output
    if timed_out or code == -signal.SIGXCPU:
        return "did not end", last_test(output), spent, output
    if code < 0:
        return "crashed", last_test(output), spent, output
    return "failed", failed_test(output), spent, output


def wait(process, wall_s):
    """(exit code, CPU seconds, whether it was stopped) of one child, with all of its own. Time in which
    this process stood still counts as a moment, for then the child may have stood still as well."""
    last, waited, timed_out = time.monotonic(), 0.0, False
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid != 0:
            process.returncode = os.waitstatus_to_exitcode(status)
            return process.returncode, usage.ru_utime + usage.ru_stime, timed_out
        now = time.monotonic()
        waited, last = waited + min(now - last, LONGEST_PAUSE_S), now
        if not timed_out and waited > wall_s:
            timed_out = True
            os.killpg(process.pid, signal.SIGKILL)
        time.sleep(0.01)


def failed_test(output):
    found = re.search(r"\[  FAILED  \] ([\w/.]+)", output) or \
        re.search(r"^(?:FAIL|ERROR): (\w+ \([\w.]+\))", output, re.M) or \
        re.search(r"^(\w+ +[\w-]+) .*\bFAIL", output, re.M)
    return found.group(1) if found else ""


def last_test(output):
    found = re.findall(r"\[ RUN      \] ([\w/.]+)", output)
    return found[-1] if found else ""


class NotSound(Exception):
    """A test fails without a fault."""


class Runner:
    def __init__(self, folder):
        self.folder = folder
        self.source = folder / "source"
        self.build = folder / "build"
        self.results = folder / "faults.json"
        self.data = {"baseline": {}, "faults": {}}
        self.lock = threading.RLock()
        if self.results.exists():
            self.data = json.loads(self.results.read_text())

    def save(self):
        with self.lock:
            self.write()

    def write(self):
        part = self.results.with_suffix(".part")
        part.write_text(json.dumps(self.data, indent=1) + "\n")
        part.replace(self.results)

    def program(self, name):
        return programs.program(name, self.source, self.build)

    def usual(self, name):
        """CPU seconds of a program without a fault, measured when it is first asked for. It has to
        pass then."""
        with self.lock:
            if name not in self.data["baseline"]:
                ended, test, cpu, output = call(self.program(name), None, 1800)
                if ended != "passed":
                    raise NotSound(f"without a fault {name} {ended}: {test}\n{output[-3000:]}")
                self.data["baseline"][name] = round(cpu, 2)
                print(f"without a fault {name} passed: {cpu:.1f} s", flush=True)
                self.save()
            return self.data["baseline"][name]

    def try_fault(self, fault, own):
        """One entry of the results: by the tests of its room, or by all others."""
        before = self.data["faults"].get(fault.name, {}) if not own else {}
        slow, spent = before.get("slow", []), before.get("cpu_s", 0.0)
        for name in programs.for_fault(fault, own) * (TRIES_OF_RACES if fault.kind in RACES else 1):
            usual = self.usual(name)
            ended, test, cpu, _ = call(self.program(name), fault, int(SLOWER * usual + SPARE_S))
            spent += cpu
            # Time is no test of faults that cost nothing but time.
            if ended == "did not end" and fault.kind == "cost":
                slow.append(name)
            elif ended != "passed":
                return {"caught_by": name, "how": ended, "test": test, "cpu_s": round(spent, 1),
                        "own": own, "slow": slow}
        return {"caught_by": None, "cpu_s": round(spent, 1), "slow": slow, "all_tried": not own}

    def try_in_place(self, fault, own):
        """The same for a file that is not C++: its text is replaced while the tests run."""
        path = self.source / fault.file
        text = path.read_text(encoding="utf-8")
        place = catalogue.place_of(fault, text)
        for name in programs.for_fault(fault, own):
            self.usual(name)  # without the fault, that is before it is there
        path.write_text(text[:place] + fault.in_place() + text[place + len(fault.sought):],
                        encoding="utf-8")
        try:
            return self.try_fault(fault, own)
        finally:
            path.write_text(text, encoding="utf-8")

    def try_all(self, faults, own, jobs):
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            running = {pool.submit(self.try_fault, fault, own): fault
                       for fault in faults if fault.is_cpp}
            for done in concurrent.futures.as_completed(running):
                self.note(running[done], done.result())
        for fault in faults:
            if not fault.is_cpp:
                self.note(fault, self.try_in_place(fault, own))

    def note(self, fault, entry):
        self.data["faults"][fault.name] = {"room": fault.room, "kind": fault.kind,
                                           "says": fault.says, "digest": fault.digest, **entry}
        self.save()
        caught = entry["caught_by"]
        print(f"{fault.name}: " + (f"{caught}, {entry['how']}, {entry['test']}" if caught else
                                   "caught by " + ("nothing" if entry["all_tried"] else "no test of its room")) + f" ({entry['cpu_s']} s)", flush=True)


def chosen(faults, arguments):
    if arguments.only:
        known = {fault.name for fault in faults}
        for name in arguments.only:
            if name not in known:
                sys.exit(f"run.py: no fault is named '{name}'")
        return [fault for fault in faults if fault.name in arguments.only]
    if arguments.room is not None:
        mine = [fault for fault in faults if fault.room == arguments.room]
        return mine or sys.exit(f"run.py: no fault is of a room '{arguments.room}'")
    if arguments.tenth is not None:
        rooms = tenths(faults)[zlib.crc32(arguments.tenth.encode()) % 10]
        return [fault for fault in faults if fault.room in rooms]
    return faults


def tenths(faults):
    """Ten sets of rooms with about as many faults each: whole rooms, since few test programs have to be
    built for these."""
    counts = collections.Counter(fault.room for fault in faults)
    sets = [set() for _ in range(10)]
    for room in sorted(counts, key=lambda room: (-counts[room], room)):
        min(sets, key=lambda some: sum(counts[one] for one in some)).add(room)
    return sets


def is_due(fault, entry):
    """Whether nothing has caught it yet, or what was caught was another fault of that name."""
    return entry is None or entry["caught_by"] is None or \
        entry.get("digest", fault.digest) != fault.digest


def names_for(arguments):
    """The tests that are tried on the chosen faults; None: all that there are."""
    if arguments.all_tests or arguments.baseline:
        return None
    return [name for fault in chosen(catalogue.read_table(), arguments)
            for name in programs.own(fault)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="DIR")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="these faults, tried anew")
    parser.add_argument("--tenth", metavar="HASH",
                        help="the rooms that belong to a commit, with about a tenth of the faults")
    parser.add_argument("--room", metavar="NAME", help="the faults of one room")
    parser.add_argument("--own", dest="all_tests", action="store_false",
                        help="the tests of each fault's room alone")
    parser.add_argument("--jobs", type=int, default=1, help="faults at the same time")
    parser.add_argument("--baseline", action="store_true", help="measured anew")
    parser.add_argument("--targets", action="store_true",
                        help="say what has to be built for them, and run nothing")
    arguments = parser.parse_args()
    if arguments.targets:
        print(*programs.targets(names_for(arguments)), sep="\n")
        return
    runner = Runner(arguments.folder.resolve())
    if arguments.baseline:
        runner.data["baseline"] = {}
        for name in programs.all_names():
            runner.usual(name)
    faults = chosen(catalogue.read_table(), arguments)
    known = runner.data["faults"]
    due = [fault for fault in faults if arguments.only or is_due(fault, known.get(fault.name))]
    for own in (True, False):
        if own or arguments.all_tests:
            runner.try_all(due, own, arguments.jobs)
            due = [fault for fault in due if known[fault.name]["caught_by"] is None]
    names = {fault.name for fault in faults}
    entries = {name: entry for name, entry in runner.data["faults"].items() if name in names}
    (runner.folder / "faults.md").write_text(table.markdown(entries), encoding="utf-8")
    print(table.summary(entries))
    sys.exit(0 if all(entry["caught_by"] for entry in entries.values()) else 1)


if __name__ == "__main__":
    try:
        main()
    except NotSound as error:
        sys.exit(str(error))

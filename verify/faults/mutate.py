#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the tests on a sample of mutants of lib/dsc (mutants.py), each by the programs that reach it.

DIR/source is the copy with the switches and DIR/build its build, which verify/faults.sh has made: sources
get the switches of mutants in place of those of faults, and headers stay, so that little is compiled. A first
pass without a mutant notes which switches each program comes by; a mutant that none does survives
without a run. Results are kept in DIR/mutants.json as they come; DIR/mutants.md is the score by room and
the list of survivors."""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys
import threading
import zlib

import catalogue
import mutants
import overlay
import programs
import run

# Long, and nearly all of what they reach is reached by others.
LEFT_OUT = {"figures", "gate", "hashes", *programs.PYTHON}
WRONG = re.compile(r"source/(lib/dsc/[\w/]+\.cpp):(\d+)(?::\d+)?: error")


def targets():
    return [name for name in programs.targets() if name.startswith("test_")
            and name.removeprefix("test_") not in LEFT_OUT]


def write_copy(root, folder, sample):
    """The sources with the switches of the sample, and the headers with those of the faults."""
    instead = {"lib/fault/mutant.h": (root / "verify/faults/mutant.h.in").read_text("utf-8")}
    for file in sorted({mutant.file for mutant in sample}):
        mine = [mutant for mutant in sample if mutant.file == file]
        instead[file] = mutants.with_switches((root / file).read_text("utf-8"), mine)
    in_headers = [fault for fault in catalogue.read_table() if fault.file.endswith(".h")]
    overlay.make(root, folder / "source", in_headers, instead)


def build(root, folder, sample, jobs):
    """The sample without those that do not compile."""
    for _ in range(8):
        write_copy(root, folder, sample)
        done = subprocess.run(["cmake", "--build", folder / "build", "--parallel", str(jobs),
                               "--target", *targets()], capture_output=True, text=True)
        if done.returncode == 0:
            return sample
        wrong = {(file, int(line) - 1) for file, line in WRONG.findall(done.stdout + done.stderr)}
        fewer = [mutant for mutant in sample if (mutant.file, mutant.line) not in wrong]
        if len(fewer) == len(sample):
            sys.exit(done.stdout[-4000:] + done.stderr[-2000:])
        print(f"{len(sample) - len(fewer)} mutants do not compile and are dropped", flush=True)
        sample = fewer
    sys.exit("the mutants do not compile")


class Runner:
    def __init__(self, folder, sample):
        self.folder, self.sample, self.lock = folder, sample, threading.Lock()
        self.results = folder / "mutants.json"
        self.data = {"baseline": {}, "reached": {}, "mutants": {}}

    def program(self, name, **environment):
        one = programs.program(name, self.folder / "source", self.folder / "build")
        return programs.Program(one.name, one.command, one.folder, tuple(environment.items()))

    def reach(self):
        """Which switches each program comes by, and how long it takes."""
        for name in (target.removeprefix("test_") for target in targets()):
            note = self.folder / f"reached.{name}"
            note.unlink(missing_ok=True)
            ended, test, cpu, _ = run.call(self.program(name, DSC_REACHED=str(note)), None, 1800)
            if ended != "passed":
                sys.exit(f"without a mutant {name} {ended}: {test}")
            self.data["baseline"][name] = round(cpu, 2)
            numbers = note.read_text().split() if note.exists() else []
            self.data["reached"][name] = sorted({int(number) for number in numbers})
            print(f"{name}: {cpu:.1f} s, reaches {len(self.data['reached'][name])}", flush=True)

    def try_mutant(self, mutant):
        names = [name for name, numbers in self.data["reached"].items()
                 if mutant.number in numbers]
        own = programs.OWN.get(mutant.room, [])
        names.sort(key=lambda name: (name not in own, self.data["baseline"][name]))
        for name in names:
            usual = self.data["baseline"][name]
            ended, test, _, _ = run.call(
                self.program(name, DSC_MUTANT=str(mutant.number)), None,
                int(run.SLOWER * usual + run.SPARE_S))
            if ended != "passed":
                return {"killed_by": name, "how": ended, "test": test}
        return {"killed_by": None, "reached_by": names}

    def note(self, mutant, entry):
        with self.lock:
            self.data["mutants"][mutant.number] = {
                "file": mutant.file, "line": mutant.line, "room": mutant.room, "rule": mutant.rule,
                "original": mutant.original, "changed": mutant.changed, **entry}
            self.results.write_text(json.dumps(self.data, indent=1) + "\n")
        print(f"{mutant.file}:{mutant.line}: {mutant.rule}: {entry['killed_by'] or 'SURVIVES'}",
              flush=True)


def markdown(entries):
    """The score by room, and the survivors."""
    rooms = collections.defaultdict(lambda: [0, 0])
    for entry in entries:
        rooms[entry["room"]][0] += 1
        rooms[entry["room"]][1] += entry["killed_by"] is not None
    rooms["all"] = [len(entries), sum(killed for _, killed in rooms.values())]
    lines = ["| room | mutants | killed | score |", "| --- | --- | --- | --- |"]
    lines += [f"| {room} | {count} | {killed} | {100 * killed / max(count, 1):.0f} % |"
              for room, (count, killed) in rooms.items()]
    lines += ["", "| survivor | rule | original | changed | reached by |",
              "| --- | --- | --- | --- | --- |"]
    for entry in entries:
        if entry["killed_by"] is None:
            cells = [f"{entry['file']}:{entry['line']}", entry["rule"], f"`{entry['original']}`",
                     f"`{entry['changed']}`", ", ".join(entry["reached_by"]) or "nothing"]
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="DIR")
    parser.add_argument("--count", type=int, default=200, help="size of the sample")
    parser.add_argument("--seed", default="1", help="of the sample, e.g. a commit's hash")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at the same time")
    arguments = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parents[2]
    folder = arguments.folder.resolve()
    total, sample = mutants.sample(root, arguments.count, zlib.crc32(arguments.seed.encode()))
    print(f"{len(sample)} of {total} mutants", flush=True)
    sample = build(root, folder, sample, arguments.jobs)
    runner = Runner(folder, sample)
    runner.reach()
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        running = {pool.submit(runner.try_mutant, mutant): mutant for mutant in sample}
        for done in concurrent.futures.as_completed(running):
            runner.note(running[done], done.result())
    entries = list(runner.data["mutants"].values())
    (folder / "mutants.md").write_text(markdown(entries), encoding="utf-8")
    print(markdown(entries))


if __name__ == "__main__":
    main()

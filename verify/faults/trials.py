# SPDX-License-Identifier: MIT
"""Runs tests on mutants: those that come by a mutant, cheap ones first, until one of them fails.

A first pass without a mutant notes which mutants each test comes by (reach.cpp.in) and how long it
takes; a mutant that none does survives without a run. A program is run again for that only where it has
changed since."""
import concurrent.futures
import dataclasses
import hashlib
import json
import tempfile
import threading

import programs
import run

SLOWER = 3          # a run that takes this many times its usual CPU time, and...
SPARE_S = 3         # ...this long besides, does not end
WAITS = 12          # a run that waits for this many times as long does not end either
FIRST_S = 0.3       # usual time of the tests of the first round; each round has twice that of the last
# What is tried later than its time says: it notices nearly everything, and says nothing about what is
# wrong. What survived is tried by that first. And earlier, because it is there for that purpose.
BROAD, BROAD_AGAIN, OWN = 4.0, 0.25, 0.5


@dataclasses.dataclass(frozen=True)
class Test:
    program: str
    name: str
    seconds: float

    @property
    def full(self):
        return f"{self.program}: {self.name}"


def rounds_of(tests):
    """[[tests]]: cut where the time of a round is up, which doubles from one to the next."""
    rounds, spent, limit = [[]], 0.0, FIRST_S
    for test in tests:
        if rounds[-1] and spent + test.seconds > limit:
            rounds.append([])
            spent, limit = 0.0, 2 * limit
        rounds[-1].append(test)
        spent += test.seconds
    return rounds


class Runner:
    def __init__(self, folder, sample, numbers, tests, seconds):
        self.folder, self.sample, self.numbers, self.seconds = folder, sample, numbers, seconds
        self.names = [name.removeprefix("test_") for name in tests]
        self.results, self.lock = folder / "mutants.json", threading.Lock()
        self.data = {"reached": {}, "mutants": {}}
        if self.results.exists():
            self.data = json.loads(self.results.read_text())

    def save(self):
        part = self.results.with_suffix(".part")
        part.write_text(json.dumps(self.data, indent=1) + "\n")
        part.replace(self.results)

    def program(self, name, tests="*", **environment):
        command = (str(self.folder / f"build/verify/test_{name}"), "--gtest_fail_fast",
                   f"--gtest_filter={tests}")
        return programs.Program(name, command, self.folder / "build", tuple(environment.items()))

    def reach(self, jobs):
        """Which mutants each test comes by."""
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(self.reach_of, self.names))

    def reach_of(self, name):
        binary = (self.folder / f"build/verify/test_{name}").read_bytes()
        digest = hashlib.sha1(binary).hexdigest()
        if self.data["reached"].get(name, {}).get("digest") == digest:
            return
        note = self.folder / f"reached.{name}"
        ended, test, cpu, output = run.call(self.program(name, DSC_REACHED=str(note)), None, 3600)
        if ended != "passed":
            raise run.NotSound(f"without a mutant {name} {ended}: {test}\n{output[-3000:]}")
        keys = {self.numbers[mutant.key]: mutant.key for mutant in self.sample}
        shared, tests = {}, []
        for line in note.read_text().splitlines():
            test, seconds, numbers = line.split("\t")
            mine = {keys[int(number)] for number in numbers.split()}
            if test.endswith("*"):
                shared[test] = shared.get(test, set()) | mine
            else:
                by = mine | shared.get("*", set()) | shared.get(test.split(".")[0] + ".*", set())
                tests.append({"name": test, "seconds": float(seconds), "by": sorted(by)})
        note.unlink()
        with self.lock:
            self.data["reached"][name] = {"digest": digest, "tests": tests}
            self.save()
        count = len({key for test in tests for key in test["by"]})
        print(f"{name}: {cpu:.1f} s, comes by {count}", flush=True)

    def tests_by_mutant(self):
        """{key: tests that come by it}"""
        found = {}
        for name in self.names:
            for entry in self.data["reached"][name]["tests"]:
                test = Test(name, entry["name"], entry["seconds"])
                for key in entry["by"]:
                    found.setdefault(key, []).append(test)
        return found

    def try_mutant(self, mutant, tests, before):
        """An entry of the results."""
        own = programs.OWN.get(mutant.room, [])

        broad = BROAD_AGAIN if before else BROAD

        def order(test):
            weight = broad if test.program in programs.BROAD else OWN if test.program in own else 1.0
            return weight * test.seconds

        tried = set(before.get("tried", []))
        spent = before.get("cpu_s", 0.0)
        left = sorted((test for test in tests if test.full not in tried), key=order)
        used = 0.0
        for tests_of_round in rounds_of(left) if left else []:
            for name in dict.fromkeys(test.program for test in tests_of_round):
                if used > self.seconds:
                    return {"killed_by": None, "tried": sorted(tried), "left": len(tests) - len(tried),
                            "cpu_s": round(spent, 1)}
                mine = [test for test in tests_of_round if test.program == name]
                limit = int(SLOWER * sum(test.seconds for test in mine) + SPARE_S)
                # Tests of two mutants may write files of one name, and what crashes leaves them behind.
                with tempfile.TemporaryDirectory() as empty:
                    ended, test, cpu, _ = run.call(
                        self.program(name, ":".join(test.name for test in mine),
                                     DSC_MUTANT=str(self.numbers[mutant.key]), TMPDIR=empty,
                                     TEST_TMPDIR=empty),
                        None, limit, WAITS * limit)
                spent, used = spent + cpu, used + cpu
                if ended != "passed":
                    return {"killed_by": name, "how": ended, "test": test,
                            "own": name in own, "cpu_s": round(spent, 1)}
                tried |= {test.full for test in mine}
        return {"killed_by": None, "tried": sorted(tried), "left": 0, "cpu_s": round(spent, 1)}

    def is_due(self, mutant, equivalent, survivors):
        known = self.data["mutants"].get(mutant.key)
        return known is None or (survivors and known["killed_by"] is None
                                 and mutant.says not in equivalent)

    def try_all(self, equivalent, survivors, jobs):
        by = self.tests_by_mutant()
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            running = {}
            for mutant in self.sample:
                if self.is_due(mutant, equivalent, survivors):
                    before = self.data["mutants"].get(mutant.key, {})
                    running[pool.submit(self.try_mutant, mutant, by.get(mutant.key, []),
                                        before)] = mutant
            for done in concurrent.futures.as_completed(running):
                self.note(running[done], done.result())
        for mutant in self.sample:
            self.data["mutants"][mutant.key]["equivalent"] = equivalent.get(mutant.says)
        self.save()

    def summary(self):
        """What the report shows."""
        return {"mutants": {mutant.key: {key: self.data["mutants"][mutant.key][key]
                                         for key in ("file", "line", "room", "rule", "killed_by",
                                                     "equivalent")}
                            for mutant in self.sample}}

    def note(self, mutant, entry):
        with self.lock:
            self.data["mutants"][mutant.key] = {
                "file": mutant.file, "line": mutant.line, "room": mutant.room, "code": mutant.code,
                "rule": mutant.rule, "changed": mutant.changed, **entry}
            self.save()
        print(f"{mutant.file}:{mutant.line}: {mutant.rule}: "
              + (f"{entry['killed_by']}, {entry['how']}, {entry['test']}" if entry["killed_by"] else
                 f"SURVIVES, {entry['left']} of {entry['left'] + len(entry['tried'])} not tried")
              + f" ({entry['cpu_s']} s)", flush=True)

    def entries(self):
        return [self.data["mutants"][mutant.key] for mutant in self.sample]

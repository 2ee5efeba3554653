#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutants of the library: small changes that nobody has thought of, made by rule, a sample of which is
put into a copy of the project with a switch each (R. H. Untch, A. J. Offutt, M. J. Harrold, "Mutation
analysis using mutant schemata", 1993); and the tests that come by each, cheap ones first, until one
of them fails.

A rule changes one token of a condition, of a value that is returned or of one that is kept, or leaves
out a call. Only what stands in one line is changed, so that no parser is needed; a mutant that does
not compile is dropped. Calls that only make room in advance are no candidates, for without them
nothing but time is different.

Results are kept in DIR/mutants.json as they come: a run that was interrupted goes on where it stopped.
DIR/mutants.md is the score by room and the list of survivors, DIR/score.json what the report shows. Exit:
0 at least as many were caught as LEAST asks, 1 fewer."""
import argparse
import collections
import concurrent.futures
import dataclasses
import hashlib
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tomllib

import faults

LEAST = 0.9     # of those that are not equivalent
SLOWER, SPARE_S = 3, 3  # what takes so many times its CPU time, and so long besides, does not end
FIRST_S = 0.3   # usual time of the tests of the first round; each round has twice that of the last
# What notices nearly everything is tried later than its time says, and what is there for it earlier.
BROAD, OWN = 4.0, 0.5
INCLUDE = '#include "fault/switch.h"\n'
CONDITION = re.compile(r"^(\s*(?:\} else )?(?:if|while) \()(.+)(\) \{)$")
LOOP = re.compile(r"^(\s*for \([^;]*; )([^;]+)(; [^;]*\) \{)$")
VALUE = re.compile(r"^(\s*return )([^{};]+)(;)$")
KEPT = re.compile(r"^(\s*(?:const )?(?:bool|double|Real|int|std::u?int\d+_t|std::size_t|Corner|auto) "
                  r"\w+ = )([^{};]+)(;)$")
CALL = re.compile(r"^(\s*)((?!return|throw|delete|using|static|const|auto|case|template)"
                  r"[A-Za-z_][\w.:>\-\[\]]*\([^{}]*\);)$")
ONLY_ROOM = re.compile(r"(?:\.|->)(?:reserve|shrink_to_fit)\(")
# A token between blanks, and what takes its place.
TOKENS = ((" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "),
          (" != ", " == "), (" && ", " || "), (" || ", " && "), (" + ", " - "), (" - ", " + "),
          (" * ", " + "))
NUMBER = re.compile(r"(?<![\w.])(\d+)(?![\w.])")
# The core, whose rooms are its folders, and the modules, each a room.
CORE, MODULES = "dsc", ("fluid", "geometric_flows", "thesis", "topology")


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str
    line: int       # from 1
    code: str       # the line without its indentation
    rule: str
    original: str
    changed: str
    occurrence: int  # of those of its file that say the same, from 0

    @property
    def room(self):
        library, room = self.file.split("/")[1:3]
        return room if library == CORE else library

    @property
    def key(self):
        """The same for as long as the line is, wherever it moves to in its file."""
        words = "\n".join((self.file, self.code, self.original, self.changed, str(self.occurrence)))
        return hashlib.sha1(words.encode()).hexdigest()[:12]

    @property
    def switch(self):
        return f'::dsc::fault::on("{self.key}")'

    @property
    def place(self):
        """Of its number among those that a run has come by."""
        number = 2166136261
        for byte in self.key.encode():
            number = ((number ^ byte) * 16777619) % (1 << 32)
        return number % (1 << 18)

    @property
    def says(self):
        """What an entry of the list of equivalent mutants has to name."""
        return self.file, self.code, self.changed


def changes_of(expression):
    """(rule, changed expression) for each token."""
    for token, other in TOKENS:
        at = expression.find(token)
        while at >= 0:
            rule = f"{token.strip()} to {other.strip()}"
            yield rule, expression[:at] + other + expression[at + len(token):]
            at = expression.find(token, at + 1)
    for found in NUMBER.finditer(expression):
        yield "number one more", (expression[:found.start()] + str(int(found.group()) + 1)
                                  + expression[found.end():])


def changes_in(line):
    """(rule, original, changed) for each mutant of a line."""
    if "constexpr" in line or "template" in line or line.count("(") != line.count(")"):
        return
    matched = CONDITION.match(line) or LOOP.match(line)
    if matched:
        yield "condition negated", matched.group(2), f"!({matched.group(2)})"
    matched = matched or VALUE.match(line) or KEPT.match(line)
    if matched:
        for rule, changed in changes_of(matched.group(2)):
            yield rule, matched.group(2), changed
    elif (found := CALL.match(line)) and not ONLY_ROOM.search(line):
        yield "call left out", found.group(2), ""


def candidates_in(file, text):
    """All mutants of a file."""
    seen = collections.Counter()
    for index, line in enumerate(text.split("\n"), 1):
        for rule, original, changed in changes_in(line):
            same = (line.strip(), original, changed)
            yield Mutant(file, index, line.strip(), rule, original, changed, seen[same])
            seen[same] += 1


def candidates():
    """All mutants of the core and of the modules."""
    found = []
    for library in (CORE, *MODULES):
        for path in sorted((faults.ROOT / "lib" / library).rglob("*.*")):
            if path.suffix in (".h", ".cpp"):
                found += candidates_in(path.relative_to(faults.ROOT).as_posix(),
                                       path.read_text(encoding="utf-8"))
    return found


def sample(found, count, seed):
    """So many of them, each room by its share. A change of the sources leaves the sample of other lines
    as it is."""
    drawn = sorted(found, key=lambda mutant: hashlib.sha1((seed + mutant.key).encode()).digest())
    return sorted(drawn[:count], key=lambda mutant: (mutant.file, mutant.line))


def with_switches(text, mutants):
    """The text of a file with the switches of its mutants; several of one line are tried in turn."""
    lines = text.split("\n")
    for line in sorted({mutant.line for mutant in mutants}):
        mine = [mutant for mutant in mutants if mutant.line == line]
        original = mine[0].original
        if mine[0].rule == "call left out":
            place = f"if (!{mine[0].switch}) {{ {original} }}"
        else:
            place = f"({original})"
            for mutant in mine:
                place = f"({mutant.switch} ? ({mutant.changed}) : {place})"
        at = lines[line - 1].rindex(original)
        lines[line - 1] = lines[line - 1][:at] + place + lines[line - 1][at + len(original):]
    return INCLUDE + "\n".join(lines)


def read_equivalent():
    """{what a mutant says: why nothing can tell it from the original}"""
    with open(pathlib.Path(__file__).parent / "equivalent.toml", "rb") as stream:
        return {(entry["file"], entry["code"], entry["changed"]): entry["why"]
                for entry in tomllib.load(stream)["mutant"]}


# --- the copy ---------------------------------------------------------------------------------------

# Names what one test program is made of; the copy's have the listener besides.
SOURCES = "add_executable(${name} ${arg_SOURCES} ${arg_APART}"
LISTENER = "lib/fault/reach.cpp"
LIBRARY = "|".join((CORE, *MODULES))
PLACE = re.compile(rf"source/(lib/(?:{LIBRARY})/[\w/]+\.(?:cpp|h)):(\d+)")
WRONG = re.compile(PLACE.pattern + r"(?::\d+)?: error")


def test_targets():
    """All test programs, but for the one whose cases take minutes each."""
    text = (faults.ROOT / "verify/CMakeLists.txt").read_text(encoding="utf-8")
    return [name for name in re.findall(r"^dsc_add_tests\((\w+)", text, re.M)
            if name != "test_hard_long"]


def write_copy(folder, mutants):
    tests = (faults.ROOT / "verify/CMakeLists.txt").read_text("utf-8")
    if SOURCES not in tests:
        sys.exit(f"mutants.py: verify/CMakeLists.txt has no line '{SOURCES}'")
    instead = {LISTENER: (faults.ROOT / "verify/faults/reach.cpp.in").read_text("utf-8"),
               "verify/CMakeLists.txt": tests.replace(
                   SOURCES, SOURCES + " ${PROJECT_SOURCE_DIR}/" + LISTENER)}
    for file in {mutant.file for mutant in mutants}:
        mine = [mutant for mutant in mutants if mutant.file == file]
        instead[file] = with_switches((faults.ROOT / file).read_text("utf-8"), mine)
    faults.write_copy(folder / "source", instead)


def without(mutants, output):
    """Those whose lines the compiler does not complain of."""
    # Where a template was asked for, if no line of an error is one of theirs.
    for places in (WRONG.findall(output), PLACE.findall(output)):
        wrong = {(file, int(line) - 1) for file, line in places}  # the include is the first line
        fewer = [mutant for mutant in mutants if (mutant.file, mutant.line) not in wrong]
        if len(fewer) < len(mutants):
            return fewer
    sys.exit("mutants.py: the copy does not compile:\n" + output[-6000:])


def build(folder, mutants, tests, jobs):
    """Those that compile, and the test programs."""
    write_copy(folder, mutants)
    # As CI runs them under the sanitizers: asserts, and checks of the standard library.
    faults.configure(folder, "-O1 -D_GLIBCXX_ASSERTIONS")
    make = ["cmake", "--build", folder / "build", "--parallel", str(jobs), "--target"]
    # First each file of the library alone, without generating code: quicker than to build.
    subprocess.run([*make, "lib/dsc/CMakeFiles/dsc.dir/cmake_pch.hxx.gch"], check=True,
                   stdout=subprocess.DEVNULL)
    entries = json.loads((folder / "build/compile_commands.json").read_text())
    commands = [(entry["directory"], [*shlex.split(entry["command"]), "-fsyntax-only"])
                for entry in entries if re.search(rf"/lib/(?:{LIBRARY})/CMakeFiles/", entry["command"])
                and "cmake_pch.hxx.gch" not in entry["command"].split(" -o ")[1]]

    def check(command):
        return subprocess.run(command[1], cwd=command[0], capture_output=True, text=True)

    while commands:
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            done = list(pool.map(check, commands))
        commands = [command for command, one in zip(commands, done) if one.returncode != 0]
        if commands:
            mutants = without(mutants, "\n".join(one.stderr for one in done if one.returncode != 0))
            write_copy(folder, mutants)
    while (done := subprocess.run([*make, *tests, "--", "-k", "0"], capture_output=True,
                                  text=True)).returncode != 0:
        mutants = without(mutants, done.stdout + done.stderr)
        write_copy(folder, mutants)
    return mutants


# --- the trials -------------------------------------------------------------------------------------


@dataclasses.dataclass(frozen=True)
class Test:
    program: str
    name: str
    seconds: float


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
    def __init__(self, folder, mutants, seconds):
        self.folder, self.mutants, self.seconds = folder, mutants, seconds
        self.store = faults.Store(folder / "mutants.json", mutants={})
        self.by = collections.defaultdict(list)  # {key: tests that come by it}

    def call(self, program, names, cpu_s, **variables):
        command = [self.folder / f"build/verify/test_{program}", "--gtest_fail_fast",
                   f"--gtest_filter={names}"]
        return faults.call(command, None, cpu_s, **variables)

    def reach(self, program):
        """Notes which mutants each test comes by, in a run without one."""
        path = self.folder / f"reached.{program}"
        ended, test, cpu, output = self.call(program, "*", 3600, DSC_REACHED=str(path))
        if ended != "passed":
            sys.exit(f"without a mutant {program} {ended}: {test}\n{output[-3000:]}")
        keys = {mutant.place: mutant.key for mutant in self.mutants}
        shared = collections.defaultdict(set)
        for line in path.read_text().splitlines():
            name, seconds, numbers = line.split("\t")
            mine = {keys[int(number)] for number in numbers.split() if int(number) in keys}
            if name.endswith("*"):
                shared[name] |= mine
                continue
            with self.store.lock:
                for key in mine | shared["*"] | shared[name.split(".")[0] + ".*"]:
                    self.by[key].append(Test(program, name, float(seconds)))
        print(f"{program}: {cpu:.1f} s", flush=True)

    def try_mutant(self, mutant):
        """An entry of the results."""
        own = faults.OWN.get(mutant.room, [])

        def order(test):
            weight = BROAD if test.program in faults.BROAD else OWN if test.program in own else 1.0
            return weight * test.seconds

        spent, left = 0.0, len(self.by[mutant.key])
        for tests in rounds_of(sorted(self.by[mutant.key], key=order)):
            for program in dict.fromkeys(test.program for test in tests):
                if spent > self.seconds:
                    break
                mine = [test for test in tests if test.program == program]
                limit = int(SLOWER * sum(test.seconds for test in mine) + SPARE_S)
                ended, test, cpu, _ = self.call(program, ":".join(test.name for test in mine), limit,
                                                DSC_FAULT=mutant.key)
                spent, left = spent + cpu, left - len(mine)
                if ended != "passed":
                    return {"killed_by": program, "how": ended, "test": test, "cpu_s": round(spent, 1)}
        return {"killed_by": None, "reached": bool(self.by[mutant.key]), "left": left,
                "cpu_s": round(spent, 1)}

    def try_all(self, equivalent, jobs):
        known = self.store.data["mutants"]
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            running = {pool.submit(self.try_mutant, mutant): mutant for mutant in self.mutants
                       if mutant.key not in known}
            for done in concurrent.futures.as_completed(running):
                mutant, entry = running[done], done.result()
                self.store.note("mutants", mutant.key, {
                    "file": mutant.file, "line": mutant.line, "room": mutant.room, "code": mutant.code,
                    "rule": mutant.rule, "changed": mutant.changed, **entry,
                    "equivalent": equivalent.get(mutant.says)})
                print(f"{mutant.file}:{mutant.line}: {mutant.rule}: {entry['killed_by'] or 'SURVIVES'} "
                      f"({entry['cpu_s']} s)", flush=True)
        return [known[mutant.key] for mutant in self.mutants]


def score(entries):
    """(caught, equivalent, survivors, share caught of those that are not equivalent)"""
    caught = sum(entry["killed_by"] is not None for entry in entries)
    equivalent = sum(entry["killed_by"] is None and entry["equivalent"] is not None for entry in entries)
    return caught, equivalent, len(entries) - caught - equivalent, caught / max(len(entries) - equivalent, 1)


def markdown(entries):
    lines = ["| room | mutants | caught | equivalent | survivors | score |",
             "| --- | --- | --- | --- | --- | --- |"]
    for room in [*sorted({entry["room"] for entry in entries}), "all"]:
        mine = [entry for entry in entries if room in (entry["room"], "all")]
        *counts, share = score(mine)
        lines.append(f"| {room} | {len(mine)} | {' | '.join(map(str, counts))} | {100 * share:.1f} % |")
    lines += ["", "| survivor | rule | line | changed | tests not tried |", "| --- | --- | --- | --- | --- |"]
    for entry in entries:
        if not entry["killed_by"] and not entry["equivalent"]:
            cells = [f"{entry['file']}:{entry['line']}", entry["rule"], f"`{entry['code']}`",
                     f"`{entry['changed']}`", str(entry["left"]) if entry["reached"] else "none reaches it"]
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="DIR")
    parser.add_argument("--count", type=int, default=1000, help="size of the sample")
    parser.add_argument("--seed", default="1", help="of the sample, e.g. a commit's hash")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at the same time")
    parser.add_argument("--seconds", type=float, default=60,
                        help="CPU seconds of tests that a mutant has to survive (%(default)s)")
    parser.add_argument("--programs", nargs="+", metavar="TEST", default=test_targets(),
                        help="test programs to build and run, e.g. test_io; by default all")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    if unknown := set(arguments.programs) - set(test_targets()):
        parser.error(f"--programs: got {', '.join(unknown)}; allowed: {', '.join(test_targets())}")
    mutants = build(folder, sample(candidates(), arguments.count, arguments.seed), arguments.programs,
                    arguments.jobs)
    print(f"{len(mutants)} compile", flush=True)
    runner = Runner(folder, mutants, arguments.seconds)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(runner.reach, (name.removeprefix("test_") for name in arguments.programs)))
    entries = runner.try_all(read_equivalent(), arguments.jobs)
    (folder / "score.json").write_text(json.dumps({"mutants": dict(enumerate(entries))}) + "\n")
    (folder / "mutants.md").write_text(markdown(entries), encoding="utf-8")
    print(markdown(entries).split("\n\n")[0])
    sys.exit(0 if score(entries)[-1] >= LEAST else 1)


if __name__ == "__main__":
    main()

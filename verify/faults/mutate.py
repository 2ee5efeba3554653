#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mutate.py DIR: runs the tests on a sample of the mutants of the library (mutants.py), each by the tests
that come by it.

DIR/source is a copy of the sources with the switches, DIR/build its build. Results are kept in
DIR/mutants.json as they come, so that a run that was interrupted goes on where it stopped, and one with
new tests tries these alone on what survived (--survivors). DIR/mutants.md is the score by room and the
list of survivors, DIR/score.json what the report shows of it. Exit: 0 at least as many were caught
as LEAST asks, 1 fewer."""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shlex
import subprocess
import sys

import mutants
import overlay
import programs
import score
import trials

LEAST = 0.9     # of those that are not equivalent
# Names what one test program is made of; the copy's have the listener besides.
SOURCES = "add_executable(${name} ${arg_SOURCES} ${arg_APART}"
LISTENER = "lib/fault/reach.cpp"
LIBRARY = "|".join((mutants.CORE, *mutants.MODULES))
PLACE = re.compile(rf"source/(lib/(?:{LIBRARY})/[\w/]+\.(?:cpp|h)):(\d+)")
WRONG = re.compile(PLACE.pattern + r"(?::\d+)?: error")


def write(path, text):
    """Beside its place, then renamed."""
    part = path.with_name(path.name + ".part")
    part.write_text(text, encoding="utf-8")
    part.replace(path)


def numbers_of(folder, sample):
    """{key: number of its switch}, the same as in the last run, so that no more is compiled again than
    has changed."""
    path = folder / "numbers.json"
    known = json.loads(path.read_text()) if path.exists() else {}
    free = max(known.values(), default=0) + 1
    for mutant in sample:
        if mutant.key not in known:
            known[mutant.key] = free
            free += 1
    write(path, json.dumps(known) + "\n")
    return known


def write_copy(root, folder, sample, numbers):
    here = root / "verify/faults"
    tests = (root / "verify/CMakeLists.txt").read_text("utf-8")
    if SOURCES not in tests:
        sys.exit(f"mutate.py: verify/CMakeLists.txt has no line '{SOURCES}'")
    instead = {"lib/fault/mutant.h": (here / "mutant.h.in").read_text("utf-8"),
               LISTENER: (here / "reach.cpp.in").read_text("utf-8"),
               "verify/CMakeLists.txt": tests.replace(
                   SOURCES, SOURCES + " ${PROJECT_SOURCE_DIR}/" + LISTENER)}
    for file in sorted({mutant.file for mutant in sample}):
        mine = [(numbers[mutant.key], mutant) for mutant in sample if mutant.file == file]
        instead[file] = mutants.with_switches((root / file).read_text("utf-8"), mine)
    overlay.make(root, folder / "source", [], instead)


def without(sample, output):
    """The sample without those whose lines the compiler complains of."""
    errors = WRONG.findall(output)
    for places in (errors, PLACE.findall(output)):  # the latter: where a template was asked for
        wrong = {(file, int(line) - 1) for file, line in places}  # the include is the first line
        fewer = [mutant for mutant in sample if (mutant.file, mutant.line) not in wrong]
        if len(fewer) < len(sample):
            return fewer
    sys.exit("mutate.py: the copy does not compile:\n" + output[-6000:])


def library_commands(build):
    """How each file of the library is compiled; without generating code."""
    entries = json.loads((build / "compile_commands.json").read_text())
    return [(entry["directory"], [*shlex.split(entry["command"]), "-fsyntax-only"])
            for entry in entries if re.search(rf"/lib/(?:{LIBRARY})/CMakeFiles/", entry["command"])
            and "cmake_pch.hxx.gch" not in entry["command"].split(" -o ")[1]]


def check(command):
    folder, words = command
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    return None if done.returncode == 0 else done.stderr


def compilable(root, folder, sample, numbers, jobs):
    """Leaves out those that do not compile: file by file, which is quicker than to build."""
    commands = library_commands(folder / "build")
    while commands:
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            complaints = list(pool.map(check, commands))
        commands = [command for command, words in zip(commands, complaints) if words is not None]
        if commands:
            fewer = without(sample, "\n".join(words for words in complaints if words is not None))
            print(f"{len(sample) - len(fewer)} mutants do not compile", flush=True)
            sample = fewer
            write_copy(root, folder, sample, numbers)
    return sample


def build(root, folder, sample, numbers, tests, jobs):
    """The sample without those that do not compile, and its test programs."""
    known = folder / "compile.json"
    dropped = set(json.loads(known.read_text())) if known.exists() else None
    asked = [mutant.key for mutant in sample]
    if dropped is not None:
        sample = [mutant for mutant in sample if mutant.key not in dropped]
    write_copy(root, folder, sample, numbers)
    # As CI runs them under the sanitizers: asserts, and checks of the standard library.
    configure = ["cmake", "-S", folder / "source", "-B", folder / "build", "-G", "Ninja",
                 "-D", "CMAKE_BUILD_TYPE=Release",
                 "-D", "CMAKE_CXX_FLAGS_RELEASE=-O1 -D_GLIBCXX_ASSERTIONS",
                 "-D", "DSC_PRECOMPILE=ON", "-D", "DSC_UNITY=ON", "-D", "DSC_BUILD_HARNESS=ON",
                 "-D", f"DSC_PYTHON={sys.executable}"]
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    make = ["cmake", "--build", folder / "build", "--parallel", str(jobs), "--target"]
    if dropped is None:
        subprocess.run([*make, "lib/dsc/CMakeFiles/dsc.dir/cmake_pch.hxx.gch"], check=True,
                       stdout=subprocess.DEVNULL)
        sample = compilable(root, folder, sample, numbers, jobs)
    while True:
        done = subprocess.run([*make, *tests, "--", "-k", "0"],
                              capture_output=True, text=True)
        if done.returncode == 0:
            break
        sample = without(sample, done.stdout + done.stderr)
        write_copy(root, folder, sample, numbers)
    dropped = (dropped or set()) | (set(asked) - {mutant.key for mutant in sample})
    write(known, json.dumps(sorted(dropped)) + "\n")
    return sample


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="DIR")
    parser.add_argument("--count", type=int, default=1000, help="size of the sample")
    parser.add_argument("--seed", default="1", help="of the sample, e.g. a commit's hash")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at the same time")
    parser.add_argument("--seconds", type=float, default=60,
                        help="CPU seconds of tests that a mutant has to survive (%(default)s)")
    parser.add_argument("--programs", nargs="+", metavar="TEST",
                        help="test programs to build and run, e.g. test_io; by default all")
    parser.add_argument("--survivors", action="store_true",
                        help="what survived is tried by the tests that were not tried on it yet")
    arguments = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parents[2]
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    found = mutants.candidates(root)
    sample = mutants.sample(found, arguments.count, arguments.seed)
    print(f"{len(sample)} of {len(found)} mutants", flush=True)
    numbers = numbers_of(folder, sample)
    tests = programs.test_targets(root)
    for name in arguments.programs or []:
        if name not in tests:
            parser.error(f"--programs: got {name}; allowed: {', '.join(tests)}")
    tests = arguments.programs or tests
    sample = build(root, folder, sample, numbers, tests, arguments.jobs)
    print(f"{len(sample)} compile", flush=True)
    runner = trials.Runner(folder, sample, numbers, tests, arguments.seconds)
    runner.reach(arguments.jobs)
    runner.try_all(mutants.read_equivalent(), arguments.survivors, arguments.jobs)
    entries = runner.entries()
    write(folder / "score.json", json.dumps(runner.summary(), indent=1) + "\n")
    write(folder / "mutants.md", score.markdown(entries, len(found)))
    print(score.summary(entries))
    sys.exit(0 if score.share(entries) >= LEAST else 1)


if __name__ == "__main__":
    main()

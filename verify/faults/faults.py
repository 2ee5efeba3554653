#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Do the tests notice what is wrong? Builds a copy of the project that holds all seeded faults, each with a
switch, and runs the tests on each of them until one catches it.

The folder `table` has a file for each room, and an entry for each fault:

    [[fault]]
    name = "flip-ignores-interface"         # unique
    says = "What is wrong, in one sentence."
    kind = "missing guard"                  # one of KINDS
    file = "lib/dsc/operations/edge_flip.h"
    form = "expression"                     # or "statement", or "text"
    original = "if («a < b») {"             # occurs once in the file, without the marks
    faulty = "a <= b"                       # what takes the place of the part between the marks
    also = ["hashes"]                       # optional: tests of other rooms that are there for it too

The part of `original` between « and », or all of it, is what the fault replaces; the rest makes it
unique. An expression becomes `(FAULT ? (faulty) : (original))`, a statement
`if (FAULT) {faulty} else {original}`; the form `text` puts `faulty` in its place as it is, with FAULT
where the switch is asked. Files that are not C++ are replaced as a whole while their fault is on.

Results are kept in DIR/faults.json as they come: a run that was interrupted goes on where it stopped, and
faults that nothing has caught are tried again."""
import argparse
import collections
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import tomllib
import zlib

KINDS = ("wrong algebra", "missing guard", "off by one", "dropped hand-over", "stale neighbour",
         "attribute not carried", "integrator", "insertion", "clean-up left out", "race", "shared state",
         "limit", "flattering measure", "writer", "cost", "plot", "topology", "reference")
OPENED, CLOSED = "«", "»"
ROOT = pathlib.Path(__file__).resolve().parents[2]
COPIED = ("CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "LICENSE", ".clang-format",
          "lib", "reference", "verify", "bench", "plots")
HEADER = "lib/fault/switch.h"

# The tests of a room: what they catch is caught on purpose. Test programs have one name each in
# verify/CMakeLists.txt.
OWN = {
    "base": ["base"],
    "geometry": ["geometry"],
    "complex": ["complex", "operations", "fuzz"],
    "queries": ["complex"],
    "quality": ["quality"],
    "operations": ["operations", "reference"],
    "initial": ["initial"],
    "motion": ["motion", "algorithm", "velocities"],
    "sizes": ["sizes", "graded"],
    "passes": ["passes", "warm_steps", "sizes"],
    "algorithm": ["algorithm", "passes"],
    "parallel": ["parallel"],
    "topology": ["topology", "wall_films"],
    "fluid": ["fluid", "fluid_figures"],
    "geometric_flows": ["velocities", "algorithm"],
    "thesis": ["thesis", "copies", "operations", "fuzz", "reference"],
    "io": ["io", "checkpoints"],
    "measures": ["measures"],
    "flows": ["flows"],
    "scenes": ["scenes", "scene_files", "scene_runs", "checkpoints", "scene_output_cli"],
    "reference": ["reference"],
    "gate": ["judge", "gate_cli"],
    "plots": ["plots"],
}
# Cheap ones first. The hashes notice nearly everything and say nothing about what is wrong, so they
# are asked last of all tests.
OTHERS = ["base", "quality", "motion", "passes", "complex", "operations", "thesis", "algorithm", "initial",
          "fluid", "fluid_figures",
          "sizes", "io", "measures", "geometry", "recipes", "scene_files", "scene_runs",
          "topology", "wall_films", "fuzz", "hard", "reference", "scenes", "parallel", "copies", "velocities",
          "checkpoints", "figures", "hashes", "gate"]
BROAD = {"hashes", "gate", "hard", "figures"}  # written to notice no fault in particular
# Some suites of a test program, by a name of their own.
SUITES = {
    "graded": ("figures", "Sizes/GradedMesh.*"),
    "flows": ("figures", "Velocity.*:SineCosine.*:FlowMap.*:Exact.*:TwoDiscs.*:ErodedDumbbell.*"),
    "scene_runs": ("figures", "RunScene.*:SceneFileExact.*:Describe.*:Catalogue/Described.*"),
}
QUICK_GATE = ["area_ratio", "symmetric_difference", "symmetric_difference_half", "inverted",
              "unreached", "min_quality"]
# The modules of a unittest, where they run, and the programs that they call.
PYTHON = {
    "gate_cli": ("verify/scenes", ["gate_cli_test"], ["dsc_scene", "dsc_verify", "dsc_hard"]),
    "scene_output_cli": ("verify/scenes", ["scene_output_cli_test"], ["dsc_scene"]),
    "plots": ("plots", ["tests.test_plots", "tests.test_parallel", "tests.test_precision",
                        "tests.test_page"], []),
}
SLOWER, SPARE_S = 2, 10  # what takes so many times its CPU time, and so long besides, does not end
MEMORY = 6 << 30         # bytes
TRIES_OF_RACES = 3       # not each run of a test shows one


@dataclasses.dataclass(frozen=True)
class Fault:
    room: str
    name: str
    says: str
    kind: str
    file: str
    form: str
    original: str
    faulty: str
    also: tuple = ()

    @property
    def is_cpp(self):
        return self.file.endswith((".h", ".cpp"))

    @property
    def digest(self):
        """Another one where the entry has been changed."""
        return zlib.crc32("\n".join((self.file, self.form, self.original, self.faulty)).encode())

    @property
    def sought(self):
        return self.original.replace(OPENED, "").replace(CLOSED, "")

    def place_in(self, text):
        if text.count(self.sought) != 1:
            raise ValueError(f"{self.room}, {self.name}: original occurs {text.count(self.sought)} times "
                             f"in {self.file}")
        return text.index(self.sought)

    @property
    def replacement(self):
        """The text that takes the place of `sought`, in C++ with the switch in it."""
        before, rest = self.original.split(OPENED) if OPENED in self.original else ("", self.original)
        right, after = rest.split(CLOSED) if CLOSED in rest else (rest, "")
        switch = f'::dsc::fault::on("{self.name}")'
        if not self.is_cpp:
            middle = self.faulty
        elif self.form == "expression":
            middle = f"({switch} ? ({self.faulty}) : ({right}))"
        elif self.form == "statement":
            middle = f"if ({switch}) {{ {self.faulty} }} else {{ {right} }}"
        else:
            middle = self.faulty.replace("FAULT", switch)
        return before + middle + after


def read_table():
    """All faults, room by room."""
    faults = []
    for path in sorted((pathlib.Path(__file__).parent / "table").glob("*.toml")):
        with open(path, "rb") as stream:
            faults += [Fault(path.stem, **entry) for entry in tomllib.load(stream)["fault"]]
    return faults


# --- the copy ---------------------------------------------------------------------------------------


def files_of(folder):
    """All files of the project, relative to its folder."""
    for name in COPIED:
        path = folder / name
        files = path.rglob("*") if path.is_dir() else [path]
        yield from (file.relative_to(folder) for file in files
                    if file.is_file() and "__pycache__" not in file.parts)


def with_switches(text, faults):
    """The text of a C++ file with the switches of its faults; throws where two of them overlap."""
    result, end = '#include "fault/switch.h"\n', 0
    for place, fault in sorted(((fault.place_in(text), fault) for fault in faults),
                               key=lambda pair: pair[0]):
        if place < end:
            raise ValueError(f"{fault.name} overlaps with the fault before it in {fault.file}")
        result += text[end:place] + fault.replacement
        end = place + len(fault.sought)
    return result + text[end:]


def texts_with(faults):
    """{file: text with switches}"""
    by_file = collections.defaultdict(list)
    for fault in faults:
        if fault.is_cpp:
            by_file[fault.file].append(fault)
    return {file: with_switches((ROOT / file).read_text(encoding="utf-8"), mine)
            for file, mine in by_file.items()}


def write_copy(target, instead):
    """Brings the copy up to date; files of `instead` have that text there. What is the same is not
    written, so that no more is compiled again than has changed."""
    texts = {str(file): (ROOT / file).read_bytes() for file in files_of(ROOT)}
    texts |= {file: text.encode() for file, text in instead.items()}
    texts[HEADER] = (ROOT / "verify/faults/switch.h.in").read_bytes()
    for file, text in texts.items():
        path = target / file
        if not path.exists() or path.read_bytes() != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)
    for file in [file for file in files_of(target) if str(file) not in texts]:
        (target / file).unlink()


def configure(folder, flags):
    subprocess.run(["cmake", "-S", folder / "source", "-B", folder / "build", "-G", "Ninja",
                    "-D", "CMAKE_BUILD_TYPE=Release", "-D", f"CMAKE_CXX_FLAGS_RELEASE={flags}",
                    "-D", "DSC_PRECOMPILE=ON", "-D", "DSC_UNITY=ON", "-D", "DSC_BUILD_HARNESS=ON",
                    "-D", f"DSC_PYTHON={sys.executable}"], check=True, stdout=subprocess.DEVNULL)


# --- the tests --------------------------------------------------------------------------------------


def all_tests():
    return list(dict.fromkeys([name for own in OWN.values() for name in own] + OTHERS))


def targets(tests):
    """What has to be built for these tests."""
    found = []
    for name in tests:
        found += PYTHON[name][2] if name in PYTHON else \
            ["dsc_verify"] if name == "gate" else [f"test_{SUITES.get(name, (name,))[0]}"]
    return list(dict.fromkeys(found))


def command_of(name, folder):
    """(command, folder to run in)"""
    build, source = folder / "build", folder / "source"
    if name in PYTHON:
        room, modules, _ = PYTHON[name]
        return [sys.executable, "-m", "unittest", "--failfast", "--verbose", *modules], source / room
    if name == "gate":
        return [build / "verify/dsc_verify", "run", *QUICK_GATE, "--out", "gate"], None
    test, suites = SUITES.get(name, (name, "*"))
    return [build / f"verify/test_{test}", "--gtest_fail_fast", f"--gtest_filter={suites}"], None


def call(command, folder, cpu_s, **variables):
    """(how it ended, which test, CPU seconds, output): it passes or fails, crashes, or does not end. In an
    empty folder unless one is given: tests may write files of one name."""
    with tempfile.TemporaryDirectory() as empty, tempfile.TemporaryFile("w+", errors="replace") as stream:
        environment = {**os.environ, "OMP_WAIT_POLICY": "passive", "PYTHONDONTWRITEBYTECODE": "1",
                       "MPLBACKEND": "Agg", "TMPDIR": empty, "TEST_TMPDIR": empty, **variables}
        process = subprocess.Popen(
            ["prlimit", f"--cpu={cpu_s}:{cpu_s + 5}", f"--as={MEMORY}", "--core=0",
             "timeout", "--signal=KILL", str(60 + 10 * cpu_s), *command],
            cwd=folder or empty, env=environment, stdin=subprocess.DEVNULL, stdout=stream,
            stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        code = process.returncode = os.waitstatus_to_exitcode(status)
        stream.seek(0)
        output = stream.read()
    spent = usage.ru_utime + usage.ru_stime
    began = (re.findall(r"\[ RUN      \] ([\w/.]+)", output) or [""])[-1]
    if code == 0:
        return "passed", "", spent, output
    if code in (-9, -24, 137, 152):  # killed, or out of CPU time
        return "did not end", began, spent, output
    if code < 0 or code > 128:
        return "crashed", began, spent, output
    failed = re.search(r"\[  FAILED  \] ([\w/.]+)", output) or \
        re.search(r"^(?:FAIL|ERROR): (\w+ \([\w.]+\))", output, re.M) or \
        re.search(r"^(\w+ +[\w-]+) .*\bFAIL", output, re.M)
    return "failed", failed.group(1) if failed else "", spent, output


class Store:
    """What is known so far, in a file."""

    def __init__(self, path, **empty):
        self.path, self.lock = path, threading.RLock()
        self.data = json.loads(path.read_text()) if path.exists() else empty

    def note(self, kind, name, entry):
        with self.lock:
            self.data[kind][name] = entry
            part = self.path.with_suffix(".part")
            part.write_text(json.dumps(self.data, indent=1) + "\n")
            part.replace(self.path)


class Runner:
    def __init__(self, folder):
        self.folder = folder
        self.store = Store(folder / "faults.json", baseline={}, faults={})

    def usual(self, name):
        """CPU seconds without a fault; the tests have to pass then."""
        with self.store.lock:
            known = self.store.data["baseline"]
            if name not in known:
                ended, test, cpu, output = call(*command_of(name, self.folder), 1800,
                                                DSC_BUILD=str(self.folder / "build"))
                if ended != "passed":
                    sys.exit(f"without a fault {name} {ended}: {test}\n{output[-3000:]}")
                self.store.note("baseline", name, round(cpu, 2))
            return known[name]

    def try_fault(self, fault, tests):
        """An entry of the results."""
        spent = 0.0
        for name in tests * (TRIES_OF_RACES if fault.kind in ("race", "shared state") else 1):
            limit = int(SLOWER * self.usual(name) + SPARE_S)
            chosen = {"DSC_FAULT": fault.name} if fault.is_cpp else {}
            ended, test, cpu, _ = call(*command_of(name, self.folder), limit, DSC_BUILD=str(self.folder / "build"), **chosen)
            spent += cpu
            # Time is no test of faults that cost nothing but time.
            if ended != "passed" and (ended, fault.kind) != ("did not end", "cost"):
                return {"caught_by": name, "how": ended, "test": test, "cpu_s": round(spent, 1),
                        "own": name in OWN[fault.room] or name in fault.also}
        return {"caught_by": None, "cpu_s": round(spent, 1)}

    def try_in_place(self, fault, tests):
        """The same for a file that is not C++: its text is replaced while the tests run."""
        for name in tests:
            self.usual(name)
        path = self.folder / "source" / fault.file
        text = path.read_text(encoding="utf-8")
        place = fault.place_in(text)
        path.write_text(text[:place] + fault.replacement + text[place + len(fault.sought):],
                        encoding="utf-8")
        try:
            return self.try_fault(fault, tests)
        finally:
            path.write_text(text, encoding="utf-8")

    def try_all(self, faults, tests_of, jobs):
        """Returns those that nothing caught."""
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            running = {pool.submit(self.try_fault, fault, tests_of(fault)): fault
                       for fault in faults if fault.is_cpp}
            for done in concurrent.futures.as_completed(running):
                self.note(running[done], done.result())
        for fault in faults:
            if not fault.is_cpp:
                self.note(fault, self.try_in_place(fault, tests_of(fault)))
        known = self.store.data["faults"]
        return [fault for fault in faults if known[fault.name]["caught_by"] is None]

    def note(self, fault, entry):
        self.store.note("faults", fault.name, {"room": fault.room, "kind": fault.kind, "says": fault.says,
                                               "digest": fault.digest, **entry})
        caught = entry["caught_by"]
        print(f"{fault.name}: " + (f"{caught}, {entry['how']}, {entry['test']}" if caught else "NOT CAUGHT")
              + f" ({entry['cpu_s']} s)", flush=True)


# --- the choice of faults ---------------------------------------------------------------------------


def tenths(faults):
    """Ten sets of rooms with about as many faults each: whole rooms, since few test programs have to be
    built for these."""
    counts = collections.Counter(fault.room for fault in faults)
    sets = [set() for _ in range(10)]
    for room in sorted(counts, key=lambda room: (-counts[room], room)):
        min(sets, key=lambda some: sum(counts[one] for one in some)).add(room)
    return sets


def chosen(faults, arguments):
    known = {name for fault in faults for name in (fault.name, fault.room)}
    for name in [*(arguments.only or []), *([arguments.room] if arguments.room else [])]:
        if name not in known:
            sys.exit(f"faults.py: no fault and no room is named '{name}'")
    rooms = {arguments.room} if arguments.room else \
        tenths(faults)[zlib.crc32(arguments.tenth.encode()) % 10] if arguments.tenth else None
    return [fault for fault in faults if (fault.name in arguments.only if arguments.only else
                                          rooms is None or fault.room in rooms)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="DIR")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="these faults, tried anew")
    parser.add_argument("--tenth", metavar="HASH",
                        help="the rooms that belong to a commit, with about a tenth of the faults")
    parser.add_argument("--room", metavar="NAME", help="the faults of one room")
    parser.add_argument("--own", action="store_true", help="the tests of each fault's room alone")
    parser.add_argument("--jobs", type=int, default=1, help="faults at the same time")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    all_faults = read_table()
    faults = chosen(all_faults, arguments)
    tests = [name for fault in faults for name in (*OWN[fault.room], *fault.also)]
    write_copy(folder / "source", texts_with(all_faults))
    # Nearly as quick to build as without optimisation, and the tests take a third of the time.
    configure(folder, "-O1 -DNDEBUG")
    if subprocess.run(["cmake", "--build", folder / "build", "--parallel", str(arguments.jobs), "--target",
                       *targets(tests if arguments.own else all_tests()), "--", "--quiet"]).returncode != 0:
        sys.exit(2)
    runner = Runner(folder)
    known = runner.store.data["faults"]
    due = [fault for fault in faults if arguments.only or fault.name not in known
           or known[fault.name]["caught_by"] is None or known[fault.name]["digest"] != fault.digest]
    due = runner.try_all(due, lambda fault: [*OWN[fault.room], *fault.also], arguments.jobs)
    if not arguments.own:
        due = runner.try_all(due, lambda fault: [name for name in OTHERS if name not in OWN[fault.room]],
                             arguments.jobs)
    entries = [known[fault.name] for fault in faults]
    counts = collections.Counter("nothing" if not entry["caught_by"] else "their own room" if entry["own"]
                                 else "a broad test" if entry["caught_by"] in BROAD else "another test"
                                 for entry in entries)
    print(f"{len(entries)} faults, caught by: " + ", ".join(f"{by}, {n}" for by, n in counts.items()))
    sys.exit(0 if all(entry["caught_by"] for entry in entries) else 1)


if __name__ == "__main__":
    main()

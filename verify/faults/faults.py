#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutation testing: builds a copy of the project that contains faults, each with a switch, and runs the tests
on each fault until one fails.

The folder `table` has a file for each room, and an entry for each seeded fault:

    [[fault]]
    name = "flip-ignores-interface"         # unique
    says = "What is wrong, in one sentence."
    kind = "missing guard"
    file = "lib/dsc/operations/edge_flip.h"
    form = "statement"                      # or "text"; unless given, "expression"
    original = "if («a < b») {"             # occurs once in the file, without the marks
    faulty = "a <= b"                       # replaces the part between the marks
    also = ["test_hashes"]                  # optional: tests of other rooms that may catch it

The part of `original` between « and », or all of it, is what the fault replaces; the rest makes it
unique. An expression becomes `(FAULT ? (faulty) : (original))`, a statement
`if (FAULT) {faulty} else {original}`; the form `text` inserts `faulty` literally, with FAULT
where the switch is read. Files that are not C++ are replaced as a whole while their fault is on.

Mutants are generated faults: a rule changes one token of a condition or of a value, or leaves out a call
(R. H. Untch, A. J. Offutt, M. J. Harrold, "Mutation analysis using mutant schemata", 1993). A mutant changes a
single line, so no parser is needed, and is dropped if it does not compile. `equivalent.toml` lists mutants
that no test can distinguish from the original."""
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
import tomllib
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
COPIED = ("CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "LICENSE", ".clang-format",
          "lib", "reference", "verify", "bench", "plots")
MODULES = ("fluid", "geometric_flows", "replay", "thesis", "topology")  # mutated like the core
PLACE = re.compile(rf"source/(lib/(?:dsc|{'|'.join(MODULES)})/[\w/]+\.(?:cpp|h)):(\d+)")
LEAST = 0.9             # smallest fraction of mutants to be detected, without equivalent ones
TRIES_OF_RACES = 3      # a race may not appear in every run
LIMITS = ["prlimit", "--cpu=300", f"--as={6 << 30}", "--core=0"]  # of each test; beyond, it "did not end"

# The tests of each room, which must catch its faults: beginnings of CTest's names.
OWN = {
    "base": ["test_base"], "geometry": ["test_geometry"], "queries": ["test_complex"],
    "complex": ["test_complex", "test_operations", "test_fuzz"], "quality": ["test_quality"],
    "operations": ["test_operations", "test_reference"], "initial": ["test_initial"],
    "motion": ["test_motion", "test_algorithm", "test_velocities"],
    "sizes": ["test_sizes", "test_figures.Sizes/GradedMesh"],
    "passes": ["test_passes", "test_warm_steps", "test_sizes"], "algorithm": ["test_algorithm", "test_passes"],
    "parallel": ["test_parallel"], "topology": ["test_topology", "test_boundary_films"],
    "dsc3": ["test_dsc3", "test_enright"], "fluid": ["test_fluid"], "geometric_flows": ["test_velocities", "test_algorithm"],
    "thesis": ["test_thesis", "test_copies", "test_operations", "test_fuzz", "test_reference"],
    "io": ["test_io", "test_checkpoints"], "measures": ["test_measures"],
    "flows": ["test_figures.(Velocity|SineCosine|FlowMap|Exact|TwoDiscs|ErodedDumbbell)"],
    "scenes": ["test_scenes", "test_scene_files", "test_checkpoints", "scene_output_cli_test",
               "test_figures.(RunScene|SceneFileExact|Describe|Catalogue/Described)"],
    "reference": ["test_reference"], "gate": ["test_judge", "gate_cli_test"], "plots": ["plots_test"],
}
# Tests that run next, and exceptions: all short ones, and finally the hashes, which notice nearly everything
# but do not say what is wrong.
OTHERS = [(["test_.*"], "^test_(hashes|figures|hard)"), (["test_figures", "test_hard"], ""),
          (["test_hashes"], "")]


@dataclasses.dataclass(frozen=True)
class Fault:
    room: str
    name: str
    kind: str
    file: str
    original: str
    faulty: str
    form: str = "expression"
    says: str = ""
    also: tuple = ()
    line: int = 0  # of a mutant, from 1

    @property
    def is_cpp(self):
        return self.file.endswith((".h", ".cpp"))

    @property
    def sought(self):
        return self.original.replace("«", "").replace("»", "")

    def place_in(self, text):
        """The position of the replaced text; for a mutant, within its line."""
        if self.line:
            start = sum(len(line) + 1 for line in text.split("\n")[:self.line - 1])
            return text.index(self.sought, start)
        if text.count(self.sought) != 1:
            sys.exit(f"{self.name}: original occurs {text.count(self.sought)} times in {self.file}")
        return text.index(self.sought)

    @property
    def replacement(self):
        """The text that takes the place of `sought`, in C++ with the switch in it."""
        before, rest = self.original.split("«") if "«" in self.original else ("", self.original)
        right, after = rest.split("»") if "»" in rest else (rest, "")
        switch = f'::dsc::fault::on("{self.name}")'
        middle = self.faulty.replace("FAULT", switch) if self.is_cpp else self.faulty
        if self.is_cpp and self.form == "expression":
            middle = f"({switch} ? ({self.faulty}) : ({right}))"
        elif self.is_cpp and self.form == "statement":
            middle = f"if ({switch}) {{ {self.faulty} }} else {{ {right} }}"
        return before + middle + after

    def applied_to(self, text):
        place = self.place_in(text)
        return text[:place] + self.replacement + text[place + len(self.sought):]


def read_toml(path):
    with open(path, "rb") as stream:
        return tomllib.load(stream)


def read_table():
    """All seeded faults, room by room."""
    return [Fault(path.stem, **entry) for path in sorted((ROOT / "verify/faults/table").glob("*.toml"))
            for entry in read_toml(path)["fault"]]


# --- mutants ----------------------------------------------------------------------------------------

TYPES = r"(?:const )?(?:bool|double|Real|int|std::u?int\d+_t|std::size_t|Corner|auto)"
VALUES = [re.compile(pattern) for pattern in (
    r"^\s*(?:\} else )?(?:if|while) \((.+)\) \{$", r"^\s*for \([^;]*; ([^;]+); [^;]*\) \{$",
    r"^\s*return ([^{};]+);$", rf"^\s*{TYPES} \w+ = ([^{{}};]+);$")]
CALL = re.compile(r"^\s*((?!return|throw|delete|using|static|const|auto|case|template)"
                  r"[A-Za-z_][\w.:>\-\[\]]*\([^{}]*\);)$")
TOKENS = (("<", "<="), ("<=", "<"), (">", ">="), (">=", ">"), ("==", "!="), ("!=", "=="), ("&&", "||"),
          ("||", "&&"), ("+", "-"), ("-", "+"), ("*", "+"))


def changes_in(line):
    """(form, original, changed) for each mutant of a line."""
    if re.search(r"constexpr|template|(?:\.|->)(?:reserve|shrink_to_fit)\(", line) or \
            line.count("(") != line.count(")"):
        return
    if not (found := next(filter(None, (pattern.match(line) for pattern in VALUES)), None)):
        if found := CALL.match(line):
            yield "statement", found[1], ""
        return
    if line.endswith("{"):
        yield "expression", found[1], f"!({found[1]})"
    for token, other in TOKENS:
        for at in re.finditer(f" {re.escape(token)} ", found[1]):
            yield "expression", found[1], f"{found[1][:at.start()]} {other} {found[1][at.end():]}"
    for at in re.finditer(r"(?<![\w.])\d+(?![\w.])", found[1]):
        yield "expression", found[1], found[1][:at.start()] + str(int(at[0]) + 1) + found[1][at.end():]


def all_mutants():
    """{(file, line without its indentation, changed): mutants}"""
    found = collections.defaultdict(list)
    for module in ("dsc", *MODULES):
        for path in sorted((ROOT / "lib" / module).rglob("*.*")):
            if path.suffix in (".h", ".cpp"):
                file = path.relative_to(ROOT).as_posix()
                room = file.split("/")[2] if module == "dsc" else module
                for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
                    for form, original, changed in changes_in(line):
                        says = file, line.strip(), changed
                        name = f"{zlib.crc32(repr((says, len(found[says]))).encode()):08x}"
                        found[says].append(Fault(room, name, "mutant", file, original, changed, form,
                                                 f"{file}:{number}: {line.strip()} -> {changed}", line=number))
    return found


def equivalent_ones():
    return {(file, *mutant.split(" => ")) for file, reasons in
            read_toml(ROOT / "verify/faults/equivalent.toml").items() for mutant in reasons}


def sample_of_mutants(count):
    """A sample with at most one mutant of each line, without equivalent ones. A change of the sources does
    not change the sample of other lines."""
    equivalent = equivalent_ones()
    some = [one for says, ones in all_mutants().items() if says not in equivalent for one in ones]
    some.sort(key=lambda one: zlib.crc32(f"1{one.name}".encode()), reverse=True)
    return list({(one.file, one.line): one for one in some}.values())[-count:]


# --- the copy ---------------------------------------------------------------------------------------


def texts_with(faults):
    """{file: text with the switches of its faults}; ends the program where two of them overlap."""
    by_file = collections.defaultdict(list)
    for fault in filter(lambda fault: fault.is_cpp, faults):
        by_file[fault.file].append(fault)
    texts = {}
    for file, mine in by_file.items():
        text = (ROOT / file).read_text(encoding="utf-8")
        last = len(text)
        for place, fault in sorted(((fault.place_in(text), fault) for fault in mine),
                                   key=lambda pair: pair[0], reverse=True):
            if place + len(fault.sought) > last:
                sys.exit(f"{fault.name} overlaps with the fault behind it in {file}")
            text, last = fault.applied_to(text), place
        texts[file] = '#include "fault/switch.h"\n' + text
    return texts


def write_copy(folder, faults):
    """Updates the copy. Unchanged files are not written, so that only changes are compiled again."""
    files = [file for name in COPIED for file in ([ROOT / name] if (ROOT / name).is_file()
                                                  else (ROOT / name).rglob("*")) if file.is_file()]
    texts = {str(file.relative_to(ROOT)): file.read_bytes() for file in files
             if "__pycache__" not in file.parts}
    texts |= {file: text.encode() for file, text in texts_with(faults).items()}
    texts["lib/fault/switch.h"] = (ROOT / "verify/faults/switch.h.in").read_bytes()
    for file in [file for file in (folder / "source").rglob("*") if file.is_file()]:
        if str(file.relative_to(folder / "source")) not in texts:
            file.unlink()
    for file, text in texts.items():
        path = folder / "source" / file
        if not path.exists() or path.read_bytes() != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)


def build(folder, faults, targets, jobs):
    """Returns the faults without the mutants that do not compile. At -O1 the copy is nearly as quick to
    build as without optimisation, and the tests take a third of the time."""
    write_copy(folder, faults)
    subprocess.run(["cmake", "-S", folder / "source", "-B", folder / "build", "-G", "Ninja",
                    "-D", "CMAKE_BUILD_TYPE=Release", "-D", "CMAKE_CXX_FLAGS_RELEASE=-O1 -D_GLIBCXX_ASSERTIONS",
                    "-D", "DSC_PRECOMPILE=ON", "-D", "DSC_UNITY=ON", "-D", "DSC_BUILD_HARNESS=ON",
                    "-D", f"DSC_PYTHON={sys.executable}"], check=True, stdout=subprocess.DEVNULL)
    while (made := subprocess.run(["cmake", "--build", folder / "build", "--parallel", str(jobs), "--target",
                                   *targets, "--", "-k", "0"], capture_output=True, text=True)).returncode:
        # The include is the first line of the copied file.
        wrong = {(file, int(line) - 1) for file, line in PLACE.findall(made.stdout + made.stderr)}
        fewer = [fault for fault in faults if (fault.file, fault.line) not in wrong]
        if len(fewer) == len(faults):
            sys.exit(f"the copy does not compile:\n{made.stdout[-6000:]}{made.stderr}")
        faults = fewer
        write_copy(folder, faults)
    return faults


# --- the trials -------------------------------------------------------------------------------------


def first_failure(folder, tests, but="", name=""):
    """(test, how, CPU seconds) of the first failing test among those with these names in CTest, or of one of
    their suites; test and how are None if all pass."""
    with tempfile.TemporaryDirectory() as empty, tempfile.TemporaryFile("w+", errors="replace") as output:
        process = subprocess.Popen(
            [*LIMITS, "ctest", "--test-dir", folder / "build", "--stop-on-failure", "--no-tests=error",
             "-R", f"^({'|'.join(tests)})($|\\.)", "-LE", "^long$", *(["-E", but] if but else [])],
            env={**os.environ, "DSC_FAULT": name, "TMPDIR": empty, "TEST_TMPDIR": empty},
            stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    seconds = round(usage.ru_utime + usage.ru_stime, 1)
    if process.returncode == 0:
        return None, None, seconds
    if failed := re.search(r"^\s*\d+ - (\S+) \((.+)\)", text, re.M):
        return failed[1], failed[2], seconds
    sys.exit(f"CTest ran nothing of {tests}:\n{text[-3000:]}")


def try_fault(folder, fault, alone):
    """The entry of a fault in the report."""
    own = [*OWN.get(fault.room, []), *fault.also]
    name, spent = fault.name if fault.is_cpp else "", 0.0
    path = folder / "source" / fault.file
    if not fault.is_cpp:
        path.write_text(fault.applied_to(path.read_text(encoding="utf-8")), encoding="utf-8")
    tries = 0 if not own else TRIES_OF_RACES if fault.kind in ("race", "shared state") else 1
    test, how = None, None
    for tests, but in [(own, "")] * tries + ([] if alone else OTHERS):
        test, how, seconds = first_failure(folder, tests, but, name)
        spent += seconds
        if test:
            break
    if not fault.is_cpp:
        path.write_bytes((ROOT / fault.file).read_bytes())
    print(f"{fault.name}: {test or 'NOT CAUGHT'} ({spent:.1f} s) {fault.says}", flush=True)
    return {"room": fault.room, "kind": fault.kind, "says": fault.says, "caught_by": test,
            "how": how, "own": test is not None and tests is own, "cpu_s": round(spent, 1)}


def check():
    """Ends the program if table, rules and sources do not fit together."""
    table, mutants = read_table(), all_mutants()
    for fault in table:
        if not fault.is_cpp:
            fault.place_in((ROOT / fault.file).read_text(encoding="utf-8"))
    texts_with(table)
    built = set(re.findall(r"dsc_add_(?:python_)?tests?\((\w+)|^foreach\(cli ([\w ]+)\)",
                           (ROOT / "verify/CMakeLists.txt").read_text(encoding="utf-8"), re.M))
    built = {word for found in built for words in found for word in words.split()}
    named = {test.split(".")[0] for tests in [*OWN.values(), *(fault.also for fault in table)] for test in tests}
    wrong = [*(f"{one}: equivalent, and no longer there" for one in equivalent_ones() if one not in mutants),
             *(f"{name}: more than one fault" for name, n in
               collections.Counter(fault.name for fault in table).items() if n > 1),
             *(f"{fault.room}: a room without tests" for fault in table if fault.room not in OWN),
             *(f"{test}: no such test" for test in named - built)]
    sys.exit("\n".join(wrong) or None)


def chosen(arguments):
    if arguments.mutants:
        return sample_of_mutants(arguments.mutants)
    table = read_table()
    rooms = sorted(OWN)
    if arguments.tenth:
        rooms = rooms[zlib.crc32(arguments.tenth.encode()) % 10::10]
    faults = [fault for fault in table if fault.room in rooms
              and (not arguments.only or {fault.name, fault.room} & set(arguments.only))]
    if unknown := set(arguments.only or []) - {word for fault in table for word in (fault.name, fault.room)}:
        sys.exit(f"no fault and no room is named {', '.join(unknown)}")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=pathlib.Path, nargs="?", help="of the copy and its build")
    parser.add_argument("--check", action="store_true", help="only whether the table fits the sources")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="these faults, or rooms")
    parser.add_argument("--tenth", metavar="HASH", help="about a tenth of the rooms, those of a commit")
    parser.add_argument("--mutants", type=int, metavar="N", help="so many mutants in place of seeded faults")
    parser.add_argument("--own", action="store_true", help="the tests of each fault's own room alone")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="faults at the same time")
    arguments = parser.parse_args()
    if arguments.check:
        check()
    if not arguments.folder:
        parser.error("where is the copy to be?")
    folder, faults = arguments.folder.resolve(), chosen(arguments)
    own = {test for fault in faults for test in [*OWN.get(fault.room, []), *fault.also]}
    targets = ["dsc_tests_asan_all", "dsc_tests_optimised"]
    if arguments.own and all(test.startswith("test_") for test in own):
        targets = {test.split(".")[0] for test in own}
    faults = build(folder, faults, targets, arguments.jobs)
    if (broken := first_failure(folder, own))[0]:
        sys.exit(f"without a fault {broken[0]} fails")
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        found = dict(zip([fault.name for fault in faults if fault.is_cpp],
                         pool.map(lambda fault: try_fault(folder, fault, arguments.own),
                                  [fault for fault in faults if fault.is_cpp])))
    for fault in faults:
        if not fault.is_cpp:
            found[fault.name] = try_fault(folder, fault, arguments.own)
    kind = "mutants" if arguments.mutants else "faults"
    (folder / f"{kind}.json").write_text(json.dumps({kind: found}, indent=1) + "\n")
    for room in [*sorted({entry["room"] for entry in found.values()}), None]:
        mine = [entry["caught_by"] is not None for entry in found.values() if room in (entry["room"], None)]
        print(f"{room or 'all'}: {sum(mine)} of {len(mine)} {kind} caught")
    sys.exit(sum(mine) < (LEAST if arguments.mutants else 1) * len(mine))


if __name__ == "__main__":
    main()

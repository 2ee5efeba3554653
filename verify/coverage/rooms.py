#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""rooms.py COVERAGE --out FILE: the shares of lines and branches that are covered, for each room of
lib/dsc and each module, from gcovr's JSON; writes them with the lines that are not covered as Markdown. Exit: 0
enough is covered, 1 it is not, 2 the file cannot be used. Standard library only."""
import argparse
import collections
import dataclasses
import json
import pathlib
import sys

LEAST_LINES, LEAST_BRANCHES = 0.95, 0.85
CORE, MODULES = "lib/dsc/", ("lib/fluid/", "lib/geometric_flows/", "lib/thesis/", "lib/topology/")
NEVER = "throw InvariantError"  # where only a mistake of the library itself leads


class NoCoverage(Exception):
    """Why the file cannot be used."""


@dataclasses.dataclass
class Counts:
    lines: int = 0
    lines_covered: int = 0
    branches: int = 0
    branches_covered: int = 0

    def add(self, other):
        self.lines += other.lines
        self.lines_covered += other.lines_covered
        self.branches += other.branches
        self.branches_covered += other.branches_covered

    @property
    def line_share(self):
        return self.lines_covered / self.lines if self.lines else 1.0

    @property
    def branch_share(self):
        return self.branches_covered / self.branches if self.branches else 1.0

    @property
    def is_enough(self):
        return self.line_share >= LEAST_LINES and self.branch_share >= LEAST_BRANCHES


def files_of(data):
    """{file: {line: (count, counts of its branches)}} of the library."""
    found = {}
    for entry in data.get("files", []):
        if entry["file"].startswith((CORE, *MODULES)):
            found[entry["file"]] = {
                line["line_number"]: (line["count"], [b["count"] for b in line["branches"]])
                for line in entry["lines"] if not line.get("gcovr/noncode")}
    if not any(found.values()):
        raise NoCoverage(f"no line of {CORE} is in it")
    return found


def counts_of(lines):
    branches = [count for _, mine in lines.values() for count in mine]
    return Counts(len(lines), sum(count > 0 for count, _ in lines.values()),
                  len(branches), sum(count > 0 for count in branches))


def by_room(files):
    """{room: Counts}, and those of all under "all"."""
    rooms = collections.defaultdict(Counts)
    for file, lines in sorted(files.items()):
        library, room = file.split("/")[1:3]
        rooms[room if file.startswith(CORE) else library].add(counts_of(lines))
    total = Counts()
    for counts in list(rooms.values()):
        total.add(counts)
    return {**rooms, "all": total}


def table(rooms):
    lines = ["| room | lines | covered | branches | covered |", "| --- | --- | --- | --- | --- |"]
    lines += [f"| {room} | {c.lines} | {100 * c.line_share:.1f} % | {c.branches} | "
              f"{100 * c.branch_share:.1f} % |" for room, c in rooms.items()]
    return lines


def ranges(numbers):
    """'3-5, 9' of 3, 4, 5, 9."""
    found = []
    for number in sorted(numbers):
        if found and found[-1][1] == number - 1:
            found[-1][1] = number
        else:
            found.append([number, number])
    return ", ".join(f"{a}-{b}" if a != b else str(a) for a, b in found)


def missing(files, root):
    """Lines that no test runs; those that only a mistake of the library could run are told apart."""
    lines, never = ["| file | lines not run | branches not taken |", "| --- | --- | --- |"], []
    for file, known in sorted(files.items()):
        text = (root / file).read_text(encoding="utf-8").split("\n") if (root / file).exists() else []
        unrun = [number for number, (count, _) in known.items() if count == 0]
        partly = [number for number, (count, branches) in known.items() if count and 0 in branches]
        for number in unrun:
            if number <= len(text) and NEVER in text[number - 1]:
                never.append(f"- {file}:{number}: `{text[number - 1].strip()}`")
        if unrun or partly:
            lines.append(f"| {file} | {ranges(unrun)} | {ranges(partly)} |")
    return lines, never


def markdown(rooms, files, root):
    total = rooms["all"]
    lines, never = missing(files, root)
    return "\n".join([
        f"{100 * total.line_share:.1f} % of the lines and {100 * total.branch_share:.1f} % of the "
        f"branches of the library are run by the tests; {100 * LEAST_LINES:g} and "
        f"{100 * LEAST_BRANCHES:g} % are asked for.", "", *table(rooms), "",
        f"{len(never)} lines that are counted as not run throw where the library itself would be wrong:",
        "", *never, "", *lines, ""])


def write(path, text):
    part = path.with_suffix(".part")
    part.write_text(text, encoding="utf-8")
    part.replace(path)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("coverage", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    arguments = parser.parse_args(argv)
    try:
        files = files_of(json.loads(arguments.coverage.read_text(encoding="utf-8")))
    except (OSError, ValueError, KeyError, TypeError, NoCoverage) as error:
        sys.stderr.write(f"rooms.py: {arguments.coverage} cannot be used: {error}\n")
        return 2
    rooms = by_room(files)
    write(arguments.out, markdown(rooms, files, pathlib.Path(__file__).resolve().parents[2]))
    print("\n".join(table(rooms)))
    print(f"asked for: {100 * LEAST_LINES:g} % of the lines, {100 * LEAST_BRANCHES:g} % of the branches")
    return 0 if rooms["all"].is_enough else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

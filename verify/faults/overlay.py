#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""overlay.py SOURCE TARGET: writes a copy of the project in which each seeded fault has a switch.

A file is only written if it changes, so that a build of the copy compiles no more than it has to. The
faults of files that are not C++ are left out here: the runner puts them in while they are on."""
import pathlib
import sys

import catalogue

COPIED = ("CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "LICENSE", ".clang-format",
          "lib", "reference", "verify", "bench", "plots")
HEADER = "lib/fault/fault.h"


def files_of(source):
    """All files of the project, relative to its folder."""
    for name in COPIED:
        path = source / name
        if path.is_dir():
            for file in path.rglob("*"):
                if file.is_file() and "__pycache__" not in file.parts:
                    yield file.relative_to(source)
        elif path.exists():
            yield path.relative_to(source)


def with_switches(text, faults):
    """The text of a C++ file with the switches of its faults; throws where two of them overlap."""
    placed = sorted(((catalogue.place_of(fault, text), fault) for fault in faults),
                    key=lambda pair: pair[0])
    result, end = [], 0
    for place, fault in placed:
        if place < end:
            raise catalogue.TableError(f"{fault.name} overlaps with the fault before it in {fault.file}")
        result += [text[end:place], fault.with_switch()]
        end = place + len(fault.sought)
    return '#include "fault/fault.h"\n' + "".join(result) + text[end:]


def write_if_changed(path, content):
    if path.exists() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def make(source, target, faults, instead=None):
    """Brings the copy up to date with the sources and the faults; files of `instead`, by their path, have
    that text there."""
    instead = instead or {}
    by_file = {}
    for fault in faults:
        if fault.is_cpp:
            by_file.setdefault(fault.file, []).append(fault)
    kept = {pathlib.Path(file) for file in (HEADER, *instead)}
    write_if_changed(target / HEADER, (source / "verify/faults/fault.h.in").read_bytes())
    for file, text in instead.items():
        write_if_changed(target / file, text.encode())
    for file in files_of(source):
        if str(file) in instead:
            continue
        content = (source / file).read_bytes()
        if str(file) in by_file:
            content = with_switches(content.decode(), by_file.pop(str(file))).encode()
        write_if_changed(target / file, content)
        kept.add(file)
    if by_file:
        raise catalogue.TableError(f"no such file: {', '.join(by_file)}")
    for file in list(files_of(target)):
        if file not in kept:
            (target / file).unlink()


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    source, target = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    if not (source / "verify/faults/fault.h.in").exists():
        sys.exit(f"overlay.py: {source} is not the project's folder")
    make(source, target, catalogue.read_table())


if __name__ == "__main__":
    main()

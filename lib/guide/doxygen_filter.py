#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes copies of the headers for doxygen, with these changes:

- the comment at the top of a file becomes the description of the file;
- the declarations of a room (a folder of lib/dsc, or a module) belong to the group of that name;
- a comment above several functions of one name, or beside an x and a y, is repeated for all of them.

No line is added or removed, so that warnings have the right line numbers.

usage: doxygen_filter.py SOURCE COPIES HEADER...   (headers within SOURCE, copies within COPIES)"""
import re
import sys
from pathlib import Path

FUNCTION = re.compile(r"([A-Za-z_]\w*)\s*\(")
COORDINATE = re.compile(r"\s*[\w<>:() ]+ (?:\w+_)?(?:x|y)(?:0|_next|_previous)?(?: = .+?)?;")
SAID_ONCE = (  # comments of declarations that are the same everywhere
    (re.compile(r"inline constexpr std::array \w+_names\{"), "The values with their names."),
    (re.compile(r".*constexpr std::string_view to_string\(\w+ \w+\) \{"), "The name of a value."),
    (re.compile(r"\s+\w+& operator\+=\(const \w+& other\)[;{ ]*"), "Adds what another one holds."),
    (re.compile(r".*void archive\(Archive& archive, .*& \w+\)[;{ ]*"),
     "Writes the value into an archive, or reads it back."),
)


def describe_file(lines):
    """Line 1 is the licence; the description ends before the first line that is not a comment."""
    lines[0] = r"/// \file"
    for i in range(1, len(lines)):
        if not lines[i].startswith("//"):
            break
        lines[i] = "/" + lines[i]


def put_into_group(lines, room):
    for i, line in enumerate(lines):
        if line.startswith("namespace dsc") and line.endswith("{"):
            lines[i] = rf"{line} /** \addtogroup {room} */ /** @{{ */"
        elif line.startswith("} // namespace dsc"):
            lines[i] = f"/** @}} */ {line}"


def leave_out(lines):
    """Removes instantiations, which are declared elsewhere, defaulted functions, and the specialisations
    of the standard library after the namespace."""
    inside = False
    for i, line in enumerate(lines):
        inside = inside or line.startswith("extern template")
        if inside or line.endswith("= default;"):
            lines[i] = ""
        inside = inside and not line.endswith(";")
        if line.startswith("} // namespace dsc"):
            lines[i + 1:] = [""] * (len(lines) - i - 1)
            break


def say_once(lines):
    for i in range(1, len(lines)):
        for pattern, comment in SAID_ONCE:
            begin = i
            while pattern.fullmatch(lines[i]) and lines[begin - 1].startswith(
                    ("template", "requires")):
                begin -= 1
            if pattern.fullmatch(lines[i]) and not lines[begin - 1].strip().startswith("///"):
                lines[begin] = f"/** {comment} */ {lines[begin]}"


def share_comments(lines):
    """In a sequence of declarations without blank lines and braces, a declaration without a comment
    gets that of the previous function of the same name."""
    comment = name = ""
    start = 0
    while start < len(lines):
        if lines[start].strip().startswith("///"):
            comment = name = ""
            while lines[start].strip().startswith("///"):
                comment += lines[start].strip()[3:]
                start += 1
        end = start
        while end + 1 < len(lines) and lines[end].strip() and lines[end][-1] not in "{};":
            end += 1
        declaration = re.sub(r"^template <.*?> ", "", " ".join(lines[start:end + 1]))
        found = FUNCTION.search(declaration)
        if lines[end].endswith(";") and found:
            if comment and name == found.group(1):
                lines[start] = f"/**{comment} */ {lines[start]}"
            elif name:
                comment = ""
            name = found.group(1)
        else:
            comment = name = ""
        start = end + 1


def share_coordinates(lines):
    for i in range(1, len(lines)):
        before = re.search(r"(?<=///<).*", lines[i - 1])
        if before and COORDINATE.fullmatch(lines[i]) and COORDINATE.match(lines[i - 1]):
            lines[i] += f" ///<{before.group(0)}"


def filtered(path, text):
    lines = text.split("\n")
    describe_file(lines)
    leave_out(lines)
    say_once(lines)
    share_comments(lines)
    share_coordinates(lines)
    room = re.search(r"/lib/(?:dsc/)?(?:(\w+)/)?", path).group(1)
    if room and room != "dsc":
        put_into_group(lines, room)
    return "\n".join(lines)


if __name__ == "__main__":
    source, copies, *headers = sys.argv[1:]
    for header in headers:
        copy = Path(copies, header)
        copy.parent.mkdir(parents=True, exist_ok=True)
        header = Path(source, header)
        copy.write_text(filtered(str(header), header.read_text(encoding="utf-8")), encoding="utf-8")

# SPDX-License-Identifier: MIT
"""Reads a Markdown file: its fenced blocks, the commands within its text, the files it names.

A comment on the line above a block, which readers do not see, says how the block is checked:

    <!-- from FILE -->            the block is FILE, or consecutive lines of it, apart from their
                                  indentation; a line `// ...` stands for any lines
    <!-- run with ARGUMENTS -->   the commands are run with these arguments as well, to be short
    <!-- not run: REASON -->      the commands are not run
"""
import re
from dataclasses import dataclass, field


@dataclass
class Block:
    file: str      # the Markdown file
    line: int      # of the opening fence, from 1
    language: str  # cpp, sh, console...
    text: list     # lines
    mark: str = ""  # the comment above: "from ...", "run with ...", "not run: ..."

    @property
    def where(self):
        return f"{self.file}:{self.line}"


@dataclass
class Page:
    blocks: list = field(default_factory=list)
    spans: list = field(default_factory=list)  # (line, text) of code within the text
    links: list = field(default_factory=list)  # (line, target)
    rows: list = field(default_factory=list)   # (line, the spans of a row of a table)


def read_page(file, text):
    page = Page()
    block, mark = None, ""
    for number, line in enumerate(text.splitlines(), 1):
        if block is not None:
            if line.startswith("```"):
                page.blocks.append(block)
                block = None
            else:
                block.text.append(line)
            continue
        if line.startswith("```"):
            block = Block(file, number, line[3:].strip(), [], mark)
        comment = re.fullmatch(r"<!-- (.*) -->", line)
        mark = comment.group(1) if comment else ""
        spans = re.findall(r"`([^`]+)`", line)
        page.spans += [(number, span) for span in spans]
        page.links += [(number, link) for link in re.findall(r"\]\(([^)#]+)[^)]*\)", line)]
        if line.startswith("|"):
            page.rows.append((number, spans))
    return page


@dataclass
class Command:
    words: str   # as it is shown
    output: list  # the lines shown below it; None where none are


def commands(block):
    """Commands of a `sh` block are one to a line, except comments; those of a `console` block begin with $,
    and their output follows. A line that ends with a backslash goes on."""
    found = []
    lines = "\n".join(block.text).replace("\\\n", " ").splitlines()
    for line in lines:
        if block.language == "console" and not line.startswith("$ "):
            found[-1].output = (found[-1].output or []) + [line]
            continue
        words = re.sub(r"(^|\s)#.*", "", line.removeprefix("$ ")).strip()
        if words:
            found.append(Command(words, None))
    return found


def without_times(text):
    """Replaces what differs from run to run and from machine to machine."""
    return re.sub(r"\d+(\.\d+)?(e[-+]\d+)? (us|ms|s|MB)\b", r"# \3", text)


def is_part_of(shown, source):
    """Whether the lines shown are consecutive lines of the source, apart from indentation."""
    pieces = [[]]
    for line in shown:
        if line.strip().startswith("// ..."):
            pieces.append([])
        elif line.strip():
            pieces[-1].append(line.strip())
    rest = [line.strip() for line in source if line.strip()]
    for piece in pieces:
        at = next((i for i in range(len(rest) - len(piece) + 1)
                   if rest[i:i + len(piece)] == piece), None)
        if at is None:
            return False
        rest = rest[at + len(piece):]
    return any(pieces)

# SPDX-License-Identifier: MIT
"""Mutants of the library: small changes that nobody has thought of, made by rule, a sample of which is
put into a copy of the project with a switch each (R. H. Untch, A. J. Offutt, M. J. Harrold, "Mutation
analysis using mutant schemata", 1993).

A rule changes one token of a condition, of a value that is returned or of one that is kept, or leaves
out a call. Only what stands in one line is changed, so that no parser is needed; a mutant that does
not compile is dropped. Calls that only make room in advance are no candidates, for without them
nothing but time is different."""
import collections
import dataclasses
import hashlib
import pathlib
import re
import tomllib

INCLUDE = '#include "fault/mutant.h"\n'
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
EQUIVALENT_KEYS = {"file", "code", "changed", "why"}


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


def candidates(source):
    """All mutants of the core and of the modules."""
    found = []
    for library in (CORE, *MODULES):
        for path in sorted((source / "lib" / library).rglob("*.*")):
            if path.suffix in (".h", ".cpp"):
                found += candidates_in(path.relative_to(source).as_posix(),
                                       path.read_text(encoding="utf-8"))
    return found


def sample(found, count, seed):
    """So many of them, each room by its share. A change of the sources leaves the sample of other lines
    as it is."""
    drawn = sorted(found, key=lambda mutant: hashlib.sha1((seed + mutant.key).encode()).digest())
    return sorted(drawn[:count], key=lambda mutant: (mutant.file, mutant.line))


def with_switches(text, numbered):
    """The text of a file with the switches of its mutants, [(number, mutant)]; several of one line are
    tried in turn."""
    lines = text.split("\n")
    for line in sorted({mutant.line for _, mutant in numbered}):
        mine = [(number, mutant) for number, mutant in numbered if mutant.line == line]
        number, first = mine[0]
        original = first.original
        if first.rule == "call left out":
            place = f"if (!::dsc::mutant::on({number})) {{ {original} }}"
        else:
            place = f"({original})"
            for number, mutant in mine:
                place = f"(::dsc::mutant::on({number}) ? ({mutant.changed}) : {place})"
        at = lines[line - 1].rindex(original)
        lines[line - 1] = lines[line - 1][:at] + place + lines[line - 1][at + len(original):]
    return INCLUDE + "\n".join(lines)


def read_equivalent(path=pathlib.Path(__file__).parent / "equivalent.toml"):
    """{what a mutant says: why nothing can tell it from the original}"""
    with open(path, "rb") as stream:
        entries = tomllib.load(stream).get("mutant", [])
    for entry in entries:
        if set(entry) != EQUIVALENT_KEYS:
            raise ValueError(f"{path.name}: an entry has {sorted(entry)}, "
                             f"wants {sorted(EQUIVALENT_KEYS)}")
    return {(entry["file"], entry["code"], entry["changed"]): entry["why"] for entry in entries}

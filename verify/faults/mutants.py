# SPDX-License-Identifier: MIT
"""Mutants of the library's source files: small changes that nobody has thought of, made by rule, a
sample of which is put into a copy of the project with a switch each (R. H. Untch, A. J. Offutt, M. J.
Harrold, "Mutation analysis using mutant schemata", 1993).

A rule changes one token of a condition, of a value that is returned or of one that is kept, or leaves
out a call. Only what stands in one line is changed, so that no parser is needed; a mutant that does
not compile is dropped by the build."""
import dataclasses
import random
import re

HEADER = '#include "fault/mutant.h"\n'
CONDITION = re.compile(r"^(\s*(?:\} else )?(?:if|while) \()(.+)(\) \{)$")
LOOP = re.compile(r"^(\s*for \([^;]*; )([^;]+)(; [^;]*\) \{)$")
VALUE = re.compile(r"^(\s*return )([^{};]+)(;)$")
KEPT = re.compile(r"^(\s*(?:const )?(?:bool|double|Real|int|std::u?int\d+_t|std::size_t|Corner|auto) "
                  r"\w+ = )([^{};]+)(;)$")
CALL = re.compile(r"^(\s*)((?!return|throw|delete|using|static|const|auto|case|template)"
                  r"[A-Za-z_][\w.:>\-\[\]]*\([^{}]*\);)$")
# A token between blanks, and what takes its place.
TOKENS = ((" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "),
          (" != ", " == "), (" && ", " || "), (" || ", " && "), (" + ", " - "), (" - ", " + "),
          (" * ", " + "))
NUMBER = re.compile(r"(?<![\w.])(\d+)(?![\w.])")


@dataclasses.dataclass(frozen=True)
class Mutant:
    number: int
    file: str
    line: int       # from 1
    rule: str
    original: str
    changed: str

    @property
    def room(self):
        return self.file.split("/")[2]


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


def candidates_in(file, text):
    """All mutants of a file, not numbered yet."""
    for index, line in enumerate(text.split("\n"), 1):
        if "constexpr" in line or "template" in line or line.count("(") != line.count(")"):
            continue
        matched = CONDITION.match(line) or LOOP.match(line)
        if matched:
            yield file, index, "condition negated", matched.group(2), f"!({matched.group(2)})"
        matched = matched or VALUE.match(line) or KEPT.match(line)
        if matched:
            for rule, changed in changes_of(matched.group(2)):
                yield file, index, rule, matched.group(2), changed
        elif found := CALL.match(line):
            yield file, index, "call left out", found.group(2), ""


def sample(source, count, seed):
    """So many mutants of lib/dsc, each room by its share."""
    found = []
    for path in sorted((source / "lib/dsc").rglob("*.cpp")):
        file = str(path.relative_to(source))
        found += candidates_in(file, path.read_text(encoding="utf-8"))
    chosen = sorted(random.Random(seed).sample(found, min(count, len(found))))
    return len(found), [Mutant(number, *one) for number, one in enumerate(chosen, 1)]


def with_switches(text, mutants):
    """The text of a file with the switches of its mutants; several of one line are tried in turn."""
    lines = text.split("\n")
    for line in sorted({mutant.line for mutant in mutants}):
        mine = [mutant for mutant in mutants if mutant.line == line]
        original = mine[0].original
        if mine[0].rule == "call left out":
            place = f"if (!::dsc::mutant::on({mine[0].number})) {{ {original} }}"
        else:
            place = f"({original})"
            for mutant in mine:
                place = f"(::dsc::mutant::on({mutant.number}) ? ({mutant.changed}) : {place})"
        assert lines[line - 1].count(original) >= 1
        at = lines[line - 1].rindex(original)
        lines[line - 1] = lines[line - 1][:at] + place + lines[line - 1][at + len(original):]
    return HEADER + "\n".join(lines)

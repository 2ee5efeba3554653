# SPDX-License-Identifier: MIT
"""The table of seeded faults: one file of the folder `table` for each room, an entry for each fault.

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
where the switch is asked. Files that are not C++ are replaced as a whole while their fault is on."""
import dataclasses
import pathlib
import tomllib
import zlib

KINDS = (
    "wrong algebra",
    "missing guard",
    "off by one",
    "dropped hand-over",
    "stale neighbour",
    "attribute not carried",
    "integrator",
    "insertion",
    "clean-up left out",
    "race",
    "shared state",
    "limit",
    "flattering measure",
    "writer",
    "cost",
    "plot",
    "topology",
    "reference",
)
FORMS = ("expression", "statement", "text")
CPP = (".h", ".cpp")
OPENED, CLOSED = "«", "»"
KEYS = {"name", "says", "kind", "file", "form", "original", "faulty"}
OPTIONAL = {"also"}


class TableError(Exception):
    """An entry that cannot be used; says which and why."""


@dataclasses.dataclass(frozen=True)
class Fault:
    name: str
    room: str
    says: str
    kind: str
    file: str
    form: str
    original: str
    faulty: str
    also: tuple = ()

    @property
    def is_cpp(self):
        return self.file.endswith(CPP)

    @property
    def digest(self):
        """Another one where the entry has been changed."""
        return zlib.crc32("\n".join((self.file, self.form, self.original, self.faulty)).encode())

    @property
    def sought(self):
        """The text that the file holds once."""
        return self.original.replace(OPENED, "").replace(CLOSED, "")

    @property
    def parts(self):
        """What stands before the part to be replaced, that part, and what stands behind it."""
        if OPENED not in self.original:
            return "", self.original, ""
        before, rest = self.original.split(OPENED)
        middle, after = rest.split(CLOSED)
        return before, middle, after

    def with_switch(self):
        """The text that takes the place of `sought` in C++, with the switch in it."""
        before, right, after = self.parts
        switch = f'::dsc::fault::on("{self.name}")'
        if self.form == "expression":
            middle = f"({switch} ? ({self.faulty}) : ({right}))"
        elif self.form == "statement":
            middle = f"if ({switch}) {{ {self.faulty} }} else {{ {right} }}"
        else:
            middle = self.faulty.replace("FAULT", switch)
        return before + middle + after

    def in_place(self):
        """The same in a file that is not C++: the faulty text alone."""
        before, _, after = self.parts
        return before + self.faulty + after


def read_fault(entry, room):
    name = entry.get("name", "without a name")
    if set(entry) - OPTIONAL != KEYS:
        raise TableError(f"{room}, {name}: has {sorted(entry)}, wants {sorted(KEYS)} and at most "
                         f"{sorted(OPTIONAL)}")
    fault = Fault(room=room, **{**entry, "also": tuple(entry.get("also", ()))})
    if fault.kind not in KINDS:
        raise TableError(f"{room}, {name}: kind '{fault.kind}' is none of {', '.join(KINDS)}")
    if fault.form not in FORMS or (fault.form != "text" and not fault.is_cpp):
        raise TableError(f"{room}, {name}: form '{fault.form}' is none of {', '.join(FORMS)}, of "
                         "which files that are not C++ have only the last")
    marks = (fault.original.count(OPENED), fault.original.count(CLOSED))
    if marks not in ((0, 0), (1, 1)):
        raise TableError(f"{room}, {name}: original has {marks} marks, wants one pair or none")
    return fault


def read_table(folder=pathlib.Path(__file__).parent / "table"):
    """All faults, room by room."""
    faults = []
    for path in sorted(folder.glob("*.toml")):
        with open(path, "rb") as stream:
            entries = tomllib.load(stream)["fault"]
        faults += [read_fault(entry, path.stem) for entry in entries]
    names = [fault.name for fault in faults]
    for name in names:
        if names.count(name) > 1:
            raise TableError(f"two faults are named {name}")
    return faults


def place_of(fault, text):
    """Where `sought` begins in the text of its file; throws where it is not there exactly once."""
    count = text.count(fault.sought)
    if count != 1:
        raise TableError(f"{fault.room}, {fault.name}: original occurs {count} times in {fault.file}")
    return text.index(fault.sought)

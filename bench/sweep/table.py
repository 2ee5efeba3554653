# SPDX-License-Identifier: MIT
"""Reads a table of what to run; tables/example.toml shows all that may stand in one.

A table is a TOML file with `about`, and a `[[run]]` for each row. A row runs a scene or any
command, once for each combination of what it lists. Lists are combined in the order in which they
stand here: `cases` or `with`, `set`, `strategy`, `submeshes`, `threads`, `seed`, `commit`, and at
last `repeats`."""
import dataclasses
import os
import re
import subprocess
import tomllib

import placeholders
from errors import TableError

TOP = {"about": str, "native": bool, "run": list, "defaults": dict}
ANY = (str, int, float)
# What a row may hold: the types of its values, and whether a list of them is taken.
KEYS = {
    "name": ((str,), False), "scene": ((str,), True), "command": ((str,), True),
    "set": ((dict,), False), "cases": ((dict,), True), "with": ((dict,), False),
    "strategy": ((str,), True), "submeshes": ((int,), True), "angle": (ANY, True),
    "threads": ((int,), True), "seed": (ANY, True), "commit": ((str,), True),
    "repeats": ((int,), False), "timed": ((bool,), False), "alone": ((bool,), False),
    "timeout": ((int, float), False), "accept": ((int,), True), "files": ((str,), True),
    "environment": ((dict,), False), "prepare": ((str,), True), "targets": ((str,), True),
    "cores": ((int,), False),
}
OF_SCENES = {"set", "cases", "strategy", "submeshes", "angle"}
OF_COMMANDS = {"with", "files", "environment", "prepare", "cores"}
NAME = re.compile(r"[A-Za-z0-9][\w.+-]*")


@dataclasses.dataclass(frozen=True)
class Row:
    """A row as it stands in the table: every list is a tuple, in the table's order."""
    name: str
    where: str
    scenes: tuple = ()
    command: tuple = ()
    cases: tuple = ({},)       # values that belong together
    lists: dict = dataclasses.field(default_factory=dict)  # key -> values that are combined
    strategies: tuple = ("sequential",)
    submeshes: tuple = (None,)
    angles: tuple = (None,)
    threads: tuple = (1,)
    seeds: tuple = (None,)
    commits: tuple = (".",)
    repeats: int = 1
    timed: bool = False
    alone: bool = False
    timeout_s: float = 3600
    accept: tuple = (0,)
    files: tuple = ()
    environment: dict = dataclasses.field(default_factory=dict)
    prepare: tuple = ()
    targets: tuple = ()
    cores: int = 1


@dataclasses.dataclass(frozen=True)
class Table:
    name: str
    path: str
    about: str
    native: bool
    rows: tuple


def read(path, root):
    """The table in a file. `root` is the project's folder, where values that commands list are
    asked for. Raises TableError."""
    try:
        with open(path, "rb") as stream:
            data = tomllib.load(stream)
    except OSError as error:
        raise TableError("a table cannot be read", path, error.strerror, "a TOML file") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise TableError("not a TOML file", path, str(error), "see tables/example.toml") from error
    for key, value in data.items():
        _check(key in TOP, "unknown key", path, key, ", ".join(TOP))
        _check(isinstance(value, TOP[key]), "wrong type", f"{path}: {key}", value,
               f"a {TOP[key].__name__}")
    entries = data.get("run", [])
    _check(entries, "a table without a row", path, "no [[run]]", "at least one [[run]]")
    rows, names = [], set()
    for number, entry in enumerate(entries, 1):
        _check(isinstance(entry, dict), "wrong type", f"{path}: run {number}", entry, "a [[run]]")
        row = _row({**data.get("defaults", {}), **entry}, f"{path}: run {number}", path, root)
        _check(row.name not in names, "two rows of one name", row.where, row.name, "another name")
        names.add(row.name)
        rows.append(row)
    return Table(os.path.splitext(os.path.basename(path))[0], path, data.get("about", ""),
                 data.get("native", True), tuple(rows))


def _check(is_good, what, where, value, allowed):
    if not is_good:
        raise TableError(what, where, value, allowed)


def _values(entry, key, default, where):
    """The value of a key as a tuple, checked; a single value is a list of one."""
    if key not in entry:
        return default
    kinds, takes_list = KEYS[key]
    value = entry[key]
    values = value if isinstance(value, list) and takes_list else [value]
    names = " or ".join(kind.__name__ for kind in kinds)
    names += ", or a list of these" if takes_list else ""
    _check(values, "an empty list", f"{where}: {key}", "[]", names)
    for one in values:
        is_good = isinstance(one, kinds) and (bool in kinds or not isinstance(one, bool))
        _check(is_good, "wrong type", f"{where}: {key}", one, names)
    return tuple(values)


def _texts(values, where):
    """Values of settings as the command line takes them."""
    for value in values:
        _check(isinstance(value, ANY) and not isinstance(value, bool), "wrong type", where, value,
               "a text or a number")
    return tuple(str(value) for value in values)


def _lines_of(command, where, root):
    """The lines that a command prints."""
    _check(isinstance(command, list) and command and all(isinstance(w, str) for w in command),
           "not a command", where, command, "a list of words")
    try:
        done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL)
    except OSError as error:
        raise TableError("a command cannot be run", where, command[0], error.strerror) from error
    lines = done.stdout.split("\n")[:-1] if done.returncode == 0 else []
    _check(lines, "a command gives no values", where,
           f"exit code {done.returncode}, {done.stderr.strip()[-300:]}", "0 and at least one line")
    return tuple(lines)


def _lists(entry, key, where, root):
    """{name: values} of the keys `set` and `with`."""
    found = {}
    for name, value in entry.get(key, {}).items():
        place = f"{where}: {key}.{name}"
        if isinstance(value, dict):
            _check(set(value) == {"lines_of"}, "unknown key", place, ", ".join(value), "lines_of")
            found[name] = _lines_of(value["lines_of"], place, root)
        else:
            values = value if isinstance(value, list) else [value]
            _check(values, "an empty list", place, "[]", "at least one value")
            found[name] = _texts(values, place)
    return found


def _row(entry, where, path, root):
    for key in entry:
        _check(key in KEYS, "unknown key", where, key, ", ".join(KEYS))
    of_scene = "scene" in entry
    _check(of_scene != ("command" in entry), "a row runs one thing", where,
           "both" if of_scene else "neither", "either scene or command")
    for key in entry:
        _check(key not in (OF_COMMANDS if of_scene else OF_SCENES), "a key of another kind of row",
               where, key, "see tables/example.toml")
    values = {key: _values(entry, key, None, where) for key in KEYS}
    scenes = tuple(_scene(name, path, where) for name in values["scene"] or ())
    name = entry.get("name", entry["scene"] if of_scene and len(scenes) == 1 and
                     isinstance(entry["scene"], str) and "/" not in entry["scene"] else None)
    _check(name is not None and NAME.fullmatch(name), "a row needs a name", where, name,
           "letters, digits and . + - _")
    where = f"{where} ({name})"
    for key, low in (("threads", 1), ("submeshes", 1), ("repeats", 1), ("cores", 1),
                     ("timeout", 0)):
        for value in values[key] or ():
            _check(value >= low and value == value, "too small", f"{where}: {key}", value,
                   f"{low} and more")
    lists = _lists(entry, "set" if of_scene else "with", where, root)
    cases = tuple({key: _texts([value], f"{where}: cases")[0] for key, value in case.items()}
                  for case in values["cases"] or ({},))
    timed = entry.get("timed", False)

    def texts(key, default):
        return default if values[key] is None else _texts(values[key], f"{where}: {key}")

    row = Row(
        name, where, scenes, values["command"] or (), cases, lists,
        values["strategy"] or ("sequential",), values["submeshes"] or (None,),
        texts("angle", (None,)), values["threads"] or (1,), texts("seed", (None,)),
        values["commit"] or (".",), entry.get("repeats", 1), timed,
        timed or entry.get("alone", False), entry.get("timeout", 3600), values["accept"] or (0,),
        values["files"] or (),
        {key: _texts([value], f"{where}: environment")[0]
         for key, value in entry.get("environment", {}).items()},
        values["prepare"] or (), values["targets"] or (("dsc_scene",) if of_scene else ()),
        entry.get("cores", 1))
    known = {*row.lists, *placeholders.OF_RUNS, *placeholders.PATHS}
    for text in (*row.command, *row.files, *row.prepare, *row.environment.values()):
        for word in placeholders.names_in(text):
            _check(word in known, "unknown placeholder", where, f"{{{word}}}",
                   ", ".join(sorted(known)))
    return row


def _scene(name, path, where):
    """A scene's name, or the path of a scene file, which is relative to the table."""
    if "/" not in name and not name.endswith(".toml"):
        return name
    file = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(path)), name))
    _check(os.path.isfile(file), "no such scene file", f"{where}: scene", name,
           "a path that begins at the table")
    return file

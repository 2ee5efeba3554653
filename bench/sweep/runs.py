# SPDX-License-Identifier: MIT
"""The runs that the rows of a table stand for, and the key of each.

What a run is, is all that its result depends on beside the machine: the commit, the scene or what
is in its file, the settings, the strategy, the threads, the seed, whether it is timed, and which
repeat it is. The key is a digest of that, so that the same run in another table, or in a row of
another name, is the same."""
import dataclasses
import hashlib
import itertools
import json
import os
import tomllib

import placeholders
from errors import TableError

RESULT = "result.json"  # in {out}: the one result of a run, where it has one
SERIAL = ("sequential", "reference")  # strategies without threads and submeshes


@dataclasses.dataclass(frozen=True)
class Run:
    """All that is needed to run it, also on another machine that sees the same files."""
    key: str
    row: str
    table: str
    identity: dict
    commit: str          # the label of the tree
    described: str       # the commit that results of its programs name
    source: str
    build: str
    command: tuple
    environment: dict
    files: tuple
    cores: int
    timed: bool
    alone: bool
    timeout_s: float
    accept: tuple

    @property
    def what(self):
        """In words, for one line."""
        identity = self.identity
        words = [f"{key}={value}" for key, value in identity["values"].items()]
        if "scene" in identity:
            words.insert(0, os.path.basename(identity["scene"]))
            words.append(identity["strategy"])
            words += [f"{key}={identity[key]}" for key in ("submeshes", "angle") if key in identity]
        words += [f"{key}={identity[key]}" for key in ("threads", "seed") if key in identity]
        if identity["repeat"] > 1 or self.timed:
            words.append(f"repeat {identity['repeat']}")
        return f"{self.row}: " + " ".join(words)


def to_json(run):
    return dataclasses.asdict(run)


def from_json(data):
    return Run(**{**data, **{key: tuple(data[key]) for key in ("command", "files", "accept")}})


def key_of(identity):
    text = json.dumps(identity, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:20]


def digest_of_scene_file(path):
    """SHA-256 of a scene file and of the files that it names: outlines, grids."""
    digest = hashlib.sha256()
    with open(path, "rb") as stream:
        text = stream.read()
    digest.update(text)
    try:
        data = tomllib.loads(text.decode())
    except (tomllib.TOMLDecodeError, UnicodeDecodeError):
        return digest.hexdigest()  # the program will say what is wrong with it
    for name in sorted(set(_texts_in(data))):
        beside = os.path.join(os.path.dirname(path), name)
        if len(name) < 1000 and os.path.isfile(beside):
            with open(beside, "rb") as stream:
                digest.update(name.encode() + b"\0" + hashlib.sha256(stream.read()).digest())
    return digest.hexdigest()


def _texts_in(value):
    if isinstance(value, str):
        yield value
    elif isinstance(value, (list, dict)):
        for one in value.values() if isinstance(value, dict) else value:
            yield from _texts_in(one)


def expand(table, trees):
    """All runs of a table in its order, each once. `trees`: {what the table calls it: Tree}."""
    found = {}
    for row in table.rows:
        for run in _of_row(row, table, trees):
            found.setdefault(run.key, run)
    return list(found.values())


def _of_row(row, table, trees):
    lists = [[(name, value) for value in values] for name, values in row.lists.items()]
    for scene, case, chosen, strategy, submeshes, angle, threads, seed, commit, repeat in \
            itertools.product(row.scenes or (None,), row.cases, itertools.product(*lists),
                              row.strategies, row.submeshes, row.angles, row.threads, row.seeds,
                              row.commits, range(1, row.repeats + 1)):
        values = {**case, **dict(chosen)}
        if len(values) < len(case) + len(chosen):
            raise TableError("a key that both set and cases give", row.where,
                             ", ".join(sorted(set(case) & set(dict(chosen)))), "one of the two")
        tree = trees[commit]
        identity = {"commit": tree.label, "native": table.native, "values": values,
                    "repeat": repeat}
        if row.timed:
            identity["timed"] = True
        if seed is not None:
            identity["seed"] = seed
        if scene is not None:
            identity.update(strategy=strategy, threads=1 if strategy in SERIAL else threads)
            identity.update({
                key: value for key, value in (("submeshes", submeshes), ("angle", angle))
                if value is not None and strategy not in SERIAL})
            yield _scene_run(row, table, tree, scene, identity)
        else:
            yield _command_run(row, table, tree, {**values, "threads": str(threads),
                                                  "seed": seed or "", "repeat": str(repeat)},
                               identity, threads)


def _scene_run(row, table, tree, scene, identity):
    words = ["{build}/lib/scenes/dsc_scene", "run", scene]
    settings = {**identity["values"], **({"seed": identity["seed"]} if "seed" in identity else {})}
    for key, value in settings.items():
        words += ["--set", f"{key}={value}"]
    words += ["--strategy", identity["strategy"], "--threads", str(identity["threads"])]
    for key in ("submeshes", "angle"):
        if key in identity:
            words += [f"--{key}", str(identity[key])]
    words += ["--json", f"{{out}}/{RESULT}"]
    identity["scene"] = scene
    if os.path.isabs(scene):
        identity["scene"] = os.path.basename(scene)
        identity["sha256"] = digest_of_scene_file(scene)
    return _run(row, table, tree, identity, words, {}, (), identity["threads"])


def _command_run(row, table, tree, values, identity, threads):
    words = [placeholders.put_in(word, values) for word in row.command]
    environment = {key: placeholders.put_in(text, values) for key, text in row.environment.items()}
    files = tuple(placeholders.put_in(text, values) for text in row.files)
    identity["command"] = words
    if environment:
        identity["environment"] = environment
    if row.threads != (1,):
        identity["threads"] = threads
    return _run(row, table, tree, identity, words, environment, files, max(row.cores, threads))


def _run(row, table, tree, identity, words, environment, files, cores):
    # Threads that spin while they wait are slow where cores are shared.
    passive = {} if row.timed else {"OMP_WAIT_POLICY": "passive"}
    return Run(key_of(identity), row.name, table.name, identity, tree.label,
               tree.described, tree.source, tree.build, tuple(words), {**passive, **environment},
               files, cores, row.timed, row.alone, row.timeout_s, row.accept)

# SPDX-License-Identifier: MIT
"""Reads result files into plain records. InputFault says in one sentence what is wrong with a file.

Google Benchmark's JSON (a name is FAMILY/key:value/...; unknown parts are ignored), the JSON of
dsc_scene and dsc_verify, and the published figures. Frames are read by load_frames.py.
"""
import json
import math
import os
import statistics
from dataclasses import dataclass, field, replace


class InputFault(Exception):
    """A result that cannot be read or made; its text is one sentence for the user."""


@dataclass(frozen=True)
class Context:
    """The origin of a result, as far as known."""

    machine: str = ""
    commit: str = ""
    cores: int = 0
    compiler: str = ""
    build_type: str = ""
    load: str = ""
    date: str = ""
    clock: str = ""
    binding: str = ""


def context_of(result):
    """The Context of a result of a program."""
    return Context(*(str(result.get(key) or "") for key in ("machine", "commit")))


@dataclass
class Measurement:
    """All repetitions of one benchmark."""

    name: str
    family: str
    positions: list
    params: dict
    times_ns: list = field(default_factory=list)
    counters: dict = field(default_factory=dict)

    def counter(self, key):
        """Median of a counter over the repetitions, or None."""
        values = self.counters.get(key)
        return statistics.median(values) if values else None

    def number(self, key):
        """A parameter of the name, or else the counter of that name, as a number or None."""
        try:
            return float(self.params[key])
        except (KeyError, ValueError):
            return self.counter(key)

    @property
    def strategy(self):
        return self.params.get("strategy", "")

    def step_us(self):
        """Microseconds per step, one value for each repetition: the counter, or the time itself."""
        values = self.counters.get("us_per_step", [])
        return values if len(values) == len(self.times_ns) else [t / 1e3 for t in self.times_ns]


@dataclass
class Bench:
    context: Context
    measurements: list
    refused: list  # (name, message) of benchmarks that refused to time a wrong answer


NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
NOT_COUNTERS = {"real_time", "cpu_time", "iterations", "repetitions", "repetition_index",
                "family_index", "per_family_instance_index"}


def read_text(path):
    try:
        with open(path, encoding="utf-8") as stream:
            return stream.read()
    except (OSError, UnicodeDecodeError) as fault:
        reason = getattr(fault, "strerror", None) or "it is not text"
        raise InputFault(f"{path} cannot be read: {reason}.") from fault


def read_json(path, kind=dict):
    """The JSON object, or a value of another given type, in a file."""
    try:
        data = json.loads(read_text(path))
    except json.JSONDecodeError as fault:
        raise InputFault(f"{path} is not whole JSON (line {fault.lineno}, column {fault.colno}: "
                         f"{fault.msg}), so it may be truncated.") from fault
    except RecursionError as fault:
        raise InputFault(f"{path} is nested too deeply to be a result.") from fault
    if not isinstance(data, kind):
        raise InputFault(f"{path} holds a JSON {type(data).__name__} where "
                         f"{'an object' if kind is dict else f'a {kind.__name__}'} is expected.")
    return data


def need(data, key, path, kind=None, where=""):
    """data[key], checked; `where` names the part of the file."""
    place = f" in {where}" if where else ""
    if not isinstance(data, dict) or key not in data:
        raise InputFault(f"{path} has no key '{key}'{place}.")
    value = data[key]
    if kind is float:
        good = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not good or not math.isfinite(value):
            raise InputFault(f"{path} has {json.dumps(value)} under '{key}'{place}, where a "
                             "finite number is expected.")
    elif kind is not None and not isinstance(value, kind):
        raise InputFault(f"{path} has {json.dumps(value)[:60]} under '{key}'{place}, where "
                         f"{'an object' if kind is dict else 'a ' + kind.__name__} is expected.")
    return value


def listed(data, key, path, kind=list):
    """data[key], checked; an empty list, or an empty value of another type, if it is missing."""
    return kind() if data.get(key) is None else need(data, key, path, kind)


def number_or_none(data, key):
    value = data.get(key)
    good = isinstance(value, (int, float)) and not isinstance(value, bool)
    return float(value) if good and math.isfinite(value) else None


def split_name(name):
    """'scaling_step/strategy:cells/threads:2/real_time' -> family, positions, parameters."""
    parts = name.split("/")
    params = dict(part.split(":", 1) for part in parts[1:] if ":" in part)
    positions = [part for part in parts[1:]
                 if ":" not in part and part not in ("real_time", "manual_time", "process_time")]
    return parts[0], positions, params


def _context(data):
    def text(key):
        value = data.get(key, "")
        return value if isinstance(value, str) else json.dumps(value)

    try:
        cores = int(float(text("dsc_cores") or 0))
    except (ValueError, OverflowError):
        cores = 0
    return Context(text("dsc_machine"), text("dsc_commit"), cores, text("dsc_compiler"),
                   text("dsc_build_type"), text("dsc_load"), text("date"), text("dsc_clock"), text("dsc_binding"))


def scene_context(scene):
    """Where and by which commit a Scene was computed."""
    return _context({f"dsc_{key}": scene.data.get(key, "") for key in ("machine", "commit")})


def read_bench(paths):
    """All measurements of several files, which must come from one machine and one commit."""
    first, measurements, refused = None, {}, []
    for path in paths:
        data = read_json(path)
        context = _context(need(data, "context", path, dict))
        rows = need(data, "benchmarks", path, list)
        if first is None:
            first = (path, context)
        elif (context.machine, context.commit) != (first[1].machine, first[1].commit):
            raise InputFault(f"{path} ({context.machine}, {context.commit}) and {first[0]} "
                             f"({first[1].machine}, {first[1].commit}) are of different machines "
                             "or commits, so their times do not compare.")
        seen = {}
        for index, row in enumerate(rows):
            where = f"benchmark {index}"
            name = need(row, "name", path, str, where)
            where = f"benchmark '{name}'"
            row = {"run_name": name, "time_unit": "ns", **row}
            if row.get("error_occurred"):
                refused.append((name, str(row.get("error_message", ""))))
                continue
            aggregate = row.get("run_type") == "aggregate"
            if aggregate and row.get("aggregate_name") != "median":
                continue
            unit = need(row, "time_unit", path, str, where)
            if unit not in NANOSECONDS:
                raise InputFault(f"{path} has time unit '{unit}' in {where}, where ns, us, ms or "
                                 "s is expected.")
            time = need(row, "real_time", path, float, where) * NANOSECONDS[unit]
            run = need(row, "run_name", path, str, where)
            values = {k: float(v) for k, v in row.items()
                      if k not in NOT_COUNTERS and isinstance(v, (int, float))
                      and not isinstance(v, bool)}
            seen.setdefault(run, {}).setdefault(aggregate, []).append((time, values))
        for run, kinds in seen.items():
            if run not in measurements:
                measurements[run] = Measurement(run, *split_name(run))
            target = measurements[run]
            # Aggregates are used only if the repetitions were not written.
            for time, values in kinds.get(False) or kinds[True]:
                target.times_ns.append(time)
                for key, value in values.items():
                    target.counters.setdefault(key, []).append(value)
    context = first[1] if first else Context()
    # What the file's head says was read before the first measurement.
    loads = [load for one in measurements.values() for load in one.counters.get("load", [])]
    if loads:
        context = replace(context, load=f"{statistics.median(loads):.2f}")
    return Bench(context, list(measurements.values()), refused)


@dataclass
class Histogram:
    scene: str
    strategy: str
    quantity: str
    edges: list
    counts: list


def _histogram(data, path, scene, strategy, quantity):
    where = f"the {quantity} histogram of {scene} ({strategy})"
    edges = need(data, "edges", path, list, where)
    counts = need(data, "counts", path, list, where)
    try:
        edges, counts = [float(e) for e in edges], [float(c) for c in counts]
    except (TypeError, ValueError) as fault:
        raise InputFault(f"{path} has something other than numbers in {where}.") from fault
    if len(edges) != len(counts) + 1 or any(b <= a for a, b in zip(edges, edges[1:])):
        raise InputFault(f"{path} has {len(edges)} edges and {len(counts)} counts in {where}, "
                         "where rising edges, one more than counts, are expected.")
    return Histogram(scene, strategy, quantity, edges, counts)


@dataclass
class Scene:
    path: str
    name: str
    strategy: str
    data: dict
    histograms: list

    def value(self, key):
        return number_or_none(self.data, key)

    def parameter(self, key):
        """A parameter as a number, or as its text, or None."""
        value = self.data["parameters"].get(key)
        try:
            return float(value)
        except (TypeError, ValueError):
            return value

    @property
    def context(self):
        return context_of(self.data)


def read_scene(path):
    data = read_json(path)
    name = need(data, "scene", path, str)
    need(data, "parameters", path, dict)
    strategy = need(data, "strategy", path, str)
    for key in ("triangles_last", "area_ratio"):
        need(data, key, path)
    shapes = listed(data, "histograms", path, dict)
    histograms = [_histogram(shapes[q], path, name, strategy, q) for q in sorted(shapes)]
    return Scene(path, name, strategy, data, histograms)


@dataclass
class Verify:
    context: Context
    checks: list
    histograms: list
    not_run: list  # checks of the gate that were not requested: {check, description, scenes}


def passed(check):
    return str(check["verdict"]).lower() in ("pass", "passed", "ok")


def read_verify(paths):
    """Checks and histograms of several reports of dsc_verify."""
    checks, histograms, not_run, context = [], [], {}, Context()
    for path in paths:
        data = read_json(path)
        context = context_of(data)
        for index, check in enumerate(need(data, "checks", path, list)):
            for key in ("check", "scene", "verdict"):
                need(check, key, path, str, f"check {index}")
            for key in ("measured", "limit"):
                need(check, key, path, None, f"check '{check['check']}'")
            checks.append(check)
        for index, item in enumerate(listed(data, "histograms", path)):
            words = [need(item, key, path, str, f"histogram {index}")
                     for key in ("scene", "strategy", "quantity")]
            histograms.append(_histogram(item, path, *words))
        for index, check in enumerate(listed(data, "not_run", path)):
            not_run[need(check, "check", path, str, f"entry {index} of 'not_run'")] = check
            listed(check, "scenes", path)
    ran = {check["check"] for check in checks}
    return Verify(context, checks, histograms,
                  [check for name, check in not_run.items() if name not in ran])


def read_published(folder):
    """{file stem: data} of the published figures; each entry must name its source and kind."""
    if not os.path.isdir(folder):
        raise InputFault(f"{folder} is not a folder of published figures.")
    published = {}
    for name in sorted(os.listdir(folder)):
        if not name.endswith(".json"):
            continue
        path = os.path.join(folder, name)
        data = read_json(path)
        need(data, "about", path, str)
        for identifier, entry in need(data, "entries", path, dict).items():
            where = f"entry '{identifier}'"
            for key in ("what", "source"):
                need(entry, key, path, str, where)
            if need(entry, "kind", path, str, where) not in ("thesis", "published", "measured"):
                raise InputFault(f"{path} has kind '{entry['kind']}' in {where}, where thesis, "
                                 "published or measured is expected.")
            if "value" not in entry and "values" not in entry:
                raise InputFault(f"{path} has neither 'value' nor 'values' in {where}.")
            need(entry, "unit", path, None, where)
        published[name[:-5]] = data
    return published


def entry(published, file, identifier):
    """An entry of the published figures, or None if it is missing."""
    return published.get(file, {}).get("entries", {}).get(identifier)


def values(published, file, identifier):
    """The values of such an entry; empty if it is missing."""
    return (entry(published, file, identifier) or {}).get("values", [])

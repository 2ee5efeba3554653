# SPDX-License-Identifier: MIT
"""Reads result files into plain records. What is wrong with a bad file is said in one sentence.

Google Benchmark's JSON (a name is FAMILY/key:value/...; unknown parts are ignored), the JSON of
dsc_scene and dsc_verify, the published figures, frames in VTK's XML, and the submeshes beside them.
"""
import json
import math
import os
import re
import statistics
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field

import numpy


class InputFault(Exception):
    """A result file that cannot be used; its text is one sentence for the user."""


@dataclass(frozen=True)
class Context:
    machine: str = ""
    commit: str = ""
    cores: int = 0
    compiler: str = ""
    build_type: str = ""
    load: str = ""
    date: str = ""


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
        """Microseconds per step, one value a repetition: the counter, or the time itself."""
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


def read_json(path):
    """The JSON object in a file."""
    try:
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
    except (OSError, UnicodeDecodeError) as fault:
        reason = getattr(fault, "strerror", None) or "it is not text"
        raise InputFault(f"{path} cannot be read: {reason}.") from fault
    try:
        data = json.loads(text)
    except json.JSONDecodeError as fault:
        raise InputFault(f"{path} is not whole JSON (line {fault.lineno}, column {fault.colno}: "
                         f"{fault.msg}), so it may be truncated.") from fault
    if not isinstance(data, dict):
        raise InputFault(f"{path} holds a JSON {type(data).__name__} where an object is expected.")
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
    except ValueError:
        cores = 0
    return Context(text("dsc_machine"), text("dsc_commit"), cores, text("dsc_compiler"),
                   text("dsc_build_type"), text("dsc_load"), text("date"))


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
            if row.get("error_occurred"):
                refused.append((name, str(row.get("error_message", ""))))
                continue
            aggregate = row.get("run_type") == "aggregate"
            if aggregate and row.get("aggregate_name") != "median":
                continue
            unit = row.get("time_unit", "ns")
            if unit not in NANOSECONDS:
                raise InputFault(f"{path} has time unit '{unit}' in {where}, where ns, us, ms or "
                                 "s is expected.")
            time = need(row, "real_time", path, float, where) * NANOSECONDS[unit]
            run = row.get("run_name", name)
            values = {k: float(v) for k, v in row.items()
                      if k not in NOT_COUNTERS and isinstance(v, (int, float))
                      and not isinstance(v, bool)}
            seen.setdefault(run, {}).setdefault(aggregate, []).append((time, values))
        for run, kinds in seen.items():
            if run not in measurements:
                measurements[run] = Measurement(run, *split_name(run))
            target = measurements[run]
            # The aggregate serves only where the repetitions themselves were not written.
            for time, values in kinds.get(False) or kinds[True]:
                target.times_ns.append(time)
                for key, value in values.items():
                    target.counters.setdefault(key, []).append(value)
    return Bench(first[1] if first else Context(), list(measurements.values()), refused)


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
        return Context(machine=str(self.data.get("machine") or ""),
                       commit=str(self.data.get("commit") or ""))


def read_scene(path):
    data = read_json(path)
    name = need(data, "scene", path, str)
    need(data, "parameters", path, dict)
    strategy = need(data, "strategy", path, str)
    for key in ("triangles_last", "area_ratio"):
        need(data, key, path)
    shapes = data.get("histograms") or {}
    if not isinstance(shapes, dict):
        raise InputFault(f"{path} has histograms that are not an object of quantities.")
    histograms = [_histogram(shapes[q], path, name, strategy, q) for q in sorted(shapes)]
    return Scene(path, name, strategy, data, histograms)


@dataclass
class Verify:
    context: Context
    checks: list
    histograms: list


def read_verify(paths):
    """Checks and histograms of several reports of dsc_verify."""
    checks, histograms, context = [], [], Context()
    for path in paths:
        data = read_json(path)
        context = Context(machine=str(data.get("machine") or ""),
                          commit=str(data.get("commit") or ""))
        for index, check in enumerate(need(data, "checks", path, list)):
            for key in ("check", "verdict"):
                need(check, key, path, str, f"check {index}")
            for key in ("scene", "measured", "limit"):
                need(check, key, path, None, f"check '{check['check']}'")
            checks.append(check)
        for index, item in enumerate(data.get("histograms") or []):
            words = [need(item, key, path, str, f"histogram {index}")
                     for key in ("scene", "strategy", "quantity")]
            histograms.append(_histogram(item, path, *words))
    return Verify(context, checks, histograms)


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
    """An entry of the published figures, or None where it is missing."""
    return published.get(file, {}).get("entries", {}).get(identifier)


@dataclass
class Frame:
    points: numpy.ndarray     # n x 2
    triangles: numpy.ndarray  # m x 3
    phases: numpy.ndarray     # m


FRAME_NAME = re.compile(r"^(?P<scene>.+)_(?P<strategy>[^_]+)_(?P<number>\d+)\.vtu$")


def frame_files(folder):
    """{(scene, strategy): [(number, time or None, path), ...] in order} of a folder of frames."""
    if not os.path.isdir(folder):
        raise InputFault(f"{folder} is not a folder of frames.")
    times, sequences = {}, {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if name.endswith(".pvd"):
            for item in _xml(path).iter("DataSet"):
                try:
                    times[os.path.basename(item.get("file", ""))] = float(item.get("timestep"))
                except (TypeError, ValueError) as fault:
                    raise InputFault(f"{path} has a data set without a number as its "
                                     "timestep.") from fault
            continue
        match = FRAME_NAME.match(name)
        if match:
            sequences.setdefault((match["scene"], match["strategy"]), []).append(
                (int(match["number"]), name))
    return {key: [(number, times.get(name), os.path.join(folder, name))
                  for number, name in sorted(files)] for key, files in sequences.items()}


def _xml(path):
    try:
        return xml.parse(path).getroot()
    except OSError as fault:
        raise InputFault(f"{path} cannot be read: {fault.strerror}.") from fault
    except xml.ParseError as fault:
        raise InputFault(f"{path} is not whole XML ({fault}), so it may be truncated.") from fault


def read_frame(path):
    """Points, triangles and phases of one VTU file (ascii, triangles only)."""
    root = _xml(path)

    def array(place, name, kind):
        found = [a for a in root.findall(f".//{place}/DataArray")
                 if name is None or a.get("Name") == name]
        if not found:
            raise InputFault(f"{path} has no data array '{name or 'of points'}' in {place}.")
        if found[0].get("format", "ascii") != "ascii":
            raise InputFault(f"{path} holds {found[0].get('format')} data in {place}, where ascii "
                             "is expected.")
        try:
            return numpy.array((found[0].text or "").split(), dtype=float).astype(kind)
        except ValueError as fault:
            raise InputFault(f"{path} holds something other than numbers in {place}.") from fault

    points = array("Points", None, float)
    corners = array("Cells", "connectivity", int)
    phases = array("CellData", "phase", int)
    kinds = array("Cells", "types", int)
    if len(points) % 3 or len(corners) != 3 * len(phases) or len(kinds) != len(phases) \
            or (kinds != 5).any():
        raise InputFault(f"{path} does not hold triangles with one phase each: {len(points)} "
                         f"coordinates, {len(corners)} corners, {len(phases)} phases.")
    count = len(points) // 3
    if len(corners) and (corners.min() < 0 or corners.max() >= count):
        raise InputFault(f"{path} names a vertex outside 0 to {count - 1}.")
    return Frame(points.reshape(-1, 3)[:, :2], corners.reshape(-1, 3), phases)


@dataclass
class Region:
    """Where a submesh owns the vertices: low <= u < high and side_low <= w < side_high, with
    u = nx x + ny y and w = nx y - ny x; low > high: u >= low or u < high."""

    kind: str       # "box" or "whole"
    normal: tuple   # of length 1
    low: float
    high: float
    side_low: float
    side_high: float
    work_us: float  # measured


SUBMESHES = ".submeshes.json"


def read_submeshes(path):
    """The colours of a partition, each a list of regions."""
    colours = []
    for c, colour in enumerate(need(read_json(path), "colours", path, list)):
        regions = need(colour, "regions", path, list, f"colour {c}")
        colours.append([_region(item, path, f"region {r} of colour {c}")
                        for r, item in enumerate(regions)])
    if not any(colours):
        raise InputFault(f"{path} has no region.")
    return colours


def _region(data, path, where):
    kind = need(data, "kind", path, str, where)
    work = need(data, "work_us", path, float, where)
    if kind == "whole":
        return Region(kind, (1.0, 0.0), -math.inf, math.inf, -math.inf, math.inf, work)
    if kind != "box":
        raise InputFault(f"{path} has kind '{kind}' in {where}, where box or whole is expected.")
    normal = need(data, "normal", path, list, where)
    if len(normal) != 2 or not all(isinstance(v, (int, float)) for v in normal) \
            or abs(math.hypot(*normal) - 1) > 1e-3:
        raise InputFault(f"{path} has normal {json.dumps(normal)[:60]} in {where}, where two "
                         "numbers, a vector of length 1, are expected.")

    def bound(key, infinite):
        if need(data, key, path, None, where) is None:
            return infinite
        return float(need(data, key, path, float, where))

    return Region(kind, tuple(normal), bound("low", -math.inf), bound("high", math.inf),
                  bound("side_low", -math.inf), bound("side_high", math.inf), work)

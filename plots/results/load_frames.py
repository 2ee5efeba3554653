# SPDX-License-Identifier: MIT
"""Reads frames in VTK's XML, and the submeshes beside them, into plain records."""
import json
import math
import os
import re
import xml.etree.ElementTree as xml
from dataclasses import dataclass

import numpy

from results.load import InputFault, need, read_json
from results.vtk_arrays import read_array


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
    """Points, triangles and phases of one VTU file (triangles only)."""
    root = _xml(path)

    def array(place, name, kind):
        found = [a for a in root.findall(f".//{place}/DataArray")
                 if name is None or a.get("Name") == name]
        if not found:
            raise InputFault(f"{path} has no data array '{name or 'of points'}' in {place}.")
        try:
            return read_array(root, found[0]).astype(kind)
        except ValueError as fault:
            raise InputFault(f"{path} holds {fault} in {place}.") from fault

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
class Event:
    """A change of the topology."""

    kind: str
    time: float
    x: float
    y: float


EVENTS = ".events.jsonl"


def read_events(path):
    """The events of a run, in order; none if there is no such file."""
    if not os.path.exists(path):
        return []
    events = []
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError as fault:
        raise InputFault(f"{path} cannot be read: {fault.strerror}.") from fault
    for number, line in enumerate(lines, 1):
        try:
            data = json.loads(line)
        except ValueError as fault:
            raise InputFault(f"{path} has no JSON in line {number}, so it may be "
                             "truncated.") from fault
        where = f"line {number}"
        events.append(Event(need(data, "kind", path, str, where),
                            *(float(need(data, key, path, float, where))
                              for key in ("time", "x", "y"))))
    return events


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

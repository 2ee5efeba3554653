# SPDX-License-Identifier: MIT
"""Reads frames (VTK's XML, by meshio), the submeshes beside them and the events of a run, into plain
records."""
import json
import math
import os
import re
import sys
import xml.etree.ElementTree as xml
from dataclasses import dataclass

import numpy

from results.load import InputFault, need, read_json, read_text

FRAME_NAME = re.compile(r"^(?P<scene>.+)_(?P<strategy>[^_]+)_(?P<number>\d+)\.vtu$")


def frame_files(folder):
    """{(scene, strategy): [(number, time or None, path), ...] in order} of a folder of frames."""
    if not os.path.isdir(folder):
        raise InputFault(f"{folder} is not a folder of frames.")
    times, sequences = {}, {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if name.endswith(".pvd"):
            try:
                for item in xml.parse(path).iter("DataSet"):
                    times[os.path.basename(item.get("file", ""))] = float(item.get("timestep"))
            except (OSError, xml.ParseError, TypeError, ValueError) as fault:
                raise InputFault(f"{path} is not a whole list of frames ({fault}).") from fault
            continue
        match = FRAME_NAME.match(name)
        if match:
            sequences.setdefault((match["scene"], match["strategy"]), []).append(
                (int(match["number"]), name))
    return {key: [(number, times.get(name), os.path.join(folder, name))
                  for number, name in sorted(files)] for key, files in sequences.items()}


@dataclass
class Frame:
    """A mesh at one time."""

    points: numpy.ndarray     # n x 2
    triangles: numpy.ndarray  # m x 3, vertex numbers
    phases: numpy.ndarray     # m
    at_vertices: dict         # {name: n numbers, or n x 2}

    def box(self):
        """The lowest and the highest corner."""
        return self.points.min(axis=0), self.points.max(axis=0)


def read_frame(path):
    """The Frame in one VTU file (triangles only)."""
    try:
        import meshio
    except ImportError as fault:
        raise InputFault(f"{sys.executable} has no meshio, which reads frames (Debian: package "
                         "python3-meshio and /usr/bin/python3).") from fault
    try:
        mesh = meshio.vtu.read(path)
    except OSError as fault:
        raise InputFault(f"{path} cannot be read: {fault.strerror}.") from fault
    except Exception as fault:  # of many kinds, because files can be broken in many ways
        raise InputFault(f"{path} is not a whole VTU file ({type(fault).__name__}: "
                         f"{' '.join(str(fault).split())}), so it may be truncated.") from fault
    kinds = {block.type for block in mesh.cells}
    if kinds != {"triangle"} or "phase" not in mesh.cell_data:
        raise InputFault(f"{path} has cells of {', '.join(sorted(kinds)) or 'no kind'} and the data "
                         f"{', '.join(mesh.cell_data) or 'nothing'}, where triangles with 'phase' are "
                         "expected.")
    triangles = mesh.cells[0].data.astype(int)
    if not 0 <= triangles.min() <= triangles.max() < len(mesh.points):
        raise InputFault(f"{path} has a triangle whose vertex is outside 0 to {len(mesh.points) - 1}.")
    return Frame(mesh.points[:, :2].astype(float), triangles,
                 mesh.cell_data["phase"][0].astype(int).ravel(),
                 {name: numbers[:, :2] if numbers.ndim > 1 else numbers
                  for name, numbers in mesh.point_data.items()})


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
    events, lines = [], read_text(path).splitlines()
    for number, line in enumerate(lines, 1):
        try:
            data = json.loads(line)
        except (ValueError, RecursionError) as fault:
            raise InputFault(f"{path} has no JSON in line {number}, so it may be "
                             "truncated.") from fault
        where = f"line {number}"
        events.append(Event(need(data, "kind", path, str, where),
                            *(float(need(data, key, path, float, where))
                              for key in ("time", "x", "y"))))
    return events


@dataclass
class Region:
    """The region of the vertices of a submesh: low <= u < high and side_low <= w < side_high, with
    u = nx x + ny y and w = nx y - ny x; if low > high: u >= low or u < high."""

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

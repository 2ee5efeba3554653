# SPDX-License-Identifier: MIT
"""Runs of dsc_precision as lines of points, with those of other programs, and the arithmetic of
the pictures and their sentences."""
import math
from dataclasses import dataclass, field

import numpy

from look import style
from results import load

DEFAULT = "default"
# Flows in the order of the page, and methods in that of legends; others follow by name.
FLOWS = ["single-vortex-8", "single-vortex-2", "swirl-260", "swirl-420", "zalesak",
         "vortex-square"]
GROUPS = ["default", "time", "remeshing", "other", "markers"]
METHODS = ["euler", "centred", "midpoint", "adaptive", "linear insertion", "coarsening by length",
           "never coarsened", "fourth order", "fourth order, coarsened", "float",
           "thesis's choice", "literal reference",
           "markers, linear", "markers, cubic", "markers, cubic, all kept",
           "markers, read as cubic, all kept"]


@dataclass
class Run:
    """One method in one flow with one edge length; errors are relative to the first area."""

    flow: str
    title: str
    method: str
    group: str
    h: float
    error: float        # symmetric difference at the end
    half: float         # half-way, or None if the flow does not turn back
    seconds: float      # CPU
    holds: bool         # no triangle inverted, all vertices arrived, not given up
    context: load.Context

    def at(self, moment):
        return self.half if moment == "half" else self.error


def read(path):
    data = load.read_json(path)
    words = [load.need(data, key, path, str) for key in ("flow", "flow_title", "method", "group")]
    parameters = load.need(data, "parameters", path, dict)
    numbers = [load.need(data, key, path, float) for key in ("sd_rel_last", "cpu_s")]
    h = load.need(parameters, "h", path, float, "the parameters")
    for name, value in (("h", h), ("cpu_s", numbers[1])):
        if value <= 0:
            raise load.InputFault(f"{path} has {value:g} under '{name}', where a positive number "
                                  "is expected.")
    bad = sum(load.number_or_none(data, key) or 0 for key in ("inverted", "unreached"))
    return Run(*words, h, numbers[0], load.number_or_none(data, "sd_rel_half"), numbers[1],
               bad == 0 and not data.get("gave_up"), load.context_of(data))


def flows(runs):
    """{flow: {method: [Run from coarse to fine]}} in the order of the page."""
    found = {}
    for run in runs:
        found.setdefault(run.flow, {}).setdefault(run.method, []).append(run)
    result = {}
    for flow in sorted(found, key=lambda flow: style.order(flow, FLOWS)):
        lines = {m: sorted(line, key=lambda r: -r.h) for m, line in found[flow].items()}
        result[flow] = dict(sorted(lines.items(), key=lambda pair: (
            style.order(pair[1][0].group, GROUPS), style.order(pair[0], METHODS))))
    return result


def length(h):
    """0.0078125 -> '1/128'; 0.01 -> '0.01': the shorter exact form."""
    inverse = round(1 / h)
    if float(f"{h:.2g}") != h and abs(inverse * h - 1) < 1e-9:
        return f"1/{inverse}"
    return f"{h:g}"


def points(line, moment="last"):
    """[(error, seconds, run)] with positive values, for a logarithmic plot."""
    return [(r.at(moment), r.seconds, r) for r in line if r.at(moment) and r.at(moment) > 0]


def time_at(line, error, moment="last"):
    """The CPU time in seconds at which a line crosses an error, interpolated linearly in
    logarithms; the shortest if it crosses several times, None if it has no points on both sides."""
    found = []
    placed = points(line, moment)
    for (e, t, _), (f, u, _) in zip(placed, placed[1:]):
        if min(e, f) <= error <= max(e, f) and e != f:
            part = math.log(error / e) / math.log(f / e)
            found.append(t * (u / t) ** part)
    return min(found, default=None)


@dataclass(frozen=True)
class Order:
    """The fitted order of convergence and the range of orders between neighbouring sizes."""

    fitted: float
    low: float
    high: float
    sizes: int

    def __str__(self):
        return f"{self.fitted:.1f} ({self.low:.1f} to {self.high:.1f})"


def order(line, moment="last"):
    """Least squares in logarithms over at least four sizes; None for fewer."""
    placed = [(math.log(r.h), math.log(e)) for e, _, r in points(line, moment)]
    if len(placed) < 4:
        return None
    local = [(f - e) / (k - h) for (h, e), (k, f) in zip(placed, placed[1:])]
    slope = numpy.polyfit(*zip(*placed), 1)[0]
    return Order(float(slope), min(local), max(local), len(placed))


@dataclass
class Peer:
    """Another program: points with a time, at the end of the flow."""

    tool: str
    is_measured: bool = True  # by this project, not taken from publications
    points: list = field(default_factory=list)  # (relative error, seconds)


@dataclass(frozen=True)
class Mark:
    """Errors without a known time."""

    label: str
    errors: tuple


def peers(flow, published):
    """The other programs in a flow, as Peers."""
    found = {}

    def add(tool, error, seconds, is_measured=True):
        if error and seconds:
            found.setdefault(tool, Peer(tool, is_measured)).points.append((error, seconds))

    scene, _, size = flow.rpartition("-") if flow[-1:].isdigit() else (flow, "", "")
    for v in load.values(published, "peers", "official_dsc_scenes"):
        theirs = str(v.get("steps_each_way", f"{v['period']:g}" if "period" in v else ""))
        if v["scene"] == scene and theirs == size:
            add("official 2D DSC", v.get("sd_rel"), v["seconds"])
    area = published.get("single_vortex", {}).get("area_exact")
    if scene == "single-vortex" and area:
        for tool, identifier in (("Basilisk", "basilisk"), ("isoAdvector", "iso_advector"),
                                 ("Gerris", "gerris")):
            for v in load.values(published, "single_vortex", identifier):
                if f"{v['period']:g}" == size:
                    add(tool, v["e1"] / area, v["seconds"])
        for v in load.values(published, "single_vortex", "level_set_leia"):
            if f"{v['period']:g}" == size:
                add("level set 512²", v["error"] / area, v["seconds"], False)
    if flow == "zalesak":
        for v in load.values(published, "zalesak", "basilisk"):
            add("Basilisk", v["l1_rel"], v["seconds"])
    for peer in found.values():
        peer.points.sort(reverse=True)
    return list(found.values())


def marks(flow, published):
    """Published errors without a time; the thesis states only areas, and the symmetric difference is at
    least the change of area."""
    result = []
    area = published.get("single_vortex", {}).get("area_exact")
    if flow == "single-vortex-8" and area:
        finest = [v["e1"] / area for k in ("rider_kothe_puckett", "stream_puckett",
                                           "emfpa_puckett", "thinc_qq")
                  for v in load.values(published, "single_vortex", k) if v["N"] == 128]
        if finest:
            result.append(Mark("volume of fluid 128²", tuple(finest)))
        tracked = [v["sd"] / area
                   for v in load.values(published, "single_vortex", "front_tracking_jl")]
        if tracked:
            result.append(Mark("FrontTrackingMethods.jl", tuple(tracked)))
    if flow == "zalesak":
        found = [load.entry(published, "zalesak", k) for k in ("emfpa_sir", "youngs", "slic")]
        if any(found):
            result.append(Mark("volume of fluid 200²", tuple(e["value"] for e in found if e)))
    thesis = {"swirl-260": "swirl_260_area_ratio", "swirl-420": "swirl_420_area_ratio",
              "vortex-square": "vortex_area_ratio"}.get(flow)
    found = load.entry(published, "thesis", thesis) if thesis else None
    if found:
        result.append(Mark("thesis, at least (area alone)", (abs(1 - found["value"]),)))
    return result

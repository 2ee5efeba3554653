# SPDX-License-Identifier: MIT
"""Work against precision: the error of a reversed or periodic scene on x, the CPU time on y, a
line for each method and a point for each edge length, with other programs beside ours."""
import math

from matplotlib.ticker import FuncFormatter, NullFormatter

import load
import series
import style

PEER_MARKERS = {"official 2D DSC": "*", "Basilisk": "p", "isoAdvector": "<", "Gerris": "d",
                "bare markers, linear": "1", "bare markers, cubic": "2"}


def runs(scenes):
    """{scene: {label: [Scene]}} of the runs that state both an error and a CPU time."""
    result = {}
    for scene in scenes:
        error, time = scene.value("sd_rel_last"), scene.value("cpu_s")
        if error is None or time is None or error <= 0 or time <= 0:
            continue
        words = [str(scene.parameter(k)) for k in ("integrator", "insertion")
                 if scene.parameter(k) is not None]
        label = scene.strategy + (f" ({', '.join(words)})" if words else "")
        name = scene.name + group_of(scene)
        result.setdefault(name, {}).setdefault(label, []).append(scene)
    return {name: {label: sorted(line, key=lambda s: s.value("cpu_s"))
                   for label, line in series.by_label(
                       [(l, s) for l, ss in lines.items() for s in ss], lambda p: p[0]).items()
                   for line in [[s for _, s in line]]}
            for name, lines in sorted(result.items())}


def group_of(scene):
    """Runs of different lengths are not compared: the steps each way or the period."""
    if scene.name == "swirl" and isinstance(scene.parameter("steps"), float):
        return f", 2 x {scene.parameter('steps'):g}"
    if scene.name == "single-vortex" and isinstance(scene.parameter("period"), float):
        return f", T = {scene.parameter('period'):g}"
    return ""


def peers(name, published):
    """[(tool, [(relative error, seconds)])] for a group of runs."""
    scene, _, length = name.partition(", ")
    length = length.split(" ")[-1]
    result = {}
    official = load.entry(published, "peers", "official_dsc_scenes")
    for v in (official or {"values": []})["values"]:
        mine = str(v.get("steps_each_way", f"{v['period']:g}" if "period" in v else ""))
        if v["scene"] == scene and mine == length and v.get("sd_rel"):
            result.setdefault("official 2D DSC", []).append((v["sd_rel"], v["seconds"]))
    if scene != "single-vortex":
        return sorted(result.items())
    area = published.get("single_vortex", {}).get("area_exact")
    for tool, identifier in (("Basilisk", "basilisk"), ("isoAdvector", "iso_advector"),
                             ("Gerris", "gerris")):
        found = load.entry(published, "single_vortex", identifier)
        for v in (found or {"values": []})["values"]:
            if area and f"{v['period']:g}" == length:
                result.setdefault(tool, []).append((v["e1"] / area, v["seconds"]))
    for kind in ("linear", "cubic"):
        found = load.entry(published, "marker_floor", f"{kind}_insertion")
        if found and area and length == "8":
            result[f"bare markers, {kind}"] = [(v["sd"] / area, v["seconds"])
                                               for v in found["values"]]
    return list(result.items())


def sentence(name, lines, theirs):
    ours = [(label, s) for label, line in lines.items() for s in line]
    label, best = min(ours, key=lambda pair: pair[1].value("sd_rel_last"))
    error, time = best.value("sd_rel_last"), best.value("cpu_s")
    h = best.parameter("h")
    text = (f"In {name} the smallest error is {style.digits(error)} ({label}"
            + (f", h = {h:g}" if isinstance(h, float) else "")
            + f") after {style.digits(time)} CPU s")
    meshes = [(e, t, tool) for tool, line in theirs for e, t in line
              if not tool.startswith("bare")]
    if meshes:
        e, t, tool = min(meshes)
        text += (f"; the most precise of the other programs, {tool}, has {style.digits(e)} after "
                 f"{style.digits(t)} CPU s")
        beaten = sum(any(s.value("sd_rel_last") < e and s.value("cpu_s") < t for _, s in ours)
                     for e, t, _ in meshes)
        text += (f"; {beaten} of their {len(meshes)} points are beaten in error and in time by "
                 "one of ours")
    return text + "."


def draw(scenes, published):
    """One Picture with a panel for each group of runs."""
    found = runs(scenes)
    pictures = []
    for name, lines in found.items():
        theirs = peers(name, published)
        if sum(len(line) for line in lines.values()) + len(theirs) > 1:
            pictures.append(_one(name, lines, theirs))
    return pictures


def _one(name, lines, theirs):
    fig, grid = style.figure(7.2, 5.0)
    axes = grid[0][0]
    looks = series.looks(lines)
    named = []  # where a point already has its edge length written beside it
    for tool, line in theirs:
        axes.plot(*zip(*sorted(line)), color=style.MUTED, linewidth=0.9, linestyle=(0, (1, 1.5)),
                  zorder=2, **style.other(PEER_MARKERS.get(tool, "p")))
    for label, line in lines.items():
        colour, marker = looks[label]
        errors = [s.value("sd_rel_last") for s in line]
        times = [s.value("cpu_s") for s in line]
        axes.plot(errors, times, color=colour, marker=marker, zorder=3, **style.solid(colour))
        for scene, x, y in zip(line, errors, times):
            h = scene.parameter("h")
            place = (math.log10(x), math.log10(y))
            if isinstance(h, float) and all(math.dist(place, p) > 0.15 for p in named):
                named.append(place)
                axes.annotate(f"h = {h:g}", (x, y), (7, 4), textcoords="offset points",
                              fontsize=7.2, color=style.MUTED)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(0.09)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g} s"))
    axes.set_xlabel("error: symmetric difference over the first area  (left is better)")
    axes.set_ylabel("CPU time  (down is better)")
    handles = [style.key(label, *look) for label, look in looks.items()]
    for tool, _ in theirs:
        handles.append(style.key(tool, style.MUTED, line=(0, (1, 1.5)), width=0.9,
                                 marks=style.other(PEER_MARKERS.get(tool, "p"))))
    first = next(iter(lines.values()))[0]
    notes = "Grey: measured on other programs" + (
        "; E1 over the area for Basilisk, isoAdvector and Gerris, which is at most the "
        "symmetric difference." if any(t in ("Basilisk", "Gerris", "isoAdvector")
                                       for t, _ in theirs) else ".")
    title = f"Error against time: {name}"
    style.finish(fig, title, style.caption_text(first.context, notes if theirs else ""), handles)
    stem = "".join(c if c.isalnum() or c == "-" else "_" for c in name)
    return style.Picture(f"precision_{stem}", title, sentence(name, lines, theirs), fig)

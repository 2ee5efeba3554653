#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws meshes: first, middle and last frame of each run, triangles coloured by phase, the interface
(edges between two phases) bold; a close-up below each large mesh.

frames.py FOLDER... --out PICTURE.png

A folder is one of `dsc_scene run --frames FOLDER`.
"""
import os
import sys

from look import script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import Rectangle

from results import load_frames

CLOSE_UP = 6_000  # from this many triangles on, a second row shows about CLOSE_COUNT of them
CLOSE_COUNT = 500
MANY = 8  # more phases than this have no names in the legend
EVENT_MARKS = {"merge": "o", "meet": "P", "split": "X", "t1": "D", "fill": "v", "remove": "s",
               "widen": "."}


def picked(files):
    """First, middle and last of a sequence; fewer if it is short."""
    last = len(files) - 1
    return [files[index] for index in sorted({0, last // 2 if last > 1 else 0, last})]


def interface(frame):
    """Edges (k x 2 vertex numbers) whose two triangles are of different phases."""
    corners = frame.triangles
    edges = numpy.sort(numpy.concatenate([corners[:, [0, 1]], corners[:, [1, 2]],
                                          corners[:, [2, 0]]]), axis=1)
    phases = numpy.tile(frame.phases, 3)
    place = numpy.lexsort((phases, edges[:, 1], edges[:, 0]))
    edges, phases = edges[place], phases[place]
    same = (edges[1:] == edges[:-1]).all(axis=1) & (phases[1:] != phases[:-1])
    return edges[1:][same]


def triangle_areas(frame):
    a, b, c = (frame.points[frame.triangles[:, k]] for k in range(3))
    return numpy.linalg.det(numpy.stack((b - a, c - a), axis=1)) / 2


def areas(frame):
    """{phase: area} of a mesh."""
    each = triangle_areas(frame)
    return {int(p): float(each[frame.phases == p].sum()) for p in numpy.unique(frame.phases)}


def window(frame, count=CLOSE_COUNT, centre=None):
    """Corners (low, high) of a square with about `count` triangles, inside the domain if the domain is
    large enough; by default at the top of the interface."""
    low, high = frame.box()
    ends = frame.points[interface(frame)].reshape(-1, 2)
    if centre is None:
        centre = ends[ends[:, 1].argmax()] if len(ends) else (low + high) / 2
    near = frame.points[frame.triangles].mean(axis=1)
    reach = numpy.sort(numpy.abs(near - centre).max(axis=1))[min(count, len(near)) - 1]
    # At a side of the domain half of that square would be empty.
    centre = numpy.where(high - low > 2 * reach, numpy.clip(centre, low + reach, high - reach),
                         (low + high) / 2)
    reach = numpy.sort(numpy.abs(near - centre).max(axis=1))[min(count, len(near)) - 1]
    return centre - reach, centre + reach


def centre_of(events):
    """The place where phases first merged or split, or the place of the first event; None without events."""
    first = [e for e in events if e.kind in ("merge", "split", "meet")] or events
    return numpy.array([first[0].x, first[0].y]) if first else None


def mesh(axes, frame, inches, low, high, fills=None, edges=True, line=style.INTERFACE):
    """Draws the part of a mesh in the rectangle between low and high; fills: one colour for each
    triangle instead of that of its phase; line: the colour of the interface."""
    corners = frame.points[frame.triangles]
    inside = ((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)).all(axis=1)
    corners = corners[inside]
    if fills is None:
        fills = numpy.array(style.PHASE_FILLS)[frame.phases % len(style.PHASE_FILLS)]
    # Edges are thinner in panels with more triangles, and not drawn with very many.
    width = min(0.6, 4.5 * inches / max(1.0, len(corners) ** 0.5))
    axes.add_collection(PolyCollection(
        corners, facecolors=fills[inside], edgecolors=style.EDGE if edges and width > 0.02 else "face",
        linewidths=max(width, 0.02)))
    axes.add_collection(LineCollection(frame.points[interface(frame)], colors=line,
                                       linewidths=1.5, capstyle="round", zorder=3))
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", xticks=[], yticks=[])
    for spine in axes.spines.values():
        spine.set_visible(False)


def _grown(first, last):
    """'0.045 % larger'."""
    if abs(last / first - 1) < 5e-6:
        return "the same to 0.001 %"
    if last > 2 * first:
        return f"{style.digits(last / first)} times as large"
    return (f"{style.digits(100 * abs(last / first - 1), 2)} % "
            f"{'larger' if last > first else 'smaller'}")


def plain(scene, shown, events=()):
    moments = {1: "", 2: " at the beginning and at the end",
               3: " at the beginning, half-way and at the end"}[len(shown)]
    text = f"{scene}{moments}, with {style.whole(len(shown[-1][2].triangles))} triangles"
    first, last = areas(shown[0][2]), areas(shown[-1][2])
    phases = [p for p in sorted(first) if p != 0]
    if len(phases) > MANY:
        text += f" and {sum(p in last for p in phases)} of {len(phases)} phases left"
    elif len(phases) == 1 and len(shown) > 1:
        before, after = first[phases[0]], last.get(phases[0], 0.0)
        text += f"; at the end its area is {_grown(before, after)}"
        if abs(after / before - 1) > 0.01:
            text += ", by the flow and by errors together"
    if events:
        text += f"; phases met or parted {style.counted(len(events), 'time')}"
    return text + "."


def read(folder):
    """[(scene, strategy, [(number, time, Frame)], [Event])] of the runs in the folder, one for each
    scene, because other strategies look the same."""
    runs, known = [], set()
    for (scene, strategy), files in sorted(load_frames.frame_files(folder).items(), key=lambda pair: (
            pair[0][0], style.order(pair[0][1]))):
        if scene in known:
            continue
        shown = [(number, time, load_frames.read_frame(path)) for number, time, path in picked(files)]
        shown = [item for item in shown if len(item[2].triangles)]
        if shown:
            known.add(scene)
            events = load_frames.read_events(
                os.path.join(folder, f"{scene}_{strategy}{load_frames.EVENTS}"))
            runs.append((scene, strategy, shown, events))
    return runs


def draw(runs, context=None):
    """A Picture for each run."""
    for scene, strategy, shown, events in runs:
        yield _one(scene, strategy, shown, events, context)


def mark_events(axes, events, low, high):
    """Draws a ring at the place of each event."""
    for kind, marker in EVENT_MARKS.items():
        places = [(e.x, e.y) for e in events if e.kind == kind
                  and low[0] <= e.x <= high[0] and low[1] <= e.y <= high[1]]
        if places:
            axes.scatter(*zip(*places), marker=marker, s=14, facecolors="none",
                         edgecolors=style.INK, linewidths=0.8, zorder=5)


def _handles(shown, events):
    """The phases, unless they are many, the interface, and the kinds of events."""
    phases = sorted({int(p) for _, _, f in shown for p in numpy.unique(f.phases)})
    handles = [style.square(f"phase {p}", style.PHASE_FILLS[p % len(style.PHASE_FILLS)])
               for p in (phases if len(phases) <= MANY else ())]
    for handle in handles:
        handle.set(markeredgecolor=style.EDGE)
    handles.append(style.key("interface", style.INTERFACE, width=1.8))
    kinds = {event.kind for event in events}
    return handles + [style.key(f"{kind}, since the frame before", style.INK, line="none", marks={
        "marker": marker, "markersize": 5, "markerfacecolor": "none", "markeredgecolor": style.INK})
        for kind, marker in EVENT_MARKS.items() if kind in kinds]


def _one(scene, strategy, shown, events, context):
    span = numpy.ptp(shown[0][2].points, axis=0)
    side = 3.1
    tall = side * float(numpy.clip(span[1] / span[0] if span[0] > 0 else 1, 0.3, 1.6))
    near = any(len(f.triangles) >= CLOSE_UP for _, _, f in shown)
    fig, grid = style.figure(
        max(5.0, 0.3 + (side + 0.15) * len(shown)), tall + 1.35 + (side + 0.3) * near, 1 + near,
        len(shown), gridspec_kw={"height_ratios": [tall, side] if near else [1]})
    before = -numpy.inf
    for column, (number, time, frame) in enumerate(shown):
        low, high = frame.box()
        slack = 0.004 * (high - low).max()
        mesh(grid[0][column], frame, side, low - slack, high + slack)
        recent = []
        if time is not None:
            recent = [event for event in events if before < event.time <= time * (1 + 1e-9)]
            mark_events(grid[0][column], recent, low, high)
            before = time
        when = f"frame {number}" + (f", t = {time:.4g}" if time is not None else "")
        grid[0][column].set_title(f"{when}, {style.whole(len(frame.triangles))} triangles",
                                  fontsize=9)
        if near:
            low, high = window(frame, centre=centre_of(recent))
            axes = grid[1][column]
            mesh(axes, frame, side, low, high)
            axes.set_title(f"close-up, {style.digits(high[0] - low[0], 2)} wide", fontsize=9)
            for spine in axes.spines.values():
                spine.set(visible=True, color=style.FAINT)
            grid[0][column].add_patch(Rectangle(low, *(high - low), fill=False, linewidth=0.8,
                                                edgecolor=style.INK, zorder=4))
    style.finish(fig, f"{scene} ({strategy})", style.caption_text(context), _handles(shown, events))
    return style.Picture(f"frames_{scene}_{strategy}", f"{scene} ({strategy})",
                         plain(scene, shown, events), fig, is_mesh=True)


def main(argv=None):
    return script.main(__doc__, lambda given: draw(
        run for folder in given.files for run in read(folder)), argv)


if __name__ == "__main__":
    sys.exit(main())

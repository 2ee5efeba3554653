#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the submeshes on the mesh (thesis, figure 8.1): a panel for each colour, triangles coloured by
the measured work of their submesh.

submeshes.py FOLDER... --out PICTURE.png

A folder is one of `dsc_scene run --frames FOLDER` with several submeshes.
"""
import math
import os
import sys
from dataclasses import dataclass

from look import script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap, Normalize, to_rgba

import frames
from results import load_frames

STRADDLING = "#C3C9CE"
COLUMNS = 3
SIDE = 3.5         # inches of a panel


@dataclass
class Division:
    """A mesh and its division into submeshes."""

    scene: str
    strategy: str
    number: int
    time: object
    frame: object
    colours: list  # of lists of load_frames.Region


def owns(region, points):
    """For each point, whether it lies in the region."""
    if region.kind == "whole":
        return numpy.ones(len(points), dtype=bool)
    nx, ny = region.normal
    u = nx * points[:, 0] + ny * points[:, 1]
    w = nx * points[:, 1] - ny * points[:, 0]
    above, below = u >= region.low, u < region.high
    # A slab may wrap around the ends of the mesh.
    along = above | below if region.low > region.high else above & below
    return along & (w >= region.side_low) & (w < region.side_high)


def owners(regions, frame):
    """For each triangle the region that contains all three vertices, or -1 if it straddles a boundary."""
    owner = numpy.full(len(frame.points), -1)
    for index in reversed(range(len(regions))):  # the first one wins, as in the library
        owner[owns(regions[index], frame.points)] = index
    corner = owner[frame.triangles]
    return numpy.where((corner == corner[:, :1]).all(axis=1), corner[:, 0], -1)


def boundaries(region, limit):
    """Line segments ((x, y), (x, y)) of the region's finite bounds, cut off at `limit`."""
    nx, ny = region.normal

    def at(u, w):
        u, w = max(-limit, min(limit, u)), max(-limit, min(limit, w))
        return nx * u - ny * w, ny * u + nx * w

    low, high = (-limit, limit) if region.low > region.high else (region.low, region.high)
    return [(at(u, region.side_low), at(u, region.side_high)) for u in (region.low, region.high)
            if math.isfinite(u)] + [(at(low, w), at(high, w))
                                    for w in (region.side_low, region.side_high) if math.isfinite(w)]


def length(frame):
    """The length of the interface."""
    ends = frame.points[frames.interface(frame)]
    return float(numpy.hypot(*(ends[:, 1] - ends[:, 0]).T).sum())


def read(folder):
    """A Division for each run in the folder with submeshes beside its frames: the frame with the longest
    interface, which has the most work to divide."""
    result = []
    for (scene, strategy), files in load_frames.frame_files(folder).items():
        found = [(number, time, load_frames.read_frame(path), load_frames.read_submeshes(beside))
                 for number, time, path in files
                 if os.path.exists(beside := os.path.splitext(path)[0] + load_frames.SUBMESHES)]
        found = [item for item in found if len(item[2].triangles)]
        if found:
            result.append(Division(scene, strategy, *max(found, key=lambda item: length(item[2]))))
    return sorted(result, key=lambda d: (d.scene, style.order(d.strategy)))


def plain(division):
    works = [r.work_us for r in division.colours[0]]
    text = f"In {division.scene} the mesh is divided into {_submeshes(division.colours[0])}"
    if len(works) > 1 and sum(works) > 0:
        text += (", of which the one with the most work has "
                 f"{max(works) * len(works) / sum(works):.2f} times the mean work")
    return text + "."


def _submeshes(regions):
    if len(regions) == 1 and regions[0].kind == "whole":
        return "the whole mesh"
    return f"{len(regions)} submesh{'' if len(regions) == 1 else 'es'}"


def draw(divisions, context=None):
    """A Picture for each division."""
    for division in divisions:
        yield _picture(division, context)


def _picture(division, context):
    frame, colours = division.frame, division.colours
    columns = min(len(colours), COLUMNS)
    lines = -(-len(colours) // columns)
    low, high = frame.box()
    tall = SIDE * float(numpy.clip((high[1] - low[1]) / max(high[0] - low[0], 1e-300), 0.4, 1.5))
    fig, grid = style.figure(max(6.4, 1.3 + SIDE * columns), 1.5 + (tall + 0.45) * lines, lines,
                             columns)
    # Pale to dark; neither end is the grey of straddling triangles.
    cmap = ListedColormap(colormaps["YlGnBu"](numpy.linspace(0.06, 0.72, 200)))
    norm = Normalize(0, max([r.work_us for regions in colours for r in regions] + [1e-9]))
    limit = float(4 * (numpy.abs(frame.points).max() + 1))  # beyond all vertices
    for colour, (axes, regions) in enumerate(zip(grid.flat, colours), 1):
        owner = owners(regions, frame)  # -1 is the last shade
        shades = numpy.array([cmap(norm(r.work_us)) for r in regions] + [to_rgba(STRADDLING)])
        frames.mesh(axes, frame, SIDE, low, high, shades[owner])
        axes.add_collection(LineCollection(
            sorted({tuple(sorted(line)) for r in regions for line in boundaries(r, limit)}),
            colors=style.INK, linewidths=0.7, zorder=4))
        axes.set_title(f"colour {colour}: {_submeshes(regions)}, "
                       f"{style.duration(sum(r.work_us for r in regions))}\n"
                       f"{style.counted(int((owner < 0).sum()), 'triangle')} on boundaries",
                       fontsize=9)
    for axes in grid.flat[len(colours):]:
        axes.set_visible(False)
    bar = fig.colorbar(ScalarMappable(norm, cmap), ax=list(grid.flat), shrink=0.7, aspect=28,
                       pad=0.015)
    bar.set_label("measured work of the submesh (µs)")
    bar.outline.set_visible(False)
    title = f"Submeshes: {division.scene} ({division.strategy})"
    when = f", t = {division.time:.4g}" if division.time is not None else ""
    style.finish(fig, title, style.caption_text(
        context, f"Frame {division.number}{when}, which has the longest interface of the frames with "
        f"submeshes; {style.whole(len(frame.triangles))} triangles. A triangle that straddles a "
        "boundary is locked while its colour is processed."),
        [style.key("interface", style.INTERFACE, width=1.8),
         style.square("straddles a boundary: locked", STRADDLING),
         style.key("boundary", style.INK, width=0.9)])
    return style.Picture(f"submeshes_{division.scene}_{division.strategy}", title,
                         plain(division), fig, *_table(division), is_mesh=True)


def _table(division):
    rows = []
    for c, regions in enumerate(division.colours, 1):
        owner, total = owners(regions, division.frame), sum(r.work_us for r in regions)
        rows += [[str(c), str(k + 1), style.whole((owner == k).sum()), style.digits(r.work_us),
                  f"{100 * r.work_us / total:.1f} %" if total > 0 else "–"]
                 for k, r in enumerate(regions)]
        rows.append([str(c), "straddling", style.whole((owner < 0).sum()), "–", "–"])
    return ["colour", "submesh", "triangles", "work µs", "share of colour"], rows


def main(argv=None):
    return script.main(__doc__, lambda given: draw(
        division for folder in given.files for division in read(folder)), argv)


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: MIT
"""The submeshes drawn on the mesh (thesis, figure 8.1): a panel for each colour, triangles coloured
by the measured work of their submesh, and a close-up where two submeshes of the first meet."""
import math
import os
from dataclasses import dataclass

import numpy
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap, Normalize, to_rgba
from matplotlib.patches import Rectangle

from mesh import frames
from results import load
from results import load_frames
from look import style

STRADDLING = "#C3C9CE"
COLUMNS = 3
SIDE = 3.5         # inches of a panel
CLOSE_COUNT = 450  # triangles in the close-up, and at most, to have a boundary of colour 2 in it
CLOSE_MOST = 5000
FIRST, LATER = style.INK, "#A8006D"  # boundaries in the close-up
DASH = (0, (4, 2))


@dataclass
class Division:
    """A mesh and how it was divided."""

    scene: str
    strategy: str
    number: int
    time: object
    frame: object
    colours: list  # of lists of load_frames.Region


def owns(region, points):
    """For each point: whether it lies in the region."""
    if region.kind == "whole":
        return numpy.ones(len(points), dtype=bool)
    nx, ny = region.normal
    u = nx * points[:, 0] + ny * points[:, 1]
    w = nx * points[:, 1] - ny * points[:, 0]
    above, below = u >= region.low, u < region.high
    # A slab may go round the ends of the mesh.
    along = above | below if region.low > region.high else above & below
    return along & (w >= region.side_low) & (w < region.side_high)


def vertex_owners(regions, points):
    """For each vertex the number of its region, -1 where there is none."""
    owner = numpy.full(len(points), -1)
    for index in reversed(range(len(regions))):  # the first one wins, as in the library
        owner[owns(regions[index], points)] = index
    return owner


def owners(regions, frame):
    """For each triangle the region that has all three vertices, or -1: it straddles a boundary."""
    corner = vertex_owners(regions, frame.points)[frame.triangles]
    whole = (corner == corner[:, :1]).all(axis=1)
    return numpy.where(whole, corner[:, 0], -1)


def boundaries(region, limit):
    """Line segments ((x, y), (x, y)) of the region's finite bounds, cut off at `limit`."""
    nx, ny = region.normal

    def cut(value):
        return max(-limit, min(limit, value))

    def at(u, w):
        return nx * u - ny * w, ny * u + nx * w

    low, high = (-limit, limit) if region.low > region.high else (cut(region.low),
                                                                   cut(region.high))
    side = cut(region.side_low), cut(region.side_high)
    lines = [(at(u, side[0]), at(u, side[1])) for u in (region.low, region.high)
             if math.isfinite(u)]
    return lines + [(at(low, w), at(high, w)) for w in (region.side_low, region.side_high)
                    if math.isfinite(w)]


def on_interface(frame):
    """For each triangle whether one of its vertices is on the interface."""
    marked = numpy.zeros(len(frame.points), dtype=bool)
    marked[frames.interface(frame).reshape(-1)] = True
    return marked[frame.triangles].any(axis=1)


def length(frame):
    """The length of the interface."""
    ends = frame.points[frames.interface(frame)]
    return float(numpy.hypot(*(ends[:, 1] - ends[:, 0]).T).sum())


def distances(points, segment):
    """The distances of points from a line segment."""
    start, end = (numpy.array(p) for p in segment)
    along = end - start
    part = ((points - start) @ along / max(along @ along, 1e-300)).clip(0, 1)
    return numpy.hypot(*(points - start - part[:, None] * along).T)


def meeting(division):
    """The place on the interface where two submeshes of the first colour meet that is nearest to a
    boundary of the second colour, and how far that is; (None, 0) if none meet."""
    frame = division.frame
    found = numpy.nonzero((owners(division.colours[0], frame) < 0) & on_interface(frame))[0]
    if not len(found):
        return None, 0.0
    middle = frame.points[frame.triangles[found]].mean(axis=1)
    middle = middle[numpy.lexsort((middle[:, 0], -middle[:, 1]))]  # the topmost first
    lines = [line for r in (division.colours + [[]])[1] for line in boundaries(r, reach(frame))]
    if not lines:
        return middle[0], 0.0
    away = numpy.min([distances(middle, line) for line in lines], axis=0)
    nearest = int(numpy.argmin(numpy.round(away / max(length(frame), 1e-300), 6)))
    return middle[nearest], float(away[nearest])


def window(frame, centre, away):
    """The corners of the close-up, which contains the boundary unless that is too far away."""
    low, high = frames.window(frame, CLOSE_COUNT, centre)
    wide = numpy.array([centre - 1.15 * away, centre + 1.15 * away])
    middle = frame.points[frame.triangles].mean(axis=1)
    inside = ((middle >= wide[0]) & (middle <= wide[1])).all(axis=1).sum()
    low, high = wide if wide[1][0] > high[0] and inside <= CLOSE_MOST else (low, high)
    # Moved back if it would reach beyond the mesh.
    first, last = frame.points.min(axis=0), frame.points.max(axis=0)
    shift = numpy.maximum(first - low, 0) + numpy.minimum(last - high, 0)
    return low + shift, high + shift


def reach(frame):
    """A length beyond all vertices, at which infinite boundaries are cut off."""
    return float(4 * (numpy.abs(frame.points).max() + 1))


def read(folder):
    """A Division for each run in the folder with submeshes beside its frames: of several frames
    the one with the longest interface, where there is most work to divide."""
    result = []
    for (scene, strategy), files in sorted(load_frames.frame_files(folder).items(), key=lambda pair: (
            pair[0][0], style.order(pair[0][1]))):
        best = None
        for number, time, path in files:
            beside = os.path.splitext(path)[0] + load_frames.SUBMESHES
            if not os.path.exists(beside):
                continue
            frame, colours = load_frames.read_frame(path), load_frames.read_submeshes(beside)
            if len(frame.triangles) and (best is None or length(frame) > best[0]):
                best = length(frame), Division(scene, strategy, number, time, frame, colours)
        if best:
            result.append(best[1])
    return result


def draw(divisions, context=None):
    """A Picture for each division."""
    for division in divisions:
        yield _picture(division, context)


def _work_colours():
    """Pale to dark; neither end is the grey of straddling triangles."""
    return ListedColormap(colormaps["YlGnBu"](numpy.linspace(0.06, 0.72, 200)))


def _fills(division, colour, norm, cmap):
    regions = division.colours[colour]
    owner = owners(regions, division.frame)
    shades = numpy.array([cmap(norm(r.work_us)) for r in regions] + [to_rgba(STRADDLING)])
    return shades[owner]  # -1 is the last


def _lines(axes, regions, limit, **look):
    lines = sorted({tuple(sorted(line)) for r in regions for line in boundaries(r, limit)})
    axes.add_collection(LineCollection(lines, **look))


def _whole(axes, division, colour, norm, cmap):
    frame, regions = division.frame, division.colours[colour]
    low, high = frame.points.min(axis=0), frame.points.max(axis=0)
    slack = 0.004 * (high - low).max()
    frames.mesh(axes, frame, SIDE, low - slack, high + slack,
                _fills(division, colour, norm, cmap))
    _lines(axes, regions, reach(frame), colors=style.INK, linewidths=0.7, zorder=4)
    straddling = int((owners(regions, frame) < 0).sum())
    axes.set_title(f"colour {colour + 1}: {_submeshes(regions)}, "
                   f"{style.duration(sum(r.work_us for r in regions))}\n"
                   f"{style.counted(straddling, 'triangle')} "
                   f"{'straddles' if straddling == 1 else 'straddle'}", fontsize=9)


def _submeshes(regions):
    if len(regions) == 1 and regions[0].kind == "whole":
        return "the whole mesh"
    return style.counted(len(regions), "submesh").replace("submeshs", "submeshes")


def _close_up(axes, division, corners, norm, cmap):
    """The close-up around a place where two submeshes meet."""
    frame, (low, high) = division.frame, corners
    frames.mesh(axes, frame, SIDE, low, high, _fills(division, 0, norm, cmap))
    _lines(axes, division.colours[0], reach(frame), colors=FIRST, linewidths=1.4, zorder=4)
    if len(division.colours) > 1:
        _lines(axes, division.colours[1], reach(frame), colors=LATER, linewidths=1.4,
               linestyles=[DASH], zorder=4)
    for spine in axes.spines.values():
        spine.set(visible=True, color=style.MUTED)
    axes.set_title(f"close-up of colour 1, {style.digits(high[0] - low[0], 2)} wide:\n"
                   "where two of its submeshes meet", fontsize=9)


def _picture(division, context):
    frame, colours = division.frame, division.colours
    centre, away = meeting(division)
    panels = len(colours) + (centre is not None)
    columns = min(panels, COLUMNS if panels != 4 else 2)
    lines = -(-panels // columns)
    span = numpy.ptp(frame.points, axis=0)
    tall = SIDE * float(numpy.clip(span[1] / span[0] if span[0] > 0 else 1, 0.4, 1.5))
    fig, grid = style.figure(max(6.4, 1.3 + SIDE * columns), 1.5 + (tall + 0.45) * lines, lines,
                             columns)
    cmap, norm = _work_colours(), Normalize(0, max(
        [r.work_us for regions in colours for r in regions] + [1e-9]))
    for colour in range(len(colours)):
        _whole(grid.flat[colour], division, colour, norm, cmap)
    if centre is not None:
        low, high = window(frame, centre, away)
        _close_up(grid.flat[len(colours)], division, (low, high), norm, cmap)
        grid.flat[0].add_patch(Rectangle(low, *(high - low), fill=False, linewidth=1.1,
                                         edgecolor=LATER, zorder=5))
    for axes in grid.flat[panels:]:
        axes.set_visible(False)
    bar = fig.colorbar(ScalarMappable(norm, cmap), ax=list(grid.flat), shrink=0.7, aspect=28,
                       pad=0.015)
    bar.set_label("measured work of the submesh (µs)")
    bar.outline.set_visible(False)
    name = f"Submeshes: {division.scene} ({division.strategy})"
    style.finish(fig, name, style.caption_text(context, _conditions(division)),
                 _legend(division, centre is not None))
    return style.Picture(f"submeshes_{division.scene}_{division.strategy}", name,
                         plain(division), fig, *_table(division),
                         details=sentence(division), is_mesh=True)


def _conditions(division):
    when = f", t = {division.time:.4g}" if division.time is not None else ""
    return (f"Frame {division.number}{when}, which has the longest interface of the frames with "
            f"submeshes; {style.whole(len(division.frame.triangles))} triangles. A triangle "
            "belongs to a submesh if all three vertices do; one that straddles a boundary is "
            "locked while its colour is at work.")


def _legend(division, near):
    handles = [style.key("interface", style.INTERFACE, width=1.8),
               style.square("straddles a boundary: locked", STRADDLING),
               style.key("boundary", FIRST, width=0.9)]
    if near and len(division.colours) > 1:
        handles.append(style.key("boundary of colour 2 (close-up)", LATER, line=DASH, width=1.4))
    return handles


def plain(division):
    works = [r.work_us for r in division.colours[0]]
    text = f"In {division.scene} the mesh is shared out among {_submeshes(division.colours[0])}"
    if len(works) > 1 and sum(works) > 0:
        text += (", of which the one with most to do has "
                 f"{max(works) * len(works) / sum(works):.2f} times the mean work")
    return text + "."


def sentence(division):
    """Balance and share of the first colour, straddling triangles, work of later colours."""
    first, frame = division.colours[0], division.frame
    works = [r.work_us for r in first]
    total = sum(r.work_us for regions in division.colours for r in regions)
    text = (f"{division.scene} ({division.strategy}), frame {division.number}: the first colour "
            f"has {_submeshes(first)}")
    if len(works) > 1 and sum(works) > 0:
        text += (f" with {style.duration(min(works))} to {style.duration(max(works))} of work, the "
                 f"largest {max(works) * len(works) / sum(works):.2f} times the mean")
    straddling = owners(first, frame) < 0
    there = int((straddling & on_interface(frame)).sum())
    text += (f"; {style.whole(straddling.sum())} of {style.whole(len(frame.triangles))} triangles "
             f"({100 * straddling.mean():.1f} %) straddle its boundaries, {style.whole(there)} of "
             "them at the interface")
    if total > 0 and len(division.colours) > 1:
        later = total - sum(works)
        text += f"; {100 * later / total:.1f} % of the work is left for later colours"
    return text + "."


def _table(division):
    header = ["colour", "submesh", "triangles", "at the interface", "work µs", "share of colour"]
    near, rows = on_interface(division.frame), []
    for c, regions in enumerate(division.colours):
        owner, total = owners(regions, division.frame), sum(r.work_us for r in regions)
        for k, r in list(enumerate(regions)) + [(-1, None)]:
            mine = owner == k
            rows.append([str(c + 1), str(k + 1) if r else "straddling", style.whole(mine.sum()),
                         style.whole((mine & near).sum()), style.digits(r.work_us) if r else "–",
                         f"{100 * r.work_us / total:.1f} %" if r and total > 0 else "–"])
    return header, rows

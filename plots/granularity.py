#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws how much work a step needs for threads to pay off: S(n) / n against the time of the sequential step.

granularity.py FILE.json... --out PICTURE.pdf

The files are results of dsc_bench with rows NAME_step; modelled rows are left out.
"""
import collections
import math
import sys

from look import script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib import colors
from matplotlib.ticker import LogLocator

from results import load, series

MARKERS = {series.GRANULARITY: "o", "scaling_step": "s", "four_circles_step": "^",
           "swirl_step": "D"}
MOST = 4  # columns
SHADE = 0.6  # of the distance from white that the next shade of a colour keeps
LEVEL = (0, (4, 3))


def threshold(points):
    """The sequential work per step, in microseconds, above which every point has S > 1: where the
    line from the last point with S <= 1 to the next one crosses 1, on a logarithmic axis. Returns
    (value, crossed); (least work, False) if S > 1 everywhere; None if S <= 1 at the most work."""
    points = sorted(points, key=lambda p: p.base.median)
    losing = [k for k, p in enumerate(points) if p.s <= 1]
    if not losing:
        return (points[0].base.median, False) if points else None
    if losing[-1] == len(points) - 1:
        return None
    below, above = points[losing[-1]], points[losing[-1] + 1]
    part = (1 - below.s) / (above.s - below.s)
    low, high = math.log(below.base.median), math.log(above.base.median)
    return math.exp(low + part * (high - low)), True


def judged(points, n):
    """The points that give the threshold: those of the family of many sizes, or else of all scenes, for
    the strategy with the most points (or the better one of two)."""
    here = [p for p in points if p.n == n]
    here = [p for p in here if p.row.family == series.GRANULARITY] or here
    lines = series.by_label(here).values()
    return max(lines, key=lambda line: (len(line), max(p.s for p in line)), default=[])


def plain(points):
    n = min(p.n for p in points)
    found = threshold(judged(points, n))
    threads = style.counted(n, "thread")
    if found is None:
        return f"No step that was measured is faster on {threads} than on one."
    if not found[1]:
        return (f"Each step that was measured is faster on {threads} than on one; the shortest takes "
                f"{style.duration(found[0])} on one.")
    return f"Steps that take more than {style.duration(found[0])} on one thread are faster on {threads}."


def draw(bench):
    """One Picture, or none if no row has several threads and a core for each."""
    points = [p for p in series.speedups(series.rows(bench))
              if p.n > 1 and not p.row.oversubscribed]
    return [_picture(points, bench.context)] if points else []


def _panel(axes, points, looks, marker_of):
    n = points[0].n
    times = [p.base.median for p in points]
    middle = math.sqrt(max(times) * min(times))
    wide = max(1.6 * math.sqrt(max(times) / min(times)), 5)
    axes.set(xscale="log", xlim=(middle / wide, middle * wide), title=style.counted(n, "thread"),
             ylim=(0, max(1.15, 1.05 * max(p.interval[2] / n for p in points))),
             xlabel="sequential work a step  $t_s$")
    axes.set_yticks(numpy.arange(0, axes.get_ylim()[1], 0.2))
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(lambda value, _: style.tick(value))
    axes.minorticks_off()
    axes.annotate("S = 1: threads pay above ", (1, 1 / n), (0, -3), ha="right", va="top",
                  xycoords=axes.get_yaxis_transform(), textcoords="offset points", fontsize=7.5,
                  color=style.MUTED)
    axes.axhline(1, color=style.MUTED, linestyle=LEVEL, linewidth=1, zorder=2)
    axes.axhspan(0, 1 / n, color=style.SHADE, zorder=0, linewidth=0)
    axes.axhline(1 / n, color=style.MUTED, linewidth=0.9, zorder=2)
    for p in points:
        style.points(axes, [(p.base.median, [s / n for s in p.interval], p.doubtful)],
                     looks[p.label][0], marker_of(p))
    found = threshold(judged(points, n))
    if found and found[1]:
        axes.axvline(found[0], color=style.INK, linewidth=0.9, linestyle=style.DOTTED, zorder=2)
        axes.annotate(f" pays from {style.duration(found[0])}", (found[0], 1), (2, -4),
                      xycoords=axes.get_xaxis_transform(), textcoords="offset points",
                      fontsize=8, va="top")


def _in_shades(looks):
    """The looks with colours that differ: of labels that share one, each is lighter than the one before."""
    turns = collections.Counter()
    shaded = {}
    for label, (colour, marker) in looks.items():
        ink = numpy.array(colors.to_rgb(colour))
        shaded[label] = (colors.to_hex(1 - (1 - ink) * SHADE ** turns[colour]), marker)
        turns[colour] += 1
    return shaded


def _picture(points, context):
    columns = sorted({p.n for p in points})[:MOST]
    looks = series.looks(series.by_label(points))
    families = series.families([p.row for p in points])
    is_one = len(families) == 1  # markers then tell strategies apart, else scenes
    if not is_one:
        looks = _in_shades(looks)

    def marker_of(point):
        return looks[point.label][1] if is_one else MARKERS.get(point.row.family, "p")

    fig, grid = style.figure(max(7.2, 0.5 + 3.6 * len(columns)), 5.0, 1, len(columns),
                             sharey=True)
    for axes, n in zip(grid[0], columns):
        _panel(axes, [p for p in points if p.n == n], looks, marker_of)
    grid[0][0].set_ylabel("$S(n)\\,/\\,n$")
    if is_one:
        handles = [style.key(label, colour, marker, "none") for label, (colour, marker) in looks.items()]
    else:
        handles = [style.square(label, colour) for label, (colour, _) in looks.items()]
        handles += [style.key(series.title(f), style.MUTED, MARKERS.get(f, "p"), "none") for f in families]
    if any(p.doubtful for p in points):
        handles.append(style.key("under load", style.MUTED, "o", "none", style.doubtful))
    handles.append(style.key("ideal", style.MUTED, line=LEVEL, width=1))
    title = "Granularity: how much work a step needs for threads to pay"
    style.finish(fig, title, style.caption_text(
        context, (series.title(families[0]) + ". " if is_one else "Colour: strategy; marker: scene. ")
        + style.bars_text([len(p.row.times) for p in points])), handles)
    return style.Picture("granularity", title, plain(points), fig, *_table(points))


def _table(points):
    header = ["scene", "triangles", "strategy", "threads", "t_s a step", "t_n a step", "S(n)",
              "S(n) / n", "pays", ""]
    points = sorted(points, key=lambda p: (p.n, p.base.median, style.order(p.row.strategy)))
    return header, [
        [series.title(p.row.family), style.whole(p.row.triangles), p.label, str(p.n),
         style.duration(p.base.median), style.duration(p.row.median), f"{p.s:.2f}",
         f"{p.u:.2f}", "yes" if p.s > 1 else "no", ", ".join(p.flags())] for p in points]


def main(argv=None):
    return script.main(__doc__, lambda given: draw(load.read_bench(given.files)), argv)


if __name__ == "__main__":
    sys.exit(main())

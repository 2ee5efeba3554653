#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws work against precision, a picture for each flow: the error on x, the CPU time on y, a line for
each method and a point for each edge length.

precision.py RESULT.json... --out PICTURE.pdf

The files are results of dsc_precision, one for each method and edge length.
"""
import math
import sys

from look import script, style  # first: reports a Python without matplotlib

from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator

from results import precision_data as data

# method -> (colour, marker); methods of one panel differ in both.
LOOKS = {
    "default": (style.BLUE, "o"),
    "euler": (style.ORANGE, "^"),
    "centred": (style.GREEN, "s"),
    "midpoint": (style.PURPLE, "v"),
    "adaptive": (style.VERMILLION, "D"),
    "linear insertion": (style.ORANGE, "^"),
    "coarsening by length": (style.GREEN, "s"),
    "never coarsened": (style.VERMILLION, "D"),
    "fourth order": (style.PURPLE, "p"),
    "fourth order, coarsened": (style.VERMILLION, "D"),
    "float": (style.SKY, "X"),
    "thesis's choice": (style.GREEN, "h"),
    "literal reference": (style.BLACK, "s"),
}
FLOOR_MARKERS = {"markers, linear": "1", "markers, cubic": "2",
                 "markers, cubic, all kept": "3",
                 "markers, read as cubic, all kept": "4"}
PEER_MARKERS = {"official 2D DSC": "*", "Basilisk": "p", "isoAdvector": "<", "Gerris": "d",
                "level set 512²": ">"}
PANELS = {"other": "Against others", "time": "Steps in time",
          "remeshing": "Insertion and coarsening\nof the interface"}
MOMENTS = {"last": "At the end", "half": "Half-way, where the shape is most stretched"}


def shown(lines, panel):
    """The methods of a panel: always the default, and bare markers where they are the lower bound."""
    floors = {"other": set(FLOOR_MARKERS), "time": set(),
              "remeshing": {"markers, linear", "markers, cubic", "markers, cubic, all kept"}}[panel]
    return {m: line for m, line in lines.items()
            if m == data.DEFAULT or line[0].group == panel or m in floors}


def fashion(method, line):
    """Keywords of a method's line, in pictures and legends."""
    if line[0].group == "markers":
        return {"color": style.MUTED, "linewidth": 0.9, "linestyle": style.DOTTED, "zorder": 2,
                "marker": FLOOR_MARKERS.get(method, "1"), "markersize": 8,
                "markeredgewidth": 1.1, "markeredgecolor": style.MUTED}
    colour, marker = style.look(method, LOOKS)
    return {"color": colour, "linewidth": 3.0 if method == data.DEFAULT else 1.4, "zorder": 3,
            "marker": marker, **style.solid(colour)}


def _lines(axes, lines, moment):
    for method, line in lines.items():
        placed = data.points(line, moment)
        above = {"zorder": 5, "markersize": 7.5} if method == data.DEFAULT else {}
        axes.plot([e for e, _, _ in placed], [t for _, t, _ in placed],
                  **{**fashion(method, line), **above})
        for e, t, run in placed:
            if not run.holds:
                axes.plot([e], [t], marker="x", color=style.INK, markersize=11, zorder=6)


def _lengths(axes, line, moment):
    """Writes the edge length beside the points of the default, on the side with few points of other
    methods, unless it would overlap the previous one."""
    low, high = (math.log(v) for v in axes.get_ylim())
    last = None
    for e, t, run in data.points(line, moment):
        height = (math.log(t) - low) / (high - low)
        if last is None or abs(height - last) > 0.06:
            last = height
            axes.annotate(f"h = {data.length(run.h)}", (e, t), (-7, -3),
                          textcoords="offset points", ha="right", va="top", fontsize=7.4,
                          color=style.BLUE, zorder=7)


def _marks(axes, marks):
    """Errors without a time, as letters on the axis, explained in the legend."""
    if not marks:
        return
    low, high = axes.get_ylim()
    axes.set_ylim(low / (high / low) ** 0.14, high)
    place = axes.get_xaxis_transform()
    for letter, mark in zip("abcdef", marks):
        for error in mark.errors:
            axes.plot([error, error], [0, 0.06], color=style.INK, linewidth=1.4, transform=place,
                      zorder=4, solid_capstyle="butt")
        middle = (min(mark.errors) * max(mark.errors)) ** 0.5
        axes.text(middle, 0.07, letter, ha="center", va="bottom", fontsize=8.5, color=style.INK,
                  fontweight="bold", transform=place, zorder=4)


def set_ticks(axis):
    """Powers of ten; also their doubles and halves if hardly any power of ten is in view."""
    low, high = axis.get_view_interval()
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)) if high < 30 * low else LogLocator(numticks=8))


def _keys(lines, peers, marks):
    handles = [Line2D([], [], label=method, **fashion(method, line))
               for method, line in lines.items()]
    handles += [style.key(peer.tool, style.MUTED, width=0.9,
                          marks=style.other(PEER_MARKERS.get(peer.tool, "p"))) for peer in peers]
    bar = {"marker": "|", "markersize": 8, "markeredgecolor": style.INK, "markeredgewidth": 1.4}
    return handles + [style.key(f"{letter}: {mark.label}", style.INK, line="none", marks=bar)
                      for letter, mark in zip("abcdef", marks)]


def draw(runs, published):
    """One Picture for each flow with an error above zero."""
    return [_one(flow, lines, data.peers(flow, published), data.marks(flow, published))
            for flow, lines in data.flows(runs).items() if any(map(data.points, lines.values()))]


def _one(flow, lines, peers, marks):
    moments = [m for m in MOMENTS
               if any(data.points(line, m) for line in lines.values())]
    panels = [key for key in PANELS
              if key == "other" or any(line[0].group == key for line in lines.values())]
    fig, grid = style.figure(3.0 + 3.7 * len(moments), 1.6 + 2.9 * len(panels), len(panels),
                             len(moments), sharex="row", sharey="row")
    for row, panel in enumerate(panels):
        some = shown(lines, panel)
        beside = (peers, marks) if panel == "other" else ([], [])
        for column, moment in enumerate(moments):
            axes = grid[row][column]
            axes.set(xscale="log", yscale="log")
            _lines(axes, some, moment)
            if moment == "last":
                for peer in beside[0]:
                    axes.plot(*zip(*peer.points), color=style.MUTED, linewidth=0.9, zorder=2,
                              **style.other(PEER_MARKERS.get(peer.tool, "p")))
            axes.margins(0.07)
            if row == 0:
                axes.set_title(MOMENTS[moment])
        grid[row][0].set_ylabel("CPU time")
        _marks(grid[row][0], beside[1])
        low, high = grid[row][0].get_xlim()
        grid[row][0].set_xlim(low / (high / low) ** 0.13, high)  # room for the edge lengths
        for axes, moment in zip(grid[row], moments):
            set_ticks(axes.xaxis)
            set_ticks(axes.yaxis)
            axes.minorticks_off()
            axes.yaxis.set_major_formatter(lambda seconds, _: style.tick(seconds * 1e6))
            if panel != "other":  # no room for labels; the panels below have the same line
                _lengths(axes, some.get(data.DEFAULT, []), moment)
        legend = grid[row][-1].legend(
            handles=_keys(some, *beside), loc="upper left", bbox_to_anchor=(1.03, 1.02),
            borderaxespad=0, fontsize=8, handlelength=2.4, labelspacing=0.35,
            title=PANELS[panel], title_fontproperties={"size": 9, "weight": "bold"})
        legend.set_alignment("left")
    for axes in grid[-1]:
        axes.set_xlabel("error: symmetric difference over first area")
    first = next(iter(lines.values()))[0]
    title = f"Error against time: {first.title}"
    style.finish(fig, title, style.caption_text(first.context, notes(lines, peers, marks)))
    return style.Picture(f"precision_{flow}", title, plain(lines, peers), fig,
                         ["method", "h", "error at T", "error at T/2", "CPU s"],
                         [[m, data.length(r.h), style.digits(r.error), style.digits(r.half),
                           style.digits(r.seconds)] for m, line in lines.items() for r in line])


def plain(lines, peers):
    """The default compared with the most accurate point of another program that it reaches, or alone."""
    title = next(iter(lines.values()))[0].title
    ours = data.points(lines.get(data.DEFAULT, []))
    if not ours:
        return f"{title}: the default method was not run, so there is nothing to compare with."
    reached = [(e, t, p.tool, mine) for p in peers if p.is_measured for e, t in p.points
               if (mine := data.time_at(lines[data.DEFAULT], e)) is not None]
    if reached:
        error, theirs, tool, mine = min(reached)
        factor = style.digits(max(theirs / mine, mine / theirs), 2)
        text = (f"at an error of {style.digits(error)}, that of {tool} after "
                f"{style.duration(theirs * 1e6)}, the default takes {style.duration(mine * 1e6)}, "
                f"{factor} times {'less' if theirs >= mine else 'as much'}")
    else:
        error, mine, run = ours[-1]
        text = (f"with edges of length {data.length(run.h)} the default errs by "
                f"{style.digits(error)} after {style.duration(mine * 1e6)}")
    broken = {r.method for line in lines.values() for r in line if not r.holds}
    return f"{title}: {text}" + (
        f"; a triangle was inverted or a vertex did not arrive with {style.listing(sorted(broken))}."
        if broken else ".")


def notes(lines, peers, marks):
    """The caption, for a reader new to the picture."""
    text = ("Lower left is better. The default is RK4, cubic insertion, coarsening by deviation, "
            "double precision; each other method changes what its name says. The line of a method that is not "
            "visible lies under that of the default. One thread, the shortest CPU time "
            "of up to three runs.")
    if any(not r.holds for line in lines.values() for r in line):
        text += " Crossed out: some vertices did not reach their target."
    if any(line[0].group == "markers" for line in lines.values()):
        text += " Bare markers: the interface alone, without a mesh."
    cells = [p.tool for p in peers if p.tool in ("Basilisk", "isoAdvector", "Gerris")]
    if peers:
        text += (" Grey: other programs, whose times come from another run, on a busy machine"
                 + (f"; the error of {style.listing(cells)} is E1 or L1, sums over cells that are "
                    "at most the symmetric difference" if cells else "") + ".")
    if marks:
        text += " Letters on the axis: errors stated without a time."
    return text


def main(argv=None):
    return script.main(__doc__, lambda given: draw(
        [data.read(path) for path in given.files], {}), argv)


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws how the error falls with the edge length: fitted orders with their spread, and guide lines of
slope two and four.

convergence.py RESULT.json... --out PICTURE.pdf

The files are results of dsc_precision, of at least four edge lengths.
"""
import sys

from look import script, style  # first: reports a Python without matplotlib

import numpy

import precision
from results import precision_data as data

FLOWS = ["single-vortex-8", "swirl-260"]
METHODS = ["default", "linear insertion", "never coarsened", "fourth order",
           "fourth order, coarsened", "markers, cubic", "markers, read as cubic, all kept"]


def chosen(runs):
    """{flow: {method: line}} of the lines with at least four sizes."""
    found = {}
    for flow, lines in data.flows(runs).items():
        some = {m: lines[m] for m in METHODS if m in lines and data.order(lines[m])}
        if flow in FLOWS and some:
            found[flow] = some
    return found


def draw(runs):
    found = chosen(runs)
    if not found:
        return []
    moments = [m for m in precision.MOMENTS if any(
        data.points(line, m) for lines in found.values() for line in lines.values())]
    fig, grid = style.figure(1.2 + 4.2 * len(found), 2.0 + 3.0 * len(moments), len(moments),
                             len(found), sharex="col", sharey=True)
    for column, (flow, lines) in enumerate(found.items()):
        for row, moment in enumerate(moments):
            _panel(grid[row][column], lines, moment)
            if column == 0:
                grid[row][column].set_ylabel("error at the end" if moment == "last"
                                            else "error half-way")
        grid[0][column].set_title(next(iter(lines.values()))[0].title)
        grid[-1][column].set_xlabel("edge length h")
    first = next(iter(next(iter(found.values())).values()))[0]
    title = "Order of convergence"
    style.finish(fig, title, style.caption_text(
        first.context, "Error: symmetric difference over the first area. Time steps shrink with h. "
        "In brackets: the orders between neighbouring edge lengths, smallest and largest."))
    return [style.Picture("precision_convergence", title, plain(found), fig,
                          ["flow", "method", "moment", "order", "smallest", "largest", "sizes"],
                          list(_rows(found, moments)))]


def _rows(found, moments):
    for lines in found.values():
        for method, line in lines.items():
            for moment in moments:
                order = data.order(line, moment)
                if order:
                    yield [line[0].title, method, "T" if moment == "last" else "T/2",
                           f"{order.fitted:.2f}", f"{order.low:.2f}", f"{order.high:.2f}",
                           str(order.sizes)]


def _panel(axes, lines, moment):
    handles = []
    for method, line in lines.items():
        placed = data.points(line, moment)
        handles += axes.plot([r.h for _, _, r in placed], [e for e, _, _ in placed],
                             label=f"{method}: {data.order(line, moment)}",
                             **precision.fashion(method, line))
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    sizes = sorted({r.h for line in lines.values() for r in line})
    axes.set_xticks(sizes, [data.length(h) for h in sizes])
    axes.minorticks_off()
    axes.yaxis.set_major_formatter(lambda v, _: f"{v:.0e}".replace("e-0", "e-"))
    _guides(axes, lines, moment, sizes)
    axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(-0.02, -0.19), fontsize=7.8,
                borderaxespad=0, handlelength=2.4, labelspacing=0.3)


def _guides(axes, lines, moment, sizes):
    """Slopes two and four from one point above the coarsest size."""
    top = 2.0 * max(e for line in lines.values() for e, _, r in data.points(line, moment))
    for slope in (2, 4):
        x = numpy.array([sizes[0], sizes[-1]])
        axes.plot(x, top * (x / sizes[-1]) ** slope, color=style.FAINT, linewidth=1.0, zorder=1)
        axes.annotate(f"h{'²' if slope == 2 else '⁴'}", (x[0], top * (x[0] / x[1]) ** slope),
                      (-3, 0), textcoords="offset points", ha="right", va="center", fontsize=8,
                      color=style.MUTED)


def plain(found):
    """The factor by which the error of the default decreases when the edge length is halved."""
    orders = [(lines[data.DEFAULT][0].title, data.order(lines[data.DEFAULT]))
              for lines in found.values() if data.DEFAULT in lines]
    if not orders:
        return "The default method was not run with enough edge lengths for an order."
    return "Edges half as long divide the error of the default by " + style.listing(
        f"{2 ** order.fitted:.1f} ({title})" for title, order in orders) + "."


def main(argv=None):
    return script.main(__doc__, lambda given: draw(
        [data.read(path) for path in given.files]), argv)


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: MIT
"""The error of scenes against CPU time and against the edge length, a picture of each for every
scene."""
import math

from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, NullLocator

import records
from accuracy import precision, precision_data
from look import style

ERROR, TIME = "sd_rel_last", "cpu_s"
LOOKS = [(style.BLUE, "o"), (style.VERMILLION, "D"), (style.GREEN, "v"), (style.ORANGE, "<"),
         (style.PURPLE, "p"), (style.SKY, "^"), (style.DARK_YELLOW, "h"), (style.BLACK, "s"),
         (style.MUTED, ">")]


def looks(labels):
    """{label: colour and marker}"""
    return {label: LOOKS[k % len(LOOKS)] for k, label in enumerate(labels)}


def lines(points):
    """{scene: {label: points from coarse to fine}} of what has an error at two edge lengths or
    more."""
    found = {}
    for point in points:
        error = point.spread(ERROR)
        if point.h and error and error.low > 0:
            found.setdefault(point.scene, {}).setdefault(point.label, []).append(point)
    found = {scene: {label: line for label, line in some.items() if len({p.h for p in line}) > 1}
             for scene, some in found.items()}
    return {scene: some for scene, some in found.items() if some}


def order(line):
    """The order of convergence over at least four edge lengths, or None."""
    return precision_data.order([
        precision_data.Run(p.scene, p.scene, p.label, "default", p.h, p.spread(ERROR).median, None,
                           1.0, True, None) for p in line])


def bars(spreads):
    """Quartiles as matplotlib takes them."""
    return [[s.median - s.low for s in spreads], [s.high - s.median for s in spreads]]


def counts_of(points):
    """How often each was run, in words."""
    counts = sorted({len(p.records) for p in points})
    runs = style.counted(counts[0], "run") if len(counts) == 1 else \
        f"{counts[0]} to {counts[-1]} runs"
    return f"Medians and quartiles of {runs} each." if counts[-1] > 1 else "One run each."


def conditions(points):
    if not any(p.is_timed for p in points):
        return "Not timed: other runs were beside these, so that their times are rough. "
    text = "Timed runs, alone on the machine. "
    if any(p.is_doubtful for p in points):
        text += (f"Half filled: not timed, or others kept more than {records.BUSY:g} cores busy "
                 "meanwhile. ")
    return text


def _line(axes, x, y, line, look, of_time=False):
    """x, y: the spreads of its points; those whose time is rough are marked."""
    colour, marker = look
    axes.errorbar([s.median for s in x], [s.median for s in y], xerr=bars(x), yerr=bars(y),
                  color=colour, linewidth=1.4, elinewidth=1, capsize=2.5, zorder=3)
    for point, a, b in zip(line, x, y):
        marks = style.doubtful(colour) if of_time and point.is_doubtful else style.solid(colour)
        axes.plot([a.median], [b.median], marker=marker, linestyle="none", zorder=4, **marks)


def _power(value, _):
    return f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e")


def _more_ticks(axis, low, high):
    """At 1, 2 and 5 where there would be hardly any at powers of ten."""
    if math.log10(high / low) < 2:
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))


def _axes(look):
    fig, grid = style.figure(7.4, 5.0)
    axes = grid[0][0]
    precision.logarithmic(axes)
    return fig, axes, [style.key(label, *which, width=1.4) for label, which in look.items()]


def against_time(scene, some, context, name):
    points = [p for line in some.values() for p in line]
    look = looks(some)
    fig, axes, handles = _axes(look)
    for k, (label, line) in enumerate(some.items()):
        _line(axes, [p.spread(ERROR) for p in line], [p.spread(TIME) for p in line], line,
              look[label], of_time=True)
        for p in line:
            # Lines take turns to have their words above and below.
            axes.annotate(f"h = {precision_data.length(p.h)}",
                          (p.spread(ERROR).median, p.spread(TIME).median),
                          (-7, -9) if k % 2 else (7, 4), ha="right" if k % 2 else "left",
                          textcoords="offset points", fontsize=7, color=look[label][0])
    axes.set_xlabel("error: symmetric difference over the first area")
    axes.set_ylabel("CPU time of all steps")
    axes.yaxis.set_major_formatter(FuncFormatter(precision.seconds))
    axes.margins(0.12)
    _more_ticks(axes.yaxis, *axes.get_ylim())
    style.finish(fig, f"Error against time: {scene}", style.caption_text(
        context, f"{counts_of(points)} {conditions(points)}Lower left is better."), handles)
    best = min(points, key=lambda p: p.spread(ERROR).median)
    return style.Picture(
        name, f"Error against time: {scene}",
        f"The smallest error in {scene} is {style.digits(best.spread(ERROR).median)}, at "
        f"h = {precision_data.length(best.h)} ({best.label}), after "
        f"{style.duration(1e6 * best.spread(TIME).median)} of CPU time.", fig,
        ["run", "h", "error", "lower quartile", "upper", "CPU s", "lower quartile", "upper",
         "runs"],
        [[p.label, precision_data.length(p.h), *_digits(p.spread(ERROR)), *_digits(p.spread(TIME)),
          str(len(p.records))] for p in points])


def _digits(spread):
    return [style.digits(value) for value in (spread.median, spread.low, spread.high)]


def against_length(scene, some, context, name):
    points = [p for line in some.values() for p in line]
    look = looks(some)
    orders = {label: order(line) for label, line in some.items()}
    fig, axes, _ = _axes(look)
    handles = [style.key(f"{label}: order {orders[label]}" if orders[label] else label, *which,
                         width=1.4) for label, which in look.items()]
    for label, line in some.items():
        x = [records.Spread(p.h, p.h, p.h, 1) for p in line]
        _line(axes, x, [p.spread(ERROR) for p in line], line, look[label])
    lengths = sorted({p.h for p in points})
    top = 2 * max(p.spread(ERROR).median for p in points)
    for slope in (1, 2):
        axes.plot(lengths, [top * (h / lengths[-1]) ** slope for h in lengths], color=style.FAINT,
                  linewidth=1, zorder=1)
        axes.annotate("h" if slope == 1 else "h²",
                      (lengths[0], top * (lengths[0] / lengths[-1]) ** slope), (-3, 0),
                      textcoords="offset points", ha="right", va="center", fontsize=8,
                      color=style.MUTED)
    axes.set_xscale("log", base=2)
    axes.set_xticks(lengths, [precision_data.length(h) for h in lengths])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(FuncFormatter(_power))
    axes.set_xlabel("edge length h (domain units)")
    axes.set_ylabel("error: symmetric difference / area")
    _more_ticks(axes.yaxis, *axes.get_ylim())
    style.finish(fig, f"Order of convergence: {scene}", style.caption_text(
        context, f"{counts_of(points)} Order: least squares over four edge lengths or more; in "
        "brackets the smallest and largest between neighbours."), handles)
    told = [f"{value.fitted:.1f} ({label})" for label, value in orders.items() if value]
    sentence = f"{scene} was run at fewer than four edge lengths, too few for an order."
    if told:
        sentence = f"In {scene} the error falls with h to the power {style.listing(told)}."
    return style.Picture(
        name, f"Order of convergence: {scene}", sentence, fig,
        ["run", "order", "smallest", "largest", "edge lengths"],
        [[label, f"{value.fitted:.2f}", f"{value.low:.2f}", f"{value.high:.2f}", str(value.sizes)]
         for label, value in orders.items() if value])

# SPDX-License-Identifier: MIT
"""The common look of all pictures: palette, markers, layout bands, captions, numbers in words.

Colours are those of Okabe and Ito ("Color universal design", 2008). Every strategy also has its own
marker, so that no picture depends on colour alone.
"""
import math
import statistics
import textwrap
from dataclasses import dataclass, field
from itertools import accumulate

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import LogFormatter, LogFormatterSciNotation, LogLocator, NullLocator  # noqa: E402

INK = "#22303A"
MUTED = "#66737D"
FAINT = "#C9D1D7"
SHADE = "#F1F4F6"

BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
BLUE, VERMILLION, PURPLE = "#0072B2", "#D55E00", "#CC79A7"
# Lines in the palette's yellow (#F0E442) are hardly visible on white; this yellow is darker.
DARK_YELLOW = "#A89400"

# strategy -> (colour, marker); the order is the order of legends and tables.
STRATEGIES = {
    "reference": (BLACK, "s"),
    "sequential": (BLUE, "o"),
    "copy": (DARK_YELLOW, "h"),
    "fixed": (ORANGE, "<"),
    "counting": (SKY, "^"),
    "active": (GREEN, "v"),
    "blocks": (PURPLE, "p"),
    "cells": (VERMILLION, "D"),
}
SPARE = [(MUTED, ">"), (INK, "d"), (GREEN, "H"), (PURPLE, "8")]

PHASE_FILLS = ["#EDF1F4", "#A9D3EE", "#F7D99A", "#A6DCC6", "#E6C3D6", "#F3B48F", "#C8CDD2"]
INTERFACE = "#C24E00"
EDGE = "#93A1AC"


@dataclass
class Picture:
    """A figure with one plain sentence on what it shows, and rows for a table if there are any."""

    name: str
    title: str
    sentence: str
    figure: object
    header: list = field(default_factory=list)
    rows: list = field(default_factory=list)
    is_mesh: bool = False  # too many triangles for a vector format, which would be tens of megabytes


def apply():
    """Sets the defaults of matplotlib for this process."""
    plt.rcParams.update({
        "font.family": "DejaVu Sans",
        "font.size": 9,
        "text.color": INK,
        "axes.edgecolor": MUTED,
        "axes.labelcolor": INK,
        "axes.titlesize": 9.5,
        "axes.titlelocation": "left",
        "axes.titlepad": 7,
        "axes.labelsize": 9,
        "axes.linewidth": 0.7,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.axisbelow": True,
        "axes.grid": True,
        "axes.grid.which": "major",
        "grid.color": "#E3E8EC",
        "grid.linewidth": 0.6,
        "xtick.color": MUTED,
        "ytick.color": MUTED,
        "xtick.labelcolor": INK,
        "ytick.labelcolor": INK,
        "xtick.labelsize": 8.5,
        "ytick.labelsize": 8.5,
        "xtick.minor.size": 0,
        "ytick.minor.size": 0,
        "xtick.major.width": 0.7,
        "ytick.major.width": 0.7,
        "lines.linewidth": 1.6,
        "lines.markersize": 6,
        "legend.frameon": False,
        "legend.fontsize": 8.5,
        "figure.facecolor": "white",
        "savefig.facecolor": "white",
        "pdf.fonttype": 42,
        "svg.hashsalt": "dsc",  # the same results give the same bytes
    })


def look(name, known=STRATEGIES):
    """Colour and marker of a strategy or another known name; unknown names get a spare pair."""
    return known.get(name) or SPARE[sum(name.encode()) % len(SPARE)]


def order(name, known=tuple(STRATEGIES)):
    """Sorting key: known names in the given order, then others by name."""
    return (known.index(name) if name in known else len(known), name)


DASHED = (0, (3.5, 2))  # for modelled, not measured, points
SHORT_DASHES = (0, (2.5, 1.5))
DOTTED = (0, (1, 1.5))


def hollow(colour):
    """Marker keywords of a modelled, not measured, point."""
    return {"markerfacecolor": "white", "markeredgecolor": colour, "markeredgewidth": 1.3}


def doubtful(colour):
    """Marker keywords of a measured point that is less reliable than the others: half filled."""
    return {"fillstyle": "left", "markerfacecolor": colour, "markerfacecoloralt": "white",
            "markeredgecolor": colour, "markeredgewidth": 1.0}


def solid(colour):
    return {"markerfacecolor": colour, "markeredgecolor": "white", "markeredgewidth": 0.7}


def other(marker):
    """Marker keywords of other programs: grey with a thin white rim, larger for spiky markers."""
    spiky = marker in ("*", "1", "2")
    return {"marker": marker, "markersize": 10 if spiky else 7, "markerfacecolor": MUTED,
            "markeredgecolor": MUTED if marker in ("1", "2") else "white",
            "markeredgewidth": 1.1 if marker in ("1", "2") else 0.5}


def key(label, colour, marker=None, line="-", marking=solid, width=1.6, marks=None):
    """A legend entry; marking is solid, hollow or doubtful."""
    marks = marks or {"marker": marker, **marking(colour)}
    return Line2D([], [], color=colour, linestyle=line, label=label, linewidth=width, **marks)


def square(label, colour):
    """A legend entry of a filled area."""
    handle = key(label, colour, "s", "none")
    handle.set(markersize=8)
    return handle


def interval(values):
    """(low, median, high) with the 95 % interval of the median by ranks, for any distribution (Hoefler and
    Belli 2015); fewer than six values have no such interval, and the range is given."""
    ordered, count = sorted(values), len(values)
    chances = accumulate(math.comb(count, rank) / 2 ** count for rank in range(count))
    cut = max(sum(chance <= 0.025 for chance in chances) - 1, 0)
    return ordered[cut], statistics.median(ordered), ordered[-1 - cut]


def bars_text(counts):
    """A sentence on the bars of medians of this number of values."""
    few = min(counts)
    if few >= 6:
        return "Medians; bars: their 95 % intervals by ranks."
    return (f"Medians; bars: the range of {few} values, which holds the median with "
            f"{100 - 100 / 2 ** (few - 1):.0f} %." if few > 1 else "Single values, without bars.")


def points(axes, entries, colour, marker, **more):
    """entries: [(x, (low, middle, high), whether it is doubtful)]. Markers with bars and without a line,
    because nothing is known between two measurements."""
    for x, (low, middle, high), is_doubtful in entries:
        axes.errorbar([x], [middle], yerr=[[middle - low], [high - middle]], fmt="none",
                      ecolor=colour, elinewidth=1, capsize=2.5, zorder=3.2)
        axes.plot([x], [middle], marker=marker, color=colour, linestyle="none", zorder=4,
                  **(doubtful(colour) if is_doubtful else solid(colour)), **more)


def figure(width, height, rows=1, columns=1, **keywords):
    """A figure and its axes (always a 2D array), laid out below a title and above a caption."""
    apply()
    return plt.subplots(rows, columns, figsize=(width, height), squeeze=False,
                        layout="constrained", **keywords)


def caption_text(context, conditions=""):
    """Machine, commit and conditions of a result, as far as known."""
    parts = []
    if context is not None:
        cores = 0 if "core" in context.machine else context.cores  # the machine already includes it
        parts = [context.machine, cores and counted(cores, "core"),
                 context.load and f"other load {context.load}", context.compiler,
                 context.build_type, context.commit and f"commit {context.commit[:12]}",
                 context.clock, context.binding]
    # Lines are broken between parts only.
    parts = [part.replace(" ", "\N{NO-BREAK SPACE}") for part in parts if part]
    first = "  ·  ".join(parts) if parts else "machine and commit not recorded"
    return first + ("\n" + conditions if conditions else "")


def _columns(labels, width):
    """As many legend columns as fit, but not more than needed for the smallest number of rows.
    A legend is filled column by column; the first columns have one entry more if the entries
    do not divide evenly.
    """
    for count in range(len(labels), 1, -1):
        if count != math.ceil(len(labels) / math.ceil(len(labels) / count)):
            continue
        used, first = 0.0, 0
        for column in range(count):
            last = first + len(labels) // count + (column < len(labels) % count)
            used += 0.58 + 0.07 * max(len(label) for label in labels[first:last])
            first = last
        if used <= width:
            return count
    return 1


def tick_between_powers(axis):
    """Gives a logarithmic axis that shows fewer than two powers of its base ticks between them: 2 and 5 times
    a power, each digit or, in the narrowest view, each tenth. Ticks that a plot has placed itself stay."""
    if axis.get_scale() != "log" or not isinstance(axis.get_major_locator(), LogLocator):
        return
    low, high = sorted(axis.get_view_interval())
    for parts in ((1, 2, 5), range(1, 10), [tenths / 10 for tenths in range(10, 100)]):
        if sum(low <= place <= high for place in axis.get_majorticklocs()) > 1:
            return
        axis.set_major_locator(LogLocator(subs=parts, numticks=100))
        axis.set_minor_locator(NullLocator())
        if isinstance(axis.get_major_formatter(), LogFormatter):  # which leaves out some of 2 and 5 by itself
            axis.set_major_formatter(LogFormatterSciNotation(minor_thresholds=(math.inf, math.inf)))


def finish(fig, title, caption, handles=()):
    """Title and legend in a band above the axes, caption in a band below; sizes in inches. Each logarithmic axis
    gets ticks."""
    for axes in fig.axes:
        for axis in (axes.xaxis, axes.yaxis):
            tick_between_powers(axis)
    width, height = fig.get_size_inches()
    left = 0.12 / width
    # Captions that are too long for the figure are wrapped.
    lines = [part.strip(" ·") for line in caption.split("\n")
             for part in textwrap.wrap(line, int(width * 18), break_on_hyphens=False)]
    bottom = 0.16 + 0.165 * len(lines)
    top = 0.42
    fig.text(left, 1 - 0.12 / height, title, ha="left", va="top", fontsize=11.5,
             fontweight="bold", color=INK)
    handles = list(handles)
    if handles:
        columns = _columns([str(h.get_label()) for h in handles], width - 0.24)
        rows = math.ceil(len(handles) / columns)
        fig.legend(handles=handles, loc="upper left", ncol=columns,
                   bbox_to_anchor=(left, 1 - 0.4 / height), borderaxespad=0, borderpad=0,
                   handlelength=2.2, columnspacing=1.6, labelspacing=0.35)
        top += 0.06 + 0.17 * rows
    fig.text(left, 0.1 / height, "\n".join(lines), ha="left", va="bottom", fontsize=7.3,
             color=MUTED, linespacing=1.35)
    fig.get_layout_engine().set(rect=(0, bottom / height, 1, 1 - (bottom + top) / height),
                                w_pad=0.08, h_pad=0.06, wspace=0.03, hspace=0.03)


def whole(value):
    """28236 -> '28,236'."""
    return f"{int(round(value)):,}"


def digits(value, count=3):
    """A number with `count` significant digits, without needless exponents."""
    if value is None:
        return "–"
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    size = abs(value)
    if size >= 10 ** count:
        return f"{value:,.0f}"
    if size < 1e-3:
        mantissa, exponent = f"{value:.{count - 1}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return f"{value:.{max(0, count - 1 - math.floor(math.log10(size)))}f}"


def duration(microseconds):
    """A duration in a suitable unit."""
    for limit, scale, unit in ((1, 1e3, "ns"), (1e3, 1, "µs"), (1e6, 1e-3, "ms")):
        if microseconds < limit:
            return f"{digits(microseconds * scale)} {unit}"
    return f"{digits(microseconds * 1e-6)} s"


def tick(microseconds):
    """A duration on an axis: 10 µs, not 10.0 µs."""
    text, unit = duration(microseconds).split(" ")
    return f"{float(text.replace(',', '')):g} {unit}"


def size_label(triangles):
    """Compact size for ticks: 28k, 2.8M."""
    if triangles >= 1e6:
        return f"{triangles / 1e6:.3g}M"
    if triangles >= 1e3:
        return f"{triangles / 1e3:.3g}k"
    return f"{triangles:g}"


def capital(text):
    """'a text' -> 'A text'."""
    return text[:1].upper() + text[1:]


def counted(number, word):
    """'1 run', '2 runs'."""
    return f"{whole(number)} {word}" + ("" if number == 1 else "s")


def listing(words):
    """'a', 'a and b', 'a, b and c'."""
    words = [str(word) for word in words]
    if len(words) < 2:
        return "".join(words)
    return ", ".join(words[:-1]) + " and " + words[-1]

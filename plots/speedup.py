# SPDX-License-Identifier: MIT
"""Speed-up S(n) and utilisation U(n) against threads, with the thesis's table 10.1 beside ours.

The base is always the sequential driver at the same size (thesis, equation 14), never the
parallel one at one thread; t_1 / t_s is stated in the sentence.
"""
import numpy
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

import load
import series
import style

THESIS = {"scaling_step": ("scaling_table_10_1", "thesis, table 10.1 (4 cores)"),
          "four_circles_step": ("four_circles", "thesis, section 10.7 (4 cores)")}
WIDE = 16  # from here on threads go on a logarithmic axis


def _thesis(family, published):
    """Rows {n, t_n, S, U} of the thesis for a family, its label and its t_s."""
    identifier, label = THESIS.get(family, (None, ""))
    found = load.entry(published, "speedup", identifier) if identifier else None
    return (found["values"], label, found.get("t_s")) if found else ([], "", None)


def _thread_axis(axes, top):
    if top > WIDE:
        axes.set_xscale("log", base=2)
        ticks = [2 ** k for k in range(12) if 2 ** k <= top]
        axes.set_xlim(0.85, top * 1.15)
    else:
        ticks = list(range(1, top + 1))
        axes.set_xlim(0.7, top + 0.3)
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _cores(axes, cores, top, ceiling, with_text, oversubscribed):
    """The vertical line at the machine's cores, and the field beyond it."""
    if not cores or cores > top:
        return
    axes.axvline(cores, color=style.MUTED, linewidth=0.9, linestyle=(0, (1, 1.5)), zorder=1.5)
    if with_text:
        axes.text(cores, ceiling, f" {style.counted(cores, 'core')} ", va="top",
                  ha="left" if cores == 1 else "right", fontsize=7.5, color=style.MUTED)
    if oversubscribed and cores < top:
        axes.axvspan(cores, axes.get_xlim()[1], color=style.SHADE, zorder=0, linewidth=0)
        if with_text:
            axes.text(axes.get_xlim()[1], ceiling, "oversubscribed ", ha="right", va="top",
                      fontsize=7.5, color=style.MUTED)


def _lines(axes, points, looks, spread, value):
    """One line for each series: trusted points solid, oversubscribed ones hollow."""
    for index, (label, line) in enumerate(points.items()):
        colour, marker = looks[label]
        # Series are set apart sideways so that markers and bars of equal height stay visible.
        place = [p.n * (1 + spread * (index - (len(points) - 1) / 2)) for p in line]
        middle = [value(p, p.s) for p in line]
        bars = [[m - value(p, p.low) for m, p in zip(middle, line)],
                [value(p, p.high) - m for m, p in zip(middle, line)]]
        axes.plot(place, middle, color=colour, zorder=3)
        axes.errorbar(place, middle, yerr=bars, fmt="none", ecolor=colour, elinewidth=1,
                      capsize=2.5, zorder=3.2)
        for x, y, p in zip(place, middle, line):
            marks = style.hollow(colour) if p.row.oversubscribed else style.solid(colour)
            axes.plot([x], [y], marker=marker, color=colour, linestyle="none", zorder=4, **marks)


def sentence(family, points, thesis):
    """What the numbers say, with the base and both times of each S(n)."""
    fair = [p for p in points if not p.row.oversubscribed and p.n > 1]
    words = []
    if fair:
        best = max(fair, key=lambda p: p.s)
        words.append(
            f"In the {series.title(family)}, {best.row.label} with {best.n} threads takes "
            f"{style.duration(best.row.median)} a step at {style.whole(best.row.triangles)} "
            f"triangles against {style.duration(best.base.median)} sequentially: "
            f"S({best.n}) = {best.s:.2f}, U({best.n}) = {best.u:.2f}")
        same = [p for p in fair if p.n == best.n]
        if len(same) > 1:
            words.append(f"; over all {len(same)} series and sizes S({best.n}) lies between "
                         f"{min(p.s for p in same):.2f} and {max(p.s for p in same):.2f}")
        beside = [t for t in thesis if t["n"] == best.n]
        if beside:
            words.append(f" (thesis: {beside[0]['S']:.2f})")
    else:
        words.append(f"In the {series.title(family)}, no row has more than one thread within the "
                     "machine's cores, so nothing here is a speed-up to trust")
    ones = [1 / p.s for p in points if p.n == 1]
    if ones:
        low, high = f"{min(ones):.2f}", f"{max(ones):.2f}"
        span = low if low == high else f"{low} to {high}"
        words.append(f"; one parallel thread takes {span} times the sequential time")
    over = sum(p.row.oversubscribed for p in points)
    if over:
        words.append(f"; {over} of {len(points)} points are oversubscribed (hollow) and say "
                     "nothing about scaling")
    return "".join(words) + "."


def draw(bench, published):
    """A Picture for each family of step benchmarks that has parallel rows."""
    found = series.rows(bench)
    pictures = []
    for family in series.families(found):
        points = series.speedups([r for r in found if r.family == family])
        if points:
            pictures.append(_family(family, points, bench.context, published))
    return pictures


def _family(family, points, context, published):
    sizes = sorted({p.row.triangles for p in points})
    looks = series.looks(series.by_label(points, lambda p: p.row.label))
    thesis, thesis_label, thesis_ts = _thesis(family, published)
    top = max([p.n for p in points] + [t["n"] for t in thesis] + [2])
    tall = max([p.high for p in points] + [t["S"] for t in thesis] + [2.0]) * 1.15
    fig, grid = style.figure(max(7.2, 0.5 + 3.1 * len(sizes)), 6.6, 2, len(sizes), sharey="row")
    for column, size in enumerate(sizes):
        here = [p for p in points if p.row.triangles == size]
        lines = series.by_label(here, lambda p: p.row.label)
        over = any(p.row.oversubscribed for p in here)
        panels = ((grid[0][column], lambda p, s: s, "S", tall),
                  (grid[1][column], lambda p, s: s / p.n, "U", max(
                      1.25, 1.1 * max(p.high / p.n for p in points))))
        for axes, value, quantity, ceiling in panels:
            _thread_axis(axes, top)
            axes.set_ylim(0, ceiling)
            _cores(axes, context.cores, top, ceiling * 0.99, quantity == "U", over)
            ideal = numpy.linspace(1, top, 200)  # curved where the axis is logarithmic
            axes.plot(ideal, ideal if quantity == "S" else ideal ** 0,
                      color=style.MUTED,
                      linestyle=(0, (4, 3)), linewidth=1, zorder=2)
            if quantity == "S":
                base = here[0].base
                axes.axhspan(base.median / max(base.times), base.median / min(base.times),
                             color=style.BLUE, alpha=0.13, linewidth=0, zorder=1)
            if thesis:
                axes.plot([t["n"] for t in thesis], [t[quantity] for t in thesis],
                          color=style.MUTED, linewidth=1, linestyle=(0, (1, 1)), zorder=2.5,
                          **style.other("*"))
            _lines(axes, lines, looks, 0.02 if top <= 4 else 0.012, value)
        grid[0][column].set_title(f"{style.whole(size)} triangles, "
                                  f"$t_s$ = {style.duration(here[0].base.median)} a step")
        grid[1][column].set_xlabel("threads $n$")
    grid[0][0].set_ylabel("speed-up  $S(n) = t_s\\,/\\,t_n$")
    grid[1][0].set_ylabel("utilisation  $U(n) = S(n)\\,/\\,n$")
    handles = [style.key(label, *look) for label, look in looks.items()]
    handles.append(style.key("ideal", style.MUTED, line=(0, (4, 3)), width=1))
    if thesis:
        handles.append(style.key(thesis_label, style.MUTED, line=(0, (1, 1)), width=1,
                                 marks=style.other("*")))
    if any(p.row.oversubscribed for p in points):
        handles.append(style.key("oversubscribed (threads > cores)", style.MUTED, "o", "none",
                                 open_marker=True))
    style.finish(fig, f"Speed-up: {series.title(family)}", style.caption_text(
        context, "Medians over repetitions; bars from the slowest to the fastest repetition; blue "
        "band: the same of the sequential run."), handles)
    return style.Picture("speedup_" + series.title(family).replace(" ", "_"),
                         f"Speed-up: {series.title(family)}",
                         sentence(family, points, thesis), fig, *_table(points, thesis, thesis_ts))


def _table(points, thesis, thesis_ts):
    header = ["triangles", "strategy", "threads", "t_s a step", "t_n a step", "S(n)", "U(n)",
              "thesis t_n", "thesis S(n)", "thesis U(n)", ""]
    rows = []
    for p in points:
        beside = next((t for t in thesis if t["n"] == p.n), None)
        theirs = ([f"{beside['t_n']} s of {thesis_ts} s", f"{beside['S']:.2f}",
                   f"{beside['U']:.2f}"] if beside else ["–"] * 3)
        rows.append([style.whole(p.row.triangles), p.row.label, str(p.n),
                     style.duration(p.base.median), style.duration(p.row.median), f"{p.s:.2f}",
                     f"{p.u:.2f}", *theirs, "oversubscribed" if p.row.oversubscribed else ""])
    return header, rows

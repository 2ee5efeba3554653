# SPDX-License-Identifier: MIT
"""How much work a step needs for threads to pay: U(n) against the time of the sequential step,
from measured rows only."""
import math

import numpy
from matplotlib.ticker import FuncFormatter, NullFormatter

from parallel import series
from look import style

MARKERS = {series.GRANULARITY: "o", "scaling_step": "s", "four_circles_step": "^",
           "swirl_step": "D"}
MOST = 4  # columns


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
    """The points from which the threshold is read: those of the family of many sizes, or else of
    all scenes, for the strategy with the most points (of two with as many, the better one)."""
    here = [p for p in points if p.n == n]
    here = [p for p in here if p.row.family == series.GRANULARITY] or here
    lines = series.by_label(here, lambda p: p.row.label).values()
    return max(lines, key=lambda line: (len(line), max(p.s for p in line)), default=[])


def counts(points):
    """Thread counts above one for which the machine has enough cores."""
    return sorted({p.n for p in points if p.n > 1 and not p.row.oversubscribed})[:MOST]


def plain(points):
    n = counts(points)[0]
    line = judged(points, n)
    found = threshold(line)
    threads = "A second thread" if n == 2 else style.counted(n, "thread")
    pays, themselves = ("pays", "itself") if n == 2 else ("pay", "themselves")
    if found is None:
        return (f"{threads} {'does' if n == 2 else 'do'} not make any step faster that was "
                "measured.")
    if not found[1]:
        return (f"{threads} {pays} for {themselves} in every step that was measured, the shortest "
                f"of which takes {style.duration(found[0])} on one thread.")
    return (f"{threads} {pays} for {themselves} in steps that take more than "
            f"{style.duration(found[0])} on one thread.")


def sentence(points):
    words = []
    for n in counts(points):
        line = judged(points, n)
        found = threshold(line)
        label = f"{style.counted(n, 'thread')} of {line[0].row.label}"
        sizes = [p.base.median for p in line]
        if found is None:
            most = max(line, key=lambda p: p.base.median)
            text = (f"{label} do not pay at any amount of work up to "
                    f"{style.duration(max(sizes))} a step, where S({n}) = {most.s:.2f}")
        elif found[1]:
            text = (f"{label} pay, S({n}) > 1, from {style.duration(found[0])} of sequential "
                    "work a step on")
        else:
            text = (f"{label} pay, S({n}) > 1, at every size measured, the smallest having "
                    f"{style.duration(found[0])} of sequential work a step")
        best = max(line, key=lambda p: p.u)
        words.append(text + f"; the best utilisation is U({n}) = {best.u:.2f} at "
                     f"{style.duration(best.base.median)} a step")
    text = ". ".join(words) + "."
    doubtful = [p for p in points if p.n in counts(points) and p.doubtful
                and not p.row.oversubscribed]
    if doubtful:
        text += (f" {len(doubtful)} points (half filled) were measured while other work loaded "
                 "the machine.")
    return text


def draw(bench):
    """One Picture, or none if no row has several threads and a core for each."""
    points = series.speedups(series.rows(bench))
    points = [p for p in points if p.n > 1 and not p.row.oversubscribed]
    if points:
        yield _picture(points, bench.context)


def _plot(axes, points, n, looks):
    axes.axhline(1, color=style.MUTED, linestyle=(0, (4, 3)), linewidth=1, zorder=2)
    axes.axhspan(0, 1 / n, color=style.SHADE, zorder=0, linewidth=0)
    axes.axhline(1 / n, color=style.MUTED, linewidth=0.9, zorder=2)
    here = [p for p in points if p.n == n]
    for (label, family), line in sorted(_lines(here).items()):
        colour = looks[label][0]
        place, middle = [p.base.median for p in line], [p.u for p in line]
        joined = "-" if family == series.GRANULARITY else "none"
        axes.plot(place, middle, color=colour, linestyle=joined, zorder=3)
        axes.errorbar(place, middle, fmt="none", ecolor=colour, elinewidth=1, capsize=2.5,
                      zorder=3.2, yerr=[[p.u - p.low / n for p in line],
                                        [p.high / n - p.u for p in line]])
        for x, y, p in zip(place, middle, line):
            marks = style.doubtful(colour) if p.doubtful else style.solid(colour)
            axes.plot([x], [y], marker=MARKERS.get(family, "p"), linestyle="none", zorder=4,
                      **marks)
    found = threshold(judged(points, n))
    if found and found[1]:
        axes.axvline(found[0], color=style.INK, linewidth=0.9, linestyle=(0, (1, 1.5)), zorder=2)
        axes.annotate(f" pays from {style.duration(found[0])}", (found[0], 1), (2, -4),
                      xycoords=axes.get_xaxis_transform(), textcoords="offset points",
                      fontsize=8, va="top")


def _lines(points):
    lines = {}
    for p in sorted(points, key=lambda p: p.base.median):
        lines.setdefault((p.row.label, p.row.family), []).append(p)
    return lines


def _axes(axes, points, n):
    times = [p.base.median for p in points]
    axes.set_xscale("log")
    axes.set_xlim(min(times) / 1.6, max(times) * 1.6)
    if max(times) / min(times) < 10:  # a decade at least, or the logarithmic axis has no tick
        middle = math.sqrt(max(times) * min(times))
        axes.set_xlim(middle / 5, middle * 5)
    axes.set_ylim(0, max(1.15, 1.05 * max(p.high / p.n for p in points)))
    axes.set_yticks(numpy.arange(0, axes.get_ylim()[1], 0.2))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.tick(value)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("sequential work a step  $t_s$")
    axes.set_title(style.counted(n, "thread"))
    axes.annotate("S = 1: threads pay above ", (1, 1 / n), (0, -3), ha="right", va="top",
                  xycoords=axes.get_yaxis_transform(), textcoords="offset points", fontsize=7.5,
                  color=style.MUTED)


def _picture(points, context):
    columns = counts(points)
    looks = series.looks(series.by_label(points, lambda p: p.row.label))
    fig, grid = style.figure(max(7.2, 0.5 + 3.6 * len(columns)), 5.0, 1, len(columns),
                             sharey=True)
    for axes, n in zip(grid[0], columns):
        _axes(axes, points, n)
        _plot(axes, points, n, looks)
    grid[0][0].set_ylabel("utilisation  $U(n) = S(n)\\,/\\,n$")
    families = series.families([p.row for p in points])
    handles = [style.square(label, colour) for label, (colour, _) in looks.items()]
    handles += [style.key(series.title(f), style.MUTED, MARKERS.get(f, "p"),
                          "-" if f == series.GRANULARITY else "none") for f in families]
    if any(p.doubtful for p in points):
        handles.append(style.key("under load", style.MUTED, "o", "none", style.doubtful))
    handles.append(style.key("ideal", style.MUTED, line=(0, (4, 3)), width=1))
    name = "Granularity: how much work a step needs for threads to pay"
    style.finish(fig, name, style.caption_text(
        context, "Measured rows only. Colour: strategy; marker: scene. Medians over repetitions; "
        "bars from the slowest to the fastest repetition."), handles)
    return style.Picture("granularity", name, plain(points), fig, *_table(points),
                         details=sentence(points))


def _table(points):
    header = ["scene", "triangles", "strategy", "threads", "t_s a step", "t_n a step", "S(n)",
              "U(n)", "pays", ""]
    points = sorted(points, key=lambda p: (p.n, p.base.median, style.order(p.row.strategy)))
    rows = [[series.title(p.row.family), style.whole(p.row.triangles), p.row.label, str(p.n),
             style.duration(p.base.median), style.duration(p.row.median), f"{p.s:.2f}",
             f"{p.u:.2f}", "yes" if p.s > 1 else "no", ", ".join(p.flags())]
            for p in points]
    return header, rows

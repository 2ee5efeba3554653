# SPDX-License-Identifier: MIT
"""Speed-up over threads, a panel for each size, and over sizes."""
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

import errors_drawn
import records
from look import style
from results import load

WIDEST = 5  # panels of one picture: the smallest, the largest and some between


def _sizes(found):
    sizes = sorted({_size(s) for s in found})
    if len(sizes) <= WIDEST:
        return sizes
    return [sizes[round(k * (len(sizes) - 1) / (WIDEST - 1))] for k in range(WIDEST)]


def _size(speedup):
    """That of the problem: the same for all threads, whatever the last triangle."""
    return speedup.point.spread("triangles_first").median if \
        load.number_or_none(speedup.point.records[0]["result"], "triangles_first") else 0.0


def _ideal(axes, threads):
    axes.plot([1, threads], [1, threads], color=style.MUTED, linestyle=(0, (4, 3)), linewidth=1,
              zorder=2)


def _looks(found):
    """A strategy has the colour that it has in all pictures, unless it is divided in several
    ways."""
    found = sorted(found, key=lambda s: style.order(s.point.strategy))
    names = list(dict.fromkeys(s.name for s in found))
    known = [name for name in names if name in style.STRATEGIES]
    if len(known) == len(names):
        return {name: style.look(name) for name in names}
    return errors_drawn.looks(names)


def _conditions(found):
    counts = sorted({s.time.count for s in found} | {s.base.count for s in found})
    repeats = counts[0] if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
    return (f"S(n): median wall time of all steps by the sequential driver over that of n threads; "
            f"bars: quartiles of {repeats} runs. Timed runs, alone on the machine. "
            f"Half filled: others kept more than {records.BUSY:g} cores busy meanwhile, or threads "
            "are more than cores.")


def _marks(axes, x, line, look, shift=1.0):
    colour, marker = look
    x = [value * shift for value in x]
    y = [s.s for s in line]
    axes.errorbar(x, y, yerr=[[s.s - s.low for s in line], [s.high - s.s for s in line]],
                  color=colour, linewidth=1.4, elinewidth=1, capsize=2.5, zorder=3)
    for a, b, speedup in zip(x, y, line):
        marks = style.doubtful(colour) if speedup.point.is_doubtful else style.solid(colour)
        axes.plot([a], [b], marker=marker, linestyle="none", zorder=4, **marks)


def _table(found):
    header = ["strategy", "triangles", "threads", "S", "lower", "upper", "sequential s",
              "n threads s", "runs"]
    return header, [[s.name, style.whole(_size(s)), str(s.point.threads),
                     f"{s.s:.2f}", f"{s.low:.2f}", f"{s.high:.2f}", style.digits(s.base.median),
                     style.digits(s.time.median), str(s.time.count)] for s in found]


def over_threads(scene, found, context, cores, name):
    sizes, looks = _sizes(found), _looks(found)
    top = max(s.point.threads for s in found)
    fig, grid = style.figure(max(7.2, 0.6 + 3.1 * len(sizes)), 4.6, 1, len(sizes), sharey=True)
    for axes, size in zip(grid[0], sizes):
        here = [s for s in found if _size(s) == size]
        for k, (line_name, line) in enumerate(records.by(here, lambda s: s.name).items()):
            line.sort(key=lambda s: s.point.threads)
            # Lines are shifted sideways so that bars of equal height stay visible.
            _marks(axes, [s.point.threads for s in line], line, looks[line_name], 1 + 0.012 * k)
        _ideal(axes, top)
        axes.set_title(f"{style.whole(size)} triangles, "
                       f"{style.duration(1e6 * here[0].base.median)}")
        axes.set_xlabel("threads $n$")
        axes.set_xlim(0.8, top + 0.3)
        axes.xaxis.set_major_locator(FixedLocator(sorted({s.point.threads for s in found})))
        if cores and 1 < cores <= top:
            axes.axvline(cores, color=style.MUTED, linewidth=0.9, linestyle=(0, (1, 1.5)),
                         zorder=1.5)
    grid[0][0].set_ylabel("speed-up $S(n)$")
    grid[0][0].set_ylim(0, 1.1 * max([top, *(s.high for s in found)]))
    handles = [style.key(line_name, *look, width=1.4) for line_name, look in looks.items()]
    handles.append(style.key("ideal", style.MUTED, line=(0, (4, 3)), width=1))
    style.finish(fig, f"Speed-up over threads: {scene}", style.caption_text(
        context, _conditions(found) + (" Dotted: the machine's cores." if cores else "")), handles)
    best = max(found, key=lambda s: s.s)
    return style.Picture(
        name, f"Speed-up over threads: {scene}",
        f"The largest speed-up in {scene} is {best.s:.2f} ({best.low:.2f} to {best.high:.2f}), by "
        f"{best.name} on {style.counted(best.point.threads, 'thread')}, of "
        f"{style.duration(1e6 * best.base.median)} by the sequential driver.", fig, *_table(found))


def over_sizes(scene, found, context, name):
    """None where there is one size only."""
    if len({_size(s) for s in found}) < 2:
        return None
    lines = records.by(found, lambda s: (s.name, s.point.threads))
    labels = {key: f"{key[0]}, {style.counted(key[1], 'thread')}" for key in lines}
    looks = errors_drawn.looks(labels.values())
    fig, grid = style.figure(7.4, 4.6)
    axes = grid[0][0]
    for key, line in lines.items():
        line.sort(key=_size)
        _marks(axes, [_size(s) for s in line], line, looks[labels[key]])
    axes.axhline(1, color=style.MUTED, linewidth=0.9, zorder=1.5)
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator(_sizes(found)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.size_label(value)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("triangles at the start")
    axes.set_ylabel("speed-up $S(n)$")
    axes.set_ylim(0, 1.1 * max(s.high for s in found))
    style.finish(fig, f"Speed-up over sizes: {scene}",
                 style.caption_text(context, _conditions(found)),
                 [style.key(label, *look, width=1.4) for label, look in looks.items()])
    largest = max(map(_size, found))
    top = max((s for s in found if _size(s) == largest), key=lambda s: s.s)
    return style.Picture(
        name, f"Speed-up over sizes: {scene}",
        f"At {style.whole(largest)} triangles {top.name} on "
        f"{style.counted(top.point.threads, 'thread')} is {top.s:.2f} times as fast as the "
        "sequential driver.", fig)

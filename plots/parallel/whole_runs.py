# SPDX-License-Identifier: MIT
"""S(n) of whole runs (FAMILY_run/.../between_us:N), against the other work that the application
does between two steps: threads that sleep meanwhile have to be woken, and caches are filled
anew."""
from look import style
from parallel import series

MARKERS = ("o", "s", "^", "D")


def between(row):
    """Other work before each step, in microseconds."""
    return int(float(dict(row.other).get("between_us", 0)))


def points(bench):
    """A Point for each parallel row; the sequential run is one with as much other work."""
    return [p for p in series.speedups(series.whole_runs(bench)) if not p.row.oversubscribed]


def draw(bench):
    """One Picture, or none if whole runs were not measured."""
    found = points(bench)
    if found:
        yield _picture(found, bench.context)


def _panels(found):
    """{(family, triangles): points}, as they are drawn."""
    panels = {}
    for p in sorted(found, key=lambda p: (p.row.family, p.row.triangles)):
        panels.setdefault((p.row.family, p.row.triangles), []).append(p)
    order = series.families([p.row for p in found])
    return dict(sorted(panels.items(), key=lambda item: (order.index(item[0][0]), item[0][1])))


def _name(here, between_them=", "):
    """Of the points of a panel."""
    return f"{series.title(here[0].row.family)}{between_them}{here[0].row.size}"


def plain(found):
    """What the most threads bring without other work, for the page."""
    words = []
    for here in _panels(found).values():
        most = max(p.n for p in here)
        first = min((p for p in here if p.n == most), key=lambda p: between(p.row))
        words.append(f"{first.s:.2f} ({_name(here)})")
    threads = style.counted(max(p.n for p in found), "thread")
    return f"Whole runs on {threads} are so many times as fast as sequential ones: " \
           + style.listing(words) + "."


def sentence(found):
    """The least and the most S(n) over all other work, and how long a run waits to begin."""
    parts = []
    for here in _panels(found).values():
        for n in sorted({p.n for p in here}):
            values = [p.s for p in here if p.n == n]
            parts.append(f"{_name(here)}: S({n}) is {min(values):.2f} to "
                         f"{max(values):.2f}")
    begins = [p.row.measurement.counter("construction_us") for p in found]
    return ("; ".join(parts) + ". A simulation is constructed in "
            f"{style.duration(min(begins))} to {style.duration(max(begins))}, which is not part of "
            "the steps; the first step is.")


def _plot(axes, here, places):
    axes.axhline(1, color=style.MUTED, linestyle=(0, (4, 3)), linewidth=1, zorder=2)
    colour = style.look("cells")[0]
    for n, marker in zip(sorted({p.n for p in here}), MARKERS):
        line = sorted((p for p in here if p.n == n), key=lambda p: between(p.row))
        x = [places.index(between(p.row)) for p in line]
        axes.errorbar(x, [p.s for p in line], color=colour, elinewidth=1, capsize=2.5, zorder=3,
                      linestyle="-" if n > 1 else (0, (1, 1.5)),
                      yerr=[[p.s - p.low for p in line], [p.high - p.s for p in line]])
        for place, p in zip(x, line):
            marks = style.doubtful(colour) if p.doubtful else style.solid(colour)
            axes.plot([place], [p.s], marker=marker, linestyle="none", zorder=4, **marks)
    axes.set_xticks(range(len(places)), [style.whole(place) for place in places])
    axes.set_xlim(-0.4, len(places) - 0.6)
    axes.set_xlabel("other work between steps, µs")


def _picture(found, context):
    panels = _panels(found)
    fig, grid = style.figure(max(7.2, 0.5 + 2.7 * len(panels)), 4.2, 1, len(panels), sharey=True)
    for axes, here in zip(grid[0], panels.values()):
        _plot(axes, here, sorted({between(p.row) for p in here}))
        axes.set_title(_name(here, ",\n"), fontsize=9)
    grid[0][0].set_ylim(0, 1.1 * max(p.high for p in found))
    grid[0][0].set_ylabel("speed-up  $S(n) = t_s\\,/\\,t_n$")
    colour = style.look("cells")[0]
    handles = [style.key(style.counted(n, "thread"), colour, marker,
                         "-" if n > 1 else (0, (1, 1.5)))
               for n, marker in zip(sorted({p.n for p in found}), MARKERS)]
    if any(p.doubtful for p in found):
        handles.append(style.key("under load", style.MUTED, "o", "none", style.doubtful))
    handles.append(style.key("as fast as sequential", style.MUTED, line=(0, (4, 3)), width=1))
    name = "Whole runs: speed-up with other work between the steps"
    style.finish(fig, name, style.caption_text(
        context, "All steps of a run with the first one, without what lies between them; strategy "
        "cells. Medians over repetitions; bars from the slowest to the fastest repetition."),
        handles)
    return style.Picture("whole_runs", name, plain(found), fig, *_table(found),
                         details=sentence(found))


def _table(found):
    header = ["scene", "size", "other work", "threads", "t_s a step", "t_n a step", "S(n)",
              "S(n) from – to", "construction", "first step", ""]
    rows = [[series.title(p.row.family), p.row.size,
             style.duration(between(p.row)) if between(p.row) else "none", str(p.n),
             style.duration(p.base.median), style.duration(p.row.median), f"{p.s:.2f}",
             f"{p.low:.2f} – {p.high:.2f}",
             *(style.duration(p.row.measurement.counter(key))
               for key in ("construction_us", "first_step_us")), ", ".join(p.flags())]
            for p in sorted(found, key=lambda p: (p.row.family, p.row.triangles,
                                                  between(p.row), p.n))]
    return header, rows

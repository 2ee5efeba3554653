#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws S(n) of whole runs against the other work that the application does between two steps: threads
that sleep meanwhile have to be woken, and caches are filled anew.

whole_runs.py FILE.json... --out PICTURE.pdf

The files are results of dsc_bench with rows NAME_run/.../between_us:N.
"""
import sys

from look import script, style  # first: it says which Python has no matplotlib

from results import load, series

MARKERS = ("o", "s", "^", "D")
LEVEL = (0, (4, 3))


def between(row):
    """Other work before each step, in microseconds."""
    return int(float(dict(row.other).get("between_us", 0)))


def points(bench):
    """A Point for each parallel row; the sequential run is one with as much other work."""
    return [p for p in series.speedups(series.whole_runs(bench)) if not p.row.oversubscribed]


def draw(bench):
    """One Picture, or none if whole runs were not measured."""
    found = points(bench)
    return [_picture(found, bench.context)] if found else []


def _panels(found):
    """The points of each panel: of a family and a size."""
    order, panels = series.families([p.row for p in found]), {}
    for p in sorted(found, key=lambda p: (order.index(p.row.family), p.row.triangles,
                                          between(p.row), p.n)):
        panels.setdefault((p.row.family, p.row.triangles), []).append(p)
    return list(panels.values())


def _name(here, between_them=", "):
    return f"{series.title(here[0].row.family)}{between_them}{here[0].row.size}"


def plain(found):
    """What the most threads bring without other work."""
    words = []
    for here in _panels(found):
        most = max(p.n for p in here)
        first = min((p for p in here if p.n == most), key=lambda p: between(p.row))
        words.append(f"{first.s:.2f} ({_name(here)})")
    threads = style.counted(max(p.n for p in found), "thread")
    return f"Whole runs on {threads} are so many times as fast as sequential ones: " \
           + style.listing(words) + "."


def _picture(found, context):
    panels, counts = _panels(found), sorted({p.n for p in found})
    looks = series.looks(series.by_label(found, lambda p: p.row.label))
    groups = [(label, n) for label in looks for n in counts]
    fig, grid = style.figure(max(7.2, 0.5 + 2.7 * len(panels)), 4.2, 1, len(panels), sharey=True)
    for axes, here in zip(grid[0], panels):
        axes.axhline(1, color=style.MUTED, linestyle=LEVEL, linewidth=1, zorder=2)
        places = sorted({between(p.row) for p in here})
        for k, (label, n) in enumerate(groups):
            shift = 0.12 * (k - len(groups) / 2 + 0.5)
            style.points(axes, [(places.index(between(p.row)) + shift, p.interval, p.doubtful)
                                for p in here if (p.row.label, p.n) == (label, n)],
                         looks[label][0], MARKERS[counts.index(n) % len(MARKERS)])
        axes.set_xticks(range(len(places)), [style.whole(place) for place in places])
        axes.set_xlim(-0.5, len(places) - 0.5)
        axes.set_xlabel("other work between steps, µs")
        axes.set_title(f"{_name(here, ', ')}\n$t_s$ = {style.duration(here[0].base.median)} a step",
                       fontsize=9)
    grid[0][0].set_ylim(0, 1.1 * max(p.interval[2] for p in found))
    grid[0][0].set_ylabel("speed-up  $S(n) = t_s\\,/\\,t_n$")
    handles = [style.key(f"{label}, {style.counted(n, 'thread')}", looks[label][0],
                         MARKERS[counts.index(n) % len(MARKERS)], "none") for label, n in groups]
    if any(p.doubtful for p in found):
        handles.append(style.key("under load", style.MUTED, "o", "none", style.doubtful))
    handles.append(style.key("as fast as sequential", style.MUTED, line=LEVEL, width=1))
    title = "Speed-up of whole runs, from the first step to the last"
    style.finish(fig, title, style.caption_text(
        context, style.bars_text([len(p.row.times) for p in found])
        + " Without constructing the simulation; with the first step."), handles)
    return style.Picture("whole_runs", title, plain(found), fig, *_table(found))


def _table(found):
    rows = []
    for p in found:
        counters = [p.row.measurement.counter(k) for k in ("construction_us", "first_step_us")]
        busy = p.row.measurement.counter("utilisation")
        rows.append([_name([p]), p.row.label, str(p.n), style.whole(between(p.row)),
                     style.duration(p.base.median), style.duration(p.row.median), f"{p.s:.2f}",
                     f"{p.u:.2f}", f"{busy:.2f}" if busy is not None else "–",
                     *(style.duration(c) if c is not None else "–" for c in counters),
                     ", ".join(p.flags())])
    return ["scene", "strategy", "threads", "other work µs", "t_s a step", "t_n a step", "S(n)",
            "S(n) / n", "U(n)", "construction", "first step", ""], rows


def main(argv=None):
    return script.main(__doc__, lambda given: draw(load.read_bench(given.files)), argv)


if __name__ == "__main__":
    sys.exit(main())

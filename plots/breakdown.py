#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the parts of the time of a step: measured on one thread, and modelled for n threads as parts of n
times the wall time of a step.

breakdown.py FILE.json... --out PICTURE.pdf

The files are results of dsc_bench with modelled rows (measure = "model" in a suite).
"""
import sys

from look import script, style  # first: reports a Python without matplotlib

from results import load, series

# counter, name, colour; the first five run in parallel, the others serially.
PARTS = [("us_remeshing", "interface remeshing", style.SKY),
         ("us_velocities", "velocities", style.DARK_YELLOW),
         ("us_movement", "movement", style.GREEN),
         ("us_mesh_update", "mesh update", style.BLUE),
         ("us_later_colours", "later colours", style.PURPLE),
         ("us_set_up", "set-up (serial)", "#F7CFA3"),
         ("us_hand_over", "hand-over (serial)", style.ORANGE),
         ("us_clean_up", "clean-up (serial)", "#8C3A00"),
         ("us_driver", "driver (serial)", style.VERMILLION)]
USES = [("work", "work in parallel sections", "#6B8CA6"),
        ("serial", "serial parts", style.INK),
        ("idle", "others idle during serial parts", "#E6C2AD"),
        ("waiting", "waiting in parallel sections", style.FAINT)]
STRATEGIES = ("cells", "active")
THREADS = (2, 4, 8, 16)
WRITE_FROM = 0.09  # of the tallest bar: smaller pieces have no number


def parts(row):
    """{counter: microseconds} of the step on one thread, or {} if it was not written."""
    values = {key: row.measurement.counter(key) for key, _, _ in PARTS}
    return {} if all(v is None for v in values.values()) else {
        key: value or 0.0 for key, value in values.items()}


def uses(row):
    """{use: microseconds}; the sum is n times the modelled wall time of a step.

    With t the wall time, w the work in parallel sections, p their wall time: serial share
    s = (t - p) / (t - p + w) and busy share b = w / (n p), hence p = t / (1 + n b s / (1 - s)).
    """
    share, busy = (row.measurement.counter(k) for k in ("serial_share", "busy_share"))
    if share is None or busy is None or not 0 <= share < 1:
        return {}
    n, wall = row.threads, row.median
    parallel = wall / (1 + n * busy * share / (1 - share))
    serial = wall - parallel
    return {"work": n * busy * parallel, "serial": serial, "idle": (n - 1) * serial,
            "waiting": max(0.0, n * (1 - busy) * parallel)}


def _bars(rows, size):
    """[(strategy, n, values)] of one size: measured on one thread, modelled on more."""
    def find(strategy, n, values):
        return [(strategy, n, found) for r in rows if (r.triangles, r.strategy, r.threads)
                == (size, strategy, n) and (found := values(r))][:1]

    return ([bar for s in STRATEGIES for bar in find(s, 1, parts)],
            [bar for s in STRATEGIES for n in THREADS for bar in find(s, n, uses)])


def plain(family, rows):
    """The largest part of a step on one thread, at the largest size."""
    found = [r for r in rows if r.threads == 1 and parts(r)]
    if not found:
        return "No row has the parts of the time of a step on one thread."
    row = max(found, key=lambda r: (r.triangles, r.strategy == STRATEGIES[0]))
    values = parts(row)
    key, name, _ = max(PARTS, key=lambda part: values[part[0]])
    return (f"In the {series.title(family)}, at {style.whole(row.triangles)} triangles, the "
            f"largest part of a step on one thread is the {name}, with "
            f"{100 * values[key] / sum(values.values()):.0f} % of the time.")


def _ink(colour):
    """Black or white, whichever is more readable on a colour."""
    red, green, blue = (int(colour[k:k + 2], 16) for k in (1, 3, 5))
    return "white" if 0.3 * red + 0.59 * green + 0.11 * blue < 140 else style.INK


def _stack(axes, bars, kinds, base):
    """A bar for each entry, with shares written into the larger pieces, and a line at `base`."""
    tallest = max([sum(values.values()) for *_, values in bars], default=1)
    for place, (_, _, values) in enumerate(bars):
        bottom, total = 0.0, sum(values.values())
        for key, _, colour in kinds:
            axes.bar(place, values[key], 0.7, bottom, color=colour, edgecolor="white",
                     linewidth=0.4, zorder=3)
            if values[key] >= max(WRITE_FROM * tallest, 0.05 * total):
                axes.text(place, bottom + values[key] / 2, f"{100 * values[key] / total:.0f} %",
                          ha="center", va="center", fontsize=7, zorder=6, color=_ink(colour))
            bottom += values[key]
    strategies = {strategy for strategy, *_ in bars}
    axes.set_xticks(range(len(bars)), [str(n) if n > 1 and len(strategies) == 1 else
                                       f"{strategy}\n{n}" if n > 1 else strategy
                                       for strategy, n, _ in bars])
    axes.set_xlim(-0.8, max(len(bars), 2) - 0.2)
    axes.grid(False, axis="x")
    axes.tick_params(axis="x", length=0)
    axes.set_ylim(0, 1.12 * max(tallest, base or 0))
    if base:
        axes.axhline(base, color=style.INK, linewidth=1, linestyle=style.SHORT_DASHES, zorder=5)


def draw(bench):
    """A Picture for each family with the parts of the time."""
    measured, rows = series.rows(bench), series.modelled(bench)
    for family in series.families(rows):
        mine = [r for r in rows if r.family == family and r.strategy in STRATEGIES]
        sizes = [s for s in sorted({r.triangles for r in mine}) if all(_bars(mine, s))]
        if sizes:
            yield _picture(family, [r for r in mine if r.triangles in sizes], measured, sizes,
                           bench.context)


def _picture(family, rows, measured, sizes, context):
    fig, grid = style.figure(max(7.2, 0.5 + 3.6 * len(sizes)), 7.6, 2, len(sizes))
    for column, size in enumerate(sizes):
        base = series.base_of(next(r for r in rows if r.triangles == size), measured)
        for axes, bars, kinds in zip(grid[:, column], _bars(rows, size), (PARTS, USES)):
            _stack(axes, bars, kinds, base and base.median)
        grid[0][column].set_title(f"{style.whole(size)} triangles, one thread, measured")
        grid[1][column].set_title("more threads, modelled and not measured")
        grid[1][column].set_xlabel("threads")
    grid[0][0].set_ylabel("time of a step (µs)")
    grid[1][0].set_ylabel("threads × time of a step (µs)")
    handles = [style.square(name, colour) for _, name, colour in PARTS]
    handles += [style.square(f"modelled: {name}", colour) for _, name, colour in USES]
    handles.append(style.key("sequential step", style.INK, line=style.SHORT_DASHES, width=1))
    title = f"The parts of the time of a step: {series.title(family)}"
    style.finish(fig, title, style.caption_text(
        context, "Above: measured on one thread, summed over submeshes; everything except the "
        "later colours and the serial parts belongs to the first colour.\nBelow: modelled, not "
        "measured, from the measured time of each task. Waiting: for a task that is not ready, for "
        "the last task of a section, and for threads to start and join."), handles)
    return style.Picture(f"breakdown_{family}", title, plain(family, rows), fig, *_table(rows))


def _table(rows):
    header = (["triangles", "strategy", "threads", "kind", "a step"]
              + [f"{name}, µs" for _, name, _ in PARTS + USES])
    lines = []
    for r in sorted(rows, key=lambda r: (r.triangles, style.order(r.strategy), r.threads)):
        values = parts(r) if r.threads == 1 else uses(r) if r.threads in THREADS else {}
        if values:
            took = sum(values.values()) if r.threads == 1 else r.median
            lines.append([style.whole(r.triangles), r.strategy, str(r.threads),
                          "measured" if r.threads == 1 else "modelled", style.duration(took)]
                         + [style.digits(values.get(key)) for key, _, _ in PARTS + USES])
    return header, lines


def main(argv=None):
    return script.main(__doc__, lambda given: draw(load.read_bench(given.files)), argv)


if __name__ == "__main__":
    sys.exit(main())

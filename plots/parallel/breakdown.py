# SPDX-License-Identifier: MIT
"""Where the time of a step goes: its parts as measured on one thread, and what n modelled threads
spend n times the wall time of a step on."""
import numpy

from parallel import series
from look import style

# counter, name, colour; the first five run in parallel, the others serially.
PARTS = [("us_upkeep", "interface upkeep", style.SKY),
         ("us_velocities", "velocities", style.DARK_YELLOW),
         ("us_movement", "movement", style.GREEN),
         ("us_mesh_update", "mesh update", style.BLUE),
         ("us_later_colours", "later colours", style.PURPLE),
         ("us_set_up", "set-up (serial)", "#F7CFA3"),
         ("us_hand_over", "hand-over (serial)", style.ORANGE),
         ("us_clean_up", "clean-up (serial)", "#8C3A00"),
         ("us_driver", "driver (serial)", style.VERMILLION)]
PARALLEL = 5
USES = [("work", "work in parallel sections", "#6B8CA6"),
        ("serial", "serial parts", style.INK),
        ("idle", "others idle during serial parts", "#E6C2AD"),
        ("waiting", "waiting in parallel sections", style.FAINT)]
STRATEGIES = ("cells", "active")
THREADS = (2, 4, 8, 16)
WRITE_FROM = 0.09  # of the tallest bar: smaller pieces carry no number


def parts(row):
    """{counter: microseconds} of the step on one thread, or {} where it was not written."""
    values = {key: row.measurement.counter(key) for key, _, _ in PARTS}
    return {} if all(v is None for v in values.values()) else {
        key: value or 0.0 for key, value in values.items()}


def uses(row):
    """{use: microseconds}, whose sum is n times the modelled wall time of a step.

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


def _at(rows, size, strategy, threads):
    return next((r for r in rows if r.triangles == size and r.strategy == strategy
                 and r.threads == threads), None)


def _panel_rows(rows, size):
    """[(strategy, n, row)] of the bars of one size: the measured ones and the modelled ones."""
    ones = [(s, 1, r) for s in STRATEGIES if (r := _at(rows, size, s, 1)) and parts(r)]
    many = [(s, n, r) for s in STRATEGIES for n in THREADS
            if (r := _at(rows, size, s, n)) and uses(r)]
    return ones, many


def plain(family, rows):
    """The largest part of a step on one thread, at the largest size."""
    found = [r for r in rows if r.threads == 1 and parts(r)]
    if not found:
        return "No row says where the time of a step on one thread goes."
    row = max(found, key=lambda r: (r.triangles, r.strategy == STRATEGIES[0]))
    values = parts(row)
    key, name, _ = max(PARTS, key=lambda part: values[part[0]])
    return (f"In the {series.title(family)}, at {style.whole(row.triangles)} triangles, the "
            f"largest part of a step on one thread is the {name}, with "
            f"{100 * values[key] / sum(values.values()):.0f} % of the time.")


def sentence(family, rows):
    """For the largest size: the largest part, later colours, serial parts; then the model."""
    words = []
    for strategy in STRATEGIES:
        found = [r for r in rows if r.strategy == strategy and r.threads == 1 and parts(r)]
        if not found:
            continue
        row = max(found, key=lambda r: r.triangles)
        values = parts(row)
        total = sum(values.values())
        largest = max(PARTS, key=lambda part: values[part[0]])
        serial = sum(values[key] for key, _, _ in PARTS[PARALLEL:])
        text = (f"with {strategy} at {style.whole(row.triangles)} triangles one thread spends "
                f"{100 * values[largest[0]] / total:.0f} % of a step of {style.duration(total)} "
                f"on {largest[1]}, {100 * values['us_later_colours'] / total:.1f} % on later "
                f"colours and {100 * serial / total:.1f} % serially")
        many = [r for r in rows if r.strategy == strategy and r.triangles == row.triangles
                and r.threads in THREADS and uses(r)]
        if many:
            most = max(many, key=lambda r: r.threads)
            spent = uses(most)
            whole = sum(spent.values())
            text += (f"; modelled on {most.threads} threads, "
                     f"{100 * spent['work'] / whole:.0f} % of the threads' time is work, "
                     f"{100 * (spent['serial'] + spent['idle']) / whole:.0f} % goes to serial "
                     f"parts and {100 * spent['waiting'] / whole:.0f} % to waiting for each "
                     "other")
        words.append(text)
    return f"In the {series.title(family)}, " + "; ".join(words) + "." if words else ""


def _stack(axes, bars, kinds, tallest):
    """bars: [(place, width, {key: value})]; writes the share into the larger pieces."""
    for place, width, values in bars:
        bottom, total = 0.0, sum(values.values())
        for key, _, colour in kinds:
            value = values[key]
            axes.bar(place, value, width, bottom, color=colour, edgecolor="white", linewidth=0.4,
                     zorder=3)
            if value >= WRITE_FROM * tallest and value >= 0.05 * total and width > 0.35:
                axes.text(place, bottom + value / 2, f"{100 * value / total:.0f} %", ha="center",
                          va="center", fontsize=7, zorder=6, color=_ink(colour))
            bottom += value


def _ink(colour):
    """Black or white, whichever reads better on a colour."""
    red, green, blue = (int(colour[k:k + 2], 16) for k in (1, 3, 5))
    return "white" if 0.3 * red + 0.59 * green + 0.11 * blue < 140 else style.INK


def _measured_panel(axes, ones, base):
    tallest = max([sum(parts(r).values()) for _, _, r in ones], default=1)
    width = 0.55 if len(ones) > 1 else 0.36
    _stack(axes, [(k, width, parts(r)) for k, (_, _, r) in enumerate(ones)], PARTS, tallest)
    axes.set_xticks(range(len(ones)), [s for s, _, _ in ones])
    axes.set_xlim(-0.8, len(ones) - 0.2)
    _finish_panel(axes, base, tallest)


def _modelled_panel(axes, many, base):
    places, labels, groups = [], [], {}
    for strategy, n, _ in many:
        place = len(places) + 0.8 * (len(set(groups) | {strategy}) - 1)
        places.append(place)
        labels.append(str(n))
        groups.setdefault(strategy, []).append(place)
    tallest = max([sum(uses(r).values()) for _, _, r in many], default=1)
    _stack(axes, [(p, 0.78, uses(r)) for p, (_, _, r) in zip(places, many)], USES, tallest)
    axes.set_xticks(places, labels)
    for strategy, where in groups.items():
        text = f"{strategy}, modelled" if len(groups) > 1 else f"threads, modelled: {strategy}"
        axes.annotate(text, (numpy.mean(where), 0), (0, -17), fontsize=8.5,
                      xycoords=axes.get_xaxis_transform(), textcoords="offset points",
                      ha="center", va="top")
    axes.set_xlim(-0.7, (places[-1] if places else 0) + 0.7)
    _finish_panel(axes, base, tallest)


def _finish_panel(axes, base, tallest):
    axes.grid(False, axis="x")
    axes.tick_params(axis="x", length=0)
    axes.set_ylim(0, 1.12 * max(tallest, base or 0))
    if base:
        axes.axhline(base, color=style.INK, linewidth=1, linestyle=(0, (2.5, 1.5)), zorder=5)


def draw(bench):
    """A Picture for each family with an account of where the time goes."""
    measured, rows = series.rows(bench), series.modelled(bench)
    for family in series.families(rows):
        mine = [r for r in rows if r.family == family and r.strategy in STRATEGIES]
        sizes = [s for s in sorted({r.triangles for r in mine}) if all(_panel_rows(mine, s))]
        if sizes:
            yield _picture(family, [r for r in mine if r.triangles in sizes], measured, sizes,
                           bench.context)


def _picture(family, rows, measured, sizes, context):
    fig, grid = style.figure(max(7.2, 0.5 + 3.6 * len(sizes)), 7.6, 2, len(sizes))
    for column, size in enumerate(sizes):
        ones, many = _panel_rows(rows, size)
        base = series.base_of(ones[0][2], measured)
        base = base.median if base else None
        _measured_panel(grid[0][column], ones, base)
        _modelled_panel(grid[1][column], many, base)
        grid[0][column].set_title(f"{style.whole(size)} triangles, one thread, measured")
        grid[1][column].set_title("more threads, modelled and not measured")
    grid[0][0].set_ylabel("time of a step (µs)")
    grid[1][0].set_ylabel("threads × time of a step (µs)")
    handles = [style.square(name, colour) for _, name, colour in PARTS]
    handles += [style.square(f"modelled: {name}", colour) for _, name, colour in USES]
    handles.append(style.key("sequential step", style.INK, line=(0, (2.5, 1.5)), width=1))
    name = f"Where the time of a step goes: {series.title(family)}"
    style.finish(fig, name, style.caption_text(
        context, "Above: measured on one thread, summed over submeshes; everything except the "
        "later colours and the serial parts belongs to the first colour.\nBelow: modelled, not "
        "measured, from the shortest measured time of each task. Waiting: for a task that is not ready, for "
        "the last task of a section, and for threads to start and join."), handles)
    return style.Picture("breakdown_" + series.title(family).replace(" ", "_"), name,
                         plain(family, rows), fig, *_table(rows),
                         details=sentence(family, rows))


def _table(rows):
    header = (["triangles", "strategy", "threads", "kind", "a step"]
              + [f"{name}, µs" for _, name, _ in PARTS] + [f"{name}, µs" for _, name, _ in USES])
    lines = []
    for r in sorted(rows, key=lambda r: (r.triangles, style.order(r.strategy), r.threads)):
        place = [style.whole(r.triangles), r.strategy, str(r.threads)]
        if r.threads == 1 and parts(r):
            values = parts(r)
            lines.append(place + ["measured", style.duration(sum(values.values()))]
                         + [style.digits(values[k]) for k, _, _ in PARTS] + ["–"] * len(USES))
        elif r.threads in THREADS and uses(r):
            values = uses(r)
            lines.append(place + ["modelled", style.duration(r.median)] + ["–"] * len(PARTS)
                         + [style.digits(values[k]) for k, _, _ in USES])
    return header, lines

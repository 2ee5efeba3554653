#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the time of a step against the number of triangles, and per interface vertex: the cost of a step
that visits only changes grows with the interface, that of a sweep of the mesh with the triangles.

step_cost.py FILE.json... --out PICTURE.pdf

The files are results of dsc_bench with rows NAME_step; modelled rows are left out. With rows
operation/NAME and kernel/gather_star, a dash shows the time of the stars and edits of a step alone.
"""
import math
import statistics
import sys

from look import script, style  # first: reports a Python without matplotlib

from results import load, series

PEER_MARKERS = ["*", "p", "<", "d"]
GUIDES = ((1.0, "grows with the mesh", "-"), (0.5, "grows with its square root", (0, (5, 2))))
PEER_SCENES = {"scaling_step": "speedup-scaling", "four_circles_step": "speedup-four-circles",
               "swirl_step": "swirl"}
DOUBTFUL = "oversubscribed or under load"
# Counter of a step: the row that times one such item alone, and its items for one: gather_star counts triangles, of
# which there are two for each vertex.
PARTS = {"examined_per_step": ("kernel", "gather_star", 2), "flips_per_step": ("operation", "edge_flip", 1),
         "splits_per_step": ("operation", "edge_split", 1),
         "collapses_per_step": ("operation", "edge_collapse", 1)}
FLOOR = "bound, modelled: stars read once and edits alone"
BOUND = {"marker": "_", "markersize": 11, "markeredgewidth": 1.8}


def chosen(found):
    """{label: rows over sizes}: the serial strategies, and each parallel one with the largest number of
    threads that is not oversubscribed (or its smallest number if all are)."""
    lines = {}
    for label, line in series.by_label(found).items():
        if line[0].strategy not in series.SERIAL:
            fair = [r.threads for r in line if not r.oversubscribed]
            threads = max(fair) if fair else min(r.threads for r in line)
            line = [r for r in line if r.threads == threads]
            label = f"{label}, {style.counted(threads, 'thread')}"
        lines[label] = line
    return lines


def peers(family, published):
    """[(name, [(triangles, microseconds per step)])] of other programs."""
    found = {}
    for v in load.values(published, "peers", "official_dsc_step"):
        if v["scene"] == PEER_SCENES.get(family):
            found.setdefault("official 2D DSC", []).append((v["triangles"], v["ms_per_step"] * 1e3))
    adapted = load.values(published, "peers", "mesh_adaptation_step")
    for v in adapted if family == "scaling_step" else ():
        found.setdefault(v["tool"], []).append((v["triangles"], v["seconds_per_step"] * 1e6))
    return [(name, sorted(points)) for name, points in found.items()]


def per_vertex(row):
    """Microseconds for each interface vertex, one value for each repetition."""
    values = row.measurement.counters.get("us_per_vertex_step", [])
    vertices = row.measurement.counter("interface_vertices")
    return values or ([t / vertices for t in row.times] if vertices else [])


def floor(bench, row):
    """Lower bound of the microseconds of a step of the row, if it reads each examined star once and makes
    only its edits; None if a part of this was not counted or measured."""
    total = 0
    for counter, (family, name, items) in PARTS.items():
        rates = [rate for m in bench.measurements if m.family == family and m.positions[:1] == [name]
                 for rate in m.counters.get("items_per_second", [])]
        count = row.measurement.counter(counter)
        if count is None or not rates:
            return None
        total += count * items * 1e6 / statistics.median(rates)
    return total


def _sequential(lines):
    return next((line for label, line in lines.items() if label.startswith("sequential")), [])


def plain(lines):
    """A sentence on the growth of a step with the mesh, for the scene with the largest range of sizes."""
    found = [(family, line) for family in lines if (line := _sequential(lines[family]))]
    if not found:
        return "No step was measured on one thread."
    family, line = max(found, key=lambda pair: pair[1][-1].triangles / pair[1][0].triangles)
    first, last = line[0], line[-1]
    if last.triangles <= first.triangles:
        return (f"In the {series.title(family)} a step of {style.whole(first.triangles)} triangles "
                f"takes {style.duration(first.median)} on one thread.")
    return (f"In the {series.title(family)} a mesh with "
            f"{style.digits(last.triangles / first.triangles, 2)} times as many triangles makes a "
            f"step {style.digits(last.median / first.median, 2)} times as long: "
            f"{style.duration(last.median)} in place of {style.duration(first.median)}.")


def plain_per_vertex(lines):
    values = [style.interval(per_vertex(r))[1] for family in lines for r in _sequential(lines[family])]
    if not values:
        return "No step on one thread states its cost per interface vertex."
    low, high = style.duration(min(values)), style.duration(max(values))
    return ("For each vertex of the interface a step on one thread costs "
            + (low if low == high else f"from {low} to {high}") + ", over all scenes and sizes.")


def draw(bench, published):
    found = [r for r in series.rows(bench) if r.family != series.GRANULARITY]
    lines = {family: chosen([r for r in found if r.family == family])
             for family in series.families(found)}
    if not lines:
        return []
    title = "Time of a step against the size of the mesh"
    floors = {id(r): us for these in lines.values() for r in _sequential(these)
              if (us := floor(bench, r)) is not None}
    fig = _figure(lines, lambda r: r.times, bench.context, title, published, floors)
    pictures = [style.Picture("step_cost", title, plain(lines), fig, *_table(lines))]
    kept = {f: {k: some for k, line in these.items() if (some := [r for r in line if per_vertex(r)])}
            for f, these in lines.items()}
    kept = {f: these for f, these in kept.items() if these}
    if kept:
        title = "Time per interface vertex and step"
        of_vertex = {id(r): floors[id(r)] / r.measurement.counter("interface_vertices")
                     for these in kept.values() for r in _sequential(these) if id(r) in floors}
        fig = _figure(kept, per_vertex, bench.context, title, {}, of_vertex)
        pictures.append(style.Picture("step_cost_per_vertex", title, plain_per_vertex(kept), fig))
    return pictures


def _figure(lines, values, context, title, published, floors):
    """A panel for each scene, narrow if it has only one size; values(row): one for each repetition; floors:
    {id of a row on one thread: its bound}."""
    rows = [r for these in lines.values() for line in these.values() for r in line]
    sizes = sorted({r.triangles for r in rows})
    names = {label: line[0].label for these in lines.values() for label, line in these.items()}
    names = dict(sorted(names.items(), key=lambda pair: (
        style.order(series.strategy_of(pair[1])), pair[1], pair[0])))
    of_row = series.looks(dict.fromkeys(names.values()))
    looks = {label: of_row[row] for label, row in names.items()}
    widths = [1.0 if len({r.triangles for line in these.values() for r in line}) > 1 else 0.55
              for these in lines.values()]
    fig, grid = style.figure(max(7.2, 0.4 + 4.0 * sum(widths)), 5.0, 1, len(lines), sharex=True,
                             sharey=True, gridspec_kw={"width_ratios": widths})
    others, guided = {}, False
    for axes, (family, these) in zip(grid[0], lines.items()):
        for label, line in these.items():
            entries = [(r.triangles, style.interval(values(r)), r.doubtful) for r in line]
            # Sizes are a continuous scale, so points are joined by lines.
            axes.plot([x for x, *_ in entries], [t[1] for _, t, _ in entries],
                      color=looks[label][0], linewidth=1.2, zorder=3)
            style.points(axes, entries, *looks[label])
        for name, points in peers(family, published):
            marker = others.setdefault(name, PEER_MARKERS[len(others) % len(PEER_MARKERS)])
            axes.plot(*zip(*points), color=style.MUTED, linewidth=0.9, linestyle=style.DOTTED,
                      zorder=2.5, **style.other(marker))
        axes.set(xscale="log", yscale="log", xlabel="triangles", title=series.title(family))
        axes.set_xticks(sizes, [style.size_label(size) for size in sizes])
        axes.yaxis.set_major_formatter(lambda value, _: style.tick(value))
        axes.minorticks_off()
        line = _sequential(these)
        bounds = [(r.triangles, floors[id(r)]) for r in line if id(r) in floors]
        axes.plot([x for x, _ in bounds], [us for _, us in bounds], color=style.INK, linestyle="none", zorder=4,
                  **BOUND)
        for power, _, dash in GUIDES if len(line) > 1 and values is not per_vertex else ():
            guided, ends = True, [line[0].triangles, line[-1].triangles]
            axes.plot(ends, [line[0].median, line[0].median * (ends[1] / ends[0]) ** power],
                      color=style.FAINT, linewidth=1.3, linestyle=dash, zorder=1)
    bottom, ceiling = grid[0][0].get_ylim()
    if ceiling / bottom < 10:  # at least a decade, or the logarithmic axis has no tick
        middle = math.sqrt(bottom * ceiling)
        grid[0][0].set_ylim(middle / 3.3, middle * 3.3)
    grid[0][0].set_ylabel("time per interface vertex and step" if values is per_vertex
                          else "time of a step")
    handles = [style.key(label, *look) for label, look in looks.items()]
    if any(r.doubtful for r in rows):
        handles.append(style.key(DOUBTFUL, style.MUTED, "o", "none", style.doubtful))
    handles += [style.key(name, style.MUTED, line=style.DOTTED, width=0.9, marks=style.other(marker))
                for name, marker in others.items()]
    if floors:
        handles.append(style.key(FLOOR, style.INK, line="none", marks=BOUND))
    handles += [style.key(name, style.FAINT, line=dash) for _, name, dash in GUIDES if guided]
    style.finish(fig, title, style.caption_text(
        context, style.bars_text([len(r.times) for r in rows])
        + (" Grey: other programs, CPU time on one thread." if others else "")
        + (" A horizontal line means that the cost grows with the interface and not with the mesh."
           if values is per_vertex else " The number of interface vertices is about the square root "
           "of the number of triangles.")), handles)
    return fig


def _table(lines):
    header = ["scene", "strategy", "triangles", "median", "range µs", "repetitions",
              "worst quality", "peak MB", ""]
    return header, [
        [series.title(f), label, style.whole(r.triangles), style.duration(r.median),
         f"{min(r.times):,.1f} – {max(r.times):,.1f}", str(len(r.times)),
         style.digits(r.measurement.counter("min_quality")),
         style.digits(r.measurement.counter("peak_memory_mb")), ", ".join(r.flags())]
        for f, these in lines.items() for label, line in these.items() for r in line]


def main(argv=None):
    return script.main(__doc__, lambda given: draw(load.read_bench(given.files), {}), argv)


if __name__ == "__main__":
    sys.exit(main())

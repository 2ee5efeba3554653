# SPDX-License-Identifier: MIT
"""Time of a step against the number of triangles, and per interface vertex: a step that touches
only what changed grows with the interface, one that sweeps the mesh grows with the triangles.
Measured rows only; what was modelled stays out."""
import math
import statistics

from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator

from results import load
from parallel import series
from look import strip
from look import style

PEER_MARKERS = ["*", "p", "<", "d"]
GUIDES = ((1.0, "grows with the mesh", "-"), (0.5, "grows with its square root", (0, (5, 2))))
PEER_SCENES = {"scaling_step": "speedup-scaling", "four_circles_step": "speedup-four-circles",
               "swirl_step": "swirl"}
DOUBTFUL = "oversubscribed or under load"


def chosen(found):
    """{label: rows over sizes}: the serial strategies, and each parallel one at the largest
    number of threads that is not oversubscribed (or its smallest, where all are)."""
    lines = {}
    for label, line in series.by_label(found).items():
        if line[0].strategy in series.SERIAL:
            lines[label] = line
            continue
        fair = [r.threads for r in line if not r.oversubscribed]
        threads = max(fair) if fair else min(r.threads for r in line)
        name = f"{label}, {style.counted(threads, 'thread')}"
        lines[name] = [r for r in line if r.threads == threads]
    return lines


def peers(family, published):
    """[(name, [(triangles, microseconds a step)])] measured on other programs."""
    result = []
    official = load.entry(published, "peers", "official_dsc_step")
    here = [v for v in (official or {"values": []})["values"]
            if v["scene"] == PEER_SCENES.get(family)]
    if here:
        result.append(("official 2D DSC", [(v["triangles"], v["ms_per_step"] * 1e3)
                                           for v in here]))
    adapt = load.entry(published, "peers", "mesh_adaptation_step")
    if adapt and family == "scaling_step":
        for tool in sorted({v["tool"] for v in adapt["values"]}):
            result.append((tool, sorted((v["triangles"], v["seconds_per_step"] * 1e6)
                                        for v in adapt["values"] if v["tool"] == tool)))
    return result


def _growth(line):
    """(first, last, exponent) of a line over at least two sizes, or None."""
    first, last = line[0], line[-1]
    if last.triangles <= first.triangles:
        return None
    return first, last, (math.log(last.median / first.median)
                         / math.log(last.triangles / first.triangles))


def plain(names, lines):
    """How a step grows with the mesh, in the scene with the largest range of sizes."""
    found = [(family, line) for family in names for label, line in lines[family].items()
             if label.startswith("sequential")]
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


def plain_per_vertex(names, lines):
    values = [statistics.median(_per_vertex(r)) for family in names
              for label, line in lines[family].items() if label.startswith("sequential")
              for r in line]
    if not values:
        return "No step on one thread states its cost per interface vertex."
    low, high = style.duration(min(values)), style.duration(max(values))
    return ("For each vertex of the interface a step on one thread costs "
            + (low if low == high else f"from {low} to {high}") + ", over all scenes and sizes.")


def sentence(family, lines, theirs):
    words = []
    for label, line in lines.items():
        grown = _growth(line)
        if label.startswith("sequential") and grown:
            first, last, power = grown
            words.append(
                f"from {style.whole(first.triangles)} to {style.whole(last.triangles)} triangles "
                f"the {label} step grows from {style.duration(first.median)} to "
                f"{style.duration(last.median)}, as the number of triangles to the power "
                f"{power:.2f}")
        elif label.startswith("sequential"):
            words.append(f"the {label} step takes {style.duration(line[0].median)} at "
                         f"{style.whole(line[0].triangles)} triangles")
    sequential = next((v for k, v in lines.items() if k.startswith("sequential")), [])
    by_size = {r.triangles: r.median for r in sequential}
    for label, line in lines.items():
        shared = [r for r in line if r.triangles in by_size]
        if label.startswith("reference") and shared:
            row = shared[-1]
            words.append(f"the literal reference takes {style.duration(row.median)} at "
                         f"{style.whole(row.triangles)} triangles, "
                         f"{style.digits(row.median / by_size[row.triangles])} times as long")
    parallel = [r for label, line in lines.items() for r in line
                if r.strategy not in series.SERIAL and not r.oversubscribed]
    if parallel:
        largest = max(r.triangles for r in parallel)
        best = min((r for r in parallel if r.triangles == largest), key=lambda r: r.median)
        words.append(f"the fastest parallel step at {style.whole(largest)} triangles is "
                     f"{best.label} with {style.counted(best.threads, 'thread')}, "
                     f"{style.duration(best.median)}")
    if sequential and theirs:
        name, (size, time) = min(((n, p) for n, points in theirs for p in points),
                                 key=lambda pair: pair[1][1])
        words.append(f"the fastest of the other programs, {name}, took {style.duration(time)} at "
                     f"{style.whole(size)} triangles")
    if not words:
        words = ["every row has more threads than there are cores"]
    return f"In the {series.title(family)}, " + "; ".join(words) + "."


def _axis(axes, sizes):
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator(sizes))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.size_label(value)))
    axes.set_xlabel("triangles")


def _plot(axes, line, values, look):
    """values(row) gives one number a repetition."""
    colour, marker = look
    sizes = [r.triangles for r in line]
    middle = [statistics.median(values(r)) for r in line]
    bars = [[m - min(values(r)) for m, r in zip(middle, line)],
            [max(values(r)) - m for m, r in zip(middle, line)]]
    axes.plot(sizes, middle, color=colour, zorder=3)
    axes.errorbar(sizes, middle, yerr=bars, fmt="none", ecolor=colour, elinewidth=1, capsize=2.5,
                  zorder=3.2)
    for size, value, row in zip(sizes, middle, line):
        marks = style.doubtful(colour) if row.doubtful else style.solid(colour)
        axes.plot([size], [value], marker=marker, color=colour, linestyle="none", zorder=4,
                  **marks)


def _per_vertex(row):
    values = row.measurement.counters.get("us_per_vertex_step", [])
    if not values and row.measurement.counter("interface_vertices"):
        values = [t / row.measurement.counter("interface_vertices") for t in row.times]
    return values


def draw(bench, published):
    found = [r for r in series.rows(bench) if r.family != series.GRANULARITY]
    names = series.families(found)
    if not names:
        return []
    if len({r.triangles for r in found}) == 1:
        return [_strips(names, found, bench.context, published)]
    return _steps(names, found, bench.context, published) + _vertices(names, found, bench.context)


def _common(names, found):
    lines = {family: chosen([r for r in found if r.family == family]) for family in names}
    plain = {label: line[0].label for these in lines.values() for label, line in these.items()}
    plain = dict(sorted(plain.items(), key=lambda pair: (
        style.order(series.strategy_of(pair[1])), pair[1], pair[0])))
    looks = series.looks(dict.fromkeys(plain.values()))
    sizes = sorted({r.triangles for line in lines.values() for l in line.values() for r in l})
    return lines, {label: looks[row] for label, row in plain.items()}, sizes


def _legend(looks, lines):
    handles = [style.key(label, *look) for label, look in looks.items()]
    if any(r.doubtful for line in lines.values() for l in line.values() for r in l):
        handles.append(style.key(DOUBTFUL, style.MUTED, "o", "none", style.doubtful))
    return handles


def _strips(names, found, context, published):
    """The picture of a run with one size only: a strip of times for each scene."""
    lines, looks, sizes = _common(names, found)
    entries = {}
    for family in names:
        entries[family] = [
            (label, line[0].times, {"marker": looks[label][1], **(
                style.doubtful if line[0].doubtful else style.solid)(looks[label][0])},
             looks[label][0]) for label, line in lines[family].items()]
        for (name, points), marker in zip(peers(family, published), PEER_MARKERS):
            size, time = min(points, key=lambda point: abs(math.log(point[0] / sizes[0])))
            entries[family].append((f"{name}, {style.size_label(round(size, -2))} triangles",
                                    [time], style.other(marker), style.MUTED))
    counts = [len(e) for e in entries.values()]
    fig, grid = style.figure(7.2, 1.1 + sum(0.75 + 0.27 * c for c in counts), len(names), 1,
                             gridspec_kw={"height_ratios": [0.7 + 0.27 * c for c in counts]})
    for axes, family in zip(grid[:, 0], names):
        strip.draw(axes, entries[family], "time of a step (median)")
        axes.set_title(f"{series.title(family)}, {style.whole(sizes[0])} triangles")
    theirs = any(peers(f, published) for f in names)
    doubtful = any(l[0].doubtful for line in lines.values() for l in line.values())
    style.finish(fig, "Time of a step", style.caption_text(
        context, "Medians; bars from the fastest to the slowest repetition."
        + (" Grey: other programs, CPU time on one thread." if theirs else "")
        + (f" Half filled: {DOUBTFUL}." if doubtful else "")))
    return style.Picture("step_cost", "Time of a step", plain(names, lines), fig,
                         *_table(names, lines), details=_text(names, lines, published))


def _panels(names, lines, height):
    """A panel for each scene, narrow where it has one size only."""
    widths = [1.0 if len({r.triangles for line in lines[f].values() for r in line}) > 1 else 0.55
              for f in names]
    return style.figure(max(7.2, 0.4 + 4.0 * sum(widths)), height, 1, len(names), sharex=True,
                        sharey=True, gridspec_kw={"width_ratios": widths})


def _steps(names, found, context, published):
    lines, looks, sizes = _common(names, found)
    fig, grid = _panels(names, lines, 5.4)
    others = {}
    for axes, family in zip(grid[0], names):
        for label, line in lines[family].items():
            _plot(axes, line, lambda r: r.times, looks[label])
        for name, points in peers(family, published):
            marker = others.setdefault(name, PEER_MARKERS[len(others) % len(PEER_MARKERS)])
            axes.plot(*zip(*points), color=style.MUTED, linewidth=0.9, linestyle=(0, (1, 1.5)),
                      zorder=2.5, **style.other(marker))
        _axis(axes, sizes)
        axes.set_yscale("log")
        axes.set_title(series.title(family))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: style.tick(value)))
        axes.yaxis.set_minor_formatter(NullFormatter())
    for axes, family in zip(grid[0], names):
        _guides(axes, lines[family])
    grid[0][0].set_ylabel("time of a step (median)")
    handles = _legend(looks, lines) + [
        style.key(name, style.MUTED, line=(0, (1, 1.5)), width=0.9, marks=style.other(marker))
        for name, marker in others.items()]
    if any(len(l) > 1 for f in names for k, l in lines[f].items() if k.startswith("sequential")):
        handles += [style.key(name, style.FAINT, line=dash) for _, name, dash in GUIDES]
    style.finish(fig, "Time of a step against the size of the mesh", style.caption_text(
        context, "Medians; bars from the fastest to the slowest repetition. "
        + ("Grey: other programs, CPU time on one thread. " if others else "")
        + "The number of interface vertices is about the square root of the number of triangles."),
        handles)
    return [style.Picture("step_cost", "Time of a step", plain(names, lines), fig,
                          *_table(names, lines), details=_text(names, lines, published))]


def _text(names, lines, published):
    return " ".join(sentence(f, lines[f], peers(f, published)) for f in names)


def _table(names, lines):
    header = ["scene", "strategy", "triangles", "median", "range µs", "repetitions",
              "worst quality", "peak MB", ""]
    rows = [[series.title(f), label, style.whole(r.triangles), style.duration(r.median),
             f"{min(r.times):,.1f} – {max(r.times):,.1f}", str(len(r.times)),
             style.digits(r.measurement.counter("min_quality")),
             style.digits(r.measurement.counter("peak_memory_mb")),
             ", ".join(r.flags())]
            for f in names for label, line in lines[f].items() for r in line]
    return header, rows


def _guides(axes, lines):
    """Slopes 1/2 and 1 through the first sequential point."""
    line = next((v for k, v in lines.items() if k.startswith("sequential")), None)
    if line is None or len(line) < 2:
        return
    low, high = line[0].triangles, line[-1].triangles
    for power, _, dash in GUIDES:
        end = line[0].median * (high / low) ** power
        axes.plot([low, high], [line[0].median, end], color=style.FAINT, linewidth=1.3,
                  linestyle=dash, zorder=1)


def _vertices(names, found, context):
    lines, looks, sizes = _common(names, found)
    for family in names:
        lines[family] = {k: kept for k, v in lines[family].items()
                         if (kept := [r for r in v if _per_vertex(r)])}
    names = [f for f in names if lines[f]]
    if not names:
        return []
    shown = {label for family in names for label in lines[family]}
    fig, grid = _panels(names, lines, 4.6)
    for axes, family in zip(grid[0], names):
        for label, line in lines[family].items():
            _plot(axes, line, _per_vertex, looks[label])
        _axis(axes, sizes)
        axes.set_yscale("log")
        axes.set_title(series.title(family))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: style.tick(value)))
        axes.yaxis.set_minor_formatter(NullFormatter())
    bottom, ceiling = grid[0][0].get_ylim()
    if ceiling / bottom < 10:  # a decade at least, or the logarithmic axis has no tick
        middle = math.sqrt(bottom * ceiling)
        grid[0][0].set_ylim(middle / 3.3, middle * 3.3)
    grid[0][0].set_ylabel("time per interface vertex and step")
    words = []
    for family in names:
        for label, line in lines[family].items():
            if label.startswith("sequential"):
                values = [statistics.median(_per_vertex(r)) for r in line]
                low, high = style.duration(min(values)), style.duration(max(values))
                span = low if low == high else f"{low} to {high}"
                over = (f", a factor of {max(values) / min(values):.2f} over a range of "
                        f"{line[-1].triangles / line[0].triangles:.3g} in triangles"
                        if len(line) > 1 else "")
                words.append(f"In the {series.title(family)} the {label} step costs {span} per "
                             f"interface vertex{over}.")
    if not words:
        words = ["No sequential row states its cost per interface vertex."]
    style.finish(fig, "Time per interface vertex and step", style.caption_text(
        context, "Medians; bars from the fastest to the slowest repetition. A level line: the "
        "cost grows with the interface and not with the mesh."),
        _legend({k: v for k, v in looks.items() if k in shown}, lines))
    return [style.Picture("step_cost_per_vertex", "Time per interface vertex",
                          plain_per_vertex(names, lines), fig, details=" ".join(words))]

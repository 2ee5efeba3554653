#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws histograms of triangle area, quality and angle for each strategy (thesis, figures 10.13, 10.14
and 10.17): one panel for each, with the outline of the sequential run in all panels.

histograms.py RESULT.json... --out PICTURE.pdf

The files are results of `dsc_scene run --json`, of one scene in one strategy each.
"""
import sys

from look import script, style  # first: reports a Python without matplotlib

import numpy

from results import load

AXES = {"area": "area (units squared)", "angle": "smallest angle of a triangle (degrees)",
        "quality": r"quality of a triangle  $(2/\sqrt{3})\,\sin\,\theta_{\min}$"}
FIGURES = {("speedup-scaling", "area"): "figure 10.13",
           ("speedup-scaling", "quality"): "figure 10.14",
           ("quality-varying", "area"): "figure 10.17"}
SHOWN = set(FIGURES) | {("speedup-scaling", "angle")}
UNITS = {"angle": "°"}
COLUMNS = 3


def groups(scenes, verify):
    """{(scene, quantity): {strategy: Histogram}}; a verify report counts before a scene's.

    If runs have different edge lengths, only those count whose length occurs in the most strategies.
    """
    result = {}
    for source in ([verify.histograms] if verify else []) + [scene.histograms for scene in scenes]:
        # The bins of areas are in units of the edge length's square.
        sizes = {(item.scene, item.strategy): item.edges[-1] for item in source if item.quantity == "area"}
        for item in source:
            if sum(item.counts) > 0:
                by_size = result.setdefault((item.scene, item.quantity), {})
                of_size = by_size.setdefault(sizes.get((item.scene, item.strategy)), {})
                of_size.setdefault(item.strategy, item)
    return {key: dict(sorted(max(by_size.values(), key=len).items(), key=lambda pair: style.order(pair[0])))
            for key, by_size in sorted(result.items())}


def median(item):
    """Median of the binned values, interpolated linearly in its bin."""
    half = sum(item.counts) / 2
    total = 0.0
    for low, high, count in zip(item.edges, item.edges[1:], item.counts):
        if count > 0 and total + count >= half:
            return low + (high - low) * (half - total) / count
        total += count
    return item.edges[-1]


def percent(item):
    """The share of each bin."""
    return 100 * numpy.array(item.counts) / sum(item.counts)


def distance(one, other):
    """Largest difference between the two cumulative curves, as a share of the triangles."""
    return float(numpy.abs(numpy.cumsum(percent(one)) - numpy.cumsum(percent(other))).max()) / 100


def base_of(found):
    return found.get("sequential") or next(iter(found.values()))


def furthest(found):
    """(largest distance from the base, strategy), or None if there is nothing to compare."""
    base = base_of(found)
    return max(((distance(h, base), s) for s, h in found.items()
                if h is not base and h.edges == base.edges), default=None)


def plain(scene, quantity, found):
    base = base_of(found)
    text = (f"Half of the triangles of {scene} have "
            f"{'an' if quantity[0] in 'aeiou' else 'a'} {quantity} of at least "
            f"{style.digits(median(base))}{UNITS.get(quantity, '')} ({base.strategy})")
    most = furthest(found)
    if most:
        text += (f"; the other ways of running it differ in at most {100 * most[0]:.1f} % of the "
                 "triangles")
    return text + "."


def draw(scenes, verify, published, context=None, shown=None):
    """A Picture for each scene and quantity, or only those shown."""
    return [_one(scene, quantity, found, published, context)
            for (scene, quantity), found in groups(scenes, verify).items()
            if shown is None or (scene, quantity) in shown]


def _one(scene, quantity, found, published, context):
    base = base_of(found)
    columns = min(COLUMNS, len(found))
    lines = -(-len(found) // columns)
    fig, grid = style.figure(max(5.2, 0.5 + 3.0 * columns), 1.15 + 2.35 * lines, lines, columns,
                             sharex=True, sharey=True)
    for axes in grid.flat[len(found):]:
        axes.set_visible(False)
    for axes, (strategy, item) in zip(grid.flat, found.items()):
        colour, _ = style.look(strategy)
        axes.stairs(percent(item), item.edges, fill=True, color=colour, alpha=0.4, linewidth=0)
        axes.stairs(percent(item), item.edges, color=colour, linewidth=0.9)
        if item is not base and item.edges == base.edges:
            axes.stairs(percent(base), base.edges, color=style.INK, linewidth=0.9,
                        linestyle=style.SHORT_DASHES)
        axes.axvline(median(item), color=style.INK, linewidth=0.8, linestyle=style.DOTTED)
        axes.set_title(f"{strategy}, {style.whole(sum(item.counts))} triangles")
    used = numpy.nonzero(sum(numpy.array(h.counts) for h in found.values()
                             if h.edges == base.edges))[0]
    low, high = base.edges[used[0]], base.edges[used[-1] + 1]
    if all(h.edges == base.edges for h in found.values()):
        slack = 0.03 * (high - low)
        grid[0][0].set_xlim(low - slack, high + slack)
    for axes in grid.flat[len(found) - columns:len(found)]:  # the lowest of each column
        axes.set_xlabel(AXES.get(quantity, quantity))
        axes.tick_params(labelbottom=True)
    for row in grid:
        row[0].set_ylabel("triangles in a bin (%)")
    if quantity == "area":
        for axes in grid.flat:
            axes.ticklabel_format(axis="x", style="sci", scilimits=(-2, 4), useMathText=True)
    twin = FIGURES.get((scene, quantity))
    conditions = "Dotted line: median. " + (
        f"Dashed outline: the {base.strategy} run. " if len(found) > 1 else "")
    theirs = load.entry(published, "thesis", "histogram_triangles_sequential")
    if twin:
        conditions += f"The thesis's {twin}"
        conditions += (f" has {style.whole(theirs['value'])} triangles (sequential)."
                       if theirs and scene == "speedup-scaling" else " shows the same.")
    name = f"{style.capital(quantity)} of the triangles: {scene}"
    style.finish(fig, name, style.caption_text(context, conditions))
    return style.Picture(f"histogram_{scene}_{quantity}", name, plain(scene, quantity, found),
                         fig)


def main(argv=None):
    def pictures(given):
        scenes = [load.read_scene(path) for path in given.files]
        return draw(scenes, None, {}, load.scene_context(scenes[0]))

    return script.main(__doc__, pictures, argv)


if __name__ == "__main__":
    sys.exit(main())

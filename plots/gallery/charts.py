# SPDX-License-Identifier: MIT
"""Pictures with axes: histograms of triangles, and values in Gouraud shading."""
import io
from itertools import accumulate

import numpy
from PIL import Image

from gallery import mesh
from gallery.shared import style

AXES = {"area": "area of a triangle (domain units²)",
        "quality": "quality of a triangle, (2/√3) sin of its smallest angle"}
COLOURS = (style.BLUE, style.ORANGE, style.VERMILLION)
DPI = 110


def _image(fig):
    buffer = io.BytesIO()
    fig.savefig(buffer, format="png", dpi=DPI)
    style.plt.close(fig)
    return Image.open(buffer).convert("RGB")


def median(edges, counts):
    """Median of binned values, linear inside its bin."""
    total = list(accumulate(counts))
    k = next(i for i, so_far in enumerate(total) if so_far >= total[-1] / 2)
    inside = (total[-1] / 2 - (total[k] - counts[k])) / counts[k]
    return edges[k] + (edges[k + 1] - edges[k]) * inside


def areas(frame, bins=60):
    """The distribution of the triangles' areas, as dsc_scene writes others."""
    a, b, c = (frame.points[frame.triangles[:, k]] for k in range(3))
    twice = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    counts, edges = numpy.histogram(twice / 2, bins=bins, range=(0, float(twice.max()) / 2))
    return {"edges": edges.tolist(), "counts": counts.tolist()}


def mean(edges, counts):
    """Mean of binned values, each taken as the middle of its bin."""
    middles = (numpy.array(edges[:-1]) + numpy.array(edges[1:])) / 2
    return float((middles * counts).sum() / sum(counts))


def largest_gap(one, other):
    """Largest difference of two cumulative distributions over the same bins, as a share."""
    a, b = (numpy.cumsum(h["counts"]) / sum(h["counts"]) for h in (one, other))
    return float(numpy.abs(a - b).max())


def histogram(quantity, shown):
    """WebP of a panel for each of [(label, {"edges", "counts"})]; the first one's outline is drawn
    dashed in the others."""
    fig, grid = style.figure(9.4, 2.75, 1, len(shown), sharex=True, sharey=True)
    base = shown[0][1]
    for axes, (label, item), colour in zip(grid[0], shown, COLOURS):
        share = 100 * numpy.array(item["counts"]) / sum(item["counts"])
        axes.stairs(share, item["edges"], fill=True, color=colour, alpha=0.4, linewidth=0)
        axes.stairs(share, item["edges"], color=colour, linewidth=0.9)
        if item is not base and item["edges"] == base["edges"]:
            outline = 100 * numpy.array(base["counts"]) / sum(base["counts"])
            axes.stairs(outline, base["edges"], color=style.INK, linewidth=0.8,
                        linestyle=style.DASHED)
        axes.axvline(median(item["edges"], item["counts"]), color=style.INK, linewidth=0.8,
                     linestyle=(0, (1, 1.5)))
        axes.set_title(label)
        axes.set_xlabel(AXES[quantity] if len(shown) == 1 else AXES[quantity].split(",")[0])
        if quantity == "area":
            axes.ticklabel_format(axis="x", style="sci", scilimits=(-2, 4), useMathText=True)
    used = numpy.nonzero(base["counts"])[0]
    low, high = base["edges"][used[0]], base["edges"][used[-1] + 1]
    grid[0][0].set_xlim(low - 0.03 * (high - low), high + 0.03 * (high - low))
    grid[0][0].set_ylabel("triangles in a bin (%)")
    few = _image(fig).quantize(48, dither=Image.Dither.NONE)
    return mesh.webp(few.convert("RGB"), lossless=True)


def shaded(frame, values, label):
    """WebP of the values in Gouraud shading, blue by way of green and yellow to red; the interface
    is black."""
    fig, grid = style.figure(4.1, 3.5)
    axes = grid[0][0]
    colours = axes.tripcolor(*frame.points.T, frame.triangles, values, shading="gouraud",
                             cmap="turbo", vmin=0, vmax=max(float(values.max()), 1e-9))
    for ends in frame.points[mesh.interface(frame)]:
        axes.plot(*ends.T, color="black", linewidth=1.1, solid_capstyle="round")
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_title(label)
    axes.set_xlabel("x (domain units)")
    axes.set_ylabel("y (domain units)")
    fig.colorbar(colours, ax=axes, label="value at the vertices (no unit)")
    return mesh.webp(_image(fig), quality=82)  # as many colours as there are

# SPDX-License-Identifier: MIT
"""Draws a mesh as a picture: triangles filled by phase or by value, thin edges, bold interface."""
import colorsys
import io

import numpy
from PIL import Image, ImageDraw

from gallery.shared import style

FINE = 3  # drawn so many times as large, then shrunk: this is what smooths the lines
QUALITY = 58  # of WebP, 0 to 100
NO_EDGE = "none"
COARSE = 3_000  # up to so many triangles edges are darker: there is room between them


def interface(frame):
    """Edges (k x 2 vertex numbers) whose two triangles are of different phases."""
    corners = frame.triangles
    edges = numpy.sort(numpy.concatenate([corners[:, [0, 1]], corners[:, [1, 2]],
                                          corners[:, [2, 0]]]), axis=1)
    phases = numpy.tile(frame.phases, 3)
    # One number an edge: the two triangles of an edge come to stand side by side.
    place = numpy.argsort(edges[:, 0] * (len(frame.points) + 1) + edges[:, 1], kind="stable")
    edges, phases = edges[place], phases[place]
    same = (edges[1:] == edges[:-1]).all(axis=1) & (phases[1:] != phases[:-1])
    return edges[1:][same]


def phase_fills(frame):
    """A colour for each triangle."""
    fills = style.PHASE_FILLS
    return [fills[phase % len(fills)] for phase in frame.phases.tolist()]


def value_fills(frame, values):
    """The thesis's colours of section 10.5: pure red whose lightness is the mean of the corners'
    values, from black (0) by way of red to white (1)."""
    table = ["#%02x%02x%02x" % tuple(round(255 * c) for c in colorsys.hls_to_rgb(0, step / 255, 1))
             for step in range(256)]
    mean = values[frame.triangles].mean(axis=1)
    return [table[k] for k in numpy.clip(numpy.round(255 * mean), 0, 255).astype(int).tolist()]


def draw(frame, pixels, fills=None, window=None, fine=FINE, edge=None, line=style.INTERFACE):
    """An RGB picture, `pixels` wide.

    fills: a colour for each triangle in place of that of its phase; window: (low x, low y, width)
    of the square that is shown in place of the whole domain; edge: the colour of edges in place of
    that for their number, or NO_EDGE; line: the colour of the interface."""
    low, high = frame.points.min(axis=0), frame.points.max(axis=0)
    if window:
        low = numpy.array(window[:2])
        high = low + window[2]
    fills = numpy.array(phase_fills(frame) if fills is None else fills, dtype=object)
    corners = frame.points[frame.triangles]
    inside = ((corners.max(axis=1) >= low) & (corners.min(axis=1) <= high)).all(axis=1)
    scale = (pixels * fine - 1) / (high[0] - low[0])
    height = max(1, round(pixels * (high[1] - low[1]) / (high[0] - low[0])))
    image = Image.new("RGB", (pixels * fine, height * fine), "white")
    pen = ImageDraw.Draw(image)
    places = numpy.column_stack([frame.points[:, 0] - low[0], high[1] - frame.points[:, 1]]) * scale
    places = numpy.rint(places).astype(int)
    edge = edge or (style.MUTED if inside.sum() <= COARSE else style.EDGE)
    for three, fill in zip(places[frame.triangles[inside]].reshape(-1, 6).tolist(),
                           fills[inside].tolist()):
        pen.polygon(three, fill=fill, outline=fill if edge == NO_EDGE else edge)
    width = max(2, round((1.9 if inside.sum() <= COARSE else 1.3) * fine * pixels / 340))
    for ends in places[interface(frame)].reshape(-1, 4).tolist():
        pen.line(ends, fill=line, width=width)
    return image.resize((pixels, height), Image.Resampling.BOX)


def webp(image, quality=QUALITY, lossless=False):
    """The bytes of a picture as WebP; lossless for lines and letters of few colours."""
    buffer = io.BytesIO()
    image.save(buffer, "WEBP", quality=quality, method=4, lossless=lossless)
    return buffer.getvalue()

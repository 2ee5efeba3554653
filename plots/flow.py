#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the flow of a fluid from frames of `dsc_scene run --frames`.

flow.py FRAME.vtu... --out PICTURE.png

A panel for each frame: the speed as a colour on a common scale, and the interface in bold.
"""
import os
import sys

from look import script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib.collections import LineCollection

import frames
from results import load, load_frames

SIDE = 3.0       # inches, the width of a panel
TALLEST = 7.0    # inches


def read(path):
    """(name, number, Frame) of a file."""
    name = os.path.basename(path)
    match = load_frames.FRAME_NAME.match(name)
    frame = load_frames.read_frame(path)
    if "velocity" not in frame.at_vertices:
        raise load.InputFault(f"{path}: no velocity at the vertices of triangles.")
    return (match["scene"], int(match["number"]), frame) if match else (name, None, frame)


def speed(frame):
    """The speed at each vertex."""
    return numpy.hypot(*frame.at_vertices["velocity"].T)


def panel(axes, frame, most):
    shown = axes.tripcolor(*frame.points.T, frame.triangles, speed(frame), shading="gouraud",
                           cmap="viridis", vmin=0, vmax=most, rasterized=True)
    axes.add_collection(LineCollection(frame.points[frames.interface(frame)], colors="white",
                                       linewidths=1.6, capstyle="round"))
    low, high = frame.box()
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    axes.grid(False)
    return shown


def picture(shown):
    """shown: [(name, number, Frame)]"""
    span = numpy.ptp(shown[0][2].points, axis=0)
    tall = min(TALLEST, SIDE * span[1] / span[0])
    most = max(float(speed(frame).max()) for _, _, frame in shown) or 1.0
    figure, grid = style.figure(max(5.0, 0.9 + SIDE * len(shown)), tall + 1.3, 1, len(shown))
    for axes, (_, number, frame) in zip(grid[0], shown):
        scale = panel(axes, frame, most)
        axes.set_title("" if number is None else f"step {number}", fontsize=9)
    figure.colorbar(scale, ax=list(grid[0]), label="speed", fraction=0.05, pad=0.02)
    counts = style.listing(style.whole(len(frame.triangles)) for _, _, frame in shown)
    title = f"{shown[0][0]}: speed and interface"
    sentence = f"{counts} triangles; the largest speed at a vertex is {style.digits(most)}"
    style.finish(figure, title, sentence)
    return style.Picture("flow", title, sentence, figure)


def main(argv=None):
    return script.main(__doc__, lambda given: [picture(
        [read(path) for path in given.files])], argv)


if __name__ == "__main__":
    sys.exit(main())

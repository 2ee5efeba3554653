#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the frames of a run as a film for browsers, in a loop.

film.py FOLDER --out FILM.webp

The folder is one of `dsc_scene run --frames FOLDER --every N`, with one run. A fluid is coloured by its
speed, on a scale up to the median of the largest speeds of the frames; other runs by their phases. The
interface is bold.
"""
import io
import sys

from look import saving, script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib import pyplot
from PIL import Image

import flow
import frames
from page import document as page
from results import load, load_frames

SIDE = 3.0           # inches, the shorter side of the domain
DPI = 90
SECONDS_A_FRAME = 0.08
QUALITY = 55         # of WebP's 100
OF_REPORT = "bubbles.webp"


def drawn(frame, time, most):
    """A frame as an image; most: the speed at the end of the scale, None without a flow."""
    low, high = frame.box()
    across, up = SIDE * (high - low) / (high - low).min()
    figure = pyplot.figure(figsize=(across, up + 0.25), dpi=DPI)
    axes = figure.add_axes((0, 0, 1, up / (up + 0.25)))
    if most is None:
        frames.mesh(axes, frame, across, low, high)
    else:
        flow.panel(axes, frame, most)
        axes.set_axis_off()
    if time is not None:
        axes.set_title(f"t = {time:.2f}", fontsize=9, pad=3)
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png")
    pyplot.close(figure)
    return Image.open(buffer).convert("RGB")


def film(folder):
    """(bytes, sentence) of the run in a folder."""
    sequences = load_frames.frame_files(folder)
    if len(sequences) != 1:
        raise load.InputFault(f"{folder} has frames of {style.counted(len(sequences), 'run')}, "
                              "where one is needed.")
    ((scene, _), files), = sequences.items()
    shown = [(time, load_frames.read_frame(path)) for _, time, path in files]
    flows = all("velocity" in frame.at_vertices for _, frame in shown)
    # When pieces merge, the speed is many times that of all other frames for a moment.
    fastest = [float(flow.speed(frame).max()) for _, frame in shown] if flows else []
    most = float(numpy.median(fastest)) or 1.0 if flows else None
    images = [drawn(frame, time, most) for time, frame in shown]
    buffer = io.BytesIO()
    images[0].save(buffer, format="WEBP", save_all=True, append_images=images[1:], loop=0,
                   duration=round(1000 * SECONDS_A_FRAME), quality=QUALITY, method=6)
    return buffer.getvalue(), f"{scene} in {style.counted(len(images), 'frame')}."


def section(out):
    """The section of the report if bench/run.sh has left a film in the folder `out`; else nothing."""
    path = out / OF_REPORT
    if not path.is_file():
        return ""
    with Image.open(path) as picture:
        width = picture.width  # a film that is scaled up is blurred
    return (f'<figure><img alt="Thirty bubbles rise and merge" style="max-width:{width}px" '
            f'src="{page.inline(path.read_bytes())}">'
            "<figcaption>The scene bubbles: the speed as a colour, brighter where it is faster, and "
            "the interface in white. Times are in units of the scene.</figcaption></figure>\n")


def main(argv=None):
    words = script.parser(__doc__)
    words.add_argument("folder", metavar="FOLDER")
    words.add_argument("--out", required=True, metavar="FILM", help="webp")
    given = words.parse_args(argv)

    def write():
        if not given.out.endswith(".webp"):
            raise load.InputFault(f"--out has '{given.out}', where names ending in .webp are allowed.")
        data, sentence = film(given.folder)
        saving.write_bytes(given.out, data)
        print(f"{given.out}: {sentence}")

    return script.attempt(words.prog, write)


if __name__ == "__main__":
    sys.exit(main())

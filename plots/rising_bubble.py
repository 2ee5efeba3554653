#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the errors of the rising bubble's figures against their cost, beside those of another code.

rising_bubble.py RESULT.json... --out PICTURE.png

Each result is one of `dsc_scene run rising-bubble --json`, with different edge lengths and steps.
Three figures have a panel each, error against CPU seconds, because a single figure can be accurate by
chance.
"""
import sys

from look import script, style  # first: reports a Python without matplotlib

from results.load import InputFault, need, read_json

# Key of a result, title, the closest published value (of MooNMD, with a mesh that fits the interface) and the
# difference of the other groups of the benchmark from it.
FIGURES = [("rise_velocity_max", "largest rise velocity", 0.24166, 4e-4),
           ("centre_last", "height of the centre at time 3", 1.08170, 1.8e-3),
           ("circularity_last", "circularity at time 3", 0.92071, None)]

# Basilisk (2025) on half of the domain: CPU seconds and the three figures, on another machine.
BASILISK = [(0.28, (0.24091, 1.07718, 0.9200)), (1.6, (0.24165, 1.07921, 0.9192)),
            (14, (0.24182, 1.08086, 0.9200)), (137, (0.24180, 1.08149, 0.9207))]
SMALLEST = 1e-6  # accuracy of the published digits


def read(path):
    """A result of the scene."""
    result = read_json(path)
    if need(result, "scene", path, str) != "rising-bubble":
        raise InputFault(f"{path} is a result of {result['scene']}, where rising-bubble is expected.")
    for key in ("cpu_s", *(key for key, *_ in FIGURES)):
        need(result, key, path, float)
    for key in ("machine", "commit"):
        need(result, key, path, str)
    return result


def error_of(value, published):
    return max(abs(value - published), SMALLEST)


def picture(results):
    figure, grid = style.figure(11, 4, 1, len(FIGURES), sharex=True)
    results = sorted(results, key=lambda result: result["cpu_s"])
    for place, (axes, (key, title, published, spread)) in enumerate(zip(grid[0], FIGURES)):
        axes.loglog([r["cpu_s"] for r in results],
                    [error_of(r[key], published) for r in results],
                    color=style.BLUE, marker="o")
        axes.loglog([seconds for seconds, _ in BASILISK],
                    [error_of(values[place], published) for _, values in BASILISK],
                    color=style.VERMILLION, marker="s")
        if spread:
            axes.axhline(spread, color=style.MUTED, linestyle=style.DASHED)
        axes.set_title(title)
        axes.set_xlabel("CPU seconds")
    grid[0][0].set_ylabel("difference from the closest published series")
    handles = [style.key("this library", style.BLUE, "o"),
               style.key("Basilisk, half of the domain", style.VERMILLION, "s"),
               style.key("what published groups differ by", style.MUTED, line=style.DASHED)]
    title = "Rising bubble: error against time"
    sentence = (f"{results[0]['machine']}, commit {str(results[0]['commit'])[:12]}; Basilisk's times are those "
                "of another machine; both use one thread")
    style.finish(figure, title, sentence, handles)
    return style.Picture("rising-bubble", title, sentence, figure)


def main(argv=None):
    return script.main(__doc__, lambda given: [picture([read(path) for path in given.files])], argv)


if __name__ == "__main__":
    sys.exit(main())

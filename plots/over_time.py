#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws a run over time from what `dsc_scene run --series` wrote.

over_time.py SERIES.csv --out PICTURE.png [--json RESULT.json]

Four panels: the error (or the length of the interface, where no exact shape is known), the worst
triangle, how many triangles and living phases there are, and the operations of a step. The result of the same
run, given by --json, adds machine and commit to the caption. Exit 0 done; 2 bad usage or a file
that cannot be used, with one sentence on the error stream.
"""
import argparse
import csv
import json
import math
import os
import sys

from look import style  # first: it says which Python has no matplotlib

from matplotlib.ticker import MaxNLocator

OPERATIONS = {"splits": (style.BLUE, "splits"), "collapses": (style.VERMILLION, "collapses"),
              "flips": (style.GREEN, "flips"), "smoothed": (style.ORANGE, "smoothed")}
NEEDED = ("step", "time", "triangles", "phases", "interface_length", "min_angle_deg", "events",
          "wall_us", *OPERATIONS)


class Unusable(Exception):
    """A file that cannot be used; its text is one sentence."""


def read(path):
    """{column: numbers}; an empty cell is NaN."""
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            text = stream.read()
        reader = csv.DictReader(text.splitlines())
        rows = list(reader)
        names = reader.fieldnames or []
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Unusable(f"{path}: cannot be read ({error}).") from error
    missing = [name for name in NEEDED if name not in names]
    if missing:
        raise Unusable(f"{path}: no column '{missing[0]}'; the file is written by "
                       "dsc_scene run --series.")
    if not text.endswith("\n") or any(None in row.values() for row in rows):
        raise Unusable(f"{path}: the last row is not whole, so the file may be truncated.")
    if len(rows) < 2:
        raise Unusable(f"{path}: {len(rows)} rows; at least two are needed.")
    columns = {}
    for name in names:
        try:
            columns[name] = [float(row[name]) if row[name] else math.nan for row in rows]
        except (TypeError, ValueError) as error:
            raise Unusable(f"{path}: column '{name}' has a cell that is no number.") from error
    return columns


def between(columns, name):
    """[(middle of the time, value of one step)] of what is counted between two rows."""
    rows = list(zip(columns["time"], columns["step"], columns[name]))
    return [((t0 + t1) / 2, value / (s1 - s0))
            for (t0, s0, _), (t1, s1, value) in zip(rows, rows[1:]) if s1 > s0]


def known(values):
    return any(math.isfinite(value) for value in values)


def draw_error(axes, columns):
    time = columns["time"]
    if known(columns.get("sd_rel", [])):
        axes.set_title("error against the exact shape")
        axes.plot(time, columns["sd_rel"], color=style.BLUE)
        axes.set_ylabel("symmetric difference / area")
        if max(v for v in columns["sd_rel"] if math.isfinite(v)) > 0:
            axes.set_yscale("log")
    else:
        axes.set_title("length of the interface")
        axes.plot(time, columns["interface_length"], color=style.BLUE)
        axes.set_ylabel("domain units")
        axes.set_ylim(bottom=0)


def draw_quality(axes, columns):
    axes.set_title("worst triangle")
    axes.plot(columns["time"], columns["min_angle_deg"], color=style.VERMILLION)
    axes.set_ylabel("smallest angle (degrees)")
    axes.set_ylim(bottom=0)


def draw_size(axes, columns):
    axes.set_title("size of the mesh")
    axes.plot(columns["time"], columns["triangles"], color=style.BLUE)
    axes.set_ylabel("triangles")
    axes.set_ylim(bottom=0)
    if len(set(columns["phases"])) > 1:
        beside = axes.twinx()
        beside.plot(columns["time"], columns["phases"], color=style.GREEN)
        beside.set_ylabel("living phases", color=style.GREEN)
        beside.set_ylim(bottom=0)
        beside.grid(False)


def draw_work(axes, columns):
    axes.set_title("operations of a step")
    for name, (colour, _) in OPERATIONS.items():
        line = between(columns, name)
        axes.plot([t for t, _ in line], [v for _, v in line], color=colour)
    axes.set_yscale("symlog", linthresh=1)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("number")


def picture(columns, title, caption):
    figure, grid = style.figure(9, 6, 2, 2, sharex=True)
    for axes, draw in zip(grid.flat, (draw_error, draw_quality, draw_size, draw_work)):
        draw(axes, columns)
        for start, end, count in zip(columns["time"], columns["time"][1:], columns["events"][1:]):
            if count > 0:
                axes.axvspan(start, end, color=style.SHADE, zorder=0)
    for axes in grid[1]:
        axes.set_xlabel("time")
        axes.xaxis.set_major_locator(MaxNLocator(5))
    handles = [style.key(label, colour) for colour, label in OPERATIONS.values()]
    if sum(columns["events"]) > 0:
        handles.append(style.square("the topology changes", style.FAINT))
    style.finish(figure, title, caption, handles)
    return figure


def words(columns, result):
    """Title and caption."""
    steps = int(columns["step"][-1])
    took = sum(v for v in columns["wall_us"] if math.isfinite(v))
    facts = f"{steps} steps in {style.duration(took)}, without measuring"
    if result is None:
        return "A run over time", f"machine and commit not recorded\n{facts}"
    title = f"{result['scene']} over time, {result['strategy']}"
    where = "  ·  ".join([str(result["machine"]), f"commit {str(result['commit'])[:12]}"])
    return title, f"{where}\n{facts}, {style.counted(result['threads'], 'thread')}"


def main(argv):
    parser = argparse.ArgumentParser(prog="over_time.py", description=__doc__.split("\n\n")[0])
    parser.add_argument("series", metavar="SERIES.csv", help="what --series wrote")
    parser.add_argument("--out", required=True, metavar="PICTURE", help="png, svg or pdf")
    parser.add_argument("--json", metavar="RESULT.json", help="what --json wrote of the same run")
    given = parser.parse_args(argv)
    name, form = os.path.splitext(os.path.basename(given.out))
    try:
        if form not in (".png", ".svg", ".pdf"):
            raise Unusable(f"{given.out}: allowed are .png, .svg and .pdf.")
        result = None
        if given.json:
            try:
                with open(given.json, encoding="utf-8") as stream:
                    result = json.load(stream)
                if not isinstance(result, dict):
                    raise ValueError("not a result of dsc_scene")
                words_needed = ("scene", "strategy", "machine", "commit", "threads")
                if not all(key in result for key in words_needed):
                    raise ValueError("not a result of dsc_scene")
            except (OSError, ValueError, RecursionError) as error:
                raise Unusable(f"{given.json}: cannot be used ({error}).") from error
        columns = read(given.series)
        figure = picture(columns, *words(columns, result))
        style.save(figure, os.path.dirname(given.out) or ".", name, [form[1:]])
    except (Unusable, OSError) as error:
        sys.stderr.write(f"over_time.py: {error}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws a run over time from a file of `dsc_scene run --series`.

over_time.py SERIES.csv --out PICTURE.png [--json RESULT.json]

Four panels: the error (or the length of the interface if no exact shape is known), the worst triangle,
the numbers of triangles and phases, and the operations per step. The result of the same run, given by
--json, adds machine and commit to the caption.
"""
import csv
import math
import sys

from look import script, style  # first: reports a Python without matplotlib

from matplotlib.ticker import MaxNLocator

from results.load import InputFault, context_of, need, read_json, read_text

OPERATIONS = {"splits": style.BLUE, "collapses": style.VERMILLION, "flips": style.GREEN,
              "smoothed": style.ORANGE}
NEEDED = ("step", "time", "triangles", "phases", "interface_length", "min_angle_deg", "events",
          "wall_us", *OPERATIONS)


def read(path):
    """{column: numbers}; an empty cell is NaN."""
    text = read_text(path)
    reader = csv.DictReader(text.splitlines())
    rows, names = list(reader), reader.fieldnames or []
    missing = [name for name in NEEDED if name not in names]
    if missing:
        raise InputFault(f"{path} has no column '{missing[0]}'; such a file is written by "
                         "dsc_scene run --series.")
    if not text.endswith("\n") or any(None in row.values() for row in rows) or len(rows) < 2:
        raise InputFault(f"{path} has {len(rows)} rows, of which the last may be truncated; at least "
                         "two whole ones are needed.")
    try:
        return {name: [float(row[name]) if row[name] else math.nan for row in rows]
                for name in names}
    except (TypeError, ValueError) as error:
        raise InputFault(f"{path} has a cell that is no number ({error}).") from error


def between(columns, name):
    """[(middle of the time, value of one step)] for counts between two rows."""
    rows = list(zip(columns["time"], columns["step"], columns[name]))
    return [((t0 + t1) / 2, value / (s1 - s0))
            for (t0, s0, _), (t1, s1, value) in zip(rows, rows[1:]) if s1 > s0]


def draw_column(axes, columns, name, colour, title, label):
    axes.plot(columns["time"], columns[name], color=colour)
    axes.set(title=title, ylabel=label)
    axes.set_ylim(bottom=0)


def draw_error(axes, columns):
    errors = [value for value in columns.get("sd_rel", []) if math.isfinite(value)]
    if not errors:
        draw_column(axes, columns, "interface_length", style.BLUE, "length of the interface",
                    "domain units")
        return
    # The error of a shape that comes back is known at the end only.
    axes.plot(columns["time"], columns["sd_rel"], color=style.BLUE, marker="o" if len(errors) == 1 else None)
    axes.set(title="error against the exact shape", ylabel="symmetric difference / area",
             yscale="log" if max(errors) > 0 else "linear")


def draw_size(axes, columns):
    draw_column(axes, columns, "triangles", style.BLUE, "size of the mesh", "triangles")
    if len(set(columns["phases"])) > 1:
        beside = axes.twinx()
        beside.plot(columns["time"], columns["phases"], color=style.GREEN)
        beside.set_ylabel("phases", color=style.GREEN)
        beside.set_ylim(bottom=0)
        beside.grid(False)


def draw_work(axes, columns):
    for name, colour in OPERATIONS.items():
        axes.plot(*zip(*between(columns, name)), color=colour)
    axes.set(title="operations of a step", ylabel="number")
    axes.set_yscale("symlog", linthresh=1)
    axes.set_ylim(bottom=0)


def picture(columns, result):
    """result: the result (--json) of the same run, or None."""
    figure, grid = style.figure(9, 6, 2, 2, sharex=True)
    error, quality, size, work = grid.flat
    draw_error(error, columns)
    draw_column(quality, columns, "min_angle_deg", style.VERMILLION, "worst triangle",
                "smallest angle (degrees)")
    draw_size(size, columns)
    draw_work(work, columns)
    for axes in grid.flat:
        for start, end, count in zip(columns["time"], columns["time"][1:], columns["events"][1:]):
            if count > 0:
                axes.axvspan(start, end, color=style.SHADE, zorder=0)
    for axes in grid[1]:
        axes.set_xlabel("time")
        axes.xaxis.set_major_locator(MaxNLocator(5))
    handles = [style.key(name, colour) for name, colour in OPERATIONS.items()]
    if sum(columns["events"]) > 0:
        handles.append(style.square("the topology changes", style.FAINT))
    took = sum(value for value in columns["wall_us"] if math.isfinite(value))
    title = "A run over time"
    facts = f"{int(columns['step'][-1])} steps in {style.duration(took)}, without measuring"
    if result:
        title = f"{result['scene']} over time, {result['strategy']}"
        facts += f", {style.counted(result['threads'], 'thread')}"
    style.finish(figure, title, style.caption_text(result and context_of(result), facts), handles)
    return style.Picture("over_time", title, facts, figure)


def read_result(path):
    result = read_json(path)
    for key, kind in (("scene", str), ("strategy", str), ("machine", str), ("commit", str),
                      ("threads", float)):
        need(result, key, path, kind)
    return result


def draw(given):
    result = read_result(given.json) if given.json else None
    return [picture(read(path), result) for path in given.files]


def main(argv=None):
    return script.main(__doc__, draw, argv, json={
        "metavar": "RESULT.json", "help": "the result (--json) of the same run"})


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws a run over time from what `dsc_scene run --series` wrote.

over_time.py SERIES.csv --out PICTURE.png [--json RESULT.json]

Four panels: the error (or the length of the interface, where no exact shape is known), the worst
triangle, how many triangles and living phases there are, and the operations of a step. The result of
the same run, given by --json, adds machine and commit to the caption.
"""
import csv
import math
import sys

from look import script, style  # first: it says which Python has no matplotlib

from matplotlib.ticker import MaxNLocator

from results.load import InputFault, need, read_json, read_text

OPERATIONS = {"splits": (style.BLUE, "splits"), "collapses": (style.VERMILLION, "collapses"),
              "flips": (style.GREEN, "flips"), "smoothed": (style.ORANGE, "smoothed")}
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


def draw(given):
    result = read_json(given.json) if given.json else None
    for key in ("scene", "strategy", "machine", "commit", "threads") if given.json else ():
        need(result, key, given.json)
    for path in given.files:
        columns = read(path)
        title, caption = words(columns, result)
        yield style.Picture("over_time", title, caption.split("\n")[1],
                            picture(columns, title, caption))


def main(argv=None):
    return script.main(__doc__, draw, argv, json={
        "metavar": "RESULT.json", "help": "what --json wrote of the same run"})


if __name__ == "__main__":
    sys.exit(main())

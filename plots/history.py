#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of the gate over commits, with the steps between them.

history.py VERIFY.json... --out PICTURE.png [--only CHECK,SCENE,...]

The files are reports of dsc_verify, one for each commit, from the oldest to the newest. Each figure is a panel
of its own, with its limit as a dashed line, the figures that changed most first; a step is a change of more
than a hundredth from one commit to the next. Figures that never changed are left out. --only selects checks
and scenes by their names.
"""
import math
import sys
from dataclasses import dataclass

from look import script, style  # first: reports a Python without matplotlib

from results.load import InputFault, read_verify

STEP = 0.01         # a change that counts, relative
MAX_PANELS = 12
ROUNDING = 1e-12    # changes of rounding errors are none
MAX_LABELS = 8


@dataclass
class Line:
    """A figure over the commits; NaN where a report does not have it."""
    check: str
    scene: str
    values: list
    limits: list

    def changes(self):
        """[(relative change, place of the commit that has it)]; both values are there."""
        pairs = enumerate(zip(self.values, self.values[1:]), 1)
        return [(abs(new - old) / max(abs(old), abs(new)), place) for place, (old, new) in pairs
                if abs(new - old) > ROUNDING]

    @property
    def steps(self):
        return [place for change, place in self.changes() if change > STEP]

    @property
    def largest(self):
        """(relative change, place) of the largest step."""
        return max(self.changes(), default=(0, 0))


def number(value):
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else math.nan


def lines_of(reports):
    """Lines in the order of their largest change."""
    found = {}
    for place, report in enumerate(reports):
        for check in report.checks:
            line = found.setdefault((check["check"], check["scene"]), Line(
                check["check"], check["scene"], [math.nan] * len(reports), [math.nan] * len(reports)))
            line.values[place] = number(check["measured"])
            line.limits[place] = number(check["limit"])
    return sorted(found.values(), key=lambda line: -line.largest[0])


def plain(lines, commits):
    steps = sum(len(line.steps) for line in lines)
    changed = sum(1 for line in lines if line.steps)
    if not steps:
        return f"None of {style.counted(len(lines), 'figure')} changed by more than a hundredth."
    first = lines[0]
    change, place = first.largest
    return (f"{style.counted(steps, 'step')} of more than a hundredth in {changed} of "
            f"{style.counted(len(lines), 'figure')}; the largest is {100 * change:.3g} % in {first.check} of "
            f"{first.scene}, from {commits[place - 1]} to {commits[place]}.")


def panel(axes, line, commits):
    places = range(len(commits))
    axes.step(places, line.limits, where="mid", color=style.MUTED, linestyle=style.DASHED)
    axes.plot(places, line.values, color=style.BLUE, marker="o", markersize=3)
    for place in line.steps:
        axes.axvspan(place - 1, place, color=style.FAINT, zorder=0)
    axes.set_title(f"{line.check}, {line.scene}")
    every = -(-len(commits) // MAX_LABELS)
    axes.set_xticks(list(places)[::every], commits[::every], rotation=45, ha="right")


def picture(reports, chosen):
    commits = [report.context.commit[:7] or "?" for report in reports]
    lines = [line for line in lines_of(reports) if not chosen or {line.check, line.scene} & chosen]
    if not lines:
        raise InputFault(f"no report has a figure of {style.listing(sorted(chosen)) or 'any check'}.")
    shown = [line for line in lines if line.changes()][:MAX_PANELS] or lines[:1]
    columns = min(3, len(shown))
    rows = -(-len(shown) // columns)
    figure, grid = style.figure(1 + 3.4 * columns, 1.4 + 2.4 * rows, rows, columns)
    for axes in grid.flat[len(shown):]:
        axes.set_visible(False)
    for axes, line in zip(grid.flat, shown):
        panel(axes, line, commits)
    handles = [style.key("figure", style.BLUE, "o"), style.key("limit", style.MUTED, line=style.DASHED),
               style.square("a step of more than a hundredth", style.FAINT)]
    title = f"Figures of {style.counted(len(commits), 'commit')}"
    style.finish(figure, title, style.caption_text(
        reports[-1].context, f"{len(shown)} of {style.counted(len(lines), 'figure')}, those that changed most."),
                 handles)
    return style.Picture("history", title, plain(lines, commits), figure,
                         ["check", "scene", *commits], [[line.check, line.scene, *line.values] for line in shown])


def draw(given):
    if len(given.files) < 2:
        raise InputFault(f"{given.files[0]} is the only report, where two or more are needed.")
    chosen = set((given.only or "").split(",")) - {""}
    return [picture([read_verify([path]) for path in given.files], chosen)]


def main(argv=None):
    return script.main(__doc__, draw, argv, only={
        "metavar": "CHECK,SCENE", "help": "checks and scenes, by name"})


if __name__ == "__main__":
    sys.exit(main())

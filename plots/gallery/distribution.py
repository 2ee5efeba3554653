# SPDX-License-Identifier: MIT
"""The distribution of areas or qualities at the end of runs: in a sentence, and beside the
thesis's number of triangles. A distribution is {"edges": [...], "counts": [...]}."""
from gallery import charts, runs
from gallery.compare import NONE, number, percent, ratio
from gallery.shared import style

UNITS = {"area": " domain units²", "quality": ""}
MEANING = {"area": "areas", "quality": "qualities, 2/√3 times the sine of the smallest angle,"}


def measure(run, part):
    """The distribution of a figures.Histogram in a run: the program's, or that of a frame."""
    if part.frame:
        return charts.areas(run.frame(run.nearest(part.frame)[1]))
    found = run.result.get("histograms", {}).get(part.quantity)
    if found is None:
        raise runs.NotRun(f"{run.plan.scene} wrote no histogram of {part.quantity}.")
    return found


def sentence(part, shown):
    """shown: [(label, distribution)]; the first one is described, the others are compared."""
    base = shown[0][1]
    total = sum(base["counts"])
    middle, mean = charts.median(**base), charts.mean(**base)
    text = (f"There are {style.whole(total)} triangles. Their median {part.quantity} is "
            f"{number(middle)}{UNITS[part.quantity]}, {number(middle / mean)} times the mean; "
            f"{percent(max(base['counts']) / total, 0)} of them lie in the fullest bin")
    gaps = [(charts.largest_gap(item, base), label) for label, item in shown[1:]
            if item["edges"] == base["edges"]]
    if gaps:
        gap, label = max(gaps)
        text += ("; the other cumulative curves differ from it by at most "
                 f"{percent(gap, 1)} of the triangles ({label})")
    if part.frame:
        text += "; the median of an exponential distribution is 0.693 times its mean"
    return text + "."


def rows_of(part, shown, facts):
    """Rows of (what, thesis, ours, ratio)."""
    known = facts.value(part.triangles) if part.triangles else None
    rows = []
    for label, item in shown:
        count = sum(item["counts"])
        theirs = known if item is shown[0][1] else None
        rows.append((f"triangles, {label}", style.whole(theirs) if theirs else NONE,
                     style.whole(count), ratio(count, theirs)))
    return rows

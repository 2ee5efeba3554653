# SPDX-License-Identifier: MIT
"""Numbers of a run in sentences, and beside the thesis's in rows of (what, thesis, ours, ratio)."""
from gallery.shared import style

NONE = "–"


def ratio(ours, theirs, count=3):
    """ours / theirs as text."""
    return style.digits(ours / theirs, count) if ours is not None and theirs else NONE


def _named(label, text):
    return f"{label}: {text}" if label else text


def rows_of(row, run, facts):
    """The rows of the table for frames of a run; row: a figures.Row."""
    theirs = facts.triangles(row.triangles) if row.triangles else {}
    rows = []
    for step in row.steps:
        count = run.counts.get(step)
        if count is not None:
            known = theirs.get(step)
            rows.append((_named(row.label, f"triangles at step {step}"),
                         style.whole(known) if known else NONE, style.whole(count),
                         ratio(count, known)))
    area = run.result.get("area_ratio")
    if row.area_ratio and area is not None:
        known = facts.value(row.area_ratio)
        rows.append((_named(row.label, "last area / first area"), f"{known:.7f}", f"{area:.7f}",
                     ratio(area, known, 5)))
        rows.append((_named(row.label, "area lost or gained, parts of the first"),
                     style.digits(abs(known - 1)), style.digits(abs(area - 1)),
                     ratio(abs(area - 1), abs(known - 1))))
    for key, what in (("sd_rel_half", "symmetric difference half-way, parts of the first area"),
                      ("sd_rel_last", "symmetric difference at the end, parts of the first area"),
                      ("attribute_error_last", "largest error of the value")):
        if run.result.get(key) is not None:
            rows.append((_named(row.label, what), NONE, style.digits(run.result[key]), NONE))
    return rows


def sentence(run):
    """What came out of a run."""
    result = run.result
    text = (f"{run.plan.scene} goes from {style.whole(result['triangles_first'])} to "
            f"{style.whole(result['triangles_last'])} triangles in "
            f"{style.counted(run.last_step, 'step')}")
    sd = result.get("sd_rel_last")
    if sd is not None:
        text += (f" and ends with {style.digits(sd)} of its first area between its shape and the "
                 "exact one")
    bad = [f"{style.whole(result[key])} {what}" for key, what in (
        ("inverted", "inverted triangles"), ("unreached", "vertices that did not arrive"))
        if result.get(key)]
    return text + (f"; there were {style.listing(bad)}." if bad else
                   "; no triangle was inverted and every vertex arrived.")


def conditions(run):
    """How a run is repeated, and where it was made."""
    result, p = run.result, run.result["parameters"]
    words = [f"h = {p['h']:g}", f"dt = {p['dt']:.4g}", str(p.get("integrator", "")),
             f"{p.get('insertion', '')} insertion", str(p.get("real", "")), result["strategy"],
             str(result.get("machine") or ""), f"commit {str(result.get('commit') or '')[:10]}"]
    return f"dsc_scene {run.plan}: " + ", ".join(w for w in words if w.strip()) + "."

# SPDX-License-Identifier: MIT
"""Numbers of a run in sentences, and beside the thesis's in rows of (what, thesis, ours, ratio)."""
from gallery.shared import style

NONE = "–"


def ratio(ours, theirs, count=3):
    """ours / theirs as text."""
    return style.digits(ours / theirs, count) if ours is not None and theirs else NONE


def _named(label, text):
    return f"{label}: {text}" if label else text


def number(value, count=3):
    """A number in a sentence: its exponent does not move to the next line alone."""
    return style.digits(value, count).replace("-", "\N{NON-BREAKING HYPHEN}")


def percent(share, digits):
    return f"{100 * share:.{digits}f}\N{NO-BREAK SPACE}%"


def off(result):
    """The area between the shape and the exact one, as a part of the exact one's; or None."""
    sd, area = result.get("sd_last"), result.get("area_exact_last")
    return sd / area if sd is not None and area else None


def rows_of(row, run, facts):
    """The rows of the table for frames of a run; none where the thesis gives no number.
    row: a figures.Row."""
    theirs = facts.triangles(row.triangles) if row.triangles else {}
    rows = []
    for step, known in theirs.items():
        count = run.counts.get(step)
        if count is not None:
            rows.append((_named(row.label, f"triangles at step {step}"), style.whole(known),
                         style.whole(count), ratio(count, known)))
    area = run.result.get("area_ratio")
    if row.area_ratio and area is not None:
        known = facts.value(row.area_ratio)
        rows += [(_named(row.label, "last area / first area"), f"{known:.7f}", f"{area:.7f}",
                  ratio(area, known, 5)),
                 (_named(row.label, "area lost or gained / first area"),
                  style.digits(abs(known - 1)), style.digits(abs(area - 1)),
                  ratio(abs(area - 1), abs(known - 1)))]
        for key, when in (("sd_rel_half", "half-way"), ("sd_rel_last", "at the end")):
            if run.result.get(key) is not None:
                rows.append((_named(row.label, f"symmetric difference {when} / first area"), NONE,
                             style.digits(run.result[key]), NONE))
    return rows


def sentence(row, run, facts):
    """What came out of a run."""
    result = run.result
    text = (f"{'the' if row.label else 'The'} scene {run.plan.scene} goes from "
            f"{style.whole(result['triangles_first'])} to "
            f"{style.whole(result['triangles_last'])} triangles in "
            f"{style.counted(run.last_step, 'step')}")
    if row.triangles:
        counts = list(facts.triangles(row.triangles).values())
        text += (f", {result['triangles_last'] / result['triangles_first']:.2f} times as many "
                 f"(the thesis's: {counts[-1] / counts[0]:.2f} times)")
    text = _named(row.label[:1].upper() + row.label[1:], text)
    error = result.get("attribute_error_last")
    if error is not None:
        text += f"; its value, from 0 to 1, is off by at most {number(error)} at the end"
    elif off(result) is not None:
        text += (f"; its symmetric difference with the exact shape is {number(off(result))} of "
                 "that shape's area at the end")
    bad = [f"{style.whole(result[key])} {what}" for key, what in (
        ("inverted", "inverted triangles"), ("unreached", "vertices that did not arrive"))
        if result.get(key)]
    return text + (f"; there were {style.listing(bad)}." if bad else
                   "; no triangle was inverted and every vertex arrived.")


def machine(run):
    return [("machine", str(run.result.get("machine") or "")),
            ("commit", str(run.result.get("commit") or ""))]


def conditions(run, insertion=""):
    """How a run is repeated."""
    result, p = run.result, run.result["parameters"]
    words = [f"h = {p['h']:g}", f"dt = {p['dt']:.4g}", str(p.get("integrator", "")),
             f"{insertion or p.get('insertion', '')} insertion", str(p.get("real", "")),
             result["strategy"]]
    return f"dsc_scene {run.plan}: " + ", ".join(w for w in words if w.strip()) + "."

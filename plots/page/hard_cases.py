# SPDX-License-Identifier: MIT
"""The table of hard cases: input, measured figures, and result."""
from look import style
from page import document as page
from page.verdicts import show
from results import load

FIXED = ("name", "asked", "what_happened", "holds")
ALWAYS = ("inverted", "unreached")


def read(path):
    """The list of dsc_hard: each case an object with name, asked, what_happened and holds."""
    cases = load.read_json(path, list)
    for index, case in enumerate(cases):
        for key in ("name", "asked", "what_happened"):
            load.need(case, key, path, str, f"case {index}")
        load.need(case, "holds", path, bool, f"case {index}")
        load.listed(case, "failures", path)
    return cases


def _measured(case):
    """'inverted 0, unreached 0, sub-steps 12': the other figures of a case, in its order. Counts of zero
    are left out, except those that must be zero."""
    values = {k: v for k, v in case.items() if k not in FIXED + ("values", "error_is", "seconds")
              and not isinstance(v, (dict, list))
              and (k in ALWAYS or (v not in (None, "") and v != 0))}
    if case.get("error_is") and "error" in values:
        values[str(case["error_is"])] = values.pop("error")
    more = case.get("values")
    values.update(more if isinstance(more, dict) else {})
    return ", ".join(f"{k.replace('_', ' ')} {show(v)}" for k, v in values.items())


def table(cases):
    """The sentence and the table, or nothing."""
    if not cases:
        return ""
    failed = [c["name"] for c in cases if not c["holds"]]
    text = (f"{len(failed)} of {style.counted(len(cases), 'hard case')} "
            f"{'does' if len(failed) == 1 else 'do'} not hold: {style.listing(failed)}."
            if failed else f"All {style.counted(len(cases), 'hard case')} hold.")
    rows = [[c["name"], c["asked"], _measured(c),
             "; ".join([c["what_happened"], *(f"fails: {f}" for f in c.get("failures") or ())]),
             "✓ holds" if c["holds"] else "✗ fails"] for c in cases]
    marks = {(r, 4): "good" if c["holds"] else "bad" for r, c in enumerate(cases)}
    return page.paragraph(text) + page.table(
        ["case", "asked", "measured", "what happened", "verdict"], rows, marks)

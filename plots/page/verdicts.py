# SPDX-License-Identifier: MIT
"""The table of verdicts at the top of the report: a row for each kind of limit with its worst figure;
failures come first, checks that were not run last."""
from look import style
from page.findings import lost
from results import load, precision_data

PASS, FAIL, OPEN = "✓ pass", "✗ fail", "not run"
CLASSES = {PASS: "good", FAIL: "bad", OPEN: "open"}
HEADER = ["verdict", "what", "worst result", "limit"]


def verdicts(results):
    """(header, rows, classes) of the table."""
    rows = [_scene_row(results["scenes"])] + _gate_rows(results["verify"]) + [
        _bench_row(results["bench"]), _precision_row(results["precision"]),
        _hard_row(results["hard"])] + _gate_not_run(results["verify"])
    order = {FAIL: 0, PASS: 1, OPEN: 2}
    rows.sort(key=lambda row: order[row[0]])
    return HEADER, rows, {(k, 0): CLASSES[row[0]] for k, row in enumerate(rows)}


def _row(what, result, limit, good):
    return [PASS if good else FAIL, what, result, limit]


def _not_run(what):
    return [OPEN, what, "–", "–"]


def _scene_row(scenes):
    what = "No triangle inverted and every vertex at its target, in all runs of scenes"
    if not scenes:
        return _not_run(what)
    bad = sum(lost(s) for s in scenes)
    return _row(what, f"{style.whole(bad)} in {style.counted(len(scenes), 'run')}", "0", bad == 0)


def _share(check):
    """The sorting key of a check: the fraction of its limit that it uses; broken limits come first."""
    value, limit = check["measured"], check["limit"]
    if not load.passed(check) or not isinstance(value, (int, float)) or isinstance(value, bool):
        return (not load.passed(check), 0.0)
    low, high = (limit, value) if check.get("sense") == ">=" else (value, limit)
    return (False, low / high if high else 0.0)


def show(value):
    if isinstance(value, bool) or value is None:
        return "–" if value is None else str(value).lower()
    if not isinstance(value, (int, float)):
        return str(value)
    return style.whole(value) if value % 1 == 0 and abs(value) < 1e6 \
        else style.digits(value, 3)


def _gate_rows(verify):
    groups = {}
    for check in verify.checks if verify else []:
        groups.setdefault(check["check"], []).append(check)
    rows = []
    for name, checks in groups.items():
        worst = max(checks, key=_share)
        what = style.capital(checks[0].get("description") or name.replace("_", " "))
        where = f" ({worst['scene']})" if worst["scene"] else ""
        count = f", {len(checks)} scenes" if len(checks) > 1 else ""
        sense = {">=": "at least ", "<=": "at most "}.get(worst.get("sense"), "")
        rows.append(_row(what + count, show(worst["measured"]) + where,
                         sense + show(worst["limit"]), all(map(load.passed, checks))))
    return rows


def _gate_not_run(verify):
    if not verify or not verify.checks:
        return [_not_run("The limits of a release (dsc_verify run)")]
    names = [c["check"].replace("_", " ") for c in verify.not_run]
    return [_not_run("Further checks of the gate: " + style.listing(names))] if names else []


def _bench_row(bench):
    what = "Answers checked before they were timed"
    if not bench:
        return _not_run(what)
    refused = len(bench.refused)
    count = style.counted(len(bench.measurements) + refused, "benchmark")
    return _row(what, f"{refused} wrong of {count}", "0 wrong", not refused)


def _precision_row(errors):
    what = "The default method in flows whose exact result is known"
    mine = [run for run in errors if run.method == precision_data.DEFAULT]
    if not mine:
        return _not_run(what)
    bad = sum(not run.holds for run in mine)
    return _row(what, f"{bad} of {style.counted(len(mine), 'run')} lost a triangle or a vertex",
                "0", not bad)


def _hard_row(cases):
    what = "Hard cases: huge steps, tiny and far coordinates, needles, NaN, contacts"
    if not cases:
        return _not_run(what)
    good = sum(case["holds"] for case in cases)
    return _row(what, f"{good} of {len(cases)} hold", "all", good == len(cases))

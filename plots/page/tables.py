# SPDX-License-Identifier: MIT
"""The tables of the report that belong to no picture: checks of the gate, runs of scenes, published
figures, refused benchmarks, files."""
import os

from look import style
from page import document as page
from page.findings import lost, thesis_ratio
from page.verdicts import show
from results import load


def gate(verify):
    """Every check that was run, and the names of those that were not."""
    passed = [load.passed(c) for c in verify.checks]
    failed = [c for c, good in zip(verify.checks, passed) if not good]
    if not verify.checks:
        return page.paragraph("The report of the gate contains no check, so it proves nothing.")
    if failed:
        names = [f"{c['check']} ({c['scene'] or '–'})" for c in failed]
        more = f" and {len(names) - 6} more" if len(names) > 6 else ""
        text = (f"{len(failed)} of {style.counted(len(passed), 'check')} "
                f"{'does' if len(failed) == 1 else 'do'} not pass: "
                + (style.listing(names) if not more else ", ".join(names[:6]) + more) + ".")
    else:
        text = ("The one check passes." if len(passed) == 1 else
                f"All {len(passed)} checks pass.")
    rows = [[c["check"], c["scene"] or "–", show(c["measured"]), show(c["limit"]),
             c.get("unit") or "", ("✓ " if good else "✗ ") + c["verdict"]]
            for c, good in zip(verify.checks, passed)]
    rows += [[c["check"], style.counted(len(c.get("scenes") or []), "scene"), "–", "–", "",
              "not run"] for c in verify.not_run]
    marks = {(r, 5): "open" if row[5] == "not run" else "good" if row[5][0] == "✓" else "bad"
             for r, row in enumerate(rows)}
    if verify.not_run:
        text += (" The others are run by build/release/verify/dsc_verify run, which takes some "
                 "minutes.")
    return page.paragraph(text) + page.table(
        ["check", "scene", "measured", "limit", "unit", "verdict"], rows, marks, "The gate")


def scenes(runs, published):
    """What every run of a scene measured, with the thesis's area ratio beside ours."""
    rows, closer, compared = [], 0, 0
    for s in sorted(runs, key=lambda s: (s.name, style.order(s.strategy), s.path)):
        ratio, theirs = s.value("area_ratio"), thesis_ratio(s, published)
        if ratio is not None and theirs is not None:
            compared += 1
            closer += abs(ratio - 1) < abs(theirs - 1)
        h = s.parameter("h")
        rows.append([
            s.name, s.strategy, f"{h:g}" if isinstance(h, float) else "–",
            style.whole(s.value("triangles_last") or 0),
            f"{ratio:.6f}" if ratio is not None else "–",
            f"{theirs:.6f}" if theirs is not None else "–",
            style.digits(s.value("sd_rel_last")), style.digits(s.value("sd_rel_half")),
            style.digits(s.value("min_quality_ever")), *(
                "–" if s.value(k) is None else style.whole(s.value(k))
                for k in ("inverted", "unreached")), style.digits(s.value("cpu_s"))])
    bad = sorted({s.name for s in runs if lost(s) > 0})
    text = (f"{style.counted(len(runs), 'run')}; " + (
        f"inverted triangles or unreached vertices in {style.listing(bad)}"
        if bad else "no inverted triangle and no unreached vertex in any"))
    if compared:
        text += (f"; the thesis also states the area ratio of {compared} of them; {closer} of ours "
                 f"{'is' if closer == 1 else 'are'} closer to 1")
    return page.paragraph(text + ".") + page.table(
        ["scene", "strategy", "h", "triangles", "area ratio", "thesis", "SD rel.", "SD at T/2",
         "worst quality", "inverted", "unreached", "CPU s"], rows, name="Runs of scenes")


def sources(published):
    rows = [[e["what"], e["kind"], e["source"]]
            for data in published.values() for e in data["entries"].values()]
    text = (f"{len(rows)} figures to compare with: "
            + style.listing(f"{sum(r[1] == k for r in rows)} {w}" for k, w in (
                ("thesis", "of the thesis"), ("published", "published"),
                ("measured", "measured by this project"))) + ".")
    return page.paragraph(text) + page.table(["what", "kind", "source"], rows,
                                             name="Published figures")


def refusals(bench):
    if not bench or not bench.refused:
        return ""
    return page.paragraph(f"{style.counted(len(bench.refused), 'benchmark')} refused "
                          "to time a wrong answer:") \
        + page.table(["benchmark", "reason"], bench.refused, name="Refused benchmarks")


def files(paths, out):
    """Links to the result files that lie in the folder of the page, and the names of the others."""
    inside, outside = [], []
    for path in paths:
        name = os.path.relpath(path, out)
        (outside if name.startswith("..") else inside).append(name)
    items = [page.link(name, name) for name in inside] + [
        page.escape(os.path.basename(name)) for name in outside]
    return '<ul class="files">' + "".join(f"<li>{item}</li>" for item in items) + "</ul>\n" \
        if items else ""

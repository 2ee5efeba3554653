# SPDX-License-Identifier: MIT
"""The tables of the report without a picture: checks of the gate, runs of scenes, published figures,
refused benchmarks, files."""
import os

from look import style
from page import document as page
from page.findings import limits, meshes, thesis_ratio
from page.verdicts import show
from results import load


def gate(verify):
    """All checks that were run, and the names of those that were not."""
    if not verify.checks:
        return page.paragraph("The report of the gate contains no checks, so it proves nothing.")
    rows = [[c["check"], c["scene"] or "–", show(c["measured"]), show(c["limit"]),
             c.get("unit") or "", ("✓ " if load.passed(c) else "✗ ") + c["verdict"]]
            for c in verify.checks]
    rows += [[c["check"], style.counted(len(c.get("scenes") or []), "scene"), "–", "–", "",
              "not run"] for c in verify.not_run]
    marks = {(r, 5): "open" if row[5] == "not run" else "good" if row[5][0] == "✓" else "bad"
             for r, row in enumerate(rows)}
    return page.paragraph(limits(verify)) + page.table(
        ["check", "scene", "measured", "limit", "unit", "verdict"], rows, marks, "The gate")


def scenes(runs, published):
    """The figures of all runs of scenes, with the thesis's area ratio beside ours."""
    rows = []
    for s in sorted(runs, key=lambda s: (s.name, style.order(s.strategy), s.path)):
        ratio, theirs = s.value("area_ratio"), thesis_ratio(s, published)
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
    return page.paragraph(meshes(runs)) + page.table(
        ["scene", "strategy", "h", "triangles", "area ratio", "thesis", "SD rel.", "SD at T/2",
         "worst quality", "inverted", "unreached", "CPU s"], rows, name="Runs of scenes")


def sources(published):
    rows = [[e["what"], e["kind"], e["source"]]
            for data in published.values() for e in data["entries"].values()]
    return page.table(["what", "kind", "source"], rows, name="Published figures")


def refusals(bench):
    if not bench or not bench.refused:
        return ""
    return page.paragraph(f"{style.counted(len(bench.refused), 'benchmark')} refused "
                          "to time a wrong answer:") \
        + page.table(["benchmark", "reason"], bench.refused, name="Refused benchmarks")


def files(paths, out):
    """Links to the result files in the folder of the page, and the names of the others."""
    inside, outside = [], []
    for path in paths:
        name = os.path.relpath(path, out)
        (outside if name.startswith("..") else inside).append(name)
    items = [page.link(name, name) for name in inside] + [
        page.escape(os.path.basename(name)) for name in outside]
    return '<ul class="files">' + "".join(f"<li>{item}</li>" for item in items) + "</ul>\n" \
        if items else ""

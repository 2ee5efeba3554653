# SPDX-License-Identifier: MIT
"""The main comparisons in tables: for each scene of the gate, the differences from the exact shape,
between parallel and sequential runs, and between the library and the literal method, each beside its
limit; and the speed-up of threads."""
from look import style
from page import document as page
from results import load, series

EXACT = (("area ratio, off 1", ("area_ratio", "accuracy_area")),
         ("symmetric difference", ("symmetric_difference", "accuracy")))
MESH = (("area", "area"), ("areas of triangles", "area_histogram"),
        ("qualities", "quality_histogram"), ("worst quality", "min_quality"))
# {title: columns of (title, checks; the first one found is shown)}
PARTS = {"Against the exact shape": EXACT,
         "Each strategy against the sequential run":
             tuple((title, ("parallel_" + name,)) for title, name in MESH),
         "The library against the literal method":
             tuple((title, ("reference_" + name,)) for title, name in MESH)}


def _cell(check):
    """'0.0283 of 0.032, cells', or '0.44, at least 0.39'."""
    measured = "–" if check["measured"] is None else style.digits(check["measured"], 2)
    limit = style.digits(check["limit"], 2)
    text = f"{measured}, at least {limit}" if check.get("sense") == ">=" else f"{measured} of {limit}"
    strategy = check.get("strategy", "sequential")
    return text + (f", {strategy}" if strategy != "sequential" else "")


def _table(title, columns, checks):
    """A row for each scene with a figure in one of the columns."""
    found = {(c["check"], c["scene"]): c for c in checks}
    rows, classes = [], {}
    for scene in dict.fromkeys(c["scene"] for c in checks):
        here = [next((found[name, scene] for name in names if (name, scene) in found), None)
                for _, names in columns]
        if not any(here):
            continue
        good = all(load.passed(c) for c in here if c)
        classes[len(rows), 0] = "good" if good else "bad"
        classes.update({(len(rows), 2 + k): "bad" for k, c in enumerate(here)
                        if c and not load.passed(c)})
        rows.append(["✓ pass" if good else "✗ fail", scene] + [_cell(c) if c else "–" for c in here])
    failed = sum(row[0] == "✗ fail" for row in rows)
    return page.paragraph(f"{title}: {style.counted(len(rows), 'scene')}, "
                          + (f"{failed} with a limit that is broken." if failed else "all limits hold.")) \
        + page.table(["verdict", "scene"] + [name for name, _ in columns], rows, classes, title) \
        if rows else ""


def _threads(bench):
    """S(n) and U(n) of whole runs without other work between steps, by strategy and size."""
    rows = []
    for p in sorted(series.undisturbed(bench), key=lambda p: (
            p.row.family, p.row.triangles, p.row.strategy, p.n)):
        used, busy = (p.row.measurement.counter(k) for k in ("threads_used", "utilisation"))
        rows.append([series.title(p.row.family), p.row.size, p.row.strategy, str(p.n),
                     "–" if used is None else f"{used:.0f}", style.duration(p.base.median),
                     f"{p.s:.2f}", f"{p.u:.2f}", "–" if busy is None else f"{busy:.2f}"])
    return page.paragraph("Whole runs against the sequential run: S(n) is the speed-up on n threads, "
                          "U(n) the share of their time for which they were busy, as measured.") \
        + page.table(["scene", "mesh", "strategy", "n", "used", "t_s a step", "S(n)", "S(n) / n",
                      "U(n)"], rows, name="Speed-up") if rows else ""


def section(results):
    """The tables as HTML; nothing if neither the gate nor the benchmarks were run."""
    checks = results["verify"].checks if results["verify"] else []
    return "".join(_table(title, columns, checks) for title, columns in PARTS.items()) \
        + _threads(results["bench"])

# SPDX-License-Identifier: MIT
"""The report of all results in some folders: index.html and pictures, each machine and commit by
itself."""
import argparse
import os
import pathlib
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(os.path.join(ROOT, "plots"))  # behind our own, which may have the same names

import errors_drawn  # noqa: E402
import records  # noqa: E402
import speedups  # noqa: E402
import speedups_drawn  # noqa: E402
import store  # noqa: E402
from accuracy import convergence, precision, precision_data  # noqa: E402
from errors import SweepError  # noqa: E402
from look import style  # noqa: E402
from page import document as page  # noqa: E402
from page import drawing, tables  # noqa: E402
from results import load  # noqa: E402

FORMATS = ("png", "svg")


def pictures(group, prefix):
    """All that can be drawn of one machine and commit."""
    points, context = records.points(group), group.context
    # Runs that were timed and runs that were not never share a picture.
    for is_timed in (True, False):
        mine = [p for p in points if p.is_timed is is_timed]
        kind = "" if is_timed else "_untimed"
        for scene, lines in errors_drawn.lines(mine).items():
            name = f"{prefix}_{_stem(scene)}{kind}"
            if is_timed or not any(p.is_timed and p.scene == scene for p in points):
                yield errors_drawn.against_time(scene, lines, context, f"{name}_error_against_time")
            yield errors_drawn.against_length(scene, lines, context, f"{name}_order")
    for scene, found in records.by(speedups.find(points), lambda s: s.point.scene).items():
        name = f"{prefix}_{_stem(scene)}"
        yield speedups_drawn.over_threads(scene, found, context, group.facts.get("cores"),
                                          f"{name}_speedup_over_threads")
        over_sizes = speedups_drawn.over_sizes(scene, found, context, f"{name}_speedup_over_sizes")
        if over_sizes:
            yield over_sizes
    suite = precision_runs(group)
    for picture in [*precision.draw(suite, {}), *convergence.draw(suite)]:
        picture.name = f"{prefix}_{picture.name}"
        yield picture


def _stem(scene):
    return "".join(c if c.isalnum() or c in "-_" else "-" for c in scene)


def precision_runs(group):
    """What dsc_precision wrote, as the report of bench/run.sh reads it; of repeats the first."""
    found = {}
    for record in group.records:
        for data in (record.get("files") or {}).values():
            if isinstance(data, dict) and {"flow", "method", "group", "sd_rel_last"} <= set(data):
                found.setdefault((data["flow"], data["method"],
                                  str(data.get("parameters", {}).get("h"))), data)
    runs = []
    with tempfile.TemporaryDirectory() as folder:
        for number, data in enumerate(found.values()):
            path = pathlib.Path(folder, f"{number}.json")
            store.write(path, data)
            runs.append(precision_data.read(str(path)))
    return runs


def failures(group):
    """Each with its command and its last words."""
    text = ""
    for record in group.failures:
        words = record["last_words"]["stderr"] or record["last_words"]["stdout"]
        text += page.fold(f"✗ {record['what']}: {record['problem']}",
                          f"<pre>{page.escape(record['again'])}</pre>"
                          f"<pre>{page.escape(chr(10).join(words))}</pre>")
    return text


def campaigns(group):
    """Rows of commands, run by run: faults, mutants, searches."""
    rows = [[r["row"], r["what"].partition(": ")[2] or "–", style.digits(r["wall_s"]),
             style.digits(r["cpu_s"]), next(iter(reversed(r["last_words"]["stdout"])), "–")[:160]]
            for r in group.records if "scene" not in r["identity"]]
    return page.fold(style.counted(len(rows), "run") + " of commands", page.table(
        ["row", "run", "wall s", "CPU s", "last line"], rows, name="Commands")) if rows else ""


def scene_table(group):
    """Every run of a scene with its spread."""
    rows = []
    for p in records.points(group):
        cells = [p.scene, p.label, "–" if p.h is None else precision_data.length(p.h)]
        for key in ("triangles_last", "sd_rel_last", "cpu_s", "wall_s"):
            found = p.spread(key)
            cells.append("–" if found is None else style.whole(found.median)
                         if key == "triangles_last" else style.digits(found.median))
            if key in ("cpu_s", "wall_s"):
                cells.append("–" if found is None else
                             f"{style.digits(found.low)} to {style.digits(found.high)}")
        rows.append(cells + [str(len(p.records)), "alone" if p.is_timed else "beside others"])
    return page.fold(style.counted(len(rows), "run") + " of scenes, repeats and seeds together",
                     page.table(["scene", "run", "h", "triangles", "error", "CPU s", "quartiles",
                                 "wall s", "quartiles", "runs", "run"], rows,
                                name="Runs of scenes")) if rows else ""


def section(group, drawn):
    counts = style.counted(len(group.records), "result")
    if group.failures:
        counts += f", {style.counted(len(group.failures), 'failed run')}"
    facts = page.facts([("machine", group.context.machine), ("commit", group.context.commit),
                        ("results", counts),
                        ("busy with other work", f"{group.context.load} (median beside timed runs)"
                         if group.context.load else "")])
    return (facts + failures(group) + "".join(page.figure(d) for d in drawn) + scene_table(group)
            + campaigns(group))


def build(folders, out, jobs):
    """Writes the page; gives its path and what was found in one sentence."""
    groups = records.read(folders)
    if not groups:
        raise SweepError(f"no result in {style.listing(map(str, folders))}; allowed: folders that "
                         "a sweep has written")
    os.makedirs(out, exist_ok=True)
    tasks = [(str(k), lambda k=k: pictures(groups[k], f"group{k + 1}")) for k in range(len(groups))]
    drawn = drawing.draw_all(tasks, out, FORMATS, jobs)
    sections = [(f"group{k + 1}", f"{group.machine}, {group.commit}", section(group, drawn[str(k)]))
                for k, group in enumerate(groups)]
    paths = [r["path"] for group in groups for r in group.records + group.failures]
    sections.append(("files", "Files", tables.files(paths, out),
                     "the results as they were written"))
    machines = len({group.machine for group in groups})
    commits = len({group.commit for group in groups})
    lead = (f"{style.counted(len(paths), 'run')} on {style.counted(machines, 'machine')} at "
            f"{style.counted(commits, 'commit')}; each machine and commit by itself, nothing is "
            "averaged over them.")
    text = page.document("Sweep", lead, "", sections)
    path = os.path.join(out, "index.html")
    style.write_bytes(path, text.encode("utf-8"))
    return path, lead


def main(argv):
    parser = argparse.ArgumentParser(prog="sweep.sh collect", description=__doc__)
    parser.add_argument("folders", nargs="+", metavar="DIR", help="where the results of sweeps are")
    parser.add_argument("--report", metavar="DIR",
                        help="where the report goes (default DIR/report)")
    parser.add_argument("--jobs", type=int, default=drawing.cores(),
                        help="pictures at the same time")
    options = parser.parse_args(argv)
    out = options.report or os.path.join(options.folders[0], "report")
    try:
        path, lead = build(options.folders, out, options.jobs)
    except load.InputFault as fault:
        raise SweepError(str(fault)) from fault
    print(f"{lead}\n{path}")
    return 0

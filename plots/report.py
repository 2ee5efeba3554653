#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws every picture and writes index.html from result files.

report.py --bench FILE... --scenes FILE... --precision FILE... --hard FILE --verify FILE...
          --frames DIR --published DIR --out DIR [--formats png,svg,pdf]

What was not run is said plainly in the page and is no error. Exit 0 done; 2 bad usage or a file
that cannot be used, with one sentence on the error stream.
"""
import argparse
import os
import sys

try:
    import matplotlib  # noqa: F401  (only to say clearly which Python lacks it)
except ImportError:
    sys.stderr.write(f"report.py: {sys.executable} has no matplotlib; run it with a Python that "
                     "has (Debian: package python3-matplotlib and /usr/bin/python3).\n")
    sys.exit(2)

import breakdown
import convergence
import copies
import frames
import granularity
import hard_cases
import histograms
import load
import page
import per_operation
import precision
import precision_data
import speedup
import step_cost
import style
import submeshes

FORMATS = ("png", "svg", "pdf")


class Usage(Exception):
    """A wrong command line; its text is one sentence."""


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Usage(f"{message} (see report.py --help).")


def arguments(argv):
    parser = Parser(prog="report.py", description=__doc__.split("\n\n")[0])
    for name, what in (("bench", "Google Benchmark JSON of dsc_bench"),
                       ("scenes", "JSON of dsc_scene"), ("precision", "JSON of dsc_precision"), ("verify", "JSON of dsc_verify")):
        parser.add_argument(f"--{name}", nargs="*", action="extend", default=[], metavar="FILE",
                            help=what)
    parser.add_argument("--hard", metavar="FILE", help="JSON of dsc_hard")
    parser.add_argument("--frames", metavar="DIR", help="frames that dsc_scene wrote")
    parser.add_argument("--published", metavar="DIR", help="the figures to compare with")
    parser.add_argument("--out", required=True, metavar="DIR", help="where the report goes")
    parser.add_argument("--formats", default=",".join(FORMATS), metavar="LIST",
                        help="of png,svg,pdf (default: all)")
    options = parser.parse_args(argv)
    options.formats = [f for f in options.formats.split(",") if f]
    for form in options.formats:
        if form not in FORMATS:
            raise Usage(f"--formats has '{form}', where {style.listing(FORMATS)} are allowed.")
    return options


class Report:
    """Collects the sections of the page and saves their pictures one by one, so that no figure is
    open when the next is drawn."""

    def __init__(self, out, formats):
        self.out, self.formats, self.sections = out, formats, []

    def figures(self, pictures):
        parts = []
        for picture in pictures:
            png = style.save(picture.figure, self.out, picture.name, self.formats)
            parts.append(page.figure(picture, png, [f"{picture.name}.{f}" for f in self.formats]))
        return "".join(parts)

    def add(self, identifier, title, pictures, missing, before="", after=""):
        inside = before + self.figures(pictures) + after
        self.sections.append((identifier, title, inside or page.paragraph(missing, "note")))


def verdict(verify):
    """The table of checks and the sentence over it."""
    passed = [str(c["verdict"]).lower() in ("pass", "passed", "ok") for c in verify.checks]
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

    def show(value):
        if isinstance(value, bool) or value is None:
            return "–" if value is None else str(value).lower()
        return style.digits(value, 4) if isinstance(value, (int, float)) else str(value)

    rows = [[c["check"], c["scene"] or "–", show(c["measured"]), show(c["limit"]),
             c.get("unit") or "", ("✓ " if good else "✗ ") + c["verdict"]]
            for c, good in zip(verify.checks, passed)]
    marks = {(r, 5): "good" if good else "bad" for r, good in enumerate(passed)}
    return page.paragraph(text) + page.table(
        ["check", "scene", "measured", "limit", "unit", "verdict"], rows, marks)


def thesis_ratio(scene, published):
    """The thesis's area ratio for a run of the same scene and length, or None."""
    steps = scene.parameter("steps")
    identifier = {"vortex-square": "vortex_area_ratio"}.get(scene.name)
    if scene.name == "swirl" and steps in (260.0, 420.0):
        identifier = f"swirl_{steps:.0f}_area_ratio"
    found = load.entry(published, "thesis", identifier) if identifier else None
    return found["value"] if found else None


def scene_table(scenes, published):
    """What every run of a scene measured, with the thesis's area ratio beside ours."""
    rows, closer, compared = [], 0, 0
    for s in sorted(scenes, key=lambda s: (s.name, style.order(s.strategy), s.path)):
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
    bad = [s.name for s in scenes if (s.value("inverted") or 0) + (s.value("unreached") or 0) > 0]
    text = (f"{style.counted(len(scenes), 'run')}; " + (
        f"inverted triangles or unreached vertices in {style.listing(sorted(set(bad)))}"
        if bad else "no inverted triangle and no unreached vertex in any"))
    if compared:
        text += (f"; the thesis also states the area ratio of {compared} of them; {closer} of ours "
                 f"{'is' if closer == 1 else 'are'} closer to 1")
    return page.paragraph(text + ".") + page.table(
        ["scene", "strategy", "h", "triangles", "area ratio", "thesis", "SD rel.", "SD at T/2",
         "worst quality", "inverted", "unreached", "CPU s"], rows)


def sources(published):
    rows = [[e["what"], e["kind"], e["source"]]
            for data in published.values() for e in data["entries"].values()]
    text = (f"{len(rows)} figures to compare with: "
            + style.listing(f"{sum(r[1] == k for r in rows)} {w}" for k, w in (
                ("thesis", "of the thesis"), ("published", "published"),
                ("measured", "measured by this project"))) + ".")
    return page.paragraph(text) + page.fold("All of them, with their sources", page.table(
        ["what", "kind", "source"], rows))


def refusals(bench):
    if not bench or not bench.refused:
        return ""
    return page.paragraph(f"{style.counted(len(bench.refused), 'benchmark')} refused "
                          "to time a wrong answer:") \
        + page.table(["benchmark", "reason"], bench.refused)


def missing(bench):
    return "The benchmarks were not run." if not bench else \
        "The benchmarks were run without the rows that this picture shows."


def copied(bench):
    """The sentence and the table of what copies cost."""
    found = copies.table(bench) if bench else None
    return page.paragraph(found[0]) + page.table(*found[1:]) if found else ""


def add_steps(report, bench, published):
    """The sections on the time of a step."""
    def pictures(draw, *more):
        return draw(bench, *more) if bench else []

    off = missing(bench)
    unmodelled = "The benchmarks were run without modelled rows." if bench else off
    report.add("speedup", "Speed-up", pictures(speedup.draw, published), off,
               before=refusals(bench))
    report.add("breakdown", "Where the time of a step goes", pictures(breakdown.draw),
               unmodelled)
    report.add("granularity", "How much work threads need", pictures(granularity.draw), off)
    report.add("copies", "Copies of submeshes against work in place", [], off,
               before=copied(bench))
    report.add("steps", "Time of a step", pictures(step_cost.draw, published), off)


def build(options):
    """Reads everything first, so that a bad file does not leave half a report behind."""
    bench = load.read_bench(options.bench) if options.bench else None
    scenes = [load.read_scene(path) for path in options.scenes]
    errors = [precision_data.read(path) for path in options.precision]
    hard = hard_cases.read(options.hard) if options.hard else None
    verify = load.read_verify(options.verify) if options.verify else None
    published = load.read_published(options.published) if options.published else {}
    runs = frames.read(options.frames) if options.frames else []
    divided = submeshes.read(options.frames) if options.frames else []
    try:
        os.makedirs(options.out, exist_ok=True)
    except OSError as fault:
        raise load.InputFault(f"{options.out} cannot be made: {fault.strerror}.") from fault

    report = Report(options.out, options.formats)
    # Histograms come from a verify report or from a scene: take the one that names its machine.
    context = next((c for c in ([verify.context] if verify else []) + [
        s.context for s in scenes] if c.machine), None)
    report.add("verdict", "Verdict", [], "The gate (dsc_verify) was not run.",
               before=verdict(verify) if verify else "")
    add_steps(report, bench, published)
    no_frames = "No frames were written." if options.frames else \
        "The scenes were run without frames." if scenes else "The scenes were not run."
    drawn_by = scenes[0].context if scenes else None
    report.add("submeshes", "Submeshes", submeshes.draw(divided, drawn_by),
               "No frame was written together with its submeshes." if runs else no_frames)
    off_bench = missing(bench)
    report.add("operations", "Cost per operation",
               per_operation.draw(bench, published) if bench else [], off_bench)
    report.add("precision", "Error against time",
               precision.draw(errors, published) + convergence.draw(errors),
               "Errors against times (dsc_precision) were not measured.")
    report.add("hard", "Hard cases", [], "The hard cases (dsc_hard) were not run." if hard is None
               else "The list of hard cases is empty, so it proves nothing.",
               before=hard_cases.table(hard) if hard else "")
    report.add("scenes", "Scenes", [], "The scenes were not run.",
               before=scene_table(scenes, published) if scenes else "")
    report.add("histograms", "Areas and qualities of the triangles",
               histograms.draw(scenes, verify, published, context),
               "No run wrote histograms." if scenes or verify else
               "Neither the scenes nor the gate were run, so there are no histograms.")
    report.add("frames", "Meshes", frames.draw(runs, drawn_by), no_frames)
    report.add("sources", "What we compare with", [], "No published figures were given, so the "
               "pictures show our own results only.",
               before=sources(published) if published else "")
    _write(report, bench, context, options)


def _write(report, bench, other, options):
    context = bench.context if bench else other
    head = page.facts([
        ("machine", context.machine), ("cores", str(context.cores or "")),
        ("load at the start", context.load), ("compiler", context.compiler),
        ("build", context.build_type), ("commit", context.commit), ("date", context.date),
    ]) if context else page.paragraph("No result names its machine.")
    text = page.document(
        "Deformable simplicial complexes: speed against error",
        "Results of these runs, beside the figures of the thesis and of other programs.",
        head, report.sections)
    style.write_bytes(os.path.join(options.out, "index.html"), text.encode("utf-8"))


def main(argv):
    try:
        build(arguments(argv))
    except (load.InputFault, Usage) as fault:
        sys.stderr.write(f"report.py: {fault}\n")
        return 2
    except OSError as fault:
        sys.stderr.write(f"report.py: {fault.filename or 'a file'} cannot be written: "
                         f"{fault.strerror}.\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws every picture and writes index.html from result files.

report.py --bench FILE... --scenes FILE... --precision FILE... --hard FILE --verify FILE... --frames DIR --published DIR --out DIR [--formats png,svg,pdf] [--jobs N]

The page says what was not run; this is not an error.
"""
import os
import sys

from look import saving, script, style  # first: reports a Python without matplotlib

import frames
import submeshes
from page import contents, document as page, drawing, hard_cases
from results import load, precision_data


def arguments(argv):
    words = script.parser(__doc__)
    for name, what in (("bench", "Google Benchmark JSON of dsc_bench"),
                       ("scenes", "JSON of dsc_scene"),
                       ("precision", "JSON of dsc_precision"), ("verify", "JSON of dsc_verify")):
        words.add_argument(f"--{name}", nargs="*", action="extend", default=[], metavar="FILE",
                           help=what)
    for name, kind, what in (
            ("hard", "FILE", "JSON of dsc_hard"),
            ("frames", "DIR", "frames of dsc_scene"),
            ("published", "DIR", "published figures for comparison"),
            ("out", "DIR", "folder for the report")):
        words.add_argument(f"--{name}", required=name == "out", metavar=kind, help=what)
    words.add_argument("--formats", default=",".join(script.FORMATS), metavar="LIST",
                       help="of png,svg,pdf (default: all)")
    words.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)), metavar="N",
                       help="pictures drawn at the same time (default: one for each core)")
    options = words.parse_args(argv)
    options.formats = [f for f in options.formats.split(",") if f]
    if not set(options.formats) <= set(script.FORMATS):
        words.error(f"--formats has '{','.join(options.formats)}', where "
                    f"{style.listing(script.FORMATS)} are allowed.")
    return options


def read(options):
    """All results as plain records."""
    found = {
        "bench": load.read_bench(options.bench) if options.bench else None,
        "scenes": [load.read_scene(path) for path in options.scenes],
        "precision": [precision_data.read(path) for path in options.precision],
        "hard": hard_cases.read(options.hard) if options.hard else None,
        "verify": load.read_verify(options.verify) if options.verify else None,
        "published": load.read_published(options.published) if options.published else {},
        "frames": options.frames,
        "runs": frames.read(options.frames) if options.frames else [],
        "divided": submeshes.read(options.frames) if options.frames else [],
    }
    found["files"] = [*options.bench, *options.scenes, *options.verify,
                      *([options.hard] if options.hard else []), *options.precision]
    return found


def build(options):
    """Reads all files first, so that a bad file does not leave an incomplete report."""
    results = read(options)
    try:
        os.makedirs(options.out, exist_ok=True)
    except OSError as fault:
        raise load.InputFault(f"{options.out} cannot be made: {fault.strerror}.") from fault
    drawn = drawing.draw_all(contents.tasks(results), options.out, options.formats, options.jobs)
    sections = contents.build(results, drawn, options.out)
    text = page.document(
        "Deformable simplicial complexes: speed against error",
        "Accuracy and speed of moving interfaces on this machine, beside figures of the thesis and of "
        "other programs.", _head(contents.context(results)), sections)
    saving.write_bytes(os.path.join(options.out, "index.html"), text.encode("utf-8"))


def _head(context):
    if not context:
        return page.paragraph("No result names its machine.")
    return page.facts([
        ("machine", context.machine),
        ("cores", "" if "core" in context.machine else str(context.cores or "")),
        ("busy with other work", f"{context.load} cores, in the median of the measurements"
         if context.load else ""), ("compiler", context.compiler),
        ("build", context.build_type), ("commit", context.commit), ("date", context.date)])


def main(argv=None):
    options = arguments(argv)
    return script.attempt("report.py", lambda: build(options))


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: MIT
"""The contents of the page in order: findings, then pictures, then reference sections, which are
folded."""
import pathlib
from functools import partial

from look import style  # first: reports a Python without matplotlib

import breakdown
import convergence
import film
import frames
import gallery
import granularity
import histograms
import operations
import precision
import space
import speedup
import step_cost
import submeshes
from page import comparison, document as page, findings, hard_cases, tables, verdicts
from results import precision_data

FIRST = ("swirl", "drop-and-pool", "grains")  # the meshes shown first


def tasks(results):
    """[(section, function that gives Pictures)]"""
    bench, published = results["bench"], results["published"]
    drawn_by = results["scenes"][0].context if results["scenes"] else None
    runs = sorted(results["runs"], key=lambda run: style.order(run[0], FIRST))
    found = [("frames", partial(frames.draw, [run], drawn_by)) for run in runs]
    if bench:
        found += [("steps", partial(step_cost.draw, bench, published)),
                  ("speedup", partial(speedup.draw, bench, published)),
                  ("breakdown", partial(breakdown.draw, bench)),
                  ("granularity", partial(granularity.draw, bench)),
                  ("operations", partial(operations.draw, bench, published))]
    errors = results["precision"]
    found += [("precision", partial(precision.draw, [run for run in errors if run.flow == flow],
                                    published)) for flow in precision_data.flows(errors)]
    found.append(("convergence", partial(convergence.draw, errors)))
    found += [("submeshes", partial(submeshes.draw, [one], drawn_by))
              for one in results["divided"]]
    # Only these: three pictures for each scene would add little; the numbers are in the results.
    found.append(("histograms", partial(histograms.draw, results["scenes"], results["verify"],
                                        published, context(results, of_meshes=True),
                                        histograms.SHOWN)))
    return found


def context(results, of_meshes=False):
    """The machine of the benchmarks, or of another result."""
    bench, verify = results["bench"], results["verify"]
    if bench and not of_meshes:
        return bench.context
    known = ([verify.context] if verify else []) + [s.context for s in results["scenes"]]
    return next((c for c in known if c.machine), None)


def _no_bench(bench):
    return "The benchmarks were not run." if not bench else \
        "The benchmarks were run without the rows that this picture shows."


def _no_frames(results):
    if results["runs"]:
        return "No frame was written together with its submeshes."
    if results["frames"]:
        return "No frames were written."
    return "The scenes were run without frames." if results["scenes"] else \
        "The scenes were not run."


def build(results, drawn, out):
    """The sections of the page in order: (identifier, title, HTML, lead); sections with a lead are
    folded, the others have None."""
    bench, published, verify = results["bench"], results["published"], results["verify"]
    scenes, hard = results["scenes"], results["hard"]

    def pictures(name, shown=99):
        """The first pictures of a section; the others are folded."""
        found = [page.figure(d) for d in drawn.get(name, [])]
        more = page.fold(f"{style.counted(len(found[shown:]), 'picture')} more",
                         "".join(found[shown:])) if found[shown:] else ""
        return "".join(found[:shown]) + more

    header, rows, classes = verdicts.verdicts(results)
    sections = [
        ("found", "What was found", None, page.listed(findings.sentences(results), "found")
         + tables.refusals(bench) + page.table(header, rows, classes, "Verdicts"), ""),
        ("compared", "Area, shape, triangles and speed", None, comparison.section(results),
         "Neither the gate nor whole runs were made, so there is nothing to compare."),
        ("frames", "The meshes", None, pictures("frames", len(FIRST)), _no_frames(results)),
        ("film", "Thirty bubbles rise and merge", None, film.section(pathlib.Path(out)), ""),
        ("space", "Three dimensions", None, space.section(out), ""),
        ("thesis", "The thesis's figures", None, gallery.section(pathlib.Path(out)), ""),
        ("steps", "Time of a step", None, pictures("steps", 1), _no_bench(bench)),
        ("speedup", "Several threads", None, pictures("speedup", 1), _no_bench(bench)),
        ("precision", "Error against time", None,
         pictures("precision", 1) + pictures("convergence"),
         "Errors against times (dsc_precision) were not measured."),
        ("gate", "The gate", "all figures with limits",
         tables.gate(verify) if verify else "", "The gate (dsc_verify) was not run."),
        ("scenes", "Scenes", "what each run measured",
         tables.scenes(scenes, published) if scenes else "", "The scenes were not run."),
        ("hard", "Hard cases", "extreme input",
         hard_cases.table(hard) if hard else "", "The hard cases (dsc_hard) were not run."
         if hard is None else "The list of hard cases is empty, so it proves nothing."),
        ("breakdown", "The parts of the time of a step", "on one thread, and modelled on more",
         pictures("breakdown"), _no_bench(bench)),
        ("granularity", "How much work threads need", "to pay off",
         pictures("granularity"), _no_bench(bench)),
        ("submeshes", "Submeshes", "how the mesh is divided among threads",
         pictures("submeshes"), _no_frames(results)),
        ("operations", "Cost of an operation", "in nanoseconds", pictures("operations"),
         _no_bench(bench)),
        ("histograms", "Areas and qualities of the triangles", "the thesis's histograms",
         pictures("histograms"), "No run wrote histograms." if scenes or verify else
         "Neither the scenes nor the gate were run, so there are no histograms."),
        ("sources", "What we compare with", "published figures and where they come from",
         tables.sources(published) if published else "", "No published figures were given, so the "
         "pictures show our own results only."),
        ("files", "Files", "the results as the programs wrote them",
         tables.files(results["files"], out), "No result file was given.")]
    return [(name, title, inside or page.paragraph(missing, "note"), lead)
            for name, title, lead, inside, missing in sections if inside or missing]

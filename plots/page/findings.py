# SPDX-License-Identifier: MIT
"""The findings: five sentences, each computed from the measured figures; without figures, the sentence
says what was not measured."""
from look import style
from results import load, series


def sentences(results):
    return [meshes(results["scenes"]), shape(results["scenes"], results["published"]),
            step(results["bench"]), threads(results["bench"], results["published"]),
            limits(results["verify"])]


def lost(scene):
    """Inverted triangles and vertices that did not arrive."""
    return (scene.value("inverted") or 0) + (scene.value("unreached") or 0)


def meshes(scenes):
    if not scenes:
        return "No scene was run, so this report says nothing about the meshes."
    bad = sorted({s.name for s in scenes if lost(s) > 0})
    runs = style.counted(len(scenes), "run")
    names = style.counted(len({s.name for s in scenes}), "scene")
    if not bad:
        return (f"In {runs} of {names} no triangle was inverted, and every interface vertex "
                "arrived at its target.")
    return (f"In {sum(lost(s) > 0 for s in scenes)} of {runs} triangles were inverted or "
            f"vertices did not arrive: {style.listing(bad)}.")


def thesis_ratio(scene, published):
    """The thesis's area ratio for a run of the same scene and length, or None."""
    steps = scene.parameter("steps")
    identifier = {"vortex-square": "vortex_area_ratio"}.get(scene.name)
    if scene.name == "swirl" and steps in (260.0, 420.0):
        identifier = f"swirl_{steps:.0f}_area_ratio"
    found = load.entry(published, "thesis", identifier) if identifier else None
    return found["value"] if found else None


def percent(ratio):
    """1.00045 -> '0.045 % more'."""
    if ratio == 1:
        return "as much"
    return f"{style.digits(100 * abs(ratio - 1), 2)} % {'more' if ratio > 1 else 'less'}"


def shape(scenes, published):
    """The swirl, the usual scene for this method."""
    swirls = [s for s in scenes if s.name == "swirl" and s.strategy == "sequential"
              and s.value("area_ratio") and s.value("sd_rel_last") is not None]
    if not swirls:
        return "The swirl was not run, so this report says nothing about the accuracy of shapes."
    run = min(swirls, key=lambda s: s.parameter("h"))
    text = ("A disc that a swirl stretches to a long spiral and winds up again ends with "
            f"{percent(run.value('area_ratio'))} area than it had, and "
            f"{style.digits(100 * run.value('sd_rel_last'), 2)} % of it in the wrong place")
    theirs = thesis_ratio(run, published)
    if theirs:
        text += f"; in the thesis it ended with {percent(theirs)} area"
    return text + "."


def step(bench):
    """The growing circle, as measured in the thesis."""
    found = [r for r in series.rows(bench) if r.family == "scaling_step"] if bench else []
    mine = {r.triangles: r for r in found if r.strategy == "sequential"}
    if not mine:
        return "No time step was measured."
    literal = [r for r in found if r.strategy == "reference" and r.triangles in mine]
    size = literal[0].triangles if literal else min(mine)
    text = (f"One time step of a growing circle in a mesh of {style.whole(size)} triangles takes "
            f"{style.duration(mine[size].median)} on one thread")
    if literal:
        factor = literal[0].median / mine[size].median
        text += (f"; a literal implementation of the thesis's method takes "
                 f"{style.duration(literal[0].median)}, {style.digits(factor)} times as long")
    return text + _doubt(mine[size].doubtful) + "."


def threads(bench, published):
    """The growing circle as in an application, all steps without other work between them; the gain of
    warm steps is only in the pictures."""
    points = [p for p in series.undisturbed(bench) if p.n > 1 and p.row.family == "scaling_run"]
    if not points:
        return "No whole run was measured with more than one thread and a core for each."
    most = max(p.n for p in points)
    best = {}
    for p in points:
        if p.n == most and (p.row.triangles not in best or p.s > best[p.row.triangles].s):
            best[p.row.triangles] = p
    text = f"With {most} threads a whole run of the same scene is " + style.listing(
        (f"{p.s:.2f} times as fast" if p.s >= 1 else f"{1 / p.s:.2f} times as slow")
        + f" at {style.whole(size)} triangles" for size, p in sorted(best.items()))
    theirs = [row["S"] for row in load.values(published, "speedup", "scaling_table_10_1")
              if row["n"] == most]
    if theirs:
        text += f"; the thesis measured {theirs[0]:.2f} on its own machine"
    return text + _doubt(any(p.doubtful for p in best.values())) + "."


def _doubt(is_doubtful):
    return "; other programs were busy meanwhile, so this may be off" if is_doubtful else ""


def limits(verify):
    if not verify or not verify.checks:
        return "The gate was not run, so nothing was compared with the limits of a release."
    failed = [c for c in verify.checks if not load.passed(c)]
    if failed:
        names = sorted({f"{c['check']} ({c['scene'] or 'all'})" for c in failed})
        text = (f"{len(failed)} of {style.counted(len(verify.checks), 'figure')} that the gate "
                f"compared with a limit break it: {style.listing(names[:6])}"
                + (f" and {len(names) - 6} more" if len(names) > 6 else ""))
    else:
        text = (f"All {style.counted(len(verify.checks), 'figure')} that the gate compared with "
                "limits are within them")
    if verify.not_run:
        text += f"; {style.counted(len(verify.not_run), 'check')} of the gate "
        text += "was not run" if len(verify.not_run) == 1 else "were not run"
    return text + "."

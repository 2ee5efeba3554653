# SPDX-License-Identifier: MIT
"""What the speed-ups say in words: sentences, conditions and table of a family of benchmarks."""
from parallel import series
from look import style


def one_thread(point, points):
    """t_1 / t_s of the series that a point belongs to, or None."""
    ones = [p for p in points if p.n == 1 and p.row.label == point.row.label
            and p.row.triangles == point.row.triangles]
    return 1 / ones[0].s if ones else None


def beside(model, points):
    """The measured point of the same strategy, size and threads as a modelled one, or None; of
    several (they differ in submeshes) the fastest, as of the model."""
    fitting = [p for p in points if p.n == model.n and p.row.strategy == model.row.strategy
               and p.row.triangles == model.row.triangles and p.row.other == model.row.other
               and not p.row.oversubscribed]
    return max(fitting, key=lambda p: p.s, default=None)


def error(model, points):
    """By how many percent the model's S(n) is off, or None where nothing was measured."""
    measured = beside(model, points)
    return 100 * (model.s / measured.s - 1) if measured else None


def _span(values, show):
    low, high = show(min(values)), show(max(values))
    return low if low == high else f"{low} to {high}"


def plain(family):
    """The largest gain that was measured, with the time of a step."""
    scene = series.title(family.name)
    within = [p for p in family.points if not p.row.oversubscribed and p.n > 1]
    if not within:
        return f"In the {scene}, nothing was measured with several threads and a core for each."
    best = max([p for p in within if not p.doubtful] or within, key=lambda p: p.s)
    return (f"In the {scene}, a step at {best.row.size} takes "
            f"{style.duration(best.base.median)} on one thread and "
            f"{style.duration(best.row.median)} on {best.n}"
            + ("; hollow points are modelled and not measured." if family.models else "."))


def sentence(family):
    """What the numbers say, with the base and both times of each S(n)."""
    return measured(family) + (" " + modelled(family) if family.models else "")


def measured(family):
    points = family.points
    within = [p for p in points if not p.row.oversubscribed and p.n > 1]
    words = []
    if within:
        best = max([p for p in within if not p.doubtful] or within, key=lambda p: p.s)
        words.append(
            f"In the {series.title(family.name)}, {best.row.label} with {best.n} threads takes "
            f"{style.duration(best.row.median)} a step at {best.row.size} "
            f"against {style.duration(best.base.median)} sequentially: "
            f"S({best.n}) = {best.s:.2f}, U({best.n}) = {best.u:.2f}")
        same = [p for p in within if p.n == best.n]
        if len(same) > 1:
            words.append(f"; over all {len(same)} series and sizes S({best.n}) lies between "
                         f"{min(p.s for p in same):.2f} and {max(p.s for p in same):.2f}")
        theirs = [t for t in family.thesis if t["n"] == best.n]
        if theirs:
            words.append(f" (thesis: {theirs[0]['S']:.2f})")
    else:
        words.append(f"In the {series.title(family.name)}, no measured row has more than one "
                     "thread and a core for each, so no speed-up measured here can be trusted")
    ones = [1 / p.s for p in points if p.n == 1]
    if ones:
        words.append(f"; one parallel thread takes {_span(ones, '{:.2f}'.format)} times the "
                     "sequential time")
    over = sum(p.row.oversubscribed for p in points)
    if over:
        words.append(f"; {over} of {len(points)} points are oversubscribed (half filled) and do "
                     "not show how the code scales")
    loaded = sum(p.doubtful and not p.row.oversubscribed for p in points)
    if loaded:
        words.append(f"; {loaded} of {len(points)} points (half filled) were measured while other "
                     "programs loaded the machine, or compared with a sequential run that was, and "
                     "are less reliable than the others")
    return "".join(words) + "."


def modelled(family):
    """How good the model is where it can be checked, and what it predicts elsewhere."""
    words = []
    for n in sorted({m.n for m in family.models if m.n > 1}):
        pairs = [(m, beside(m, family.points)) for m in family.models if m.n == n]
        pairs = [(m, p) for m, p in pairs if p]
        if pairs:
            worst = max(pairs, key=lambda pair: abs(error(pair[0], [pair[1]])))
            errors = [error(m, [p]) for m, p in pairs]
            over = f" over {len(pairs)} rows, most" if len(pairs) > 1 else ""
            words.append(
                f"the model's S({n}) differs from the measured one by "
                f"{_span(errors, '{:+.1f} %'.format)}{over} "
                f"for {worst[0].row.label} at {worst[0].row.size}, "
                f"{worst[0].s:.2f} against {worst[1].s:.2f}")
    if not words:
        words.append("no measured row has more than one thread, so the model could not be checked")
    beyond = [m for m in family.models if m.n > 1 and not beside(m, family.points)]
    best = {n: max((m for m in beyond if m.n == n), key=lambda m: m.s)
            for n in sorted({m.n for m in beyond})}
    if best:
        words.append("the best prediction of the model for thread counts that were not measured is "
                     + style.listing(f"S({n}) = {m.s:.2f}" for n, m in best.items())
                     + f", U({n_last(best)}) = {best[n_last(best)].u:.2f}"
                     + f" ({_where(best.values())})")
    return "Modelled, not measured: " + "; ".join(words) + "."


def n_last(best):
    return max(best)


def _where(models):
    """'cells at 2,800,000 triangles', with every strategy and size once."""
    places = dict.fromkeys(f"{m.row.label} at {m.row.size}" for m in models)
    return style.listing(places)


def _counters(models, name):
    return [c for m in models if (c := m.row.measurement.counter(name)) is not None]


def _bandwidth(models):
    one = _counters(models, "bandwidth_of_one_gb_s")
    every = _counters(models, "bandwidth_of_all_gb_s")
    if not one or not every:
        return ""
    return f" (memory: {max(one):.3g} GB/s for one of them, {max(every):.3g} GB/s for all)"


def conditions(family):
    text = ("Medians over repetitions; bars from the slowest to the fastest repetition; blue "
            "band: the same for the sequential run.")
    if family.models:
        cost = _counters(family.models, "section_start_us")
        text += ("\nHollow and dashed: modelled, not measured. The shortest measured time of each "
                 "task, with all cores of this machine at work if n > 1, scheduled on n workers, "
                 "plus the serial parts and the cost of a section's start and end"
                 + (f" (measured: {_span(cost, style.duration)})" if cost else "")
                 + ". So each worker shares caches and memory as much as each of these cores does"
                 + _bandwidth(family.models)
                 + ". If several numbers of submeshes were modelled for one n, the fastest is "
                 "shown.")
    if family.others:
        text += ("\nGrey: the thesis, and other programs that adapt a mesh in parallel, each on "
                 "a different machine; those that state no size are drawn in every column.")
    return text


HEADER = ["size", "strategy", "kind", "threads", "submeshes", "t_s a step", "t_n a step",
          "S(n)", "S(n) from – to", "U(n)", "t_1 / t_s", "model's error", "thesis t_n",
          "thesis S(n)", "thesis U(n)", ""]


def table(family):
    found = sorted(family.points + family.models, key=lambda p: (
        p.row.triangles, style.order(p.row.strategy), p.row.label, p.row.modelled, p.n))
    return HEADER, [_row(p, family) for p in found] + [_other(o) for o in family.others]


def _row(p, family):
    model = p.row.modelled
    one = one_thread(p, family.models if model else family.points)
    off = error(p, family.points) if model else None
    theirs = next((t for t in family.thesis if t["n"] == p.n), None)
    cells = [p.row.size, p.row.label, "modelled" if model else "measured",
             str(p.n), str(p.row.submeshes) if p.row.submeshes else "as pay",
             style.duration(p.base.median), style.duration(p.row.median), f"{p.s:.2f}",
             f"{p.low:.2f} – {p.high:.2f}", f"{p.u:.2f}", f"{one:.2f}" if one else "–",
             f"{off:+.1f} %" if off is not None else "–"]
    cells += ([f"{theirs['t_n']} s of {family.thesis_ts} s", f"{theirs['S']:.2f}",
               f"{theirs['U']:.2f}"] if theirs else ["–"] * 3)
    return cells + [", ".join(p.flags())]


def _other(o):
    name, kind = o.name.split(", ")
    return [f"{style.whole(o.triangles)} triangles" if o.triangles else "–", name, kind, str(o.n), "–", "–", "–",
            f"{o.s:.2f}", "–", f"{o.s / o.n:.2f}", "–", "–", "–", "–", "–", "another program"]

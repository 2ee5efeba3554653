#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the speed-up S(n) and the utilisation U(n) from results of dsc_bench.

speedup.py FILE.json... --out PICTURE.pdf [--case NAME]

S(n) is the time of the sequential strategy over that on n threads. U(n) is the measured fraction of the
time of n threads for which they are busy, shown beside S(n) / n. A file with several families (NAME_run,
NAME_step) gives one picture for each, PICTURE-speedup_NAME.pdf and so on, unless --case chooses one.
"""
import sys
from dataclasses import dataclass

from look import script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib.ticker import FixedLocator

from results import load, series

THESIS = {"scaling_step": ("scaling_table_10_1", "thesis, table 10.1 (4 cores)"),
          "four_circles_step": ("four_circles", "thesis, section 10.7 (4 cores)")}
# entry of reference/published/speedup.json -> name, marker
OTHERS = {"omega_h_s2": ("omega_h, measured", "P"),
          "omega_h_utilisation": ("omega_h, modelled", "P"),
          "pragmatic_s2": ("PRAgMaTIc, measured", "X"),
          "pragmatic_utilisation": ("PRAgMaTIc, published", "1"),
          "trinity_utilisation": ("trinity, published", "2")}
OTHERS_FAMILY = "scaling_step"  # their scenes are a growing circle too, or a mesh adapted everywhere
WIDE = 8  # from this number of threads on the axis is logarithmic
IDEAL, BOUND = (0, (4, 3)), (0, (1, 1))


@dataclass(frozen=True)
class Other:
    """S(n) of another program."""

    label: str
    marker: str
    triangles: float  # 0: not stated
    n: int
    s: float


@dataclass
class Family:
    """The data of one picture."""

    name: str
    points: list    # measured
    models: list    # modelled
    thesis: object = None  # its entry of the published figures
    others: tuple = ()

    @property
    def sizes(self):
        return sorted({p.row.triangles for p in self.points + self.models})

    @property
    def top(self):
        """The largest number of threads."""
        return max([p.n for p in [*self.points, *self.models, *self.others]]
                   + [t["n"] for t in self.theirs] + [2])

    @property
    def theirs(self):
        """Rows {n, t_n, S, U} of the thesis."""
        return self.thesis["values"] if self.thesis else []

    def others_at(self, size):
        """Points of other programs at about this size, and of programs that state no size."""
        return [o for o in self.others if not o.triangles or 0.5 < o.triangles / size < 2]


def others(published):
    """Every published or measured S(n) of another program."""
    return tuple(Other(*OTHERS[name], v.get("triangles", 0), v["n"],
                       v["S"] if "S" in v else v["U"] * v["n"])
                 for name in OTHERS for v in load.values(published, "speedup", name))


def gather_runs(bench):
    """A Family for each family of whole runs that has parallel rows."""
    measured = series.whole_runs(bench)
    found, models = series.speedups(measured), series.speedups(series.modelled(bench, "_run"), measured)
    return [Family(name, *([p for p in points if p.row.family == name] for points in (found, models)))
            for name in series.families([p.row for p in found + models])]


def gather(bench, published):
    """A Family for each family of step benchmarks that has parallel rows."""
    measured, modelled = series.rows(bench), series.modelled(bench)
    result = []
    for name in series.families(measured + modelled):
        bases = [r for r in measured if r.family == name]
        family = Family(name, series.speedups(bases),
                        series.speedups([r for r in modelled if r.family == name], bases))
        if name != series.GRANULARITY and family.sizes:
            family.thesis = load.entry(published, "speedup", THESIS.get(name, ("",))[0])
            family.others = others(published) if name == OTHERS_FAMILY else ()
            result.append(family)
    return result


def draw(bench, published):
    """A Picture for each family that has parallel rows; whole runs come first."""
    return [picture(family, bench.context)
            for family in gather_runs(bench) + gather(bench, published)]


def error(model, points):
    """The difference in per cent of the model's S(n) from the fastest measured one of the same strategy,
    size and threads, or None if nothing was measured."""
    fitting = [p.s for p in points if p.n == model.n and p.row.strategy == model.row.strategy
               and p.row.triangles == model.row.triangles and p.row.other == model.row.other
               and not p.row.oversubscribed]
    return 100 * (model.s / max(fitting) - 1) if fitting else None


def amdahl(points):
    """{label: the serial share of the work, measured with the most threads}; by Amdahl's law, S(n) is at
    most 1 / (share + (1 - share) / n)."""
    return {p.label: share for p in sorted(points, key=lambda p: p.n)
            if (share := p.row.measurement.counter("serial_share")) is not None}


def _axes(axes, family, quantity, cores, is_over):
    ticks = list(range(1, family.top + 1))
    axes.set_xlim(0.7, family.top + 0.3)
    values = [p.interval[2] for p in family.points + family.models] + [2.0] \
        + [t["S"] for t in family.theirs] + [o.s for o in family.others]
    if quantity == "U":
        axes.set_ylim(0, max([1.15] + [1.1 * p.interval[2] / p.n for p in family.points]))
    elif family.top <= WIDE:
        axes.set_ylim(0, 1.15 * max(values))
    else:  # the ideal is a line in this panel, too
        axes.set_yscale("log", base=2)
        axes.set_ylim(0.8 * min([1.0] + [p.interval[0] for p in family.points + family.models]),
                      1.3 * max(values))
        axes.yaxis.set_major_locator(FixedLocator([2.0 ** k for k in range(-4, 12)]))
        axes.yaxis.set_major_formatter("{x:g}")
    if family.top > WIDE:
        axes.set_xscale("log", base=2)
        axes.set_xlim(0.76, family.top * 1.25)
        ticks = [2 ** k for k in range(12) if 2 ** k <= family.top]
    axes.set_xticks(ticks, map(str, ticks))
    axes.minorticks_off()
    if not cores or cores > family.top:
        return
    axes.axvline(cores, color=style.MUTED, linewidth=0.9, linestyle=style.DOTTED, zorder=1.5)
    texts = [(cores, f" {style.counted(cores, 'core')} ", "left" if cores == 1 else "right")]
    if cores < family.top:
        axes.axvspan(cores, axes.get_xlim()[1], color=style.SHADE, zorder=0, linewidth=0)
        texts.append((axes.get_xlim()[1], "oversubscribed " if is_over else
                      "more than the machine has ", "right"))
    for x, text, side in texts if quantity == "U" else ():
        axes.text(x, 0.985, text, ha=side, va="top", fontsize=7.5, color=style.MUTED,
                  transform=axes.get_xaxis_transform())


def _grey(other):
    return {**style.other(other.marker),
            **(style.hollow(style.MUTED) if other.label.endswith("modelled") else {})}


def _panel(axes, family, size, quantity, looks):
    """S(n), or S(n) / n with the measured utilisation beside it."""
    power = 0 if quantity == "S" else 1
    here = [p for p in family.points if p.row.triangles == size]
    line = numpy.geomspace(1, family.top, 50)
    axes.plot(line, line ** (1 - power), color=style.MUTED, linestyle=IDEAL, linewidth=1, zorder=2)
    for label, share in amdahl(here).items():
        axes.plot(line, line ** -power / (share + (1 - share) / line), color=looks[label][0],
                  linestyle=BOUND, linewidth=1, zorder=2)
    theirs = [(t["n"], t["S"], style.other("*")) for t in family.theirs]
    for n, s, marks in theirs + [(o.n, o.s, _grey(o)) for o in family.others_at(size)]:
        axes.plot([n], [s / n ** power], color=style.MUTED, linestyle="none", zorder=2.6, **marks)
    lines = series.by_label(here)
    for index, (label, line) in enumerate(lines.items()):
        # Series are shifted sideways so that markers and bars of equal height remain visible.
        shift = 1 + (0.045 if family.top > WIDE else 0.03) * (index - (len(lines) - 1) / 2)
        style.points(axes, [(p.n * shift, [s / p.n ** power for s in p.interval], p.doubtful)
                            for p in line], *looks[label])
        busy = [(p.n * shift, u) for p in line if quantity == "U"
                and (u := p.row.measurement.counter("utilisation")) is not None]
        axes.plot([x for x, _ in busy], [u for _, u in busy], linestyle="none", marker="_",
                  markersize=13, markeredgewidth=2, color=looks[label][0], zorder=3.1)
    models = [p for p in family.models if p.row.triangles == size]
    for label, line in series.by_label(models).items():
        axes.plot([p.n for p in line], [p.s / p.n ** power for p in line], color=looks[label][0],
                  linestyle=style.DASHED, linewidth=1.3, marker=looks[label][1], zorder=3.6,
                  **style.hollow(looks[label][0]))


def _legend(family, looks):
    measured = {p.label for p in family.points}
    handles = [style.key(label, *look, line="none") for label, look in looks.items()
               if label in measured]
    handles += [style.key(f"{label}, modelled", *looks[label], line=style.DASHED, width=1.3,
                          marking=style.hollow)
                for label in dict.fromkeys(p.label for p in family.models)]
    if any(p.doubtful for p in family.points):
        handles.append(style.key("oversubscribed or under load", style.MUTED, "o", "none",
                                 style.doubtful))
    if any("utilisation" in p.row.measurement.counters for p in family.points):
        handles.append(style.key("busy, as measured", style.MUTED, line="none", marks={
            "marker": "_", "markersize": 13, "markeredgewidth": 2}))
    handles.append(style.key("ideal", style.MUTED, line=IDEAL, width=1))
    if amdahl(family.points):
        handles.append(style.key("bound by the serial share (Amdahl)", style.MUTED, line=BOUND,
                                 width=1))
    if family.theirs:
        handles.append(style.key(THESIS[family.name][1], style.MUTED, line="none",
                                 marks=style.other("*")))
    shown = [o for size in family.sizes for o in family.others_at(size)]
    return handles + [style.key(label, style.MUTED, line="none", marks=_grey(found[0]))
                      for label, found in series.by_label(shown).items()]


def picture(family, context):
    """S(n) and U(n) of a family, a column for each size."""
    looks = series.looks(series.by_label(family.points + family.models))
    width = 3.7 if family.top > WIDE else 3.1
    legend, notes = _legend(family, looks), conditions(family)
    fig, grid = style.figure(max(7.2, 0.5 + width * len(family.sizes)),
                             6.6 + 0.09 * len(legend) + len(notes) / 700, 2, len(family.sizes),
                             sharey="row")
    for column, size in enumerate(family.sizes):
        here = [p for p in family.points + family.models if p.row.triangles == size]
        base = here[0].base
        for axes, quantity in zip(grid[:, column], "SU"):
            _axes(axes, family, quantity, context.cores, any(p.row.oversubscribed for p in here))
            _panel(axes, family, size, quantity, looks)
        low, middle, high = style.interval(base.times)
        grid[0][column].axhspan(middle / high, middle / low, color=style.BLUE, alpha=0.13,
                                linewidth=0, zorder=1)
        grid[0][column].set_title(f"{base.size}, $t_s$ = {style.duration(middle)} a step")
        grid[1][column].set_xlabel("threads $n$")
    grid[0][0].set_ylabel("speed-up  $S(n) = t_s\\,/\\,t_n$")
    grid[1][0].set_ylabel("$S(n)\\,/\\,n$, and utilisation\n$U(n)$ = busy time / "
                          "($n\\,\\cdot$ wall time)")
    firsts = {dict(p.row.other).get("stop_after") for p in family.points + family.models}
    part = (", whole runs" if firsts == {None} else
            f", {series.SAID['stop_after'].format(*firsts)}" if len(firsts) == 1 else "")
    title = f"Speed-up: {series.title(family.name)}" + (part if family.name.endswith("_run") else "")
    style.finish(fig, title, style.caption_text(context, notes), legend)
    return style.Picture(f"speedup_{family.name}", title, plain(family), fig, *table(family))


def plain(family):
    """The largest measured gain with several threads and a core for each, with both times."""
    within = [p for p in family.points if not p.row.oversubscribed and p.n > 1]
    if not within:
        return (f"In the {series.title(family.name)}, nothing was measured with several threads and "
                "a core for each.")
    best = max([p for p in within if not p.doubtful] or within, key=lambda p: p.s)
    busy = best.row.measurement.counter("utilisation")
    return (f"In the {series.title(family.name)}, a step at {best.row.size} takes "
            f"{style.duration(best.base.median)} on one thread and "
            f"{style.duration(best.row.median)} with {best.row.label} on {best.n}: "
            f"S({best.n}) = {best.s:.2f}, S({best.n}) / {best.n} = {best.u:.2f}"
            + (f", U({best.n}) = {busy:.2f}" if busy is not None else "")
            + ("; hollow points are modelled and not measured." if family.models else "."))


def conditions(family):
    text = style.bars_text([len(p.row.times) for p in family.points] or [1]) \
        + " Blue band: the same for the sequential run."
    rates = [max((p.row.measurement.counter(name) or 0 for p in family.models), default=0)
             for name in ("bandwidth_of_one_gb_s", "bandwidth_of_all_gb_s")]
    if family.models:
        text += ("\nHollow and dashed: modelled, not measured. The tasks of measured steps "
                 "are scheduled on n workers, plus the serial parts and the measured cost of a "
                 "section's start and end.")
    if all(rates):
        text += (f" Memory, triad: {rates[0]:.3g} GB/s for one core, {rates[1]:.3g} for all, so that "
                 f"what memory limits gains {rates[1] / rates[0]:.2f} at most.")
    if family.others:
        text += ("\nGrey: the thesis, and other programs that adapt a mesh in parallel, each on "
                 "a different machine; those that state no size are drawn in every column.")
    return text


def table(family):
    header = ["size", "strategy", "kind", "threads", "used", "submeshes", "t_s a step", "t_n a step",
              "S(n)", "S(n) from – to", "S(n) / n", "U(n)", "serial share", "model's error",
              "thesis t_n", "thesis S(n)", "thesis U(n)", ""]
    found = sorted(family.points + family.models, key=lambda p: (
        p.row.triangles, style.order(p.row.strategy), p.label, p.row.modelled, p.n))
    return header, [_row(p, family) for p in found] + [
        [f"{style.whole(o.triangles)} triangles" if o.triangles else "–", *o.label.split(", "),
         str(o.n), *["–"] * 4, f"{o.s:.2f}", "–", f"{o.s / o.n:.2f}", *["–"] * 6,
         "another program"] for o in family.others]


def _row(p, family):
    def counter(name, form):
        value = None if p.row.modelled else p.row.measurement.counter(name)
        return form.format(value) if value is not None else "–"

    off = error(p, family.points) if p.row.modelled else None
    theirs = next((t for t in family.theirs if t["n"] == p.n), None)
    low, _, high = p.interval
    return [p.row.size, p.label, "modelled" if p.row.modelled else "measured", str(p.n),
            counter("threads_used", "{:.0f}"),
            str(p.row.submeshes) if p.row.submeshes else "as pay", style.duration(p.base.median),
            style.duration(p.row.median), f"{p.s:.2f}", f"{low:.2f} – {high:.2f}", f"{p.u:.2f}",
            counter("utilisation", "{:.2f}"), counter("serial_share", "{:.1%}"),
            f"{off:+.1f} %" if off is not None else "–",
            *([f"{theirs['t_n']} s of {family.thesis.get('t_s')} s", f"{theirs['S']:.2f}",
               f"{theirs['U']:.2f}"] if theirs else ["–"] * 3), ", ".join(p.flags())]


def of_files(given):
    bench = load.read_bench(given.files)
    found = gather_runs(bench) + gather(bench, {})
    if not found:
        raise load.InputFault(f"{given.files[0]} has no parallel row with a sequential one beside it, "
                              "so there is no S(n); strategies = [\"sequential\", \"cells\"] in a "
                              "suite measures both.")
    names = [family.name for family in found]
    if given.case not in (None, *names):
        raise load.InputFault(f"--case has '{given.case}', where {style.listing(names)} can be drawn.")
    return [picture(family, bench.context) for family in found
            if given.case in (None, family.name)]


def main(argv=None):
    return script.main(__doc__, of_files, argv, case={
        "metavar": "NAME", "help": "of the rows NAME/strategy:..., such as swirl_run"})


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: MIT
"""Speed-up S(n) and utilisation U(n) against threads, with the thesis's table 10.1 and published
efficiencies beside ours.

The base is always the sequential driver at the same size (thesis, equation 14), never the
parallel one at one thread. What the benchmark program modelled for more threads than the machine
has is drawn hollow and dashed, and called modelled in legend, table and caption.
"""
from dataclasses import dataclass

import numpy
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator

from results import load
from parallel import series
from parallel import speedup_text
from look import style

THESIS = {"scaling_step": ("scaling_table_10_1", "thesis, table 10.1 (4 cores)"),
          "four_circles_step": ("four_circles", "thesis, section 10.7 (4 cores)")}
# entry of reference/published/speedup.json -> name, marker
OTHERS = {"omega_h_s2": ("omega_h, measured", "P"),
          "omega_h_utilisation": ("omega_h, modelled", "P"),
          "pragmatic_s2": ("PRAgMaTIc, measured", "X"),
          "pragmatic_utilisation": ("PRAgMaTIc, published", "1"),
          "trinity_utilisation": ("trinity, published", "2")}
OTHERS_FAMILY = "scaling_step"  # theirs is a growing circle too, or a mesh adapted all over
WIDE = 8  # from here on threads go on a logarithmic axis


@dataclass(frozen=True)
class Other:
    """S(n) of another program."""

    name: str
    marker: str
    kind: str
    triangles: float  # 0: not stated
    n: int
    s: float

    @property
    def modelled(self):
        return self.kind == "modelled"


@dataclass
class Family:
    """Everything that one picture shows."""

    name: str
    points: list    # measured
    models: list    # modelled
    thesis: list    # rows {n, t_n, S, U} of the thesis
    thesis_label: str
    thesis_ts: object
    others: list

    @property
    def sizes(self):
        return sorted({p.row.triangles for p in self.points + self.models})

    @property
    def top(self):
        """The largest number of threads."""
        return max([p.n for p in self.points + self.models + self.others]
                   + [t["n"] for t in self.thesis] + [2])

    def others_at(self, size):
        """Points of other programs at about this size, and those of programs that state no size."""
        return [o for o in self.others if not o.triangles or 0.5 < o.triangles / size < 2]


def others(published):
    """Every published or measured S(n) of another program."""
    found = []
    for identifier, (name, marker) in OTHERS.items():
        entry = load.entry(published, "speedup", identifier)
        for v in entry["values"] if entry else []:
            s = v["S"] if "S" in v else v["U"] * v["n"]
            found.append(Other(name, marker, name.split(", ")[1], v.get("triangles", 0), v["n"],
                               s))
    return found


def gather_runs(bench):
    """A Family for each family of whole runs that has parallel rows."""
    found = series.speedups(series.whole_runs(bench))
    return [Family(name, [p for p in found if p.row.family == name], [], [], "", None, [])
            for name in series.families([p.row for p in found])]


def gather(bench, published):
    """A Family for each family of step benchmarks that has parallel rows."""
    measured, modelled = series.rows(bench), series.modelled(bench)
    result = []
    for name in series.families(measured + modelled):
        bases = [r for r in measured if r.family == name]
        points = series.speedups(bases)
        models = series.speedups([r for r in modelled if r.family == name], bases)
        if name == series.GRANULARITY or not points + models:
            continue
        identifier, label = THESIS.get(name, (None, ""))
        found = load.entry(published, "speedup", identifier) if identifier else None
        result.append(Family(name, points, models, found["values"] if found else [], label,
                             found.get("t_s") if found else None,
                             others(published) if name == OTHERS_FAMILY else []))
    return result


def draw(bench, published):
    """A Picture for each family of step benchmarks that has parallel rows."""
    for family in gather(bench, published):
        yield picture(family, bench.context)


def _thread_axis(axes, top):
    if top > WIDE:
        axes.set_xscale("log", base=2)
        ticks = [2 ** k for k in range(12) if 2 ** k <= top]
        axes.set_xlim(0.76, top * 1.25)
    else:
        ticks = list(range(1, top + 1))
        axes.set_xlim(0.7, top + 0.3)
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _speed_axis(axes, family):
    """S(n), on a logarithmic axis if that of the threads is one, so that the ideal is a line."""
    values = [p.high for p in family.points + family.models] + [t["S"] for t in family.thesis] \
        + [o.s for o in family.others]
    if family.top <= WIDE:
        axes.set_ylim(0, 1.15 * max(values + [2.0]))
        return
    low = min([p.low for p in family.points + family.models] + [1.0])
    axes.set_yscale("log", base=2)
    axes.set_ylim(0.8 * low, 1.3 * max(values + [2.0]))
    axes.yaxis.set_major_locator(FixedLocator([2.0 ** k for k in range(-4, 12)]))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _cores(axes, cores, top, over, with_text):
    """The vertical line at the machine's cores, and the field beyond it."""
    if not cores or cores > top:
        return
    axes.axvline(cores, color=style.MUTED, linewidth=0.9, linestyle=(0, (1, 1.5)), zorder=1.5)
    if cores < top:
        axes.axvspan(cores, axes.get_xlim()[1], color=style.SHADE, zorder=0, linewidth=0)
    if not with_text:
        return
    words = {"transform": axes.get_xaxis_transform(), "fontsize": 7.5, "color": style.MUTED,
             "va": "top"}
    axes.text(cores, 0.985, f" {style.counted(cores, 'core')} ",
              ha="left" if cores == 1 else "right", **words)
    if cores < top:
        axes.text(axes.get_xlim()[1], 0.985,
                  "oversubscribed " if over else "more than the machine has ", ha="right", **words)


def _measured(axes, lines, looks, spread, value):
    """One line for each series: trusted points solid, others half filled."""
    for index, (label, line) in enumerate(lines.items()):
        colour, marker = looks[label]
        # Series are shifted sideways so that markers and bars of equal height stay visible.
        place = [p.n * (1 + spread * (index - (len(lines) - 1) / 2)) for p in line]
        middle = [value(p, p.s) for p in line]
        bars = [[m - value(p, p.low) for m, p in zip(middle, line)],
                [value(p, p.high) - m for m, p in zip(middle, line)]]
        axes.plot(place, middle, color=colour, zorder=3)
        axes.errorbar(place, middle, yerr=bars, fmt="none", ecolor=colour, elinewidth=1,
                      capsize=2.5, zorder=3.2)
        for x, y, p in zip(place, middle, line):
            marks = style.doubtful(colour) if p.doubtful else style.solid(colour)
            axes.plot([x], [y], marker=marker, color=colour, linestyle="none", zorder=4, **marks)


def _modelled(axes, lines, looks, value):
    for label, line in lines.items():
        colour, marker = looks[label]
        axes.plot([p.n for p in line], [value(p, p.s) for p in line], color=colour,
                  linestyle=style.DASHED, linewidth=1.3, marker=marker, zorder=3.6,
                  **style.hollow(colour))


def _beside(axes, family, size, value):
    """The thesis and the other programs, in grey."""
    if family.thesis:
        axes.plot([t["n"] for t in family.thesis], [value(t["n"], t["S"]) for t in family.thesis],
                  color=style.MUTED, linewidth=1, linestyle=(0, (1, 1)), zorder=2.5,
                  **style.other("*"))
    for name, line in series.by_label(family.others_at(size), lambda o: o.name).items():
        axes.plot([o.n for o in line], [value(o.n, o.s) for o in line], color=style.MUTED,
                  linewidth=0.8, linestyle=style.DASHED if line[0].modelled else "none",
                  zorder=2.6, **_grey(line[0]))


def _grey(other):
    marks = style.other(other.marker)
    if other.modelled:
        marks.update(style.hollow(style.MUTED))
    return marks


def _looks(family):
    """{label: colour and marker}, the same for what is measured and modelled of one label."""
    return series.looks(series.by_label(family.points + family.models, lambda p: p.row.label))


def _panels(family, column, grid, cores, looks):
    size = family.sizes[column]
    here = [p for p in family.points if p.row.triangles == size]
    lines = series.by_label(here, lambda p: p.row.label)
    models = series.by_label([p for p in family.models if p.row.triangles == size],
                             lambda p: p.row.label)
    over = any(p.row.oversubscribed for p in here)
    base = next(p.base for p in family.points + family.models if p.row.triangles == size)
    for axes, quantity in zip((grid[0][column], grid[1][column]), "SU"):
        _thread_axis(axes, family.top)
        if quantity == "S":
            _speed_axis(axes, family)
            axes.axhspan(base.median / max(base.times), base.median / min(base.times),
                         color=style.BLUE, alpha=0.13, linewidth=0, zorder=1)
        else:
            axes.set_ylim(0, max([1.25] + [1.1 * p.high / p.n for p in here]))
        _cores(axes, cores, family.top, over, quantity == "U")
        ideal = numpy.array([1, family.top])
        axes.plot(ideal, ideal if quantity == "S" else ideal ** 0, color=style.MUTED,
                  linestyle=(0, (4, 3)), linewidth=1, zorder=2)
        power = 0 if quantity == "S" else 1
        _beside(axes, family, size, lambda n, s, power=power: s / n ** power)
        _measured(axes, lines, looks, 0.045 if family.top > WIDE else 0.02,
                  lambda p, s, power=power: s / p.n ** power)
        _modelled(axes, models, looks, lambda p, s, power=power: s / p.n ** power)
    grid[0][column].set_title(f"{base.size}, "
                              f"$t_s$ = {style.duration(base.median)} a step")
    grid[1][column].set_xlabel("threads $n$")


def _legend(family, looks):
    measured = {p.row.label for p in family.points}
    modelled = {p.row.label for p in family.models}
    handles = [style.key(label, *look) for label, look in looks.items() if label in measured]
    handles += [style.key(f"{label}, modelled", *look, line=style.DASHED, width=1.3,
                          marking=style.hollow)
                for label, look in looks.items() if label in modelled]
    if any(p.doubtful for p in family.points):
        handles.append(style.key("oversubscribed or under load", style.MUTED, "o", "none",
                                 style.doubtful))
    handles.append(style.key("ideal", style.MUTED, line=(0, (4, 3)), width=1))
    if family.thesis:
        handles.append(style.key(family.thesis_label, style.MUTED, line=(0, (1, 1)), width=1,
                                 marks=style.other("*")))
    shown = [o for size in family.sizes for o in family.others_at(size)]
    for name, found in series.by_label(shown, lambda o: o.name).items():
        handles.append(style.key(name, style.MUTED, width=0.8, marks=_grey(found[0]),
                                 line=style.DASHED if found[0].modelled else "none"))
    return handles


def picture(family, context):
    """S(n) and U(n) of a family, a column for each size."""
    columns = len(family.sizes)
    width = 3.7 if family.top > WIDE else 3.1
    looks = _looks(family)
    fig, grid = style.figure(max(7.2, 0.5 + width * columns), 7.4, 2, columns, sharey="row")
    for column in range(columns):
        _panels(family, column, grid, context.cores, looks)
    grid[0][0].set_ylabel("speed-up  $S(n) = t_s\\,/\\,t_n$")
    grid[1][0].set_ylabel("utilisation  $U(n) = S(n)\\,/\\,n$")
    name = series.title(family.name)
    title = f"Speed-up: {name}" + (", whole runs" if family.name.endswith("_run") else "")
    style.finish(fig, title, style.caption_text(
        context, speedup_text.conditions(family)), _legend(family, looks))
    return style.Picture("speedup_" + name.replace(" ", "_"), title,
                         speedup_text.plain(family), fig, *speedup_text.table(family),
                         details=speedup_text.sentence(family))

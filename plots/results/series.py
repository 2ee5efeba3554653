# SPDX-License-Identifier: MIT
"""Groups the rows of step benchmarks (FAMILY_step/strategy:S/triangles:N/...) and of whole runs into
series, whose sizes are numbers of triangles or edge lengths (h:H), and
computes S(n) = t_s / t_n and U(n) = S(n) / n (thesis, section 9.7) from medians.

Rows are of two kinds, which are never mixed: `rows` returns measured ones, `modelled` those that the
benchmark program modelled for more threads than the machine has."""
import math
import statistics
from dataclasses import dataclass

from look import style

# Parts of a name that do not distinguish configurations.
STRUCTURAL = {"strategy", "triangles", "threads", "submeshes", "iterations", "repeats",
              "min_time", "min_warmup_time", "warmup", "h", "steps", "modelled"}
SERIAL = ("reference", "sequential")
FAMILY_TITLES = {"scaling_step": "scaling of a circle", "four_circles_step": "four circles",
                 "scaling_run": "scaling of a circle", "four_circles_run": "four circles",
                 "swirl_step": "swirl", "granularity_step": "scaling of a circle, many sizes",
                 "enright_run": "flow of Enright's test", "translation-3d_run": "translation of a ball"}
SAID = {"between_us": "{} µs between steps",  # of other work
        "stop_after": "the first {} steps"}
MUCH = 0.25  # of all cores: measurements under a larger load are marked
GRANULARITY = "granularity_step"  # has its own picture


@dataclass
class Row:
    """One configuration of one size: its times in microseconds per step."""

    family: str
    triangles: float
    strategy: str
    threads: int
    submeshes: int
    other: tuple        # parameters that distinguish configurations, as sorted pairs
    times: list
    oversubscribed: bool
    measurement: object
    label: str = ""
    modelled: bool = False  # computed for this number of threads, not measured
    loaded: bool = False    # measured while other programs kept MUCH of the cores busy

    @property
    def median(self):
        return statistics.median(self.times)

    @property
    def size(self):
        """The size in words, as in the name."""
        h = _edge_length(self.measurement)
        return f"h = {h:g}" if h else f"{style.whole(self.triangles)} triangles"

    @property
    def doubtful(self):
        return self.oversubscribed or self.loaded

    def flags(self):
        """Remarks beside the row's figures."""
        words = ["oversubscribed"] if self.oversubscribed else []
        return words + ([f"load {self.measurement.counter('load'):.1f}"] if self.loaded else [])


@dataclass(frozen=True)
class Point:
    """S(n) of a row and of the ends of its time's interval, with the two rows."""

    row: Row
    base: Row

    @property
    def n(self):
        return self.row.threads

    @property
    def label(self):
        return self.row.label

    @property
    def interval(self):
        """(low, S, high)"""
        low, middle, high = style.interval(self.row.times)
        return tuple(self.base.median / time for time in (high, middle, low))

    @property
    def s(self):
        return self.base.median / self.row.median

    @property
    def u(self):
        return self.s / self.n

    @property
    def doubtful(self):
        return self.row.doubtful or self.base.loaded

    def flags(self):
        """Remarks on the row and on the sequential run, which are printed beside S(n)."""
        return self.row.flags() + [f"sequential run: {w}" for w in self.base.flags()]


def title(family):
    words = family.removesuffix("_step").removesuffix("_run").replace("_", " ")
    return FAMILY_TITLES.get(family, words)


def rows(bench):
    """All measured step rows; two rows of one label differ only in threads or size."""
    return _labelled([r for r in _all(bench) if not r.modelled])


def modelled(bench, ending="_step"):
    """The modelled rows of steps or of whole runs, with the fastest number of submeshes for each n."""
    fastest = {}
    for row in _all(bench, ending):
        key = (row.family, row.triangles, row.strategy, row.other, row.threads)
        if row.modelled and (key not in fastest or row.median < fastest[key].median):
            fastest[key] = row
    return _labelled(list(fastest.values()))


def whole_runs(bench):
    """All measured rows of whole runs (FAMILY_run/...), which are never mixed with those of steps."""
    return _labelled([r for r in _all(bench, "_run") if not r.modelled])


def between(row):
    """Other work before each step of a whole run, in microseconds."""
    return int(float(dict(row.other).get("between_us", 0)))


def undisturbed(bench):
    """The Points of whole runs without other work, with a core for each thread."""
    return [p for p in speedups(whole_runs(bench)) if not p.row.oversubscribed
            and between(p.row) == 0 and "stop_after" not in dict(p.row.other)] if bench else []


def _edge_length(measurement):
    """The edge length in the name if it is the size, or None."""
    params = measurement.params
    return None if "triangles" in params or "h" not in params else measurement.number("h")


def _triangles(measurement):
    """The size by which rows are compared. Strategies differ a little in their numbers of triangles, so for
    a row named by its edge length it is the number of triangles that would fill the unit square."""
    h = _edge_length(measurement)
    return round(4 / (math.sqrt(3) * h * h)) if h else measurement.number("triangles")


def _all(bench, ending="_step"):
    found = []
    for m in bench.measurements:
        triangles = _triangles(m)
        if not m.family.endswith(ending) or not m.strategy or not triangles:
            continue
        times = m.step_us()
        if min(times) <= 0:
            continue
        threads = int(m.number("threads") or 1) if m.strategy not in SERIAL else 1
        cores = bench.context.cores
        model = bool(m.number("modelled")) or bool(m.counter("modelled"))
        found.append(Row(
            m.family, triangles, m.strategy, threads,
            int(m.number("submeshes") or 0),
            tuple(sorted((k, v) for k, v in m.params.items() if k not in STRUCTURAL)), times,
            not model and (bool(m.counter("oversubscribed")) or 0 < cores < threads), m,
            modelled=model, loaded=0 < MUCH * cores < (m.counter("load") or 0)))
    return found


def _labelled(found):
    for row in found:
        kin = [r for r in found if r.family == row.family and r.strategy == row.strategy]
        words = [SAID.get(k, k + " {}").format(v) for k, v in row.other
                 if len({dict(r.other).get(k) for r in kin}) > 1]
        twins = [r for r in kin if r.triangles == row.triangles and r.other == row.other]
        if any(len({t.submeshes for t in twins if t.threads == u.threads}) > 1 for u in twins):
            words.insert(0, f"{row.submeshes} submeshes" if row.submeshes else "as many as pay")
        row.label = row.strategy + (f" ({', '.join(words)})" if words else "")
    found.sort(key=lambda r: (r.family, r.triangles, style.order(r.strategy), r.label, r.threads))
    return found


def families(found):
    """The names of families: known ones in the order of FAMILY_TITLES, then others."""
    known = list(FAMILY_TITLES)
    return sorted({r.family for r in found}, key=lambda family: style.order(family, known))


def base_of(row, found):
    """The sequential row with which a parallel row is compared, or None."""
    mine = dict(row.other)
    fitting = [r for r in found if r.strategy == "sequential" and not r.modelled
               and r.family == row.family
               and r.triangles == row.triangles
               and mine.get("stop_after") == dict(r.other).get("stop_after")
               and all(mine.get(k, v) == v for k, v in r.other)]
    # Of several candidates, the one with the most common parameters.
    return max(fitting, key=lambda r: len(set(r.other) & set(row.other)), default=None)


def speedups(found, bases=None):
    """A Point for each parallel row that has a sequential run in `bases`, which for modelled rows are the
    measured ones."""
    pairs = [(row, base_of(row, found if bases is None else bases)) for row in found
             if row.strategy not in SERIAL]
    return [Point(row, base) for row, base in pairs if base]


def strategy_of(label):
    """'cells, 2 threads' or 'cells (real float)' -> 'cells'."""
    return label.partition(",")[0].partition(" (")[0]


def by_label(items):
    """{label: items} in the order of the strategies."""
    groups = {}
    for item in items:
        groups.setdefault(item.label, []).append(item)
    return dict(sorted(groups.items(), key=lambda pair: (
        style.order(strategy_of(pair[0])), pair[0])))


def looks(labels):
    """{label: (colour, marker)}; labels of one strategy share its colour and differ in marker."""
    chosen, used = {}, {}
    for label in labels:
        colour, marker = style.look(strategy_of(label))
        turn = used.setdefault(colour, 0)
        used[colour] += 1
        chosen[label] = (colour, marker if turn == 0 else style.SPARE[(turn - 1) % 4][1])
    return chosen

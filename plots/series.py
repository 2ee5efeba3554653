# SPDX-License-Identifier: MIT
"""Groups the rows of step benchmarks (FAMILY_step/strategy:S/triangles:N/...) into series, and
computes S(n) = t_s / t_n and U(n) = S(n) / n (thesis, section 9.7) from medians."""
import statistics
from dataclasses import dataclass

import style

# Parts of a name that never tell two configurations apart.
STRUCTURAL = {"strategy", "triangles", "threads", "submeshes", "iterations", "repeats",
              "min_time", "min_warmup_time", "warmup", "h", "steps"}
SERIAL = ("reference", "sequential")
FAMILY_TITLES = {"scaling_step": "scaling of a circle", "four_circles_step": "four circles"}


@dataclass
class Row:
    """One configuration of one size: its times in microseconds per step."""

    family: str
    triangles: float
    strategy: str
    threads: int
    submeshes: int
    other: tuple        # parameters that tell configurations apart, sorted pairs
    times: list
    oversubscribed: bool
    measurement: object
    label: str = ""

    @property
    def median(self):
        return statistics.median(self.times)


@dataclass(frozen=True)
class Point:
    """S(n) of a row, the range over its repetitions, and what it was computed from."""

    row: Row
    base: Row
    s: float
    low: float
    high: float

    @property
    def n(self):
        return self.row.threads

    @property
    def u(self):
        return self.s / self.row.threads


def title(family):
    if family in FAMILY_TITLES:
        return FAMILY_TITLES[family]
    return family[:-5].replace("_", " ") if family.endswith("_step") else family


def rows(bench):
    """All step rows, labelled such that two rows of one label differ in threads or size only."""
    found = []
    for m in bench.measurements:
        triangles = m.number("triangles")
        if not m.family.endswith("_step") or not m.strategy or not triangles:
            continue
        times = m.step_us()
        if min(times) <= 0:
            continue
        threads = int(m.number("threads") or 1) if m.strategy not in SERIAL else 1
        cores = bench.context.cores
        found.append(Row(
            m.family, triangles, m.strategy, threads, int(m.number("submeshes") or 0),
            tuple(sorted((k, v) for k, v in m.params.items() if k not in STRUCTURAL)), times,
            bool(m.counter("oversubscribed")) or 0 < cores < threads, m))
    for row in found:
        kin = [r for r in found if r.family == row.family and r.strategy == row.strategy]
        words = [f"{k} {v}" for k, v in row.other
                 if len({dict(r.other).get(k) for r in kin}) > 1]
        twins = [r for r in kin if r.triangles == row.triangles and r.other == row.other]
        if any(len({t.submeshes for t in twins if t.threads == u.threads}) > 1 for u in twins):
            words.insert(0, f"{row.submeshes} submeshes")
        row.label = row.strategy + (f" ({', '.join(words)})" if words else "")
    found.sort(key=lambda r: (r.family, r.triangles, style.order(r.strategy), r.label, r.threads))
    return found


def families(found):
    names = sorted({r.family for r in found})
    known = [f for f in FAMILY_TITLES if f in names]
    return known + [f for f in names if f not in known]


def base_of(row, found):
    """The sequential row that a parallel row is compared with, or None."""
    mine = dict(row.other)
    fitting = [r for r in found if r.strategy == "sequential" and r.family == row.family
               and r.triangles == row.triangles
               and all(mine.get(k, v) == v for k, v in r.other)]
    # Where several fit, the one that shares most parameters.
    return max(fitting, key=lambda r: len(set(r.other) & set(row.other)), default=None)


def speedups(found):
    """A Point for each parallel row that has a sequential run beside it."""
    points = []
    for row in found:
        base = base_of(row, found) if row.strategy not in SERIAL else None
        if base is not None:
            points.append(Point(row, base, base.median / row.median,
                                base.median / max(row.times), base.median / min(row.times)))
    return points


def strategy_of(label):
    """'cells, 2 threads' or 'cells (real float)' -> 'cells'."""
    return label.partition(",")[0].partition(" (")[0]


def by_label(items, label=lambda item: item.label):
    """{label: items} in the order of the strategies."""
    groups = {}
    for item in items:
        groups.setdefault(label(item), []).append(item)
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

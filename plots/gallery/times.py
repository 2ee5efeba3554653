# SPDX-License-Identifier: MIT
"""Times by numbers of threads beside the thesis's (table 10.1): whole runs, best of a few."""
import os

from gallery.compare import NONE, ratio
from gallery.runs import Plan
from gallery.shared import style

REPEATS = 5


def measure(program, scene, threads):
    """The least time of all steps of a run in seconds; threads = 0: the sequential method."""
    strategy = "cells" if threads else ""
    runs = [program.run(Plan(scene, (), strategy, threads=threads, again=again))
            for again in range(1, REPEATS + 1)]
    return min(run.result["wall_s"] for run in runs)


def table(program, part, facts):
    """(sentence, rows) for one scene; more threads than cores are not measured."""
    entry, cores = facts.entry(part.entry), os.cpu_count() or 1
    counts = sorted({1, *(item["n"] for item in entry["values"])})
    ours = {n: measure(program, part.scene, n) for n in [0, *(n for n in counts if n <= cores)]}
    rows = [(f"{part.label}: t_s, sequential", f"{entry['t_s']} s", f"{1e3 * ours[0]:.3g} ms",
             ratio(ours[0], entry["t_s"]))]
    for item in entry["values"]:
        n = item["n"]
        speedup = ours[0] / ours[n] if n in ours else None
        rows.append((f"{part.label}: S({n}) = t_s / t_{n}", f"{item['S']:.2f}",
                     f"{speedup:.2f}" if speedup else NONE, ratio(speedup, item["S"])))
    text = (f"{part.scene} takes {1e3 * ours[0]:.3g} ms in the sequential method, all steps "
            "together")
    parallel = [n for n in ours if n > 1]
    if parallel:
        most = max(parallel)
        text += f", and {1e3 * ours[most]:.3g} ms on {style.counted(most, 'thread')}"
    return text + ".", rows


def conditions():
    cores = os.cpu_count() or 1
    return (f"Each time is the least of {REPEATS} runs with the strategy cells, on this machine "
            f"of {style.counted(cores, 'core')} with whatever else it did; more threads than "
            "cores are left out. The thesis's are of four cores of an Intel Core i5-3570K.")

# SPDX-License-Identifier: MIT
"""Times by numbers of threads beside the thesis's (table 10.1): whole runs, the best of a few."""
import os

from gallery import busy
from gallery.compare import NONE, percent, ratio
from gallery.runs import Plan
from gallery.shared import style

REPEATS = 5


def measure(program, scene, threads, key):
    """The least time of all steps of a run in seconds, by the clock (wall_s) or by the processor
    (cpu_s); threads = 0: the sequential method."""
    runs = [program.run(Plan(scene, strategy="cells" if threads else "", threads=threads,
                             again=again)) for again in range(1, REPEATS + 1)]
    return min(run.result[key] for run in runs)


def table(program, part, facts):
    """(sentence, note, rows) for one scene."""
    entry, cores = facts.entry(part.entry), os.cpu_count() or 1
    share = busy.share()
    quiet = share is not None and share < busy.BUSY
    own = measure(program, part.scene, 0, "cpu_s")
    rows = [(f"{part.label}: t_s, sequential", f"{entry['t_s']} s", f"{1e3 * own:.3g} ms",
             ratio(own, entry["t_s"]))]
    text = (f"All steps of {part.scene} together take the sequential method "
            f"{1e3 * own:.3g} ms of processor time")
    base = measure(program, part.scene, 0, "wall_s") if quiet else None
    for item in entry["values"]:
        n = item["n"]
        speedup = base / measure(program, part.scene, n, "wall_s") if quiet and n <= cores else None
        rows.append((f"{part.label}: S({n}) = t_s / t_{n}", f"{item['S']:.2f}",
                     f"{speedup:.2f}" if speedup else NONE, ratio(speedup, item["S"])))
        if speedup and n > 1:
            text += f"; {n} threads are {speedup:.2f} times as fast"
    return text + ".", note(share, quiet, cores), rows


def note(share, quiet, cores):
    """The conditions of the times."""
    text = f"Ours are the least of {REPEATS} runs"
    if quiet:
        text += (f" on {style.counted(cores, 'core')}, threads with the strategy cells; more "
                 "threads than cores are not timed")
    elif share is None:
        text += "; threads were not timed, because it is not known how busy the machine is"
    else:
        text += (f"; threads were not timed, because others used {percent(share, 0)} of the "
                 "machine's cores")
    return text + (". The thesis's times are of four cores of an Intel Core i5-3570K, and of a "
                   "number of steps that it does not state.")

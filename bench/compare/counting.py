# SPDX-License-Identifier: MIT
"""Instructions and allocations of the steps of fixed runs, of two programs."""
import concurrent.futures

import callgrind
import judgement
import timing
import workloads


def counts_of(side, workload, within):
    _, steps = timing.run(side, workload.counted)
    with timing.named(workload.counted) as path:
        return judgement.Counts(*callgrind.count(side.command(path), within), steps)


def of_both(sides, workload):
    """(base, new, what was counted). Both run at the same time, which does not affect counts. Only steps are
    counted, so that start and output do not dilute a difference; if one of the programs has no such
    function, whole runs of both. Raises NotCounted."""
    def count(within):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            return tuple(pool.map(lambda side: counts_of(side, workload, within), sides))

    if workload.counted:
        try:
            return *count(workloads.STEP), "steps"
        except callgrind.NotCalled:
            pass
    return *count(None), "whole run"

# SPDX-License-Identifier: MIT
"""Instructions and allocations of the steps of fixed runs, of two programs."""
import concurrent.futures
import os
import tempfile

import callgrind
import judgement
import timing
import workloads


def counts_of(program, workload, within):
    if not workload.counted:
        timing.run(program, "")
        return judgement.Counts(*callgrind.count([program]), steps=1)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.toml")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(workload.counted)
        _, steps = timing.run(program, workload.counted)
        return judgement.Counts(*callgrind.count([program, "run", path], within), steps)


def of_both(programs, workload):
    """(base, new, what was counted). Both run at the same time, which does not affect counts. Only steps are
    counted, so that start and output do not dilute a difference; if one of the programs has no such
    function, whole runs of both. Raises NotCounted."""
    def count(within):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            return tuple(pool.map(lambda program: counts_of(program, workload, within), programs))

    if workload.counted:
        try:
            return *count(workloads.STEP), "steps"
        except callgrind.NotCalled:
            pass
    return *count(None), "whole run"

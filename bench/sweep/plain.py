# SPDX-License-Identifier: MIT
"""The plain loop: the jobs of a plan in order on this machine, without a workflow engine."""
import concurrent.futures
import threading

import execute
from errors import Interrupted


class Cores:
    """Hands out the cores of this machine."""

    def __init__(self, count):
        self.count = self.free = count
        self.changed = threading.Condition()

    def take(self, wanted, stopped):
        """How many were taken: no more than there are. 0 if `stopped` while waiting."""
        wanted = min(wanted, self.count)
        with self.changed:
            while self.free < wanted:
                if stopped():
                    return 0
                self.changed.wait(0.25)
            self.free -= wanted
        return wanted

    def give_back(self, taken):
        with self.changed:
            self.free += taken
            self.changed.notify_all()


def loop(chunks, store, jobs, again, stopped, say):
    """Runs everything, `jobs` cores at a time; what has to be alone comes last. A failed run is
    recorded and the others go on. Raises Interrupted when `stopped` says so."""
    cores = Cores(jobs)

    def one(run, taken):
        try:
            outcome = execute.run_once(run, store, stopped, again)
            say(outcome, run)
        finally:
            cores.give_back(taken)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        running = []
        for chunk in sorted(chunks, key=lambda chunk: chunk.alone):
            for run in chunk.runs:
                taken = cores.take(jobs if chunk.alone else run.cores, stopped)
                if stopped():
                    break
                running.append(pool.submit(one, run, taken))
        # What one of them raises is raised here, after all have ended.
        problems = [future.exception() for future in running]
    for problem in problems:
        if problem is not None:
            raise problem
    if stopped():
        raise Interrupted

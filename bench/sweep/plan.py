# SPDX-License-Identifier: MIT
"""What is due, and how it is shared out among jobs.

A job of a workflow engine costs a second or so, a run often less: so a job does many runs, one
after the other. The first jobs are long and the last ones short, so that the cores are busy to the
end. Runs that are timed stand in one job for each row, in which the repeats take turns: what else
the machine does then meets all of them alike."""
import dataclasses
import json
import math
import random

import runs

SHORTEST = 16  # the last jobs are this part of an equal share for each core


@dataclasses.dataclass(frozen=True)
class Chunk:
    """Runs that one job does in this order."""
    runs: tuple
    cores: int
    alone: bool
    timed: bool


def due(all_runs, store, again):
    """Those without a result, in the table's order."""
    return [run for run in all_runs
            if not store.is_done(run) and (again or not store.has_failed(run))]


def interleaved(some):
    """All first repeats in a random order, then all second ones in another."""
    rounds = {}
    for run in some:
        rounds.setdefault(run.identity.get("repeat", 1), []).append(run)
    source = random.Random(1)
    return [run for repeat in sorted(rounds)
            for run in source.sample(rounds[repeat], len(rounds[repeat]))]


def sizes(count, jobs):
    """How many runs each job has: fewer and fewer."""
    least = max(1, math.ceil(count / (SHORTEST * jobs)))
    found = []
    while count > 0:
        found.append(min(count, max(least, math.ceil(count / (2 * jobs)))))
        count -= found[-1]
    return found


def chunks(some, jobs, batch=None):
    """The jobs for some runs; `batch`: how many runs a job has, where that is asked for."""
    found, rows, beside = [], {}, {}
    for run in some:
        if run.alone:
            rows.setdefault(run.row, []).append(run)
        else:
            beside.setdefault(run.cores, []).append(run)
    for cores in sorted(beside, reverse=True):
        rest = beside[cores]
        for size in sizes(len(rest), jobs) if batch is None else \
                [batch] * math.ceil(len(rest) / batch):
            found.append(Chunk(tuple(rest[:size]), cores, False, False))
            rest = rest[size:]
    for row in rows.values():
        found.append(Chunk(tuple(interleaved(row)), max(run.cores for run in row), True,
                           row[0].timed))
    return found


def write(path, some_chunks, **more):
    """The plan, as a job reads it on whichever machine it runs."""
    with open(path, "w", encoding="utf-8") as stream:
        json.dump({**more, "chunks": [
            {"cores": chunk.cores, "alone": chunk.alone, "timed": chunk.timed,
             "runs": [runs.to_json(run) for run in chunk.runs]} for chunk in some_chunks]}, stream)

# SPDX-License-Identifier: MIT
"""Runs two programs in pairs, as many as the judgement needs."""
import contextlib
import json
import os
import random
import resource
import subprocess
import tempfile
import time
from dataclasses import dataclass

import judgement

AT_ONCE = 5  # pairs between two judgements


@dataclass(frozen=True)
class Side:
    """One of the two that are compared: a program, and the options that its runs get."""
    program: str
    settings: tuple = ()

    def command(self, scene):
        return [self.program, "run", scene, *self.settings] if scene else [self.program]


def environment():
    return {**os.environ, "OMP_NUM_THREADS": "1"}


def timed(command, allowed=(0,)):
    """Microseconds of CPU time of a command. Raises RuntimeError if it ends with another code."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in allowed:
        raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}: {done.stderr.strip()}")
    return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) * 1e6


@contextlib.contextmanager
def named(scene):
    """The name by which a program finds a scene: its own, or that of a file with its text."""
    if "\n" not in scene:
        yield scene
        return
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.toml")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(scene)
        yield path


def result_of(side, scene):
    """One run of a scene, or of the text of a scene file: microseconds of CPU time, and its result."""
    with named(scene) as path, tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "result.json")
        # Exit code 1 means that the run broke an invariant, which other tests check.
        cpu = timed([*side.command(path), "--json", out], allowed=(0, 1))
        if not os.path.exists(out):
            raise RuntimeError(f"{side.program} has written no result")
        with open(out, encoding="utf-8") as stream:
            return cpu, json.load(stream)


def run(side, scene):
    """One run, of a program without arguments if there is no scene: microseconds of CPU time of the run
    and of a step (mean), of wall time of a step (median), and the number of steps."""
    if not scene:
        return {"whole run, CPU": timed(side.command(scene))}, 1
    cpu, result = result_of(side, scene)
    return {"whole run, CPU": cpu,
            "steps, CPU": result["cpu_s"] * 1e6 / max(result["steps"], 1),
            "step, median": result["step_us_median"]}, result["steps"]


class Pairs:
    """The times of one workload: {figure: [(base, new)]}."""

    def __init__(self):
        self.times = {}

    def add(self, base, new):
        for figure, time_of_base in base.items():
            self.times.setdefault(figure, []).append((time_of_base, new[figure]))

    @property
    def count(self):
        return max(map(len, self.times.values()), default=0)

    @property
    def is_decided(self):
        return self.count >= judgement.FEWEST_PAIRS and all(
            judgement.median_ratio(pairs).verdict != judgement.Verdict.UNDECIDED
            for pairs in self.times.values())


def measure(runs, max_pairs, max_seconds, say, source=None):
    """{name: Pairs}. `runs`: {name: (run of base, run of new)}, functions that return {figure: time}. A
    workload gets no further pairs once all of its figures are decided; the others get pairs in turn, in
    random order, up to a number of pairs and seconds."""
    source = source or random.Random()
    begin = time.monotonic()
    found = {name: Pairs() for name in runs}
    for base, new in runs.values():
        base(), new()  # warms up the disk's cache
    left = list(runs)
    count = 0
    while left and count < max_pairs:
        count += 1
        for name in source.sample(left, len(left)):
            times = [None, None]
            for which in source.sample((0, 1), 2):
                times[which] = runs[name][which]()
            found[name].add(*times)
        if count % AT_ONCE == 0:
            left = [name for name in left if not found[name].is_decided]
            say(f"{count} pairs; still undecided: {', '.join(left) or 'none'}")
            if time.monotonic() - begin > max_seconds:
                break
    return found

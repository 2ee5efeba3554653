# SPDX-License-Identifier: MIT
"""Runs two programs in pairs, as many as the judgement needs."""
import json
import os
import random
import resource
import subprocess
import tempfile
import time

import judgement

AT_ONCE = 5  # pairs between two judgements


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


def run(program, scene):
    """One run of the text of a scene file, or of a program without arguments if there is no text:
    microseconds of CPU time of the run and of a step (mean), of wall time of a step (median), and the
    number of steps."""
    if not scene:
        return {"whole run, CPU": timed([program])}, 1
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "scene.toml"), os.path.join(folder, "result.json")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(scene)
        # Exit code 1 means that the run broke an invariant, which other tests check.
        cpu = timed([program, "run", path, "--json", out], allowed=(0, 1))
        if not os.path.exists(out):
            raise RuntimeError(f"{program} has written no result")
        with open(out, encoding="utf-8") as stream:
            result = json.load(stream)
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

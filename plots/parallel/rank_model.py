# SPDX-License-Identifier: MIT
"""What a step takes on more ranks than were measured, where each keeps the same share of the work
(weak scaling): the measured times of one rank, and messages by the figures of a stated network.

Nothing here is measured beyond two or more ranks of one machine; see `ASSUMPTIONS`.
"""
import statistics
from dataclasses import dataclass

from results import load

MOST = 1024  # ranks


@dataclass(frozen=True)
class Network:
    latency_us: float = 2.0     # of a message
    gigabytes_per_s: float = 12.5  # in and out of each rank: 100 Gbit/s

    def told_to(self, others, bytes_each, exchanges):
        """Microseconds a step: each rank sends its messages to so many others. The rounds of an
        exchange double those who know, and all bytes pass through the link of each."""
        rounds = max(others, 0).bit_length()
        return exchanges * rounds * self.latency_us + others * bytes_each / (
            1e3 * self.gigabytes_per_s)


NEIGHBOURS = 6  # of a cell in the plane, on average

ASSUMPTIONS = (
    "each rank has as much work as one of those measured, and its others tell as much; what is "
    "serial is done by each rank for all of them; no rank waits for a slower one; nobody else "
    "uses caches, memory or the network")


@dataclass(frozen=True)
class RankRun:
    """Of the first rank, in microseconds of a step."""

    scene: str
    triangles: int
    ranks: int
    work: float
    tell: float
    wait: float
    repeat: float
    step: float
    bytes: float      # that one rank tells
    exchanges: float

    @property
    def serial(self):
        """What is in no section that is shared, for the share of one rank."""
        return max(0.0, self.step - self.work - self.tell - self.wait - self.repeat) / self.ranks

    @property
    def alone(self):
        """One rank that has nobody to tell."""
        return self.work + self.serial

    @property
    def repeat_one(self):
        """What one other rank has done."""
        return self.repeat / (self.ranks - 1)


def read(path):
    """The JSON of a run in several processes."""
    data = load.read_json(path)
    ranks = load.need(data, "ranks", path, int)
    if ranks < 2:
        raise load.InputFault(f"{path} is of {ranks} rank, where a run in two or more is expected.")
    times = load.need(data, "rank_us_per_step", path, dict)
    steps = load.need(data, "steps", path, int)
    if steps < 1:
        raise load.InputFault(f"{path} has no step.")
    work, tell, wait, repeat = (load.need(times, key, path, float, "rank_us_per_step")
                                for key in ("work", "tell", "wait", "repeat"))
    if work <= 0:
        raise load.InputFault(f"{path} has a rank without work.")
    return RankRun(load.need(data, "scene", path, str), load.need(data, "triangles_last", path, int),
                   ranks, work, tell, wait, repeat,
                   1e6 * load.need(data, "wall_s", path, float) / steps,
                   load.need(data, "bytes_per_step", path, float) / ranks,
                   load.need(data, "exchanges_per_step", path, float))


def step(run, ranks, network, told=None):
    """Microseconds of a step on so many ranks. `told`: how many others each one tells; all of
    them, as it is, if nothing else is said."""
    if ranks == 1:
        return run.alone
    others = ranks - 1 if told is None else min(ranks - 1, told)
    serial = run.serial * (ranks if told is None else 1)
    return (run.work + run.tell + others * run.repeat_one + serial
            + network.told_to(others, run.bytes, run.exchanges))


def efficiency(run, ranks, network, told=None):
    """The time of a step of one rank over that of so many with a share each."""
    return run.alone / step(run, ranks, network, told)


def measured(run):
    """The same, as it was measured on this machine: messages by its memory, waiting included."""
    return run.alone / run.step


def over(runs, value):
    """Least, median and most of a value of repeated runs."""
    values = [value(run) for run in runs]
    return min(values), statistics.median(values), max(values)


def counts(most=MOST):
    """1, 2, 4, ... ranks."""
    return [2 ** k for k in range(most.bit_length()) if 2 ** k <= most]

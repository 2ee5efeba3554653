# SPDX-License-Identifier: MIT
"""When one of two commits counts as slower.

Times. Both programs run in pairs, one right after the other and in an order drawn anew for each pair. The
figure is the median of the pairs' ratios, new over base. Where neighbours make a machine busy, the load
changes over seconds and minutes: it meets both of a pair and leaves their ratio, whereas medians or
quartiles of each program by itself wander with it. One program against itself, in blocks of 20 pairs at a
load of 7 to 9 on two cores: the median of ratios had a standard deviation of 0.4 to 1.7 %, the ratio of
medians 1.2 to 6.3 %. The wall time of whole runs had two to three times as much noise, and is left out.

The interval of that median lies between two order statistics, as in the sign test: with n independent
ratios, each above their median by the toss of a coin, it takes the k-th from both ends where so few tosses
have that chance. It needs no shape of the noise. Neither does it need noise without a memory if the programs
are alike: which of a pair is the new one is drawn by lot, so that the ratio of each pair is above or below 1
by that lot alone, whatever the machine does. For a program slower by a factor, the same holds around it.

A slowdown of 5 % is to be caught, and unchanged code must not be taken for slower. So the limit is in the
middle, 1.025, and pairs are run until the interval is no wider than 5 %: then both truths are half of that
away from the limit, as far as the interval reaches, and an error has a chance of one in ten thousand. Pairs end early where
the whole interval is on one side of the limit. Where it stays too wide, nothing is said: undecided.

Tried on synthetic times of a busy machine, a jitter of 3 %, a load that wanders by 10 % and bursts of up to
50 % in a tenth of the runs: of 50 runs of unchanged code no figure was called slower and fewer than one in fifty
undecided, and a slowdown of 5 % was found in each figure 20 times of 20.

Instructions and allocations: counts of one run each, which repeat to within a few millionths. What is to be
caught is 2 % and one allocation a step, and the limits are again in the middle.
"""
import enum
import functools
import math
import statistics
from dataclasses import dataclass

SLOWDOWN = 1.05      # in time, that is to be caught
TIME_LIMIT = 1.025
INSTRUCTIONS_LIMIT = 1.01
ALLOCATIONS_LIMIT = 0.5  # more of them in a step
CONFIDENCE = 0.9999  # many figures are judged at once
FEWEST_PAIRS = 5


class Verdict(enum.Enum):
    NOT_SLOWER = "not slower"
    SLOWER = "slower"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Ratio:
    """Of new times to those of the base, with its interval."""
    value: float
    low: float
    high: float

    @property
    def is_narrow(self):
        return self.high <= SLOWDOWN * self.low

    @property
    def verdict(self):
        if self.low > TIME_LIMIT:
            return Verdict.SLOWER
        if self.high < TIME_LIMIT:
            return Verdict.NOT_SLOWER
        if self.is_narrow:
            return Verdict.SLOWER if self.value > TIME_LIMIT else Verdict.NOT_SLOWER
        return Verdict.UNDECIDED


def check(pairs):
    """Raises ValueError for fewer than FEWEST_PAIRS and for times that are none."""
    if len(pairs) < FEWEST_PAIRS:
        raise ValueError(f"{len(pairs)} pairs; at least {FEWEST_PAIRS} are needed")
    if not all(0 < time < float("inf") for pair in pairs for time in pair):
        raise ValueError("a time that is not a positive number")


@functools.lru_cache(maxsize=None)
def rank_of_bounds(count, confidence=CONFIDENCE):
    """How many of `count` ratios lie below the interval, and as many above it; None if it would have to
    be wider than all of them."""
    allowed = 2 ** count * round((1 - confidence) * 1e9) // (2 * 10 ** 9)  # no float holds 2 ** 1024
    below, ways = 0, 0
    while below <= count:
        ways += math.comb(count, below)
        if ways > allowed:
            break
        below += 1
    return below - 1 if below > 0 else None


def median_ratio(pairs, confidence=CONFIDENCE):
    """The median of the ratios of pairs (base, new), by which the new one is judged. Its interval is
    unbounded where there are too few pairs for any."""
    check(pairs)
    ratios = sorted(new / base for base, new in pairs)
    rank = rank_of_bounds(len(ratios), confidence)
    low, high = (0.0, math.inf) if rank is None else (ratios[rank], ratios[-1 - rank])
    return Ratio(statistics.median(ratios), low, high)


@dataclass(frozen=True)
class Counts:
    """Of one run."""
    instructions: int
    allocations: int
    steps: int


def more_instructions(base, new):
    """The ratio, and whether it is too large."""
    ratio = new.instructions / base.instructions
    return ratio, ratio > INSTRUCTIONS_LIMIT


def more_allocations(base, new):
    """By how many a step, and whether these are too many."""
    more = new.allocations / new.steps - base.allocations / base.steps
    return more, more > ALLOCATIONS_LIMIT

# SPDX-License-Identifier: MIT
"""The rules by which a commit counts as slower.

Times. Both programs run in pairs, one directly after the other, in a random order for each pair. The
figure is the median of the pairs' ratios, new over base. On a busy machine the load changes over seconds
and minutes: it affects both runs of a pair but hardly their ratio, whereas medians or quartiles of each
program alone drift with it. With one program against itself, in blocks of 20 pairs at a load of 7 to 9 on
two cores, the median of ratios had a standard deviation of 0.4 to 1.7 %, the ratio of medians 1.2 to
6.3 %. The wall time of whole runs had two to three times as much noise, and is not used.

The interval of that median lies between two order statistics, as in the sign test: each of n independent
ratios lies above the median with probability 1/2, so the interval is bounded by the k-th ratios from both
ends, with k from the binomial distribution. This assumes no distribution of the noise. If the programs are
equally fast, the noise need not be independent either: which run of a pair is the new one is random, so
each ratio is above or below 1 at random, whatever the machine does. For a program slower by a factor, the
same holds around this factor.

A slowdown of 5 % must be detected, and unchanged code must not be called slower. So the limit is in the
middle, 1.025, and pairs are run until the interval is at most 5 % wide: both ratios, 1 and 1.05, are then
half an interval away from the limit, and an error has a probability of one in ten thousand. Pairs end
early if the whole interval is on one side of the limit. If it stays too wide, the result is undecided.

On synthetic times of a busy machine (a jitter of 3 %, a load that drifts by 10 % and bursts of up to 50 %
in a tenth of the runs), no figure was called slower in 50 runs of unchanged code, fewer than one in fifty
was undecided, and a slowdown of 5 % was detected in each figure in 20 of 20 runs.

Instructions and allocations are counts of one run each, which repeat to within a few millionths. Increases
of 2 % and of one allocation per step must be detected; the limits are again in the middle.
"""
import enum
import functools
import math
import statistics
from dataclasses import dataclass

SLOWDOWN = 1.05      # in time, to be detected
TIME_LIMIT = 1.025
INSTRUCTIONS_LIMIT = 1.01
ALLOCATIONS_LIMIT = 0.5  # more of them in a step
CONFIDENCE = 0.9999  # high, because many figures are judged at once
FEWEST_PAIRS = 5


class Verdict(enum.Enum):
    NOT_SLOWER = "not slower"
    SLOWER = "slower"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Ratio:
    """The ratio of new times to those of the base, with its interval."""
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
    """Raises ValueError for fewer than FEWEST_PAIRS pairs and for times that are not positive numbers."""
    if len(pairs) < FEWEST_PAIRS:
        raise ValueError(f"{len(pairs)} pairs; at least {FEWEST_PAIRS} are needed")
    for time in (time for pair in pairs for time in pair):
        if not 0 < time < float("inf"):
            raise ValueError(f"a time of {time} s; times must be finite and above 0")


@functools.lru_cache(maxsize=None)
def rank_of_bounds(count, confidence=CONFIDENCE):
    """The number of the `count` ratios below the interval, which is also that above it; None if the
    interval would have to be wider than all ratios."""
    allowed = 2 ** count * round((1 - confidence) * 1e9) // (2 * 10 ** 9)  # 2 ** 1024 is too large for a float
    below, ways = 0, 0
    while below <= count:
        ways += math.comb(count, below)
        if ways > allowed:
            break
        below += 1
    return below - 1 if below > 0 else None


def median_ratio(pairs, confidence=CONFIDENCE):
    """The median of the ratios of pairs (base, new), by which the new one is judged. Its interval is
    unbounded if there are too few pairs."""
    check(pairs)
    ratios = sorted(new / base for base, new in pairs)
    rank = rank_of_bounds(len(ratios), confidence)
    low, high = (0.0, math.inf) if rank is None else (ratios[rank], ratios[-1 - rank])
    return Ratio(statistics.median(ratios), low, high)


@dataclass(frozen=True)
class Counts:
    """The counts of one run."""
    instructions: int
    allocations: int
    steps: int


def more_instructions(base, new):
    """The ratio of the counts, and whether it is too large."""
    ratio = new.instructions / base.instructions
    return ratio, ratio > INSTRUCTIONS_LIMIT


def more_allocations(base, new):
    """The increase per step, and whether it is too large."""
    more = new.allocations / new.steps - base.allocations / base.steps
    return more, more > ALLOCATIONS_LIMIT

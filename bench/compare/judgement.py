# SPDX-License-Identifier: MIT
"""When one of two commits counts as slower.

Times: both programs run in pairs, one right after the other and in random order, so that what else
the machine does meets both. The figure is the ratio of the medians of all pairs, new over base. Its
confidence interval is a percentile bootstrap: pairs are drawn again with replacement, 2000 times,
from a fixed seed. An alarm needs both a ratio above the limit and an interval that lies above 1:
the former so that a difference of no importance is none, the latter so that noise is none.

Instructions and allocations: counts of one run each, which repeat to within a few millionths.
"""
import random
import statistics
from dataclasses import dataclass

TIME_LIMIT = 1.05
INSTRUCTIONS_LIMIT = 1.02
ALLOCATIONS_LIMIT = 0.5  # more of them in a step
CONFIDENCE = 0.999  # many figures are judged at once
RESAMPLES = 2000
FEWEST_PAIRS = 5


@dataclass(frozen=True)
class Ratio:
    """Of the new one's median to the base's, with its interval."""
    value: float
    low: float
    high: float

    @property
    def is_slower(self):
        return self.value > TIME_LIMIT and self.low > 1


def ratio_of_medians(pairs, confidence=CONFIDENCE, resamples=RESAMPLES, seed=1):
    """`pairs`: times (base, new), above 0. Raises ValueError for fewer than FEWEST_PAIRS."""
    if len(pairs) < FEWEST_PAIRS:
        raise ValueError(f"{len(pairs)} pairs; at least {FEWEST_PAIRS} are needed")
    if not all(0 < time < float("inf") for pair in pairs for time in pair):
        raise ValueError("a time that is not a positive number")

    def ratio(some):
        return (statistics.median(new for _, new in some)
                / statistics.median(base for base, _ in some))

    source = random.Random(seed)
    drawn = sorted(ratio(source.choices(pairs, k=len(pairs))) for _ in range(resamples))
    tail = int((1 - confidence) / 2 * resamples)
    return Ratio(ratio(pairs), drawn[tail], drawn[-1 - tail])


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

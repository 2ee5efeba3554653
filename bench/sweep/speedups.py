# SPDX-License-Identifier: MIT
"""S(n): the time of the sequential driver over that of n threads, on the same machine, commit,
scene and settings, and only among timed runs. The time is the wall time of all steps; medians are
divided, and the spread is that of the quartiles of the time of n threads."""
import dataclasses

import records

TIME = "wall_s"


@dataclasses.dataclass(frozen=True)
class Speedup:
    point: records.Point
    base: records.Spread
    time: records.Spread

    @property
    def s(self):
        return self.base.median / self.time.median

    @property
    def low(self):
        return self.base.median / self.time.high

    @property
    def high(self):
        return self.base.median / self.time.low

    @property
    def name(self):
        """Of its line: the strategy and what else is set beside the size."""
        setting = self.point.setting
        return ", ".join([self.point.strategy, setting] if setting else [self.point.strategy])


def find(points):
    """Of all timed points that have a sequential run beside them."""
    found = []
    for same in records.by([p for p in points if p.is_timed], lambda p: p.problem).values():
        bases = [p for p in same if p.strategy == "sequential" and p.spread(TIME)]
        if bases:
            base = bases[0].spread(TIME)
            found += [Speedup(p, base, p.spread(TIME)) for p in same
                      if p.strategy not in ("sequential", "reference") and p.spread(TIME)
                      and p.spread(TIME).low > 0]
    return found

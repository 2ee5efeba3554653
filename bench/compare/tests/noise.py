# SPDX-License-Identifier: MIT
"""Synthetic times of a busy machine."""
import math


class Machine:
    """Its load wanders slowly, each run has a jitter of its own, and some meet a burst."""

    def __init__(self, source, jitter=0.03, memory=0.98, drift=0.1, bursts=0.1):
        self.source, self.jitter, self.memory, self.drift = source, jitter, memory, drift
        self.bursts = bursts
        self.load = source.gauss(0, drift)

    def time(self, slowdown):
        fresh = math.sqrt(1 - self.memory ** 2) * self.drift
        self.load = self.memory * self.load + self.source.gauss(0, fresh)
        burst = 0.5 * self.source.random() if self.source.random() < self.bursts else 0
        return 1000 * slowdown * math.exp(self.load + self.source.gauss(0, self.jitter)) * (1 + burst)

    def program(self, slowdown=1.0):
        """A run of it: {figure: time}."""
        return lambda: {"time": self.time(slowdown)}

# SPDX-License-Identifier: MIT
"""The fixed runs that two commits are compared by: sequential ones, for a second thread adds noise
and no instructions."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Workload:
    name: str
    timed: tuple  # the arguments of `dsc_scene run`, half a second or so
    counted: tuple  # the same in fewer steps: counting makes a run fifty times as long


def settings(*pairs):
    return tuple(word for pair in pairs for word in ("--set", pair))


BARE = Workload("program", None, None)  # any program, as it is

ALL = (
    Workload("swirl", ("swirl", *settings("h=0.02", "steps=60")),
             ("swirl", *settings("h=0.04", "steps=20"))),
    Workload("single-vortex", ("single-vortex", *settings("h=0.02", "dt=0.05")),
             ("single-vortex", *settings("h=0.04", "dt=0.1"))),
    Workload("zalesak", ("zalesak", *settings("h=0.01")),
             ("zalesak", *settings("h=0.03"))),
    Workload("drop-and-pool", ("drop-and-pool",), ("drop-and-pool", *settings("h=0.03"))),
    Workload("growing-circle", ("speedup-scaling", *settings("h=0.005", "steps=40")),
             ("speedup-scaling", *settings("h=0.02", "steps=10"))),
)

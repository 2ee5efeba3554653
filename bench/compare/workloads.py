# SPDX-License-Identifier: MIT
"""The fixed runs that two commits are compared by: sequential ones, for a second thread adds noise
and no instructions."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Workload:
    name: str
    timed: tuple  # the arguments of `dsc_scene run`, half a second or so
    counted: str  # a scene file of fewer steps: counting makes a run fifty times as long


def settings(*pairs):
    return tuple(word for pair in pairs for word in ("--set", pair))


BARE = Workload("program", None, None)  # any program, as it is


def of_steps(scene, **options):
    """A scene file whose exact shape is not measured: that would outweigh the steps."""
    lines = [f"{key} = {value}" for key, value in options.items()]
    return "\n".join([f'scene = "{scene}"', "[options]", *lines, "[measure]", "shape = false", ""])


ALL = (
    Workload("swirl", ("swirl", *settings("h=0.02", "steps=60")),
             of_steps("swirl", h=0.04, steps=40)),
    Workload("single-vortex", ("single-vortex", *settings("h=0.02", "dt=0.05")),
             of_steps("single-vortex", h=0.04, dt=0.1)),
    Workload("zalesak", ("zalesak", *settings("h=0.01")), of_steps("zalesak", h=0.03)),
    Workload("drop-and-pool", ("drop-and-pool",), of_steps("drop-and-pool", h=0.03)),
    Workload("growing-circle", ("speedup-scaling", *settings("h=0.005", "steps=40")),
             of_steps("speedup-scaling", h=0.02, steps=40)),
)

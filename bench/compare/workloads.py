# SPDX-License-Identifier: MIT
"""The fixed runs that two commits are compared by: sequential ones, for a second thread adds noise
and no instructions."""
from dataclasses import dataclass

# The steps of a run, and nothing else of it: what is counted.
STEP = "dsc::Simulation<double>::step_along*"


@dataclass(frozen=True)
class Workload:
    name: str
    timed: str    # a scene file
    counted: str  # one of no more steps: counting makes a run fifty times as long


BARE = Workload("program", "", "")  # any program, as it is


def of_steps(scene, **options):
    """A scene file whose exact shape is not measured: that would outweigh the steps."""
    lines = [f"{key} = {value}" for key, value in options.items()]
    return "\n".join([f'scene = "{scene}"', "[options]", *lines, "[measure]", "shape = false", ""])


# As short as leaves most of the time to the steps. Longer runs are no less noisy beside each other: two
# of 20 ms differed by as much as two of 100 ms, so five pairs of the former tell more than one of the latter.
ALL = (
    Workload("swirl", of_steps("swirl", h=0.02, steps=60), of_steps("swirl", h=0.04, steps=40)),
    Workload("single-vortex", of_steps("single-vortex", h=0.03, dt=0.07),
             of_steps("single-vortex", h=0.04, dt=0.1)),
    Workload("zalesak", of_steps("zalesak", h=0.03), of_steps("zalesak", h=0.03)),
    Workload("drop-and-pool", of_steps("drop-and-pool", h=0.015), of_steps("drop-and-pool", h=0.03)),
    Workload("growing-circle", of_steps("speedup-scaling", h=0.015, steps=80),
             of_steps("speedup-scaling", h=0.02, steps=40)),
)

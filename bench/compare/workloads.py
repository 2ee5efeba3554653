# SPDX-License-Identifier: MIT
"""The fixed runs for comparing two commits. They are sequential, because a second thread adds noise
and no instructions."""
from dataclasses import dataclass

# The function whose instructions are counted: the steps of a run.
STEP = "dsc::Simulation<double>::step_along*"


@dataclass(frozen=True)
class Workload:
    name: str
    timed: str    # a scene file
    counted: str  # a scene file with fewer steps: counting makes a run fifty times as long


BARE = Workload("program", "", "")  # any program without arguments


def of_steps(scene, **options):
    """A scene file without comparison with the exact shape, which would take longer than the steps."""
    lines = [f"{key} = {value}" for key, value in options.items()]
    return "\n".join([f'scene = "{scene}"', "[options]", *lines, "[measure]", "shape = false", ""])


# As short as possible with most of the time spent in steps. Longer runs are not less noisy: two runs of 20 ms differed
# by as much as two of 100 ms, so five pairs of short runs say more than one pair of long runs.
ALL = (
    Workload("swirl", of_steps("swirl", h=0.02, steps=60), of_steps("swirl", h=0.04, steps=40)),
    Workload("single-vortex", of_steps("single-vortex", h=0.03, dt=0.07),
             of_steps("single-vortex", h=0.04, dt=0.1)),
    Workload("zalesak", of_steps("zalesak", h=0.03), of_steps("zalesak", h=0.03)),
    Workload("drop-and-pool", of_steps("drop-and-pool", h=0.015), of_steps("drop-and-pool", h=0.03)),
    Workload("growing-circle", of_steps("speedup-scaling", h=0.015, steps=80),
             of_steps("speedup-scaling", h=0.02, steps=40)),
)

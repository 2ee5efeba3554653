# SPDX-License-Identifier: MIT
"""Several steps on end."""


def run(sim, flow, dt, steps, *, time=None, after=None, progress=None):
    """Makes several steps.

    Parameters
    ----------
    sim : Simulation
    flow : callable or Flow
        As for `Simulation.step`.
    dt : float
        Of each step.
    steps : int
    time : float, optional
        Where to begin; by default where the last step ended.
    after : callable, optional
        Called as `after(sim, report)` after each step; the run ends where it returns False.
    progress : callable, optional
        Called with a line of text after each step: `print`, for one.

    Returns
    -------
    list of Report

    Examples
    --------
    >>> reports = dsc.run(sim, dsc.swirl(), 0.01, 3)
    >>> [report.unreached for report in reports]
    [0, 0, 0]
    """
    begin = sim.time if time is None else time
    reports = []
    for k in range(steps):
        report = sim.step(flow, begin + k * dt, dt)
        reports.append(report)
        if progress is not None:
            progress(f"step {k + 1} of {steps}, t = {sim.time:.6g}, {report.interface_vertices} interface vertices, "
                     f"{report.unreached} unreached")
        if report.gave_up or (after is not None and after(sim, report) is False):
            break
    return reports

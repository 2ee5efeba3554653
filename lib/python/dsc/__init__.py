# SPDX-License-Identifier: MIT
"""2D deformable simplicial complexes: interfaces that move, in a triangle mesh that stays valid.

>>> import dsc
>>> square = [(0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7)]
>>> mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: square}, edge_length=0.1)
>>> sim = dsc.Simulation(mesh, edge_length=0.1)
>>> sim.step(lambda x, t: 0 * x + (1, 0), 0, 0.1).unreached
0
>>> round(mesh.areas[1], 12)
0.16
"""
from . import scenes
from ._dsc import (Curve, Event, FileError, Flow, InputError, Mesh, Report, Simulation,
                   curvature_flow, initial_complex)
from .data import Data
from .drawing import animate, plot

__all__ = ["Curve", "Data", "Event", "FileError", "Flow", "InputError", "Mesh", "Report", "Simulation",
           "animate", "curvature_flow", "initial_complex", "plot", "run", "scenes"]

Mesh.vertex_data = property(lambda mesh: Data(mesh, "vertex"), doc="Of vertices: a `Data`.")
Mesh.triangle_data = property(lambda mesh: Data(mesh, "triangle"), doc="Of triangles: a `Data`.")


def run(sim, flow, dt, steps, *, time=None, after=None):
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

    Returns
    -------
    list of Report
    """
    begin = sim.time if time is None else time
    reports = []
    for k in range(steps):
        report = sim.step(flow, begin + k * dt, dt)
        reports.append(report)
        if report.gave_up or (after is not None and after(sim, report) is False):
            break
    return reports

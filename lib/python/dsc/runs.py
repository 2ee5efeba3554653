# SPDX-License-Identifier: MIT
"""Runs of several steps, and files of their meshes."""
import os
import pathlib
import sys
from xml.sax.saxutils import quoteattr

from . import arrays


def run(sim, flow, dt, steps, *, time=None, after=None, progress=None):
    """Makes several steps.

    Parameters
    ----------
    sim : Simulation
    flow : callable or Flow
        As for `Simulation.step`.
    dt : float
        The length of each step.
    steps : int
    time : float, optional
        The initial time; by default the end of the last step.
    after : callable, optional
        Called as `after(sim, report)` after each step; the run ends if it returns False.
    progress : callable or bool, optional
        Called with a line of text after each step, such as `print`. True: shows the line on standard
        error, in place of the previous one.

    Returns
    -------
    list of Report

    Examples
    --------
    >>> reports = dsc.run(sim, dsc.swirl(), 0.01, 3)
    >>> [report.unreached for report in reports]
    [0, 0, 0]
    """
    if progress is True:
        def progress(line):
            end = "\033[K" if len(reports) < steps else "\033[K\n"
            print(f"\r{line}", end=end, file=sys.stderr, flush=True)
    begin = sim.time if time is None else time
    reports = []
    for k in range(steps):
        report = sim.step(flow, begin + k * dt, dt)
        reports.append(report)
        if progress:
            progress(f"step {k + 1} of {steps}, t = {sim.time:.6g}, {report.interface_vertices} interface vertices, "
                     f"{report.unreached} unreached")
        if report.gave_up or (after is not None and after(sim, report) is False):
            break
    return reports


class Series:
    """Meshes over time as a file `NAME.pvd` for ParaView, beside the meshes `NAME_00000.vtu`, ....

    Parameters
    ----------
    path : str or pathlib.Path
        The path of the .pvd file, which is complete after each added mesh.

    Examples
    --------
    >>> series = dsc.Series(folder / "swirl.pvd")
    >>> reports = dsc.run(sim, dsc.swirl(), 0.01, 3, after=lambda sim, report: series.add(sim.mesh, sim.time))
    """

    def __init__(self, path):
        self._path = pathlib.Path(path)
        if self._path.suffix != ".pvd":
            arrays.refuse("bad name of a series", "Series", repr(str(path)), "a path that ends in .pvd")
        self._entries = []

    def add(self, mesh, time):
        """Writes a mesh and adds it to the .pvd file."""
        path = self._path.with_name(f"{self._path.stem}_{len(self._entries):05d}.vtu")
        mesh.write_vtu(path)
        self._entries.append(f'<DataSet timestep="{float(time)!r}" file={quoteattr(path.name)}/>\n')
        part = self._path.with_name(self._path.name + ".part")
        part.write_text('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n'
                        + "".join(self._entries) + "</Collection>\n</VTKFile>\n", encoding="utf-8")
        os.replace(part, self._path)

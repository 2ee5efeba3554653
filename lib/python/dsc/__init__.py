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
from . import bench, interplay, scenes
from ._dsc import (FileError, Flow, Fluid, InputError, Mesh, Simulation, SolveError, area, circle,
                   curvature_flow, growth, hausdorff, initial_complex, interface_flow, swirl,
                   symmetric_difference)
from .data import Data
from .drawing import animate, plot
from .records import Curve, Event, Interface, Report
from .runs import run
from .state import load, save

__all__ = ["Curve", "Data", "Event", "FileError", "Flow", "Fluid", "InputError", "Interface", "Mesh", "Report",
           "Simulation", "SolveError", "animate", "area", "bench", "circle", "curvature_flow", "growth",
           "hausdorff", "initial_complex", "interface_flow", "load", "plot", "run", "save", "scenes", "swirl",
           "symmetric_difference"]

Mesh.vertex_data = property(lambda mesh: Data(mesh, "vertex"), doc="Of vertices: a `Data`.")
Mesh.triangle_data = property(lambda mesh: Data(mesh, "triangle"), doc="Of triangles: a `Data`.")
Mesh.areas = property(lambda mesh: {phase: one["area"] for phase, one in mesh.figures["phases"].items()},
                      doc="The area of each phase that occurs: a dict.")
Mesh.__repr__ = lambda mesh: (f"<dsc.Mesh: {len(mesh.triangles)} triangles, {len(mesh.points)} vertices, "
                              f"phases {', '.join(map(str, mesh.areas))}>")
Flow.__repr__ = lambda flow: f"<dsc.Flow: {flow._name}{flow._given}>"
Simulation.__repr__ = lambda sim: (f"<dsc.Simulation: {sim.interface_size} interface vertices, "
                                   f"time {sim.time:.6g}>")

# SPDX-License-Identifier: MIT
"""Deformable simplicial complexes in the plane and in space: interfaces that move, in a mesh that stays valid.

>>> import dsc
>>> square = [(0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7)]
>>> mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: square}, edge_length=0.1)
>>> sim = dsc.Simulation(mesh, edge_length=0.1)
>>> sim.step(lambda x, t: 0 * x + (1, 0), 0, 0.1).unreached
0
>>> round(mesh.areas[1], 12)
0.16
"""
try:
    from ._dsc import FileError, InputError, SolveError, __version__
except ModuleNotFoundError as error:
    if error.name != f"{__name__}._dsc":
        raise
    import os
    import sys
    folder = os.path.dirname(__file__)
    built = [name for name in os.listdir(folder) if name.startswith("_dsc.")]
    raise ImportError(
        f"{folder}: no compiled part for {sys.executable}: got {built[0] if built else 'none'}; build it by "
        f"`cmake --preset release -D DSC_MODULE_PYTHON={sys.executable}` and `cmake --build --preset release "
        "--target dsc_python`, and name build/release/lib/python in PYTHONPATH") from None
from .data import Data
from .drawing import animate, plot
from .flows import Flow, curvature_flow, growth, interface_flow, swirl
from .fluid import Fluid
from .measures import area, circle, grains, hausdorff, symmetric_difference
from .mesh import Mesh, from_labels, initial_complex
from .mesh3 import Mesh3
from .reading import from_meshio
from .records import Curve, Event, Faces, InputReport, Interface, Report, Report3
from .runs import Series, run
from .shapes3 import Shape3, ball, box, closed_surface, ellipsoid, torus
from .simulation import Simulation
from .state import load, save

__all__ = ["Curve", "Data", "Event", "Faces", "FileError", "Flow", "Fluid", "InputError", "InputReport", "Interface",
           "Mesh", "Mesh3", "Report", "Report3", "Series", "Shape3", "Simulation", "SolveError", "animate", "area",
           "ball", "bench", "box", "circle", "closed_surface", "curvature_flow", "ellipsoid", "from_labels",
           "from_meshio", "grains", "growth", "hausdorff", "initial_complex", "interface_flow", "load", "plot", "run",
           "save", "scenes", "swirl", "symmetric_difference", "torus"]


def __getattr__(name):
    """Imports rarely used parts on first use."""
    import importlib

    if name in ("bench", "scenes"):
        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

# SPDX-License-Identifier: MIT
"""Flows, other than functions of positions and time."""
from . import _dsc
from .mesh import Mesh


class Flow:
    """A flow for `Simulation.step`, other than a function of positions and time.

    Made by `swirl`, `growth`, `curvature_flow` and `interface_flow`.
    """

    def __init__(self, name, *given):
        """By the function of the compiled part that has this name, with what it takes."""
        self._name = name
        self._given = given
        self._compiled = getattr(_dsc, name)(*given)

    def __repr__(self):
        return f"<dsc.Flow: {self._name}{self._given}>"

    def __reduce__(self):
        return Flow, (self._name, *self._given)


def interface_flow(function):
    """A flow that sees the interface.

    Parameters
    ----------
    function : callable
        Called as `function(interface, time)` with an `Interface`, once in each stage of the
        integrator (`euler`, `midpoint` or `rk4`) for all of the interface, by the thread that called
        `step`; returns velocities (n, 2).

    Returns
    -------
    Flow

    Notes
    -----
    Explicit integrators limit the step of a flow that smooths: where the velocity is -curvature *
    normal, dt * 4 / l**2 must stay below 2, with l the shortest edge. `curvature_flow` has no limit.

    Examples
    --------
    >>> @dsc.interface_flow
    ... def grow(interface, time):
    ...     return 0.1 * interface.normals
    >>> sim.step(grow, 0, 0.1).unreached
    0
    """
    return Flow("interface_flow", function)


def swirl(amplitude=1.0, period=0.0):
    """amplitude * f(t) * (sin(pi x)**2 sin(2 pi y), -sin(pi y)**2 sin(2 pi x)).

    Parameters
    ----------
    amplitude : float
    period : float
        f is cos(pi t / period), or 1 if this is 0.

    Returns
    -------
    Flow
    """
    return Flow("swirl", amplitude, period)


def growth(speeds):
    """Phases grow along their normals; convex corners open into arcs.

    The simulation must be made for it: `dsc.Simulation(mesh, flow, edge_length=h)`.

    Parameters
    ----------
    speeds : dict
        `{(growing, into): speed}`, in lengths per time; interfaces of other pairs stay.

    Returns
    -------
    Flow
    """
    return Flow("growth", dict(speeds))


def curvature_flow(tension=1.0, mobility=1.0, keep_areas_of=None):
    """The interface moves along its normal at tension * mobility * curvature.

    Parameters
    ----------
    tension, mobility : float
        Of all pairs of phases.
    keep_areas_of : Mesh or dict, optional
        Each phase but 0 keeps the area that it has in this mesh, or the area that is given by phase.

    Returns
    -------
    Flow
    """
    areas = keep_areas_of or {}
    if isinstance(areas, Mesh):
        areas = {phase: areas._area(phase) for phase in areas.areas if phase != 0}
    return Flow("curvature_flow", tension, mobility, dict(areas))

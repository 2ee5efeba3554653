# SPDX-License-Identifier: MIT
"""Flows, other than functions of positions and time."""
import warnings

import numpy as np

from . import _dsc, arrays
from .mesh import Mesh


class Flow:
    """A flow for `Simulation.step`, other than a function of positions and time.

    Made by `swirl`, `growth`, `curvature_flow` and `interface_flow`.
    """

    def __init__(self, name, *given):
        """Calls the function of the compiled part with this name and these arguments."""
        self._name = name
        self._given = given
        self._compiled = getattr(_dsc, name)(*given)

    def __repr__(self):
        return f"<dsc.Flow: {self._name}{self._given}>"

    def __reduce__(self):
        return Flow, (self._name, *self._given)


def interface_flow(function):
    """A flow that depends on the interface.

    Parameters
    ----------
    function : callable
        The thread that called `step` calls `function(interface, time)` with an `Interface`, once in
        each stage of the integrator (`euler`, `midpoint` or `rk4`) for the whole interface. It
        returns velocities (n, 2).

    Returns
    -------
    Flow

    Notes
    -----
    Explicit integrators limit the step of a flow that smooths: for the velocity -curvature *
    normal, dt * 4 / l**2 must be below 2, with l the shortest edge. `curvature_flow` has no limit.

    Normals and curvatures are 0 at junctions, so a velocity made of these alone leaves each junction where
    it is: `interface.arms` has the edges that pull at it.

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
    """Phases grow along their normals; convex features open into arcs.

    The simulation must be made for it: `dsc.Simulation(mesh, flow, edge_length=h)`.

    Parameters
    ----------
    speeds : dict
        `{(growing, into): speed}`, in lengths per time; interfaces of other pairs do not move.

    Returns
    -------
    Flow
    """
    return Flow("growth", arrays.by_key(speeds, "speeds", arrays.pair, "a dict {(growing, into): speed}"))


def curvature_flow(tension=1.0, mobility=1.0, keep_areas_of=None):
    """The interface moves along its normal at tension * mobility * curvature.

    Parameters
    ----------
    tension, mobility : float, dict or (n, n) array_like
        The value of all pairs of phases; or values by pair, `{(one, other): value}`, with 1 for all others;
        or a symmetric matrix whose rows and columns are phases.
    keep_areas_of : Mesh or dict, optional
        Phases with constant areas: each phase but 0 of this mesh with its area, or areas by phase.

    Returns
    -------
    Flow

    Warns
    -----
    UserWarning
        If one of the three tensions of three phases is larger than the other two together: no junction
        is in balance, and the third phase spreads between the first two.

    Examples
    --------
    The tensions of W. T. Read and W. Shockley (1950) for grains whose orientations differ by up to 15 degrees:

    >>> angles = np.radians([0, 4, 9, 13])
    >>> apart = np.abs(angles[:, None] - angles) / np.radians(15)
    >>> tension = apart * (1 - np.log(np.where(apart > 0, apart, 1)))
    >>> flow = dsc.curvature_flow(tension=tension)
    """
    areas = keep_areas_of or {}
    arrays.expect_plane(areas, "curvature_flow")
    if isinstance(areas, Mesh):
        areas = {phase: areas._area(phase) for phase in areas.areas if phase != 0}
    areas = arrays.by_key(areas, "keep_areas_of", arrays.phase, "a Mesh or a dict {phase: area}")
    tension, tensions = _by_pair(tension, "tension")
    mobility, mobilities = _by_pair(mobility, "mobility")
    _warn_of_spreading(tensions)
    pairs = {pair: (tensions.get(pair, tension), mobilities.get(pair, mobility))
             for pair in {**tensions, **mobilities}}
    return Flow("curvature_flow", tension, mobility, pairs, areas)


def _by_pair(given, where):
    """The value of all other pairs, and `{(smaller, larger): value}`."""
    if isinstance(given, dict):
        values = {}
        for pair, value in given.items():
            key = tuple(sorted(arrays.pair(pair, where)))
            if key in values:
                arrays.refuse("a pair is named twice", where, repr(pair), "each pair once, in either order")
            values[key] = arrays.number(value, f"{where}[{pair}]")
        return 1.0, values
    array = arrays.numbers(given, where)
    if array is not None and array.ndim == 0:
        return float(array), {}
    if array is None or array.ndim != 2 or array.shape[0] != array.shape[1]:
        arrays.refuse("neither a number nor values by pair", where, arrays.shown(given),
                      "a number, a dict {(one, other): number} or a matrix (n, n)")
    if not np.array_equal(array, array.T):
        one, other = np.argwhere(array != array.T)[0]
        arrays.refuse("the matrix is not symmetric", where,
                      f"{array[one, other]} for ({one}, {other}) and {array[other, one]} for ({other}, {one})",
                      "the same for both")
    rows, columns = np.triu_indices(len(array), 1)
    return 1.0, dict(zip(zip(rows.tolist(), columns.tolist()), array[rows, columns].tolist()))


def _warn_of_spreading(tensions):
    least = min(tensions.values(), default=0)
    for (one, other), value in tensions.items():
        if value <= 2 * least:  # no two others can add up to less
            continue
        for third in {phase for pair in tensions for phase in pair} - {one, other}:
            sides = [tensions.get(tuple(sorted((phase, third)))) for phase in (one, other)]
            if None not in sides and value > sum(sides):
                warnings.warn(f"no junction of phases {one}, {other} and {third} is in balance: the tension of "
                              f"({one}, {other}) is {value:g}, more than the sum of {sides[0]:g} and {sides[1]:g} of "
                              f"the pairs with {third}, which spreads between them", stacklevel=3)
                return

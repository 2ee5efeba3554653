# SPDX-License-Identifier: MIT
"""Incompressible flow."""
import copy

from . import _dsc, arrays
from .state import sealed, unsealed

SIDES = ("left", "right", "bottom", "top", "other")


class Fluid(_dsc.Fluid):
    """Incompressible flow of two or more phases, which moves the interface of a simulation.

    Parameters
    ----------
    sim : Simulation
    phases : dict
        `{phase: (density, viscosity)}`, for each phase; `{phase: None}` is a void, beside which the
        fluids have a free surface.
    tensions : dict
        `{(one, other): tension}`, for each pair that meets, or `(tension, angle)` with the contact
        angle in degrees between the interface and a slip wall, inside `other`.
    gravity : (2,) array_like
    slip : set of {'left', 'right', 'bottom', 'top', 'other'}, or one of them
        Where the fluid slides along the domain boundary; it rests elsewhere. The first four are the
        sides of the box around the domain; 'other' is the boundary that lies on none of them.
    inertia : bool
        Whether the fluid has inertia; otherwise the Stokes equations are solved.
    tolerance : float
        Target error per step, as a fraction of the edge length, which determines the steps; 0: steps
        of dt.
    threads : int
        Does not change the results.
    """

    def __init__(self, sim, phases, tensions, *, gravity=(0, 0), slip=(), inertia=True, tolerance=0,
                 threads=1):
        """Starts at rest at time 0; without inertia, with the velocity that follows from the interface."""
        arrays.expect_plane(sim.mesh, "Fluid")
        slip = (slip,) if isinstance(slip, str) else slip
        for side in slip:
            if side not in SIDES:
                arrays.refuse("not a side of the domain", "slip", repr(side), ", ".join(SIDES))
        phases = arrays.by_key(phases, "phases", arrays.phase, "a dict {phase: (density, viscosity)}", _material)
        tensions = arrays.by_key(tensions, "tensions", arrays.pair, "a dict {(one, other): tension}", _tension)
        properties = [(phase, *(one or (1, 1)), one is None) for phase, one in phases.items()]
        pairs = [(*pair, *one) for pair, one in tensions.items()]
        super().__init__(sim.mesh, properties, pairs, arrays.point(gravity, "gravity"),
                         [side in slip for side in SIDES], inertia, tolerance, threads)
        self._sim = sim
        self._options = dict(phases=dict(phases), tensions=dict(tensions), gravity=gravity, slip=tuple(slip),
                             inertia=inertia, tolerance=tolerance, threads=threads)

    @property
    def simulation(self):
        """The simulation whose interface the fluid moves."""
        return self._sim

    def __repr__(self):
        return f"<dsc.Fluid: {len(self._options['phases'])} phases, time {self.time:.6g}>"

    def __reduce__(self):
        return _fluid_from, (self._sim, sealed(self._options, self._state()))

    def __copy__(self):
        make, (sim, state) = self.__reduce__()
        return make(copy.copy(sim), state)  # a copy moves a mesh of its own

    def step(self, dt):
        """Advances by dt; with a tolerance, in as many steps as needed.

        Parameters
        ----------
        dt : float

        Returns
        -------
        Report
            The sums over these steps.
        """
        self._sim._compiled.step(self, self.time, dt)
        return self._sim.report


def _fluid_from(sim, state):
    options, inner = unsealed(state, "fluid")
    fluid = Fluid(sim, **options)
    fluid._restore(inner)
    return fluid


def _material(value, where):
    return None if value is None else _two(value, where, "(density, viscosity), or None for a void")


def _tension(value, where):
    if isinstance(value, tuple) and len(value) == 2 and value[1] is None:
        value = value[0]  # as a fluid keeps a tension without an angle
    array = arrays.numbers(value, where)
    if array is not None and array.ndim == 0:
        return float(array), None
    return _two(value, where, "tension, or (tension, angle)")


def _two(value, where, allowed):
    array = arrays.numbers(value, where)
    if array is None or array.shape != (2,):
        arrays.refuse("not two numbers", where, arrays.shown(value), allowed)
    return array.tolist()

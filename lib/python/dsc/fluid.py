# SPDX-License-Identifier: MIT
"""Incompressible flow."""
from . import _dsc, arrays

SIDES = ("left", "right", "bottom", "top")


class Fluid(_dsc.Fluid):
    """Incompressible flow of two and more phases, which moves the interface of a simulation.

    Parameters
    ----------
    sim : Simulation
    phases : dict
        `{phase: (density, viscosity)}`, for each phase; None in their place: a void, with a free
        surface around it.
    tensions : dict
        `{(one, other): tension}`, for each pair that meets, or `(tension, angle)`: in degrees,
        between the interface and a wall that slips, inside `other`.
    gravity : (2,) array_like
    slip : set of {'left', 'right', 'bottom', 'top'}, or one of them
        The sides of the domain along which the fluid slides; it rests at the others.
    inertia : bool
        Whether it has any: else the equations are those of Stokes.
    tolerance : float
        Error per step, as a share of the edge length, from which the steps are chosen; 0: those
        asked for.
    threads : int
        Any number gives the same bits.
    """

    def __init__(self, sim, phases, tensions, *, gravity=(0, 0), slip=(), inertia=True, tolerance=0,
                 threads=1):
        """At rest, at time 0; without inertia at the velocity that the interface gives."""
        slip = (slip,) if isinstance(slip, str) else slip
        for side in slip:
            if side not in SIDES:
                arrays.refuse("no side of the domain", "slip", repr(side), ", ".join(SIDES))
        properties = [(phase, *((1, 1) if one is None else one), one is None)
                      for phase, one in phases.items()]
        pairs = [(*pair, *(one if isinstance(one, (tuple, list)) else (one, None)))
                 for pair, one in tensions.items()]
        super().__init__(sim.mesh, properties, pairs, arrays.point(gravity, "gravity"),
                         [side in slip for side in SIDES], inertia, tolerance, threads)
        self._sim = sim

    def step(self, dt):
        """Moves on by dt, with a tolerance in as many steps as it takes.

        Parameters
        ----------
        dt : float

        Returns
        -------
        Report
            Of all of these steps.
        """
        self._sim._step(self, self.time, dt)
        return self._sim.report

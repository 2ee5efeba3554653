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
    slip : set of sides, or one of them
        Where the fluid slides along the domain boundary; it rests on the other sides. These are 'left',
        'right', 'bottom' and 'top' of the box around the domain, 'other' for the boundary that lies on
        none of them, and the names that the mesh has for its own (`Mesh.sides`).
    open : set of sides, or one of them
        Where the fluid flows out, or in, without stress. Unless a side is open, what flows in has to
        flow out.
    inflow : dict
        `{side: speed}`: the speed at which the fluid flows in at a right angle, a number or a function of
        x, y and the time; negative where it flows out.
    velocity : dict
        `{side: (u, v)}`, or such a function: the velocity of a wall, such as a lid.
    inertia : bool
        Whether the fluid has inertia; otherwise the Stokes equations are solved.
    tolerance : float
        Target error per step, as a fraction of the edge length, which determines the steps; 0: steps
        of dt.
    threads : int
        Does not change the results.
    """

    def __init__(self, sim, phases, tensions, *, gravity=(0, 0), slip=(), open=(), inflow=None,
                 velocity=None, inertia=True, tolerance=0, threads=1):
        """Starts at rest at time 0; without inertia, with the velocity that follows from the interface."""
        arrays.expect_plane(sim.mesh, "Fluid")
        slip, open = ((one,) if isinstance(one, str) else tuple(one) for one in (slip, open))
        inflow, velocity = inflow or {}, velocity or {}
        edges, names = sim.mesh._sides
        sides = _sides(dict(slip=slip, open=open, inflow=inflow, velocity=velocity), [*sim.mesh.sides, *SIDES])
        phases = arrays.by_key(phases, "phases", arrays.phase, "a dict {phase: (density, viscosity)}", _material)
        tensions = arrays.by_key(tensions, "tensions", arrays.pair, "a dict {(one, other): tension}", _tension)
        properties = [(phase, *(one or (1, 1)), one is None) for phase, one in phases.items()]
        pairs = [(*pair, *one) for pair, one in tensions.items()]
        super().__init__(sim.mesh, properties, pairs, arrays.point(gravity, "gravity"),
                         sides, edges.reshape(-1, 2), names, inertia, tolerance, threads)
        self._sim = sim
        self._options = dict(phases=dict(phases), tensions=dict(tensions), gravity=gravity, slip=slip, open=open,
                             inflow=dict(inflow), velocity=dict(velocity), inertia=inertia, tolerance=tolerance, threads=threads)

    @property
    def simulation(self):
        """The simulation whose interface the fluid moves."""
        return self._sim

    def __repr__(self):
        return f"<dsc.Fluid: {len(self._options['phases'])} phases, time {self.time:.6g}>"

    def __reduce__(self):
        return _fluid_from, (self._sim, sealed("Fluid", options=self._options, state=self._state()))

    def __copy__(self):
        return self.__deepcopy__({})  # a copy moves a mesh of its own

    def __deepcopy__(self, memo):
        return _begun(copy.deepcopy(self._sim, memo), self._options, self._state())

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
    return _begun(sim, *unsealed(state, "Fluid", "options", "state"))


def _begun(sim, options, state):
    fluid = Fluid(sim, **options)
    fluid._restore(state)
    return fluid


def _sides(given, names):
    """The conditions of all sides: (name, kind, function)."""
    of_side = {}
    for kind, sides in given.items():
        if kind in ("inflow", "velocity"):
            arrays.by_key(sides, kind, lambda one, where: one, "a dict {side: value}", lambda one, where: one)
        for side in sides:
            if side not in names:
                arrays.refuse("not a side of the domain", kind, repr(side), ", ".join(dict.fromkeys(names)))
            if side in of_side:
                arrays.refuse("two conditions on one side", kind, repr(side), f"{of_side[side]} or {kind}")
            of_side[side] = kind
    functions = {side: _function(value, f"{kind}[{side!r}]", count)
                 for kind, count in (("inflow", 1), ("velocity", 2)) for side, value in given[kind].items()}
    return [(name, of_side.get(name, "no_slip"), functions.get(name)) for name in dict.fromkeys(names)]


def _function(value, where, count):
    """A function of x, y and the time that returns one number or two."""
    def checked(one):
        array = arrays.numbers(one, where)
        if array is None or array.shape != ((), (2,))[count - 1]:
            arrays.refuse(("not a number", "not two numbers")[count - 1], where, arrays.shown(one),
                          ("a speed", "(u, v)")[count - 1] + ", or a function of x, y and the time that returns it")
        return array.tolist()

    if callable(value):
        return lambda x, y, time: checked(value(x, y, time))
    constant = checked(value)
    return lambda x, y, time: constant


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

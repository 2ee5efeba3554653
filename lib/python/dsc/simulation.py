# SPDX-License-Identifier: MIT
"""Simulations: the compiled part, with reports, flows and pickling."""
from . import _dsc, arrays
from .flows import Flow
from .records import Event, Report
from .state import sealed, unsealed


class Simulation(_dsc.Simulation):
    __doc__ = f"""Moves the interface of a mesh and keeps the mesh a valid complex.
A mesh has at most one simulation at a time.

Parameters
----------
mesh : Mesh
flow : Flow, optional
    A flow that needs a simulation of its own kind: `growth`.
**options
    The following ones.
{_dsc.option_help}"""

    def __init__(self, mesh, flow=None, **options):
        """Starts at time 0. The mesh belongs to the simulation until the simulation is deleted."""
        super().__init__(mesh, getattr(flow, "_compiled", flow), options)
        self._flow = flow

    @property
    def flow(self):
        """The flow given to the constructor, or None."""
        return self._flow

    def step(self, flow, time, dt):
        """Moves the interface from `time` to `time + dt`.

        Parameters
        ----------
        flow : callable or Flow
            A function of positions (n, 2) and the time, which returns velocities (n, 2). The thread
            that called `step` calls it once in each stage of the integrator, for all interface
            vertices. `step` passes on its exceptions; the mesh is then valid but has not reached
            the end of the step: `time` and `report` say how far it came.
        time, dt : float

        Returns
        -------
        Report
        """
        if isinstance(flow, Flow):
            compiled = flow._compiled
        elif callable(flow):
            compiled = _dsc.velocity(flow)
        else:
            arrays.refuse("not a flow", "Simulation.step", arrays.shown(flow),
                          "a function of positions (n, 2) and time, or a dsc.Flow")
        self._step(compiled, time, dt)
        return self.report

    @property
    def report(self):
        """The `Report` of the last step, also if it ended by an exception."""
        told = self._report()
        events = [Event(**event) for event in told.pop("events")]
        return Report(**told, events=events)

    def __repr__(self):
        return f"<dsc.Simulation: {self.interface_size} interface vertices, time {self.time:.6g}>"

    def __reduce__(self):
        return _simulation_from, (self.mesh, sealed(self.options, self.flow, self._state()))

    def __copy__(self):
        make, (mesh, state) = self.__reduce__()
        return make(mesh.copy(), state)  # a mesh has at most one simulation


def _simulation_from(mesh, state):
    options, flow, inner = unsealed(state, "simulation")
    sim = Simulation(mesh, flow, **options)
    sim._restore(inner)
    return sim

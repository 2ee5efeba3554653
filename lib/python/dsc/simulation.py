# SPDX-License-Identifier: MIT
"""Simulations: the compiled part, with reports, flows and pickling."""
import copy
import types

from . import _dsc, arrays
from .flows import Flow
from .mesh3 import Mesh3
from .records import Event, Report, Report3
from .state import sealed, unsealed


class Simulation:
    __doc__ = f"""Moves the interface of a mesh and keeps the mesh a valid complex.
A mesh has at most one simulation at a time.

Parameters
----------
mesh : Mesh or Mesh3
flow : Flow, optional
    A flow that needs a simulation of its own kind: `growth`. Not for a `Mesh3`.
**options
    For a `Mesh`, the following ones.
{_dsc.option_help}
Other Parameters
----------------
**options
    For a `Mesh3`, the following ones.
{_dsc.option3_help}"""

    __class_getitem__ = classmethod(types.GenericAlias)  # Simulation[Mesh3], for annotations

    def __init__(self, mesh, flow=None, **options):
        """Starts at time 0. The mesh belongs to the simulation until the simulation is deleted."""
        if isinstance(mesh, Mesh3):
            if flow is not None:
                arrays.refuse("a flow that needs a simulation of its own kind", "Simulation of a Mesh3",
                              arrays.shown(flow), "None: give the velocity to `step`")
            self._compiled = _dsc.Simulation3(mesh, options)
        else:
            self._compiled = _dsc.Simulation(mesh, getattr(flow, "_compiled", flow), options)
        self._flow = flow

    @property
    def mesh(self):
        """The mesh that moves."""
        return self._compiled.mesh

    @property
    def time(self):
        """The time that the last step reached, also if it ended by an exception."""
        return self._compiled.time

    @property
    def options(self):
        """All options: a dict."""
        return self._compiled.options

    @property
    def interface_size(self):
        """The number of interface vertices."""
        return self._compiled.interface_size

    @property
    def flow(self):
        """The flow given to the constructor, or None."""
        return self._flow

    def step(self, flow, time, dt):
        """Moves the interface from `time` to `time + dt`.

        Parameters
        ----------
        flow : callable or Flow
            A function of positions (n, 2) and the time, which returns velocities (n, 2); for a `Mesh3`,
            (n, 3) and (n, 3). The thread that called `step` calls it once in each stage of the
            integrator, for all interface vertices. `step` passes on its exceptions; the mesh is then
            valid but has not reached the end of the step: `time` and `report` say how far it came.
            Flows of the library are for a `Mesh`.
        time, dt : float

        Returns
        -------
        Report
            For a `Mesh3`, a `Report3`.
        """
        in_space = isinstance(self._compiled, _dsc.Simulation3)
        if isinstance(flow, Flow) and not in_space:
            compiled = flow._compiled
        elif callable(flow):
            compiled = flow if in_space else _dsc.velocity(flow)
        else:
            arrays.refuse("not a flow", "Simulation.step", arrays.shown(flow),
                          "a function of positions (n, 3) and time" if in_space else
                          "a function of positions (n, 2) and time, or a dsc.Flow")
        self._compiled.step(compiled, time, dt)
        return self.report

    @property
    def report(self):
        """The `Report` of the last step, or `Report3`, also if it ended by an exception."""
        told = self._compiled.report()
        if isinstance(self._compiled, _dsc.Simulation3):
            return Report3(**told)
        events = [Event(**event) for event in told.pop("events")]
        return Report(**told, events=events)

    def __repr__(self):
        return f"<dsc.Simulation: {self.interface_size} interface vertices, time {self.time:.6g}>"

    def __reduce__(self):
        return _simulation_from, (self.mesh, sealed("simulation", options=self.options, flow=self.flow,
                                                    state=self._compiled.state()))

    def __copy__(self):
        return self.__deepcopy__({})  # a mesh has at most one simulation

    def __deepcopy__(self, memo):
        return _begun(copy.deepcopy(self.mesh, memo), self.options, copy.copy(self.flow), self._compiled.state())


def _simulation_from(mesh, state):
    return _begun(mesh, *unsealed(state, "simulation", "options", "flow", "state"))


def _begun(mesh, options, flow, state):
    sim = Simulation(mesh, flow, **options)
    sim._compiled.restore(state)
    return sim

# SPDX-License-Identifier: MIT
"""What the compiled part tells: plain records, which can be kept, compared and pickled.

The types of their fields are in the stub: an import of `typing` would take as long as all others.
"""
from collections import namedtuple

from . import _dsc


class Curve(namedtuple("Curve", "points is_closed left right")):
    """A piece of the interface between two phases.

    Attributes
    ----------
    points : (n, 2) array
        In order along the curve.
    is_closed : bool
        Whether the last point is joined to the first.
    left, right : int
        The phases on both sides of the way along it; 0 beyond the sides of the domain.
    """

    __slots__ = ()


class InputReport(namedtuple("InputReport", "points thinned deviation area_changed dropped area_dropped "
                             "clipped")):
    """What was left out of shapes or curves because the mesh is too coarse for it.

    Attributes
    ----------
    points : int
        How many there were.
    thinned : int
        Points left out of the interface.
    deviation : float
        The largest distance of these from the interface.
    area_changed : float
        By leaving them out: the sum over all curves of the net change.
    dropped : int
        Shapes that are too small.
    area_dropped : float
        Of these shapes.
    clipped : int
        Outlines and holes that were cut at the sides of the domain.

    As a text, it has a sentence for each thing that was left out.
    """

    __slots__ = ()

    def __str__(self):
        return "\n".join(_dsc.sentences(*self))


class Event(namedtuple("Event", "kind time place lost taken area")):
    """A change of topology.

    Attributes
    ----------
    kind : {'merge', 'split', 'meet', 'widen', 't1', 'fill', 'remove'}
        A film of one phase opened between two pieces of another one, a neck closed, two phases
        border on each other now, an earlier film opened farther, a vertex of too many sectors came
        apart, a piece of phase 0 vanished, a piece of another phase did.
    time : float
        At the end of the sub-step.
    place : (float, float)
    lost : int
        The phase whose area it was.
    taken : (int, int)
        The phases that took the area.
    area : float
        That changed hands.
    """

    __slots__ = ()


class Report(namedtuple("Report", "unreached held sub_steps interface_vertices reached gave_up events reason")):
    """What one step did.

    Attributes
    ----------
    unreached : int
        Vertices that did not arrive, summed over sub-steps.
    held : int
        Of these: held because of a velocity that was not finite.
    sub_steps : int
        How many the step was cut into.
    interface_vertices : int
        At the end of the step.
    reached : float
        The time at the end: earlier than asked for if the step gave up.
    gave_up : str
        Empty if the step was done as a whole; else `too_many_sub_steps` (of the velocity),
        `too_many_passes` (of a sub-step), `velocity_jumps` (`adaptive`) or `interrupted`.
    events : list of Event
        Changes of topology, in their order.
    reason : str
        Why the step gave up and what may help, as a sentence; empty if it did not give up.
    """

    __slots__ = ()


class Interface:
    """The interface at one stage of the integrator, for a function that `interface_flow` takes.

    Entry i of each array is the same vertex; neighbours are positions in these arrays. Curves run so
    that the larger of their two phases is on the left. -1 stands for none: at junctions, and for the
    outside of the domain.

    Attributes
    ----------
    positions : (n, 2) array
    previous, next : (n,) arrays of int
        The neighbours along the curve.
    left, right : (n,) arrays of int
        The phases on both sides.
    normals : (n, 2) array
        Unit normals from left to right; 0 at junctions.
    curvatures : (n,) array
        Positive where the left phase is convex; 0 at junctions.
    lengths : (n,) array
        Half of the edges of each vertex.
    arms : (k, 4) array of int
        Edges that leave junctions: rows of junction, neighbour, phase on the left and phase on the
        right, counter-clockwise about each junction.
    is_junction, is_feature, is_on_boundary, is_locked : (n,) arrays of bool
        No point of a single curve; kept, without a tangent; can only slide along the domain
        boundary; stays.
    """

    def __init__(self, **arrays):
        self.__dict__.update(arrays)

    def __len__(self):
        return len(self.positions)

    def __repr__(self):
        return f"<dsc.Interface: {len(self)} vertices, {self.is_junction.sum()} junctions>"

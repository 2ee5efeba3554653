# SPDX-License-Identifier: MIT
"""Reports of the compiled part as plain records, which can be stored, compared and pickled.
The types of their fields are in the stub: importing `typing` would take as long as everything else.
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
        The phases on both sides in the direction of the curve; 0 outside the domain.
    """

    __slots__ = ()


class InputReport(namedtuple("InputReport", "points thinned deviation area_changed dropped area_dropped "
                             "clipped")):
    """The detail of shapes or curves that was left out because it is too fine for the mesh.

    Attributes
    ----------
    points : int
        The number of points given.
    thinned : int
        Points left out of the interface.
    deviation : float
        The largest distance of the points left out from the interface.
    area_changed : float
        The change of area by the points left out: the sum of the net changes of all curves.
    dropped : int
        Shapes left out because they are too small.
    area_dropped : float
        The area of these shapes.
    clipped : int
        Outlines and holes that were cut at the sides of the domain.

    `str` gives a sentence for each kind of detail that was left out.
    """

    __slots__ = ()

    def __str__(self):
        return "\n".join(_dsc.sentences(*self))


class Event(namedtuple("Event", "kind time place lost taken area")):
    """A change of topology.

    Attributes
    ----------
    kind : {'merge', 'split', 'meet', 'widen', 't1', 'fill', 'remove'}
        'merge': a film of one phase opened between two pieces of another one; 'split': a neck closed;
        'meet': two phases have a common border now; 'widen': an earlier film opened farther;
        't1': an unstable junction was split; 'fill': a piece of phase 0 vanished;
        'remove': a piece of another phase vanished (T2).
    time : float
        The end of the sub-step.
    place : (float, float)
    lost : int
        The phase that lost the area.
    taken : (int, int)
        The phases that gained the area.
    area : float
        The area that changed its phase.
    """

    __slots__ = ()


def _shown(report, *more):
    """A line on a report for its `repr`: lists of reports stay readable."""
    parts = [f"time {report.reached:.6g}", f"{report.interface_vertices} interface vertices",
             f"{report.unreached} unreached", *more, *([report.gave_up] if report.gave_up else [])]
    return f"<dsc.{type(report).__name__}: {', '.join(parts)}>"


class Report(namedtuple("Report", "unreached held sub_steps interface_vertices reached gave_up events reason")):
    """The report of a step.

    Attributes
    ----------
    unreached : int
        Vertices that did not arrive, summed over sub-steps.
    held : int
        Of these, the vertices whose velocity was not finite.
    sub_steps : int
        The number of sub-steps.
    interface_vertices : int
        At the end of the step.
    reached : float
        The time at the end; earlier than `time + dt` if the step gave up.
    gave_up : str
        Empty if the step was completed; else `too_many_sub_steps` (the velocity is too large),
        `too_many_passes` (in a sub-step), `velocity_jumps` (with `adaptive`) or `interrupted`.
    events : list of Event
        The changes of topology, in their order.
    reason : str
        Why the step gave up and what may help, as a sentence; empty if it did not give up.
    """

    __slots__ = ()

    def __repr__(self):
        return _shown(self, *([f"{len(self.events)} event{'s' * (len(self.events) > 1)}"] if self.events else []))


class Report3(namedtuple("Report3", "unreached held sub_steps interface_vertices reached gave_up reason passes "
                         "unjammed error operations")):
    """The report of a step of a `Mesh3`.

    Attributes
    ----------
    unreached, held, sub_steps, interface_vertices, reached
        As in `Report`.
    gave_up : str
        Empty if the step was completed; `too_many_sub_steps` if the velocity is too large, or jumps.
    reason : str
        Why the step gave up, as a sentence; empty if it did not give up.
    passes : int
        Of movement and mesh repair, summed over sub-steps.
    unjammed : int
        Interface edges that were collapsed under relaxed rules, to let vertices arrive.
    error : float
        The largest estimate of the error of the adaptive integrator, a length.
    operations : dict of int
        What was done, by name: `splits`, `collapses`, `edge_removals`, `face_flips` and `smoothings`
        inside a phase; `interface_splits`, `interface_collapses` and `interface_flips` of edges of the
        interface; `reassigned`: flat tets on the interface that changed their phase.
    """

    __slots__ = ()

    def __repr__(self):
        return _shown(self)


class Faces(namedtuple("Faces", "triangles inside outside")):
    """The faces of the interface of a `Mesh3`.

    Attributes
    ----------
    triangles : (k, 3) array of int
        Rows of `mesh.points`, counter-clockwise as seen from the outside.
    inside, outside : (k,) arrays of int
        The phases on both sides; `inside` is the higher one.
    """

    __slots__ = ()


class Interface:
    """The interface at one stage of the integrator, for the function of an `interface_flow`.

    Entry i of all arrays belongs to the same vertex; neighbours are indices into these arrays. Curves
    run with the larger of their two phases on the left. -1 means none: at junctions, and outside the
    domain.

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
        Half the length of the two edges of each vertex.
    arms : (k, 4) array of int
        The edges at junctions: rows of junction, neighbour, phase on the left and phase on the
        right, counter-clockwise around each junction.
    is_junction, is_feature, is_on_boundary, is_locked : (n,) arrays of bool
        Whether a vertex does not lie on a single curve; is kept and has no tangent; can only slide
        along the domain boundary; never moves.
    """

    def __init__(self, **arrays):
        self.__dict__.update(arrays)

    def __len__(self):
        return len(self.positions)

    def __repr__(self):
        return f"<dsc.Interface: {len(self)} vertices, {self.is_junction.sum()} junctions>"

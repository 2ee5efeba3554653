# SPDX-License-Identifier: MIT
"""Shapes in space, as signed distances: negative inside, positive outside."""
import os

import numpy as np

from . import _dsc, arrays


class Shape3:
    """A shape in space, for `initial_complex`.

    Made by `ball`, `box`, `ellipsoid`, `torus` and `closed_surface`. A call with points (n, 3) returns their
    signed distances (n,), negative inside, so that shapes can be combined by numpy; such a function is a
    shape too.

    Examples
    --------
    >>> one, other = dsc.ball((0.4, 0.5, 0.5), 0.2), dsc.ball((0.6, 0.5, 0.5), 0.2)
    >>> one([(0.4, 0.5, 0.5), (0.9, 0.5, 0.5)]).round(12)
    array([-0.2,  0.3])
    >>> both = lambda points: np.minimum(one(points), other(points))
    >>> mesh = dsc.initial_complex(((0, 0, 0), (1, 1, 1)), {1: both}, edge_length=0.1)
    """

    def __init__(self, name, *given):
        """Calls the function of the compiled part with this name and these arguments."""
        self._name = name
        self._given = given
        self._compiled = getattr(_dsc, name)(*given)

    def __call__(self, points):
        return self._compiled(arrays.points(points, "points", width=3))

    def __repr__(self):
        return f"<dsc.Shape3: {self._name}>"

    def __reduce__(self):
        return Shape3, (self._name, *self._given)


def ball(centre, radius):
    """A ball.

    Parameters
    ----------
    centre : (3,) array_like
    radius : float

    Returns
    -------
    Shape3
    """
    return Shape3("ball", arrays.points([centre], "centre", 1, 3), arrays.length(radius, "radius"))


def box(low, high):
    """A box with sides parallel to the axes; its edges are rounded over an edge length.

    Parameters
    ----------
    low, high : (3,) array_like
        The corners with the smallest and with the largest coordinates.

    Returns
    -------
    Shape3
    """
    corners = arrays.points([low, high], "low, high", 2, 3)
    if not (corners[0] < corners[1]).all():
        arrays.refuse("not a box", "box", f"low {corners[0].tolist()}, high {corners[1].tolist()}",
                      "high beyond low in each coordinate")
    return Shape3("box", corners)


def ellipsoid(centre, radii):
    """An ellipsoid with axes parallel to the coordinate axes.

    Parameters
    ----------
    centre, radii : (3,) array_like

    Returns
    -------
    Shape3
    """
    radii = [[arrays.length(one, "radii") for one in arrays.points([radii], "radii", 1, 3)[0]]]
    return Shape3("ellipsoid", arrays.points([centre], "centre", 1, 3), radii)


def torus(centre, axis, circle_radius, tube_radius):
    """A tube around a circle.

    Parameters
    ----------
    centre, axis : (3,) array_like
    circle_radius, tube_radius : float

    Returns
    -------
    Shape3
    """
    return Shape3("torus", arrays.points([centre], "centre", 1, 3), arrays.points([axis], "axis", 1, 3),
                  arrays.length(circle_radius, "circle_radius"), arrays.length(tube_radius, "tube_radius"))


def closed_surface(points, triangles=None):
    """The inside of a closed surface, which may have several parts; a part inside another is a hollow.

    Parameters
    ----------
    points : (n, 3) array_like, or the path of a file
        meshio reads the file, such as .stl, .ply and .obj. Points with equal coordinates are merged.
    triangles : (k, 3) array_like of int
        Rows of `points`, in either orientation; not with a path.

    Returns
    -------
    Shape3

    Raises
    ------
    InputError
        With the place, if an edge does not have two triangles, or two triangles cross each other.
    """
    name = "surface"
    if isinstance(points, (str, os.PathLike)):
        name = os.fspath(points)
        points, triangles = _surface_in(name)
    elif triangles is None:
        arrays.refuse("no triangles", "closed_surface", "points alone", "points and triangles, or the path of a file")
    points = arrays.points(points, "points", width=3)
    triangles = arrays.whole_numbers(triangles, "triangles", "(k, 3)", 2)
    if triangles.shape[1] != 3:
        arrays.refuse("not triangles", "triangles", f"an array of the shape {triangles.shape}", "the shape (k, 3)")
    points, rows = np.unique(points, axis=0, return_inverse=True)
    if triangles.max(initial=0) < len(rows.ravel()):  # else the library names the index
        triangles = rows.ravel()[triangles]
    return Shape3("closed_surface", points, triangles.astype(np.uint32), name)


def _surface_in(path):
    import meshio

    try:
        mesh = meshio.read(path)
    except meshio.ReadError as error:
        raise _dsc.FileError(f"{path}: cannot be read: {error}") from error
    triangles = [block.data for block in mesh.cells if block.type == "triangle"]
    if not triangles:
        arrays.refuse("no triangles", path, f"{len(mesh.cells)} blocks of other cells", "at least one triangle")
    return mesh.points, np.vstack(triangles)


def _shape(value, where):
    """The compiled part of a shape."""
    if isinstance(value, Shape3):
        return value._compiled
    if not callable(value):
        arrays.refuse("not a shape", where, arrays.shown(value), "a dsc.Shape3, such as dsc.ball((0, 0, 0), 1), or "
                      "a function of points (n, 3) that returns signed distances (n,)")
    return _dsc.shape(value)


def _inside(value, where):
    """A phase, or a dict of the phases that a shape divides."""
    if isinstance(value, dict):
        return {arrays.phase(one, where): arrays.phase(other, where) for one, other in value.items()}
    return arrays.phase(value, where)


def is_in_space(domain, shapes):
    """Whether a first mesh with this domain and these shapes is one in space. Raises InputError."""
    try:
        corners = np.asarray(domain, float)
    except (TypeError, ValueError):  # no array: a polygon with holes, or an object
        corners = np.empty(0)
    is_box = corners.shape == (2, 3)
    if is_box and corners[0, 2] != corners[1, 2]:
        return True
    given = shapes.values() if isinstance(shapes, dict) else shapes if isinstance(shapes, (list, tuple)) else [shapes]
    given = [one for several in given for one in (several if isinstance(several, (list, tuple)) else [several])]
    if any(isinstance(one, Shape3) for one in given):
        arrays.refuse("no domain for a shape in space", "domain", arrays.shown(domain),
                      "the two corners of a box: three coordinates each, of which none is equal")
    return False


def shapes_of(value):
    """The shapes of `initial_complex` in space as pairs for the compiled part. Raises InputError."""
    if value is None:
        return []
    if isinstance(value, dict):
        value = [(shape, phase) for phase, given in value.items()
                 for shape in (given if isinstance(given, (list, tuple)) else [given])]
    pairs = []
    try:
        given = [(shape, inside) for shape, inside in value]
    except (TypeError, ValueError):
        arrays.refuse("not shapes", "shapes", arrays.shown(value),
                      "a dict {phase: shape}, or a list of (shape, phase) and (shape, {divided phase: phase inside})")
    for k, (shape, inside) in enumerate(given):
        pairs.append((_shape(shape, f"shapes[{k}]"), _inside(inside, f"shapes[{k}]")))
    return pairs

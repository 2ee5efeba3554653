# SPDX-License-Identifier: MIT
"""The sides of a domain: the straight edges of its boundary as given, and the name of each."""
import numpy as np

from . import arrays


def none():
    """The sides of a domain whose edges have no names."""
    return np.empty((0, 2, 2)), []


def of_rings(rings, sides):
    """The edges of a polygon's rings with their names: for each ring a name, a name for each edge, or None."""
    if sides is None:
        return none()
    if len(rings) == 1 and len(rings[0]) == 2:
        arrays.refuse("names for the sides of a rectangle", "sides", arrays.shown(sides),
                      "a polygon; the sides of a rectangle are left, right, bottom and top")
    if not isinstance(sides, (str, list, tuple)):
        arrays.refuse("not names of sides", "sides", arrays.shown(sides),
                      "for each ring of the domain a name, a list of names or None")
    given = [sides] if isinstance(sides, str) else list(sides)
    if len(given) != len(rings):
        arrays.refuse("not one entry for each ring of the domain", "sides",
                      f"{len(given)} for {len(rings)} rings", "a name, a list of names or None for each ring")
    edges, names = [], []
    for k, (ring, of_ring) in enumerate(zip(rings, given)):
        ring = np.asarray(ring, float)
        if (ring[0] == ring[-1]).all():
            ring = ring[:-1]
        of_ring = list(of_ring) if isinstance(of_ring, (list, tuple)) else [of_ring] * len(ring)
        if len(of_ring) != len(ring):
            arrays.refuse("not one name for each edge", f"sides[{k}]", f"{len(of_ring)} names for {len(ring)} edges",
                          "one name for the ring, or one for each edge")
        edges.append(np.stack((ring, np.roll(ring, -1, axis=0)), axis=1))
        names += [_name(one, f"sides[{k}]") for one in of_ring]
    return np.concatenate(edges), names


def of_triangles(points, triangles, sides):
    """The edges of the boundary of triangles, with the names of those in a dict of rows of points."""
    if not sides:
        return none()
    boundary = boundary_of(triangles)
    name_of = {}
    for name, rows in sides.items():
        rows = arrays.whole_numbers(rows, f"sides[{name!r}]", "(k, 2)", 2)
        for row in np.sort(rows, axis=1).tolist():
            if tuple(row) not in boundary:
                arrays.refuse("not an edge of the boundary of the triangles", f"sides[{name!r}]", str(row),
                              "rows of two points of such an edge")
            name_of[tuple(row)] = _name(name, "sides")
    edges = sorted(boundary)
    return np.asarray(points, float)[np.array(edges)], [name_of.get(edge, "") for edge in edges]


def boundary_of(triangles):
    """The edges of only one triangle: a set of pairs of rows, each ascending."""
    corners = np.asarray(triangles)
    edges = np.sort(np.concatenate((corners[:, :2], corners[:, 1:], corners[:, ::2])), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    return set(map(tuple, edges[counts == 1].tolist()))


def by_name(sides):
    """A dict of the edges (k, 2, 2) of each side."""
    edges, names = sides
    return {name: edges[[one == name for one in names]] for name in dict.fromkeys(names) if name}


def _name(value, where):
    if value is not None and not isinstance(value, str):
        arrays.refuse("not a name of a side", where, arrays.shown(value), "a text, or None")
    return value or ""

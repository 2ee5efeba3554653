# SPDX-License-Identifier: MIT
"""Measures of outlines, such as those of `Mesh.outlines`, and of the grains of a mesh.

Outlines are one array (n, 2) or a list of such arrays.
"""
import numpy as np

from . import _dsc
from .arrays import expect_plane, outlines as _outlines, point


def symmetric_difference(first, second):
    """The area that lies in only one of two regions, exact up to rounding.

    Parameters
    ----------
    first, second : (n, 2) array_like, or a list of them
        Outlines, such as `mesh.outlines(1)`; a point is inside if it is inside an odd number of them.

    Returns
    -------
    float

    Examples
    --------
    >>> one = [(0, 0), (2, 0), (2, 1), (0, 1)]
    >>> other = [(1, 0), (3, 0), (3, 1), (1, 1)]
    >>> dsc.symmetric_difference(one, other)
    2.0
    """
    return _dsc.symmetric_difference(_outlines(first, "first"), _outlines(second, "second"))


def hausdorff(first, second):
    """The largest distance from a point of either set of outlines to the other one.

    Parameters
    ----------
    first, second : (n, 2) array_like, or a list of them

    Returns
    -------
    float
    """
    return _dsc.hausdorff(_outlines(first, "first"), _outlines(second, "second"))


def area(outlines):
    """The area inside outlines that run counter-clockwise, clockwise around holes.

    Parameters
    ----------
    outlines : (n, 2) array_like, or a list of them

    Returns
    -------
    float
    """
    return _dsc.area(_outlines(outlines, "outlines"))


def circle(centre, radius, edge_length):
    """An outline whose edges are at most `edge_length` long.

    Parameters
    ----------
    centre : (2,) array_like
    radius, edge_length : float

    Returns
    -------
    (n, 2) array
        Counter-clockwise; the first vertex is at angle 0.
    """
    return _dsc.circle(*point(centre, "centre"), radius, edge_length)


def grains(mesh):
    """Figures of the grains of a microstructure, in which each phase is a grain.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    dict of (n,) arrays
        By ascending `phase`: `area`; `perimeter`, without edges on the domain boundary; `radius` of a
        disc of this area; `neighbours`, the number of phases with a common edge; `sides`, the number
        of its curves between junctions or ends at the domain boundary, and of closed curves around it
        or inside it (one for each neighbour); `at_boundary`, whether it touches the domain boundary.
        `pandas.DataFrame` accepts this dict.

    Examples
    --------
    >>> list(dsc.grains(mesh))
    ['phase', 'area', 'perimeter', 'radius', 'neighbours', 'sides', 'at_boundary']
    """
    expect_plane(mesh, "grains")
    phases, grain = np.unique(mesh.phases, return_inverse=True)
    n, outside = len(phases), -1
    # Directed edges with their grain on the left, and the grain across each edge.
    tails, heads = mesh.triangles.T.ravel(), np.roll(mesh.triangles, -1, axis=1).T.ravel()
    order = np.lexsort((tails > heads, np.maximum(tails, heads), np.minimum(tails, heads)))
    tails, heads, left = tails[order], heads[order], np.tile(grain, 3)[order]
    beside = np.zeros(len(order), dtype=int)
    twins = np.flatnonzero((tails[1:] == heads[:-1]) & (heads[1:] == tails[:-1]))
    beside[twins], beside[twins + 1] = 1, -1
    right = np.where(beside == 0, outside, left[np.arange(len(order)) + beside])
    edges = np.flatnonzero(left != right)
    tails, heads, left, right = tails[edges], heads[edges], left[edges], right[edges]
    inside = right != outside
    # A side begins at a vertex where an edge of a pair of grains starts and no edge of the same pair ends.
    ends = np.r_[np.c_[left, right, heads], np.c_[left, right, tails]][np.r_[inside, inside]]
    places, number = np.unique(ends, axis=0, return_inverse=True)
    in_and_out = np.bincount(number, np.repeat([-1, 1], len(ends) // 2), len(places))
    begun = places[in_and_out > 0, :2]
    pairs = np.unique(np.c_[left, right][inside], axis=0)
    # A pair that meets only in closed curves has one side.
    first = np.unique(np.r_[begun, pairs], axis=0, return_index=True)[1]
    sides = np.bincount(np.r_[begun, pairs[first[first >= len(begun)] - len(begun)]][:, 0], minlength=n)
    neighbours = np.bincount(pairs[:, 0], minlength=n)
    lengths = np.hypot(*(mesh.points[heads] - mesh.points[tails])[inside].T)
    a, b, c = np.moveaxis(mesh.points[mesh.triangles], 1, 0)
    area = np.bincount(grain, np.linalg.det(np.stack((b - a, c - a), axis=1)) / 2, n)
    return {"phase": phases, "area": area, "perimeter": np.bincount(left[inside], lengths, n),
            "radius": np.sqrt(area / np.pi), "neighbours": neighbours, "sides": sides,
            "at_boundary": np.bincount(left[~inside], minlength=n) > 0}

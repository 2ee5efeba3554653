# SPDX-License-Identifier: MIT
"""Measures of outlines, such as those of `Mesh.outlines`.

What is given is one outline, (n, 2), or a list of them.
"""
from . import _dsc
from .arrays import outlines as _outlines, point


def symmetric_difference(first, second):
    """The area that belongs to one of two regions alone, exact up to rounding.

    Parameters
    ----------
    first, second : (n, 2) array_like, or a list of them
        Outlines, such as `mesh.outlines(1)`; a point is inside if an odd number of them is around it.

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

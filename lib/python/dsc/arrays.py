# SPDX-License-Identifier: MIT
"""Checks and converts arguments for the compiled part; errors are sentences."""
import operator
from collections.abc import Mapping

import numpy as np

from . import _dsc

LARGEST = 0xffffffff  # of 32 bits; as a phase, the outside of the domain


def refuse(what, where, value, allowed):
    """Raises InputError in the form of the library's errors."""
    raise _dsc.InputError(f"{where}: {what}: got {value}; allowed: {allowed}")


def shown(value):
    """The `repr` of a value, cut after 60 characters."""
    text = repr(value)
    return text if len(text) <= 60 else text[:60] + "…"


def expect_plane(mesh, where):
    """Raises InputError for a mesh in space."""
    if isinstance(mesh, _dsc.Mesh3):
        refuse("a mesh in space", where, repr(mesh), "a Mesh, which is in the plane")


def phases_shown(phases):
    """The phases of a mesh for its `repr`: all, or the first ones and the last one."""
    names = [str(phase) for phase in phases]
    if len(names) <= 8:
        return f"phases {', '.join(names)}"
    return f"{len(names)} phases {', '.join([*names[:6], '…', names[-1]])}"


def numbers(value, where):
    """An array of real numbers; None for complex numbers and texts, which numpy would cast silently.

    Raises InputError if entries are masked.
    """
    if np.ma.is_masked(value):
        refuse("masked entries", where, f"{np.ma.count_masked(value)} of {np.ma.size(value)}",
               "none: leave them out, or replace them by `filled`")
    try:
        array = np.asarray(value)
    except ValueError:  # rows of several lengths
        return None
    return array if array.dtype.kind in "fiub" else None


def points(value, where, rows="n", width=2):
    """An array of the shape (rows, width). `where` names the argument. Raises InputError."""
    shape = f"numbers of the shape ({rows}, {width})"
    array = numbers(value, where)
    if array is None:
        refuse("not an array of points", where, shown(value), shape)
    if array.ndim != 2 or array.shape[1] != width or rows not in ("n", len(array)):
        refuse("points of the wrong shape", where, f"an array of the shape {array.shape}", shape)
    return array


def point(value, where, width=2):
    """The coordinates of a point. Raises InputError."""
    return points([value], where, 1, width)[0].tolist()


def length(value, where):
    """A positive number. Raises InputError."""
    array = numbers(value, where)
    if array is None or array.ndim != 0 or not 0 < array < np.inf:
        refuse("not a length", where, shown(value), "a positive number")
    return float(array)


def whole_numbers(value, where, shape, dimensions):
    """An array of non-negative numbers of 32 bits; of truth values, 0 and 1. Raises InputError."""
    array = numbers(value, where)
    allowed = f"whole numbers from 0 of the shape {shape}"
    if array is None:
        refuse("not an array of numbers", where, shown(value), allowed)
    if array.ndim != dimensions:
        refuse("an array of another shape", where, array.shape, allowed)
    if array.dtype.kind == "b":
        return array.astype(np.uint8)
    if array.dtype.kind == "f":
        refuse("numbers that need not be whole", where, array.dtype, f"{allowed}, such as `array.astype(int)`")
    if array.size and not 0 <= array.min() <= array.max() <= LARGEST:
        refuse("a number out of range", where, array.min() if array.min() < 0 else array.max(),
               f"whole numbers from 0 to {LARGEST}")
    return array


def count(value, where):
    """A whole number from 0. Raises InputError."""
    try:
        number = operator.index(value)
    except TypeError:
        number = -1
    if number < 0:
        refuse("not a count", where, shown(value), "whole numbers from 0")
    return number


def phase(value, where):
    """The number of a phase. Raises InputError."""
    try:
        number = operator.index(value)
    except TypeError:
        number = -1
    if not 0 <= number < LARGEST:
        refuse("not a phase", where, shown(value), f"whole numbers from 0, below {LARGEST}")
    return number


def pair(value, where):
    """Two different phases. Raises InputError."""
    if not isinstance(value, tuple) or len(value) != 2:
        refuse("not a pair of two phases", where, repr(value), "keys (one, other)")
    one, other = (phase(of, where) for of in value)
    if one == other:
        refuse("not a pair of two phases", where, repr(value), "keys (one, other)")
    return one, other


def by_key(value, where, key, allowed, entry=None):
    """A dict with checked keys and values. Raises InputError.

    `key(value, where)` checks a key; so does `entry` a value, which is a number otherwise.
    """
    if not isinstance(value, Mapping):
        refuse("not a dict", where, shown(value), allowed)
    return {key(one, where): (entry or number)(of, f"{where}[{one}]") for one, of in value.items()}


def number(value, where):
    """A real number. Raises InputError."""
    array = numbers(value, where)
    if array is None or array.ndim != 0:
        refuse("not a number", where, shown(value), "a number")
    return float(array)


def outlines(value, where):
    """A list of outlines from one outline, or from a list or tuple of arrays. Raises InputError."""
    def is_point(one):
        array = numbers(one, where)
        return array is not None and array.ndim < 2

    is_list = isinstance(value, (list, tuple)) and value and not any(map(is_point, value))
    found = [points(one, where) for one in (value if is_list else [value])]
    for one in found:
        _dsc.check_outline(one, where)
    return found


def flat_points(value, where):
    """An array of points (n, 2); a constant third column is dropped. Raises InputError."""
    array = numbers(value, where)
    if array is not None and array.ndim == 2 and array.shape[1] == 3:
        if len(array) and np.ptp(array[:, 2]):
            refuse("points at several heights", where, f"a third column from {array[:, 2].min():g} "
                   f"to {array[:, 2].max():g}", "points of a plane")
        array = array[:, :2]
    return points(value if array is None else array, where)


def polygons(value, where):
    """Polygons as a list of (name, outline, holes). Raises InputError.

    Accepts one ring of points, a list or tuple of rings, and objects with a `__geo_interface__` or
    such dictionaries: polygons, collections, and features of these.
    """
    value = getattr(value, "__geo_interface__", value)
    if isinstance(value, dict):
        return _geometry(value, where)

    def is_point(one):
        array = None if hasattr(one, "__geo_interface__") or isinstance(one, dict) else numbers(one, where)
        return array is not None and array.ndim < 2

    if isinstance(value, (list, tuple)) and value and not any(map(is_point, value)):
        return [one for k, part in enumerate(value) for one in polygons(part, f"{where}[{k}]")]
    return [(where, flat_points(value, where), [])]


def _geometry(value, where):
    kind = value.get("type")
    if kind == "Feature":
        return _geometry(value["geometry"] or {"type": "GeometryCollection", "geometries": []}, where)
    if kind in ("FeatureCollection", "GeometryCollection"):
        parts = value["features" if kind == "FeatureCollection" else "geometries"]
        return [one for k, part in enumerate(parts) for one in _geometry(part, f"{where}[{k}]")]
    if kind == "LinearRing":
        return [(where, flat_points(value["coordinates"], where), [])]
    if kind not in ("Polygon", "MultiPolygon"):
        refuse("a geometry without an area", where, kind, "Polygon, MultiPolygon, LinearRing, or collections of them")
    regions = value["coordinates"] if kind == "MultiPolygon" else [value["coordinates"]]
    names = [f"{where}[{k}]" for k in range(len(regions))] if kind == "MultiPolygon" else [where]
    return [(name, rings[0], rings[1:])
            for name, region in zip(names, regions) if region
            for rings in [[flat_points(ring, name) for ring in region]]]


def shapes(value):
    """The shapes of `initial_complex` as a list of (outline, phase, holes, name). Raises InputError."""
    value = getattr(value, "__geo_interface__", value)
    if value is None:
        return []
    if not isinstance(value, dict):
        refuse("not shapes", "shapes", shown(value),
               "a dict of phases and polygons, or an object with a __geo_interface__")
    if "type" in value:  # each feature is a phase: that of its property, or the next number
        features = value["features"] if value["type"] == "FeatureCollection" else [value]
        value = {}
        for k, one in enumerate(features):
            properties = one.get("properties") or {}
            number = phase(properties.get("phase", k + 1), f"shapes, property phase of feature {k}")
            value.setdefault(number, []).append(one)
    return [(outline, phase(number, "shapes"), holes, name)
            for number, one in value.items()
            for name, outline, holes in polygons(one, f"shapes[{number!r}]")]

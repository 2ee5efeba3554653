# SPDX-License-Identifier: MIT
"""What users give, as the compiled part takes it; whatever is wrong with it ends in a sentence."""
import operator

import numpy as np

from . import _dsc

LARGEST = 0xffffffff  # of 32 bits; as a phase it stands for the outside of the domain


def refuse(what, where, value, allowed):
    """Raises InputError, in the words of the library."""
    raise _dsc.InputError(f"{where}: {what}: got {value}; allowed: {allowed}")


def shown(value):
    """As Python would print it, cut after 60 characters."""
    text = repr(value)
    return text if len(text) <= 60 else text[:60] + "…"


def numbers(value, where):
    """An array of real numbers, or None: complex ones and texts would be cast in silence.

    Raises InputError where entries are masked: what is below a mask is no number.
    """
    if np.ma.is_masked(value):
        refuse("masked entries", where, f"{np.ma.count_masked(value)} of {np.ma.size(value)}",
               "none: leave them out, or give them values by `filled`")
    try:
        array = np.asarray(value)
    except ValueError:  # rows of several lengths
        return None
    return array if array.dtype.kind in "fiub" else None


def points(value, where, rows="n"):
    """An array of the shape (rows, 2). `where` names the argument. Raises InputError."""
    shape = f"numbers of the shape ({rows}, 2)"
    array = numbers(value, where)
    if array is None:
        refuse("not an array of points", where, shown(value), shape)
    if array.ndim != 2 or array.shape[1] != 2 or rows not in ("n", len(array)):
        refuse("points of another shape", where, f"an array of the shape {array.shape}", shape)
    return array


def point(value, where):
    """The two coordinates of anything with two numbers. Raises InputError."""
    return points([value], where, 1)[0].tolist()


def whole_numbers(value, where, shape, dimensions):
    """An array of numbers from 0 that fit into 32 bits. Raises InputError."""
    array = numbers(value, where)
    if array is None or array.dtype.kind not in "iu" or array.ndim != dimensions or (
            array.size and not 0 <= array.min() <= array.max() <= LARGEST):
        refuse("not an array of numbers of 32 bits", where, shown(value),
               f"whole numbers from 0 of the shape {shape}")
    return array


def phase(value, where):
    """The number of a phase. Raises InputError."""
    try:
        number = operator.index(value)
    except TypeError:
        number = -1
    if not 0 <= number < LARGEST:
        refuse("not a phase", where, shown(value), f"whole numbers from 0, below {LARGEST}")
    return number


def outlines(value, where):
    """One outline, or those of a list or tuple of arrays, as a list. Raises InputError."""
    def is_point(one):
        array = numbers(one, where)
        return array is not None and array.ndim == 1

    is_list = isinstance(value, (list, tuple)) and value and not any(map(is_point, value))
    found = [points(one, where) for one in (value if is_list else [value])]
    for one in found:
        _dsc.check_outline(one, where)
    return found

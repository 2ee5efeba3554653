# SPDX-License-Identifier: MIT
"""Pickles with a checksum, so that a changed byte is noticed, and checkpoint files."""
import pickle

from . import _dsc, arrays


def sealed(name, **state):
    """The bytes of these values. Raises InputError, whose message begins with the name, where one cannot be pickled."""
    try:
        return _dsc.sealed(pickle.dumps(state))
    except (AttributeError, TypeError, pickle.PicklingError):
        for key, value in state.items():
            _expect_picklable(f"{name}: {key}", value)
        raise


def unsealed(state, name, *keys):
    """The values with these keys. Raises FileError, whose message begins with the name."""
    try:
        values = pickle.loads(_dsc.unsealed(state, name))
    except (AttributeError, ImportError) as error:
        raise _dsc.FileError(f"{name}: needs what is not here: {error}; import or define it before loading") from error
    if not isinstance(values, dict) or set(values) != set(keys):
        raise _dsc.FileError(f"{name}: written by another version of dsc, with another layout; load it with that "
                             "version and keep the arrays, such as points, triangles and phases")
    return [values[key] for key in keys]


def _expect_picklable(where, value):
    try:
        pickle.dumps(value)
    except (AttributeError, TypeError, pickle.PicklingError) as error:
        if isinstance(value, dict):
            for key, one in value.items():
                _expect_picklable(f"{where}[{key!r}]", one)
        elif isinstance(value, (list, tuple)):
            for k, one in enumerate(value):
                _expect_picklable(f"{where}[{k}]", one)
        raise _dsc.InputError(f"{where}: cannot be pickled: got {arrays.shown(value)}; allowed: numbers, or a function "
                              "that `def` defines at the top of a module, which pickle finds by its name; "
                              "copy.copy works with any function") from error


def save(path, thing):
    """Writes a checkpoint: a simulation or a mesh, or anything else that can be pickled.

    A simulation continues from it bitwise identically. The write is atomic.

    Parameters
    ----------
    path : str or path
    thing : Simulation, Mesh or object
        A tuple keeps references between its elements, such as that of a simulation to its mesh.

    Raises
    ------
    FileError
    InputError
        If a function cannot be pickled, such as a lambda among the options.
    """
    _dsc.write_sealed(str(path), pickle.dumps(thing))


def load(path):
    """Reads a checkpoint back.

    Parameters
    ----------
    path : str or path
        A file written by `save`. As with any pickle, load only files that you trust.

    Returns
    -------
    object
        The saved object.

    Raises
    ------
    FileError
        If a byte has changed, or the file is not a complete checkpoint.

    Examples
    --------
    >>> dsc.save(folder / "run", sim)
    >>> dsc.load(folder / "run").mesh.mesh_hash == mesh.mesh_hash
    True
    """
    with open(path, "rb") as file:
        return pickle.loads(_dsc.unsealed(file.read(), str(path)))

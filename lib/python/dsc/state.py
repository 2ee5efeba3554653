# SPDX-License-Identifier: MIT
"""Pickles with a checksum, so that a changed byte is noticed, and checkpoint files."""
import pickle

from . import _dsc


def sealed(*state):
    """The bytes of an object that can be pickled."""
    return _dsc.sealed(pickle.dumps(state))


def unsealed(state, name):
    """The tuple that was sealed. Raises FileError; its message begins with the name."""
    return pickle.loads(_dsc.unsealed(state, name))


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
        return unsealed(file.read(), str(path))

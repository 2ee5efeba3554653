# SPDX-License-Identifier: MIT
"""Bytes: sealed for pickles, so that a changed byte is noticed, and as checkpoints in files."""
import pickle

from . import _dsc


def sealed(*state):
    """Anything that can be pickled, as bytes."""
    return _dsc.sealed(pickle.dumps(state))


def unsealed(state, name):
    """The tuple that was sealed. Raises FileError, which begins with the name."""
    return pickle.loads(_dsc.unsealed(state, name))


def save(path, thing):
    """Writes a checkpoint: a simulation or a mesh, or anything else that can be pickled.

    A simulation goes on from it to the same bits. The file exists as a whole or not at all.

    Parameters
    ----------
    path : str or path
    thing : Simulation, Mesh or object
        A tuple of them keeps who belongs to whom.

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
        A file that `save` has written. As with any pickle, only open what you trust.

    Returns
    -------
    object
        What was saved.

    Raises
    ------
    FileError
        Where a byte has changed, or the file is not a whole checkpoint.

    Examples
    --------
    >>> dsc.save(folder / "run", sim)
    >>> dsc.load(folder / "run").mesh.mesh_hash == mesh.mesh_hash
    True
    """
    with open(path, "rb") as file:
        return unsealed(file.read(), str(path))

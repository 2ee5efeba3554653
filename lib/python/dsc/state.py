# SPDX-License-Identifier: MIT
"""Meshes, flows and simulations as bytes: for pickles, copies and checkpoints."""
import copy
import pickle

from . import _dsc


def _load_mesh(state):
    return _dsc.Mesh._from_state(state)


def _load_simulation(mesh, state):
    options, flow, inner = pickle.loads(_dsc._unsealed(state, "simulation"))
    sim = _dsc.Simulation(mesh, flow, **options)
    sim._restore(inner)
    return sim


def _load_flow(name, given):
    return getattr(_dsc, name)(*given)


def _reduce_simulation(sim):
    state = pickle.dumps((sim.options, sim.flow, sim._state()))
    return _load_simulation, (sim.mesh, _dsc._sealed(state))


_dsc.Mesh.__reduce__ = lambda mesh: (_load_mesh, (mesh._state(),))
_dsc.Flow.__reduce__ = lambda flow: (_load_flow, (flow._name, flow._given))
_dsc.Simulation.__reduce__ = _reduce_simulation
_dsc.Simulation.__copy__ = copy.deepcopy  # of a mesh of its own, which has one simulation only


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
    _dsc._write_sealed(str(path), pickle.dumps(thing))


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
        return pickle.loads(_dsc._unsealed(file.read(), str(path)))

# SPDX-License-Identifier: MIT
"""Meshes of tets: the compiled part, with the methods expected of a Python object."""
from . import _dsc, arrays, interplay
from .data import Data
from .records import Faces
from .state import sealed, unsealed


class Mesh3(_dsc.Mesh3):
    """A mesh of tetrahedra (tets) that have phases: a simplicial complex in space.

    Made by `initial_complex` of a domain in space, changed by the steps of a `Simulation`. The arrays of
    points, tets and phases have no gaps, are C-contiguous and read-only; a step does not change arrays
    taken before it.

    Parameters
    ----------
    points : (n, 3) array_like
    tetrahedra : (m, 4) array_like of int
        Rows of `points`, in either orientation. A face has at most two tets. Together they fill a box.
    phases : (m,) array_like of int

    Examples
    --------
    >>> ball = dsc.ball((0.5, 0.5, 0.5), 0.3)
    >>> mesh = dsc.initial_complex(((0, 0, 0), (1, 1, 1)), {1: ball}, edge_length=0.1)
    >>> sim = dsc.Simulation(mesh, edge_length=0.1)
    >>> sim.step(lambda x, t: 0 * x + (1, 0, 0), 0, 0.1).unreached
    0
    """

    def __init__(self, points, tetrahedra, phases):
        """Makes a mesh from arrays; `initial_complex` makes a mesh from shapes."""
        tetrahedra = arrays.whole_numbers(tetrahedra, "tetrahedra", "(m, 4)", 2)
        phases = arrays.whole_numbers(phases, "phases", "(m,)", 1)
        if tetrahedra.shape != (len(phases), 4):
            arrays.refuse("arrays whose shapes do not match", "Mesh3",
                          f"tetrahedra of the shape {tetrahedra.shape} and {len(phases)} phases",
                          "tetrahedra (m, 4) and phases (m,)")
        super().__init__(arrays.points(points, "points", width=3), tetrahedra, phases)

    @classmethod
    def _made_of(cls, *parts):
        """Makes a mesh by another constructor of the compiled part."""
        mesh = cls.__new__(cls)
        _dsc.Mesh3.__init__(mesh, *parts)
        return mesh

    def copy(self):
        """An independent copy."""
        return self._made_of(self)

    __copy__ = copy

    def __deepcopy__(self, memo):
        return self.copy()

    def __reduce__(self):
        return _mesh3_from, (sealed("mesh", complex=self._bytes(), vertex_data=dict(self.vertex_data),
                                    tet_data=dict(self.tet_data)),)

    def __repr__(self):
        return (f"<dsc.Mesh3: {len(self.phases)} tets, {len(self.points)} vertices, "
                f"{arrays.phases_shown(self.volumes)}>")

    @property
    def vertex_data(self):
        """The data of vertices: a `Data`."""
        return Data(self, "vertex")

    @property
    def tet_data(self):
        """The data of tets: a `Data`."""
        return Data(self, "tet")

    @property
    def volumes(self):
        """The volume of each phase in the mesh: a dict."""
        return self._volumes()

    def interface_faces(self):
        """The faces between tets of different phases: a `Faces`.

        Examples
        --------
        >>> faces = mesh3.interface_faces()
        >>> set(faces.inside.tolist()), set(faces.outside.tolist())
        ({1}, {0})
        """
        return Faces(*self._faces())

    to_meshio = interplay.to_meshio


def _mesh3_from(state):
    complex_bytes, vertex_data, tet_data = unsealed(state, "mesh", "complex", "vertex_data", "tet_data")
    mesh = Mesh3._made_of(complex_bytes)
    mesh.vertex_data.update(vertex_data)
    mesh.tet_data.update(tet_data)
    return mesh

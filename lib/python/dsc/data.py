# SPDX-License-Identifier: MIT
"""Data of vertices, triangles and tets as dictionaries of arrays."""
from collections.abc import MutableMapping

from .arrays import numbers, refuse, shown


OF_THE_MESH = ("phase", "position")


class Data(MutableMapping):
    """Arrays by name, one entry for each vertex, triangle or tet: numbers (n,) or vectors, which are
    (n, 2) in a `Mesh` and (n, 3) in a `Mesh3`.

    They follow the mesh: a vertex made by a split gets the value interpolated from its neighbours, a
    new triangle or tet that of the one that it replaces. Reading returns a copy; assign it to write it back.
    """

    def __init__(self, mesh, kind):
        self._mesh = mesh
        self._kind = kind

    def _names(self):
        return [name for name, is_of_vertices in self._mesh._data_names().items()
                if is_of_vertices == (self._kind == "vertex")]

    def __getitem__(self, name):
        if name not in self._names():
            raise KeyError(name)
        return self._mesh._data(name)

    def __setitem__(self, name, values):
        if name in OF_THE_MESH:
            refuse("a name that files use for the mesh itself", f"{self._kind}_data", repr(name), "another name")
        count = len(self._mesh.points if self._kind == "vertex" else self._mesh.phases)
        width = self._mesh.points.shape[1]
        array = numbers(values, name)
        if array is None or array.shape not in ((count,), (count, width)):
            refuse(f"not one entry for each {self._kind}", name, shown(values),
                   f"numbers of the shape ({count},) or ({count}, {width})")
        write = self._mesh._set_vertex_data if self._kind == "vertex" else self._mesh._set_cell_data
        write(name, array)

    def __delitem__(self, name):
        if name not in self._names():
            raise KeyError(name)
        self._mesh._remove_data(name)

    def __iter__(self):
        return iter(self._names())

    def __len__(self):
        return len(self._names())

    def __repr__(self):
        return f"<{self._kind} data: {', '.join(self) or 'none'}>"

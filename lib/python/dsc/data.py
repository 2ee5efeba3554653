# SPDX-License-Identifier: MIT
"""Data of vertices and triangles as dictionaries of arrays."""
from collections.abc import MutableMapping

from .arrays import numbers, refuse, shown


OF_THE_MESH = ("phase", "position")


class Data(MutableMapping):
    """Arrays by name, one entry for each vertex or triangle: numbers (n,) or vectors (n, 2).

    They follow the mesh: a vertex that a split makes takes the value between its neighbours, a
    triangle that of the one it was cut off. Reading gives a copy; assign it to write it back.
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
            refuse("what files call the mesh's own", f"{self._kind}_data", repr(name), "another name")
        count = len(self._mesh.points if self._kind == "vertex" else self._mesh.triangles)
        array = numbers(values, name)
        if array is None or array.shape not in ((count,), (count, 2)):
            refuse("not the data of these simplices", name, shown(values),
                   f"numbers of the shape ({count},) or ({count}, 2)")
        getattr(self._mesh, f"_set_{self._kind}_data")(name, array)

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

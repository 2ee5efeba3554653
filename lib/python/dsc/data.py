# SPDX-License-Identifier: MIT
"""Data of vertices and triangles as dictionaries of arrays."""
from collections.abc import MutableMapping


class Data(MutableMapping):
    """Arrays by name, one entry for each vertex or triangle: numbers (n,) or vectors (n, 2).

    They follow the mesh: a vertex that a split makes takes the value between its neighbours, a
    triangle that of the one it was cut off. Reading gives a copy; assign it to write it back.
    """

    def __init__(self, mesh, kind):
        self._mesh = mesh
        self._kind = kind

    def _call(self, name, *arguments):
        return getattr(self._mesh, name.replace("data", f"{self._kind}_data"))(*arguments)

    def __getitem__(self, name):
        values = self._call("_data", name)
        if values is None:
            raise KeyError(name)
        return values

    def __setitem__(self, name, values):
        self._call("_set_data", name, values)

    def __delitem__(self, name):
        self[name]
        self._mesh._remove_data(name)

    def __iter__(self):
        return iter(self._call("_data_names"))

    def __len__(self):
        return len(self._call("_data_names"))

    def __repr__(self):
        return f"<{self._kind} data: {', '.join(self) or 'none'}>"

# SPDX-License-Identifier: MIT
"""Reads meshes of other programs."""
import numpy as np

from . import arrays
from .mesh import Mesh
from .mesh3 import Mesh3
from .sides import boundary_of


def from_meshio(mesh, phases=None):
    """The `Mesh` of the triangles of a `meshio.Mesh`, or of an object with `points`, `cells` and `cell_data`;
    the `Mesh3` of its tets, if it has any.

    Parameters
    ----------
    mesh : meshio.Mesh
        Cells without area are ignored; other cells must be triangles. Points may have a third
        coordinate if it is constant. If there are tets, cells without volume are ignored. Lines on the
        boundary that have a physical group are sides with its name, for `Fluid`, or with its number.
    phases : str, optional
        The name of the cell data with the phases. By default the first existing one of `phase`,
        `gmsh:physical`, `medit:ref` and `gmsh:geometrical`; without any, all cells have phase 1.
    """
    if not all(hasattr(mesh, name) for name in ("points", "cells", "cell_data")):
        arrays.refuse("not a mesh", "from_meshio", arrays.shown(mesh),
                      "what `meshio.read(path)` returns, or another object with points, cells and cell_data")
    data = dict(mesh.cell_data)
    if phases is None:
        phases = next((name for name in ("phase", "gmsh:physical", "medit:ref", "gmsh:geometrical") if name in data),
                      None)
    elif phases not in data:
        arrays.refuse("no such cell data", "from_meshio", repr(phases), ", ".join(map(repr, data)) or "none")
    blocks = [(block.type, block.data) if hasattr(block, "type") else block for block in mesh.cells]
    in_space = any(kind.startswith("tetra") for kind, _ in blocks)
    wanted, corners, ignored = ("tetra", 4, ("vertex", "line", "triangle", "quad")) if in_space else (
        "triangle", 3, ("vertex", "line"))
    simplices, numbers = [], []
    for k, (kind, cells) in enumerate(blocks):
        if kind == wanted:
            simplices.append(np.asarray(cells).reshape(-1, corners))
            numbers.append(np.ones(len(cells), int) if phases is None else data[phases][k])
        elif not kind.startswith(ignored):
            arrays.refuse("cells that are not tets" if in_space else "cells that are not triangles", f"cells[{k}]",
                          f"{len(cells)} of type {kind!r}", "tets; cells without volume are ignored" if in_space else
                          "triangles; cells without area are ignored")
    if not simplices:
        arrays.refuse("no triangles", "from_meshio", f"{len(mesh.cells)} blocks of other cells", "at least one triangle")
    if any(np.ma.is_masked(one) for one in numbers):
        hidden = sum(np.ma.count_masked(one) for one in numbers)
        arrays.refuse("masked entries", f"cell_data[{phases!r}]", f"{hidden} of {sum(map(len, numbers))}", "none")
    used, rows = np.unique(np.vstack(simplices), return_inverse=True)
    numbers = np.concatenate(numbers)
    if numbers.dtype.kind == "f" and (numbers == np.round(numbers)).all():
        numbers = numbers.astype(np.int64)
    points = np.ma.asarray(mesh.points)[used]
    if in_space:
        return Mesh3(points, rows.reshape(-1, 4), numbers)
    corners = rows.reshape(-1, 3)
    return Mesh(arrays.flat_points(points, "points"), corners, numbers, _sides(mesh, blocks, data, used, corners))


def _sides(mesh, blocks, data, used, corners):
    """The edges of each physical group of lines, as far as they lie on the boundary of the triangles."""
    groups = data.get("gmsh:physical")
    if groups is None:  # the field data of other formats are arrays of any shape
        return {}
    names = {int(entry[0]): name for name, entry in getattr(mesh, "field_data", {}).items()
             if np.shape(entry) == (2,) and entry[1] == 1}
    sides = {}
    for k, (kind, cells) in enumerate(blocks):
        if kind.startswith("line"):
            ends = np.asarray(cells)[:, :2]
            rows = np.minimum(np.searchsorted(used, ends), len(used) - 1)
            rows[(used[rows] != ends).any(axis=1)] = 0  # not of the triangles: no edge joins a point to itself
            for row, tag in zip(np.sort(rows, axis=1).tolist(), groups[k]):
                if tag:
                    sides.setdefault(names.get(int(tag), str(int(tag))), []).append(row)
    boundary = boundary_of(corners) if sides else set()
    found = {name: [row for row in rows if tuple(row) in boundary] for name, rows in sides.items()}
    return {name: np.array(rows) for name, rows in found.items() if rows}

# SPDX-License-Identifier: MIT
"""Conversions of meshes to and from other packages, which are imported on first use."""
import numpy as np

from . import arrays
from .measures import area


def _encloses(loop, point):
    """Whether the point lies inside the loop: whether an odd number of edges lie to its right."""
    a, b = loop, np.roll(loop, -1, axis=0)
    straddles = (a[:, 1] > point[1]) != (b[:, 1] > point[1])
    a, b = a[straddles], b[straddles]
    x = a[:, 0] + (point[1] - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return (x > point[0]).sum() % 2 == 1


def polygons(mesh, phase):
    """The regions of a phase.

    Parameters
    ----------
    mesh : Mesh
    phase : int

    Returns
    -------
    list of lists of (n, 2) arrays
        For each region the outline and then its holes.
    """
    loops = mesh.outlines(phase)
    outer = [[loop] for loop in loops if area(loop) > 0]
    for hole in (loop for loop in loops if area(loop) < 0):
        middle = (hole[0] + hole[1]) / 2  # of an edge: a vertex may also be one of the outline
        around = [one for one in outer if _encloses(one[0], middle)]
        min(around, key=lambda one: area(one[0])).append(hole)
    return outer


def to_geojson(mesh):
    """A FeatureCollection (RFC 7946) with a MultiPolygon for each phase, as dictionaries and lists."""
    def feature(phase):
        rings = [[np.vstack((loop, loop[:1])).tolist() for loop in region]
                 for region in polygons(mesh, phase)]
        return {"type": "Feature", "properties": {"phase": phase, "area": mesh.areas[phase]},
                "geometry": {"type": "MultiPolygon", "coordinates": rings}}

    return {"type": "FeatureCollection", "features": [feature(phase) for phase in mesh.areas]}


def to_shapely(mesh, phase):
    """The regions of a phase as a `shapely.MultiPolygon`."""
    from shapely.geometry import MultiPolygon

    return MultiPolygon([(region[0], region[1:]) for region in polygons(mesh, phase)])


def to_meshio(mesh):
    """A `meshio.Mesh` with the phases and all data."""
    import meshio

    from .mesh3 import Mesh3

    in_space = isinstance(mesh, Mesh3)
    corners, data = (mesh.tetrahedra, mesh.tet_data) if in_space else (mesh.triangles, mesh.triangle_data)
    return meshio.Mesh(mesh.points, [("tetra" if in_space else "triangle", corners)], point_data=dict(mesh.vertex_data),
                       cell_data={name: [values] for name, values in {"phase": mesh.phases, **data}.items()})


def from_meshio(mesh, phases=None):
    """The `Mesh` of the triangles of a `meshio.Mesh`, or of an object with `points`, `cells` and `cell_data`;
    the `Mesh3` of its tets, if it has any.

    Parameters
    ----------
    mesh : meshio.Mesh
        Cells without area are ignored; other cells must be triangles. Points may have a third
        coordinate if it is constant. If there are tets, cells without volume are ignored.
    phases : str, optional
        The name of the cell data with the phases. By default the first existing one of `phase`,
        `gmsh:physical`, `medit:ref` and `gmsh:geometrical`; without any, all cells have phase 1.
    """
    from .mesh import Mesh
    from .mesh3 import Mesh3

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
    return Mesh(arrays.flat_points(points, "points"), rows.reshape(-1, 3), numbers)


def to_triangulation(mesh):
    """A `matplotlib.tri.Triangulation`."""
    from matplotlib.tri import Triangulation

    return Triangulation(*mesh.points.T, mesh.triangles)

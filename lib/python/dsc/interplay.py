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

    cells = {"phase": mesh.phases, **mesh.triangle_data}
    return meshio.Mesh(mesh.points, [("triangle", mesh.triangles)], point_data=dict(mesh.vertex_data),
                       cell_data={name: [values] for name, values in cells.items()})


def from_meshio(mesh, phases=None):
    """The `Mesh` of the triangles of a `meshio.Mesh`, or of an object with `points`, `cells` and `cell_data`.

    Parameters
    ----------
    mesh : meshio.Mesh
        Cells without area are ignored; other cells must be triangles. Points may have a third
        coordinate if it is constant.
    phases : str, optional
        The name of the cell data with the phases. By default the first existing one of `phase`,
        `gmsh:physical`, `medit:ref` and `gmsh:geometrical`; without any, all triangles have phase 1.
    """
    from .mesh import Mesh

    if not all(hasattr(mesh, name) for name in ("points", "cells", "cell_data")):
        arrays.refuse("not a mesh", "from_meshio", arrays.shown(mesh),
                      "what `meshio.read(path)` returns, or another object with points, cells and cell_data")
    data = dict(mesh.cell_data)
    if phases is None:
        phases = next((name for name in ("phase", "gmsh:physical", "medit:ref", "gmsh:geometrical") if name in data),
                      None)
    elif phases not in data:
        arrays.refuse("no such cell data", "from_meshio", repr(phases), ", ".join(map(repr, data)) or "none")
    triangles, numbers = [], []
    for k, block in enumerate(mesh.cells):
        kind, cells = (block.type, block.data) if hasattr(block, "type") else block
        if kind == "triangle":
            triangles.append(np.asarray(cells).reshape(-1, 3))
            numbers.append(np.ones(len(cells), int) if phases is None else data[phases][k])
        elif kind != "vertex" and not kind.startswith("line"):
            arrays.refuse("cells that are not triangles", f"cells[{k}]", f"{len(cells)} of type {kind!r}",
                          "triangles; cells without area are ignored")
    if not triangles:
        arrays.refuse("no triangles", "from_meshio", f"{len(mesh.cells)} blocks of other cells", "at least one triangle")
    if any(np.ma.is_masked(one) for one in numbers):
        hidden = sum(np.ma.count_masked(one) for one in numbers)
        arrays.refuse("masked entries", f"cell_data[{phases!r}]", f"{hidden} of {sum(map(len, numbers))}", "none")
    used, rows = np.unique(np.vstack(triangles), return_inverse=True)
    numbers = np.concatenate(numbers)
    if numbers.dtype.kind == "f" and (numbers == np.round(numbers)).all():
        numbers = numbers.astype(np.int64)
    points = arrays.flat_points(np.ma.asarray(mesh.points)[used], "points")
    return Mesh(points, rows.reshape(-1, 3), numbers)


def to_triangulation(mesh):
    """A `matplotlib.tri.Triangulation`."""
    from matplotlib.tri import Triangulation

    return Triangulation(*mesh.points.T, mesh.triangles)

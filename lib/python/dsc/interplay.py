# SPDX-License-Identifier: MIT
"""Conversions of meshes to other packages, which are imported on first use."""
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

    in_space = hasattr(mesh, "tetrahedra")
    corners, data = (mesh.tetrahedra, mesh.tet_data) if in_space else (mesh.triangles, mesh.triangle_data)
    return meshio.Mesh(mesh.points, [("tetra" if in_space else "triangle", corners)], point_data=dict(mesh.vertex_data),
                       cell_data={name: [values] for name, values in {"phase": mesh.phases, **data}.items()})


def to_triangulation(mesh):
    """A `matplotlib.tri.Triangulation`."""
    from matplotlib.tri import Triangulation

    return Triangulation(*mesh.points.T, mesh.triangles)

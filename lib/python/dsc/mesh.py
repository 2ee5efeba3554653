# SPDX-License-Identifier: MIT
"""Meshes: the compiled part, with the methods expected of a Python object."""
import pathlib
import tempfile
import warnings

import numpy as np

from . import _dsc, arrays, interplay
from . import sides as sides_of
from .data import Data
from .mesh3 import Mesh3
from .records import Curve, InputReport
from .shapes3 import is_in_space, shapes_of
from .state import sealed, unsealed


class Mesh(_dsc.Mesh):
    """A triangle mesh whose triangles have phases: a 2D simplicial complex.

    Made by `initial_complex`, changed by the steps of a `Simulation`. The arrays of points, triangles
    and phases have no gaps, are C-contiguous and read-only; a step does not change arrays taken before it.

    Parameters
    ----------
    points : (n, 2) array_like
    triangles : (m, 3) array_like of int
        Rows of `points`, in either orientation. An edge has at most two triangles.
    phases : (m,) array_like of int
    sides : dict, optional
        The edges of each side of the domain: `{name: (k, 2) rows of points}`.
    """

    def __init__(self, points, triangles, phases, sides=None):
        """Makes a mesh from arrays; `initial_complex` makes a mesh from shapes."""
        triangles = arrays.whole_numbers(triangles, "triangles", "(m, 3)", 2)
        phases = arrays.whole_numbers(phases, "phases", "(m,)", 1)
        if triangles.shape != (len(phases), 3):
            arrays.refuse("arrays whose shapes do not match", "Mesh",
                          f"triangles of the shape {triangles.shape} and {len(phases)} phases",
                          "triangles (m, 3) and phases (m,)")
        points = arrays.flat_points(points, "points")
        super().__init__(points, triangles, phases)
        self._sides = sides_of.of_triangles(points, triangles, sides)

    @classmethod
    def _made_of(cls, *parts, sides=None):
        """Makes a mesh by another constructor of the compiled part."""
        mesh = cls.__new__(cls)
        _dsc.Mesh.__init__(mesh, *parts)
        mesh._sides = sides or sides_of.none()
        return mesh

    def copy(self):
        """An independent copy."""
        return self._made_of(self, sides=self._sides)

    __copy__ = copy

    def __deepcopy__(self, memo):
        return self.copy()

    def __reduce__(self):
        return _mesh_from, (sealed("mesh", complex=self._bytes(), vertex_data=dict(self.vertex_data),
                                   triangle_data=dict(self.triangle_data), sides=self._sides),)

    def __repr__(self):
        return (f"<dsc.Mesh: {len(self.triangles)} triangles, {len(self.points)} vertices, "
                f"{arrays.phases_shown(self.areas)}>")

    def _repr_svg_(self):
        """The representation in a notebook."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mesh.svg"
            self.write_svg(path)
            return path.read_text(encoding="utf-8")

    @property
    def vertex_data(self):
        """The data of vertices: a `Data`."""
        return Data(self, "vertex")

    @property
    def triangle_data(self):
        """The data of triangles: a `Data`."""
        return Data(self, "triangle")

    @property
    def sides(self):
        """The straight edges (k, 2, 2) of each side of the domain that has a name, as given: a dict."""
        return sides_of.by_name(self._sides)

    @property
    def areas(self):
        """The area of each phase in the mesh: a dict."""
        return {phase: one["area"] for phase, one in self.figures["phases"].items()}

    @property
    def input_report(self):
        """The detail that `initial_complex` left out because it is too fine for the mesh: an `InputReport`."""
        return InputReport(*self._input_report())

    def interface_curves(self):
        """The interface as curves, cut where more than two phases meet: a list of `Curve`."""
        return [Curve(*parts) for parts in self._interface_curves()]

    def outlines(self, phase, samples=1):
        """Closed loops around a phase, counter-clockwise, clockwise around its holes.

        Parameters
        ----------
        phase : int
        samples : int
            Points for each edge, on the cubic through its neighbours; 1: only the vertices.

        Returns
        -------
        list of (n, 2) arrays
        """
        return self._outlines(phase, samples)

    polygons = interplay.polygons
    to_geojson = interplay.to_geojson
    to_meshio = interplay.to_meshio
    to_shapely = interplay.to_shapely
    to_triangulation = interplay.to_triangulation


def _mesh_from(state):
    complex_bytes, vertex_data, triangle_data, sides = unsealed(state, "mesh", "complex", "vertex_data",
                                                                "triangle_data", "sides")
    mesh = Mesh._made_of(complex_bytes, sides=sides)
    mesh.vertex_data.update(vertex_data)
    mesh.triangle_data.update(triangle_data)
    return mesh


def _curve(value, where):
    try:
        points, left, right = value
    except (TypeError, ValueError):
        arrays.refuse("not a curve", where, arrays.shown(value),
                      "(points, phase on the left, phase on the right)")
    return arrays.flat_points(points, where), arrays.phase(left, where), arrays.phase(right, where)


def initial_complex(domain, shapes=None, *, curves=None, sides=None, **options):
    if is_in_space(domain, shapes):
        for name, value in (("curves", curves), ("sides", sides)):
            if value is not None:
                arrays.refuse(f"{name} in a domain in space", "initial_complex", name, "shapes")
        return Mesh3._made_of(arrays.points(domain, "domain", 2, 3), shapes_of(shapes), options)
    rings = [ring for _, outline, holes in arrays.polygons(domain, "domain") for ring in (outline, *holes)]
    if not rings or min(map(len, rings)) < (2 if len(rings) == 1 else 3):
        arrays.refuse("not a domain", "domain", arrays.shown(domain),
                      "two points: the lower left corner of a rectangle and the upper right one; or a "
                      "polygon of three or more")
    pieces = arrays.shapes(shapes)
    if pieces and curves is not None:
        arrays.refuse("both shapes and curves are given", "initial_complex", "both", "either")
    if curves is not None:
        pieces = [_curve(one, f"curves[{k}]") for k, one in enumerate(curves)]
    mesh = Mesh._made_of(rings, pieces, options, sides=sides_of.of_rings(rings, sides))
    if shapes is not None:
        _warn_of_needles(mesh, options["edge_length"])
    return mesh


def _warn_of_needles(mesh, edge_length):
    """Borders that were meant to coincide, but do not, leave needles between them."""
    needle = 3  # degrees
    angles = mesh.min_angles
    worst = int(angles.argmin())
    if angles[worst] >= needle:
        return
    corners = mesh.points[mesh.triangles[angles < needle]]
    sides = np.roll(corners, -1, axis=1) - corners
    doubled = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    gap = (doubled / np.linalg.norm(sides, axis=2).max(axis=1)).max() / edge_length
    x, y = mesh.points[mesh.triangles[worst]].mean(axis=0)
    tolerance = min(max(2 * gap, 0.002), 0.1)
    warnings.warn(f"the first mesh has an angle of {angles[worst]:.2g} degrees at ({x:.4g}, {y:.4g}); if borders of "
                  f"shapes are meant to meet there, give border_tolerance={tolerance:.1g}, or twice the rounding of the "
                  "coordinates over edge_length", stacklevel=3)


def from_labels(array, domain=None, min_pixels=0, **options):
    labels = arrays.whole_numbers(array, "labels", "(rows, columns)", 2)
    rows, columns = labels.shape
    options = {_dsc.current_option(name): value for name, value in options.items()}
    min_pixels = options.pop("min_pixels", min_pixels)
    corners = arrays.points(((0, 0), (columns, rows)) if domain is None else domain, "domain", 2)
    _warn_of_grey(labels)
    return Mesh._made_of(corners, labels, arrays.count(min_pixels, "min_pixels"), options)


def _warn_of_grey(labels):
    """Grey values along the borders of an anti-aliased picture are phases that have no pixel inside."""
    few = 8
    is_inner = np.ones(labels.shape, bool)
    for axis in (0, 1):
        differs = np.diff(labels, axis=axis) != 0
        before, after = ((0, 1), (0, 0)), ((1, 0), (0, 0))
        for pad in (before, after):
            is_inner &= ~np.pad(differs, pad if axis == 0 else pad[::-1])
    phases = len(np.unique(labels))
    thin = phases - len(np.unique(labels[is_inner]))
    if thin > few and 2 * thin > phases:
        warnings.warn(f"{thin} of {phases} phases have no pixel whose neighbours have the same phase, as the grey "
                      "values along the borders of an anti-aliased picture: from_labels takes each value as a phase; "
                      "give numbers of phases, such as np.where(picture > 127, 1, 0), or merge small grains by "
                      "min_pixels", stacklevel=3)


from_labels.__doc__ = f"""Makes the mesh of an image whose pixels are numbers of phases.

Boundaries between pixels of different phases become smooth curves that meet at junctions. They lie
within half a pixel of the sides of the pixels, and each grain keeps the area of its pixels.

Parameters
----------
array : (rows, columns) array_like of int
    The first row is the uppermost, as in pictures; if it is the lowest, give `array[::-1]`.
domain : array_like (2, 2), optional
    The lower left and the upper right corner of the rectangle that the image covers.
    By default pixels are squares of side 1.
min_pixels : int
    Grains of fewer pixels, and those smaller than 0.2 edge lengths, go to the neighbour with the longest
    common border. `mesh.input_report` counts them as dropped.
**options
    The following ones.
{_dsc.size_help}
Returns
-------
Mesh
"""


initial_complex.__doc__ = f"""Makes the first mesh of a simulation.

Parameters
----------
domain : array_like (2, 2), or a polygon; or array_like (2, 3)
    The lower left corner of a rectangle, and the upper right one; or a polygon: (n, 2) points, a list
    of such rings, the second of which is a hole in the first, or what has a `__geo_interface__`.
    In space: the corners of a box with the smallest coordinates and with the largest.
shapes : dict, or an object with a __geo_interface__; optional
    For each phase a polygon (n, 2), a list of polygons, or an object with a `__geo_interface__`, such as
    polygons of shapely and columns of geopandas. Instead of the dict, a frame of geopandas or a
    FeatureCollection: each of its features is a phase, by its property `phase`, or numbered from 1 on.
    Polygons may be closed or open, run either way, share borders and reach beyond the domain. The
    innermost polygon counts; a polygon inside another one of the same phase is a hole; the rest is phase 0.

    In space: for each phase a `Shape3` such as `ball`, a function of points (n, 3) that returns signed
    distances (n,), or a list of these; or a list of pairs `(shape, phase)` and `(shape, {{one: other}})`.
    Where shapes overlap, the later one counts; they may reach beyond the domain. With a dict, a shape
    divides phases: inside it, what was phase `one` is phase `other`, and other phases stay. A function is
    called for one point at a time.
curves : sequence of (points, left, right), optional
    Instead of shapes: curves from junction to junction with the phases on both sides. Not in space.
sides : list, optional
    Names of the sides of a polygon, for `Fluid`: for each ring a name, a list with a name for each edge
    (that from the first point to the second is the first), or None. Not in space.
**options
    The following ones in the plane.
{_dsc.size_help}
Other Parameters
----------------
**options
    The following ones in space.
{_dsc.size3_help}
Returns
-------
Mesh, or Mesh3 in space
"""

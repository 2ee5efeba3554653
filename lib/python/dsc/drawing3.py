# SPDX-License-Identifier: MIT
"""Pictures of meshes in space by pyvista, or vtk, which are imported on first use."""
import re

import numpy as np

from . import arrays

MOST_EDGES = 20_000  # faces: with more, edges would hide the colours


def plot(mesh, plotter=None, *, values=None, edges=None, palette, **style):
    """The interface of a `Mesh3`; see `dsc.plot`."""
    faces = mesh.interface_faces()
    rows, triangles = np.unique(faces.triangles, return_inverse=True)
    triangles = triangles.reshape(-1, 3)
    if values is not None:
        values = np.asarray(values, float)
        if values.shape != (len(mesh.points),):
            arrays.refuse("not one value for each vertex", "values", f"an array of the shape {values.shape}",
                          f"the shape ({len(mesh.points)},)")
        values = values[rows]
    edges = len(triangles) <= MOST_EDGES if edges is None else edges
    colours = None
    if values is None:
        if len(palette) < 2 or not all(re.fullmatch("#[0-9a-fA-F]{6}", str(one)) for one in palette):
            arrays.refuse("not a palette", "palette", arrays.shown(palette),
                          "two or more colours '#rrggbb' for a Mesh3")
        hexadecimal = [palette[one] for one in 1 + (faces.inside.astype(int) - 1) % (len(palette) - 1)]
        colours = np.array([[int(one[i:i + 2], 16) for i in (1, 3, 5)] for one in hexadecimal], np.uint8)
    try:
        import pyvista
    except ImportError:
        return _vtk_renderer(mesh.points[rows], triangles, values, colours, edges, plotter, style)
    surface = pyvista.PolyData(mesh.points[rows], np.c_[np.full(len(triangles), 3), triangles].ravel())
    plotter = pyvista.Plotter() if plotter is None else plotter
    style = {"show_edges": edges, "scalars": colours if values is None else values, "rgb": values is None} | style
    plotter.add_mesh(surface, **style)
    return plotter


def _vtk_renderer(points, triangles, values, colours, edges, renderer, style):
    try:
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: draws
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
    except ImportError as error:
        raise ImportError("a picture of a Mesh3 needs pyvista or vtk: got neither; `pip install pyvista`, "
                          "or on Debian python3-vtk9") from error
    if style:
        arrays.refuse("a style for pyvista", "plot", ", ".join(style), "none: pyvista is not installed")
    surface, place, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    place.SetData(numpy_to_vtk(points, deep=True))
    packed = np.c_[np.full(len(triangles), 3), triangles].astype(np.int64).ravel()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(packed, deep=True))
    surface.SetPoints(place)
    surface.SetPolys(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    if values is None:
        surface.GetCellData().SetScalars(numpy_to_vtk(colours, deep=True))
    else:
        surface.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
        mapper.SetScalarRange(values.min(initial=np.inf), values.max(initial=-np.inf))
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetEdgeVisibility(bool(edges))
    renderer = vtkRenderer() if renderer is None else renderer
    renderer.AddActor(actor)
    renderer.ResetCamera()
    return renderer

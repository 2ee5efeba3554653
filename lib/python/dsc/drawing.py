# SPDX-License-Identifier: MIT
"""Pictures of meshes by matplotlib, which is imported on first use."""
import numpy as np

from . import arrays, drawing3
from .mesh3 import Mesh3

# The palette of Okabe and Ito (2008), safe for the colour-blind; the exterior is white.
PALETTE = ("#ffffff", "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#0072b2", "#d55e00")
MOST_EDGES = 40_000  # triangles: with more, edges would hide the colours


def plot(mesh, ax=None, *, values=None, edges=None, interface=True, palette=PALETTE, **style):
    """Draws the triangles in the colours of their phases, and the interface on top.

    Parameters
    ----------
    mesh : Mesh or Mesh3
        Of a `Mesh3`, the interface is drawn, by pyvista if it is installed, otherwise by vtk.
    ax : matplotlib.axes.Axes, optional
        By default the current one. For a `Mesh3`: a `pyvista.Plotter`, or a `vtkRenderer`; by default a new one.
    values : array_like, optional
        Values of the triangles, coloured instead of their phases; for a `Mesh3`, of the vertices.
    edges : bool, optional
        Whether edges are drawn; by default if the mesh has few enough.
    interface : bool
        Whether the interface is drawn.
    palette : sequence of colours
        The first is that of phase 0. Larger phases reuse the others, with different colours for
        neighbours if there are enough. For a `Mesh3`: two or more, as '#rrggbb'.
    **style
        Passed to `Axes.tripcolor`; for a `Mesh3`, to `pyvista.Plotter.add_mesh`.

    Returns
    -------
    matplotlib.axes.Axes
        For a `Mesh3`: the `pyvista.Plotter`, whose method `show` opens a window; or the `vtkRenderer`.

    Raises
    ------
    ImportError
        If the package that draws is not installed.
    """
    if isinstance(mesh, Mesh3):
        return drawing3.plot(mesh, ax, values=values, edges=edges, palette=palette, **style)
    import matplotlib.pyplot as plt
    from matplotlib.collections import LineCollection
    from matplotlib.colors import ListedColormap

    ax = plt.gca() if ax is None else ax
    x, y = mesh.points.T
    if edges is None:
        edges = len(mesh.triangles) <= MOST_EDGES
    style.setdefault("edgecolors", "#888888" if edges else "face")
    style.setdefault("linewidth", 0.25 if edges else 0.1)
    if values is None:
        values = _colours(mesh, len(palette))
        style |= {"cmap": ListedColormap(palette), "vmin": -0.5, "vmax": len(palette) - 0.5}
    ax.tripcolor(x, y, mesh.triangles, facecolors=np.asarray(values, float), **style)
    if interface:
        lines = [np.vstack((curve.points, curve.points[:1])) if curve.is_closed else curve.points
                 for curve in mesh.interface_curves()]
        ax.add_collection(LineCollection(lines, colors="black", linewidths=1.5))
    ax.set_aspect("equal")
    ax.set_xlim(x.min(), x.max())
    ax.set_ylim(y.min(), y.max())
    return ax


def _colours(mesh, count):
    """The index of each triangle in a palette: its phase, cyclically; a phase that would have the colour
    of a smaller neighbouring phase takes the next colour that no such neighbour has."""
    phases = mesh.phases.astype(int)
    if count < 2 or phases.max(initial=0) < count:
        return phases % count
    edges = np.sort(np.concatenate([mesh.triangles[:, [i, i - 1]] for i in range(3)]), axis=1)
    order = np.lexsort(edges.T)
    edges, of_edges = edges[order], np.tile(phases, 3)[order]
    twins = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1) & (of_edges[1:] != of_edges[:-1]))
    pairs = np.unique(np.sort(np.c_[of_edges[twins], of_edges[twins + 1]], axis=1), axis=0)
    smaller = {}
    for one, other in pairs.tolist():
        smaller.setdefault(other, []).append(one)
    colours = {0: 0}
    for phase in np.unique(phases).tolist():
        taken = {colours[one] for one in smaller.get(phase, ())}
        wishes = [1 + (phase - 1 + k) % (count - 1) for k in range(count - 1)]
        colours.setdefault(phase, next((colour for colour in wishes if colour not in taken), wishes[0]))
    return np.array([colours[phase] for phase in phases.tolist()])


def animate(sim, flow, dt, steps, *, every=1, ax=None, **style):
    """An animation of a run; the steps are made when it is saved or shown.

    Parameters
    ----------
    sim, flow, dt, steps
        As for `run`.
    every : int
        Steps between pictures.
    ax : matplotlib.axes.Axes, optional
    **style
        Passed to `plot`.

    Returns
    -------
    matplotlib.animation.FuncAnimation
    """
    import matplotlib.pyplot as plt
    from matplotlib.animation import FuncAnimation

    arrays.expect_plane(sim.mesh, "animate")
    ax = plt.gca() if ax is None else ax
    made = 0

    def draw(frame):
        nonlocal made
        while made < frame * every:
            sim.step(flow, sim.time, dt)
            made += 1
        ax.clear()
        plot(sim.mesh, ax, **style)
        ax.set_title(f"t = {sim.time:.3g}")

    return FuncAnimation(ax.figure, draw, frames=steps // every + 1, init_func=lambda: None)

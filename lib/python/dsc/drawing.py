# SPDX-License-Identifier: MIT
"""Pictures of meshes by matplotlib, which is imported where something is drawn."""
import numpy as np

# Okabe and Ito (2008), which the colour-blind can tell apart; the exterior is white.
PALETTE = ("#ffffff", "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#0072b2", "#d55e00")
MOST_EDGES = 40_000  # triangles: with more, edges would cover everything


def plot(mesh, ax=None, *, values=None, edges=None, interface=True, palette=PALETTE, **style):
    """Draws the triangles in the colours of their phases, and the interface on top.

    Parameters
    ----------
    mesh : Mesh
    ax : matplotlib.axes.Axes, optional
        By default the present one.
    values : array_like, optional
        Of each triangle, in place of its phase.
    edges : bool, optional
        Whether edges are drawn; by default where they can be told apart.
    interface : bool
        Whether the interface is drawn.
    palette : sequence of colours
        The first is that of phase 0; phases beyond the last use the others again.
    **style
        Handed to `Axes.tripcolor`.

    Returns
    -------
    matplotlib.axes.Axes
    """
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
        phases = mesh.phases.astype(int)
        values = np.where(phases == 0, 0, 1 + (phases - 1) % (len(palette) - 1))
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


def animate(sim, flow, dt, steps, *, every=1, ax=None, **style):
    """A film of a run, which makes its steps as the film is saved or shown.

    Parameters
    ----------
    sim, flow, dt, steps
        As for `run`.
    every : int
        Steps from picture to picture.
    ax : matplotlib.axes.Axes, optional
    **style
        Handed to `plot`.

    Returns
    -------
    matplotlib.animation.FuncAnimation
    """
    import matplotlib.pyplot as plt
    from matplotlib.animation import FuncAnimation

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

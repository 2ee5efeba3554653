# SPDX-License-Identifier: MIT
import dsc
import matplotlib.pyplot as plt
import numpy as np


def conduct(mesh, conductivity):
    """Temperatures between a wall of 1 at x = 0 and one of 0 at x = 1, and the heat that flows."""
    corners = mesh.points[mesh.triangles]
    edges = np.roll(corners, -1, axis=1) - np.roll(corners, 1, axis=1)  # opposite to each corner
    doubled = np.linalg.det(edges[:, :2])  # areas
    local = np.einsum("tik,tjk->tij", edges, edges) * (conductivity / doubled / 2)[:, None, None]
    matrix = np.zeros((len(mesh.points),) * 2)  # for more points: scipy.sparse.coo_array
    rows = np.repeat(mesh.triangles, 3, axis=1)
    columns = np.tile(mesh.triangles, 3)
    np.add.at(matrix, (rows, columns), local.reshape(-1, 9))
    x = mesh.points[:, 0]
    known = (x == 0) | (x == 1)
    heat = np.where(x == 0, 1.0, 0.0)
    free = ~known
    heat[free] = np.linalg.solve(matrix[np.ix_(free, free)], -matrix[np.ix_(free, known)] @ heat[known])
    return heat, (matrix @ heat)[x == 0].sum()


h = 0.06
mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: dsc.circle((0.5, 0.75), 0.2, h)}, edge_length=h)
sim = dsc.Simulation(mesh, edge_length=h)
flows = []


def solve(sim, report):
    mesh.vertex_data["heat"], flow = conduct(mesh, np.where(mesh.phases == 1, 100.0, 1.0))
    flows.append(flow)


dsc.run(sim, dsc.swirl(), 0.08, 20, after=solve)
print(f"heat flow: {flows[0]:.3f} through a disc, {flows[-1]:.3f} through what it was drawn out to")
figure, axes = plt.subplots(1, 2, figsize=(7, 3.2), layout="constrained")
axes[0].tricontourf(mesh.to_triangulation(), mesh.vertex_data["heat"], 20)
dsc.plot(mesh, axes[0], edgecolors="none", alpha=0)
axes[1].plot(0.08 * np.arange(1, 21), flows)
axes[1].set(xlabel="time", title="heat flow")
figure.savefig("conduction.png", dpi=80)

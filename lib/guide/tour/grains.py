# SPDX-License-Identifier: MIT
import dsc
import matplotlib.pyplot as plt
import numpy as np

# Each triangle of an empty mesh belongs to the grain whose seed is the nearest.
h = 0.02
empty = dsc.initial_complex(((0, 0), (1, 1)), edge_length=h)
seeds = np.random.default_rng(3).random((40, 2))
centres = empty.points[empty.triangles].mean(axis=1)
grains = 1 + np.hypot(*(centres[:, None] - seeds).T).argmin(axis=0)
mesh = dsc.Mesh(empty.points, empty.triangles, grains)

# Boundaries move by their curvature; a jagged one is smooth at once, so no corner is kept.
sim = dsc.Simulation(mesh, edge_length=h, feature_degrees=180, topology="change")
events, left = [], []


def note(sim, report):
    events.extend(report.events)
    left.append(len(mesh.areas))


figure, axes = plt.subplots(1, 3, figsize=(9, 3.2), layout="constrained")
dsc.plot(mesh, axes[0], edges=False)
dsc.run(sim, dsc.curvature_flow(), 2e-4, 100, after=note)
dsc.plot(mesh, axes[1], edges=False)
axes[2].plot(2e-4 * np.arange(1, 101), left)
axes[2].set(xlabel="time", title="grains")
kinds, counts = np.unique([event.kind for event in events], return_counts=True)
print(f"{left[-1]} grains are left; events: {dict(zip(kinds.tolist(), counts.tolist()))}")
for ax, title in zip(axes, ("the start", "time 0.02")):
    ax.set(title=title, xticks=(), yticks=())
figure.savefig("grains.png", dpi=72)

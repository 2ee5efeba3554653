# SPDX-License-Identifier: MIT
import dsc
import matplotlib.pyplot as plt
import numpy as np

h = 0.02
start = dsc.circle((0.5, 0.75), 0.15, h)
mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: start}, edge_length=h)
sim = dsc.Simulation(mesh, edge_length=h, threads=2)


def swirl(x, t):
    bump, slope = (x * (1 - x)).T, (1 - 2 * x).T
    return 160 * np.c_[bump[0]**2 * bump[1] * slope[1], -bump[1]**2 * bump[0] * slope[0]]


figure, axes = plt.subplots(1, 3, figsize=(9, 3.2), layout="constrained")
dsc.plot(mesh, axes[0])
dsc.run(sim, swirl, 0.01, 100)
dsc.plot(mesh, axes[1])
dsc.run(sim, lambda x, t: -swirl(x, t), 0.01, 100)
dsc.plot(mesh, axes[2])
error = dsc.symmetric_difference(mesh.outlines(1, samples=16), dsc.circle((0.5, 0.75), 0.15, 1e-3))
print(f"back again, all but {error / mesh.areas[1]:.1e} of the area")
for ax, title in zip(axes, ("the start", "after time 1", "and back")):
    ax.set(title=title, xticks=(), yticks=())
figure.savefig("swirl.png", dpi=72)

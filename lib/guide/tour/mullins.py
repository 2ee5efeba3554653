import dsc
import matplotlib.pyplot as plt
import numpy as np

# Grains in an L-shaped section, each with an orientation; the tension of a boundary grows with the angle between the
# orientations of its grains (W. T. Read and W. Shockley, 1950).
h, dt = 0.025, 2e-4
section = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
random = np.random.default_rng(5)
seeds = 2 * random.random((160, 2))
orientations = random.uniform(0, 15, 161)
apart = np.maximum(np.abs(orientations[:, None] - orientations) / 15, 0.1)
read_shockley = apart * (1 - np.log(apart))

empty = dsc.initial_complex(section, edge_length=h)
centres = empty.points[empty.triangles].mean(axis=1)
nearest = 1 + np.hypot(*(centres[:, None] - seeds).T).argmin(axis=0)
told = []
figure, axes = plt.subplots(1, 3, figsize=(10, 3.4), layout="constrained")
for ax, tension, title in ((axes[0], 1.0, "equal tensions"), (axes[1], read_shockley, "Read and Shockley")):
    mesh = dsc.Mesh(empty.points, empty.triangles, nearest)
    sim = dsc.Simulation(mesh, edge_length=h, feature_degrees=180, topology="change")
    flow = dsc.curvature_flow(tension=tension)
    dsc.run(sim, flow, dt, 40)
    before = dsc.grains(mesh)
    dsc.run(sim, flow, dt, 5)
    after = dsc.grains(mesh)
    # Grains inside the section that have kept their sides; von Neumann and Mullins: dA/dt = pi / 3 (n - 6).
    phases, old, new = np.intersect1d(before["phase"], after["phase"], return_indices=True)
    kept = (before["sides"][old] == after["sides"][new]) & ~before["at_boundary"][old]
    sides = before["sides"][old][kept]
    rates = (after["area"][new] - before["area"][old])[kept] / (5 * dt)
    off = np.abs(rates - np.pi / 3 * (sides - 6)) / (np.pi / 3)
    told.append(f"{title}: {len(sides)} grains, median difference {np.median(off):.1g}")
    ax.plot(sides, rates / (np.pi / 3), "o", alpha=0.6)
    ax.plot((3, 9), (-3, 3), "k:")
    ax.set(xlabel="sides n", ylabel="dA/dt, in units of π/3", title=title)
dsc.plot(mesh, axes[2], edges=False)
axes[2].set(title="the grains at the end", xticks=(), yticks=())
print("; ".join(told))
figure.savefig("mullins.png", dpi=72)

import dsc
import matplotlib.pyplot as plt
import numpy as np

h = 0.04
square = ((0, 0), (1, 1))


def ring(x, y, radius, count, waves=0):
    angle = np.linspace(0, 2 * np.pi, count)  # the last point repeats the first, all but rounding
    radius = radius * (1 + waves * np.cos(40 * angle))
    return np.c_[x + radius * np.cos(angle), y + radius * np.sin(angle)]


# A fine outline, and a speck.
coast = dsc.initial_complex(square, {1: [ring(.5, .5, .3, 5000, .02), ring(.9, .9, .005, 20)]}, edge_length=h)

# An island with a lake, as geometries of other packages say it; another island reaches beyond the map.
island = {"type": "Polygon", "coordinates": [ring(.4, .5, .3, 80), ring(.45, .5, .12, 40)]}
islands = dsc.initial_complex(square, {1: [island, ring(1, .2, .2, 60)]}, edge_length=h)

# Polygons that share their borders become curves that meet at junctions.
cells = {1: [(0, 0), (.6, 0), (.5, .4), (0, .5)], 2: [(.6, 0), (1, 0), (1, .6), (.5, .4)],
         3: [(0, .5), (.5, .4), (.4, 1), (0, 1)], 4: [(.5, .4), (1, .6), (1, 1), (.4, 1)]}
coverage = dsc.initial_complex(square, cells, edge_length=h)

# Pixels with the number of the nearest of twelve seeds.
seeds = np.random.default_rng(1).integers(0, 50, (12, 2))
rows, columns = np.indices((50, 50))
labels = ((rows[..., None] - seeds[:, 0])**2 + (columns[..., None] - seeds[:, 1])**2).argmin(axis=-1)
grains = dsc.from_labels(labels, square, min_pixels=20, edge_length=h)
error = max(abs(area - (labels == phase).mean()) for phase, area in grains.areas.items())
print(f"{coast.input_report.dropped} speck left out, {islands.input_report.clipped} island cut off, "
      f"areas of grains kept to 1e-6: {error < 1e-6}")

figure, axes = plt.subplots(1, 4, figsize=(12, 3.2), layout="constrained")
for ax, mesh, title in zip(axes, (coast, islands, coverage, grains),
                           ("detail", "holes, and beyond the domain", "shared borders", "a label image")):
    dsc.plot(mesh, ax)
    ax.set(title=title, xticks=(), yticks=())
figure.savefig("shapes.png", dpi=72)

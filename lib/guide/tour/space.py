import dsc
import matplotlib.pyplot as plt
import numpy as np

h = 0.04
ball = dsc.ball((0.35, 0.35, 0.35), 0.15)
halves = [(ball, 1), (lambda x: x[:, 2] - 0.35, {1: 2})]  # below this plane, phase 1 becomes 2
mesh = dsc.initial_complex(((0, 0, 0), (1, 1, 1)), halves, edge_length=h)
sim = dsc.Simulation(mesh, edge_length=h, threads=2)
figure, axes = plt.subplots(1, 3, figsize=(9, 3.2), subplot_kw={"projection": "3d"}, layout="constrained")


def flow(x):
    (a, b, c), (p, q, r) = (x * (1 - x)).T, (x * (1 - x) * (1 - 2 * x)).T
    return 1700 * np.c_[2 * a * a * q * r, -b * b * p * r, -c * c * p * q]


for ax, sign, title in zip(axes, (0, 1, -1), ("the start", "after time 0.5", "and back")):
    dsc.run(sim, lambda x, t: sign * flow(x), 0.02, 25)
    faces = mesh.interface_faces()
    ax.plot_trisurf(*mesh.points.T, triangles=faces.triangles[faces.inside == 1], color="C0")
    ax.plot_trisurf(*mesh.points.T, triangles=faces.triangles[faces.inside == 2], color="C1")
    ax.set(xlim=(0.2, 0.8), ylim=(0.1, 0.7), zlim=(0.15, 0.75))
    ax.set_box_aspect((1, 1, 1), zoom=1.5)
    ax.set_title(title, y=0.9)
    ax.set_axis_off()
outer = mesh.points[np.unique(faces.triangles[faces.outside == 0])]
print(f"back within {np.abs(ball(outer)).max() / h:.0e} edge lengths of the ball")
figure.savefig("space.png", dpi=72)

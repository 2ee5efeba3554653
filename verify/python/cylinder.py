# SPDX-License-Identifier: MIT
"""The flow past a cylinder of the guide."""
import dsc
import numpy as np

angles = np.arange(32) * 2 * np.pi / 32
channel = [(0, 0), (2.2, 0), (2.2, 0.41), (0, 0.41)]
cylinder = np.c_[0.2 + 0.05 * np.cos(angles), 0.2 + 0.05 * np.sin(angles)]

mesh = dsc.initial_complex([channel, cylinder], sides=[["wall", "outlet", "wall", "inlet"], "cylinder"],
                           edge_length=0.01, growth=1.2, longest=0.04)
sim = dsc.Simulation(mesh, edge_length=0.01)
fluid = dsc.Fluid(sim, {0: (1, 0.001)}, {}, open="outlet",
                  inflow={"inlet": lambda x, y, t: 1.2 * y * (0.41 - y) / 0.41**2})
for _ in range(50):
    fluid.step(0.04)
drag, lift = 500 * np.array(fluid.force_on("cylinder"))

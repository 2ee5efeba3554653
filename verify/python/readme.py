# SPDX-License-Identifier: MIT
import dsc
import numpy as np

a = np.linspace(0, 2*np.pi, 96, endpoint=False)
disc = np.c_[.5 + .15*np.cos(a), .75 + .15*np.sin(a)]
mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: disc}, edge_length=.01)
sim = dsc.Simulation(mesh, edge_length=.01, threads=2)

def swirl(x, t):
    X, Y = np.pi*x.T
    return np.c_[np.sin(X)**2*np.sin(2*Y), -np.sin(Y)**2*np.sin(2*X)]

for k in range(100):
    assert sim.step(swirl, .01*k, .01).unreached == 0
ax = dsc.plot(mesh)          # phases, edges, interface

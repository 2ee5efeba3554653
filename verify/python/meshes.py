# SPDX-License-Identifier: MIT
"""Meshes and flows that several tests use."""
import dsc
import numpy as np

H = 0.02
DOMAIN = ((0, 0), (1, 1))
BOX = ((0, 0, 0), (1, 1, 1))


def disc(centre=(0.5, 0.75), radius=0.15, points=48):
    angles = np.linspace(0, 2 * np.pi, points, endpoint=False)
    return np.c_[centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles)]


def disc_mesh(h=H, **where):
    return dsc.initial_complex(DOMAIN, {1: disc(**where)}, edge_length=h)


def ball_mesh(h=0.1):
    return dsc.initial_complex(BOX, {1: dsc.ball((0.5, 0.5, 0.6), 0.25)}, edge_length=h)


def l_shape(n=20, phase=lambda centres: 0):
    """A mesh of the unit square without its upper right quarter; phases by the centres of triangles."""
    row = n + 1
    j, i = (one.ravel() for one in np.mgrid[:row, :row])
    low = (j * row + i)[(i < n) & (j < n) & ((2 * i < n) | (2 * j < n))]
    corners = np.r_[np.c_[low, low + 1, low + row + 1], np.c_[low, low + row + 1, low + row]]
    used, triangles = np.unique(corners, return_inverse=True)
    points = np.c_[i, j][used] / n
    triangles = triangles.reshape(-1, 3)
    return dsc.Mesh(points, triangles, phase(points[triangles].mean(axis=1)) + np.zeros(len(triangles), int))


def swirl(x, t):
    X, Y = np.pi * x.T
    return np.c_[np.sin(X)**2 * np.sin(2 * Y), -np.sin(Y)**2 * np.sin(2 * X)]


def turn(x, t):
    """In space, about an axis through the centre of the box."""
    return np.c_[0.5 - x[:, 1], x[:, 0] - 0.5, 0 * t * x[:, 2]]


def started(steps=3, **options):
    sim = dsc.Simulation(ball_mesh(), edge_length=0.1, **options)
    dsc.run(sim, turn, 0.1, steps)
    return sim

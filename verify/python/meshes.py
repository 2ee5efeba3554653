# SPDX-License-Identifier: MIT
"""Meshes and flows that several tests use."""
import dsc
import numpy as np

H = 0.02
DOMAIN = ((0, 0), (1, 1))


def disc(centre=(0.5, 0.75), radius=0.15, points=48):
    angles = np.linspace(0, 2 * np.pi, points, endpoint=False)
    return np.c_[centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles)]


def disc_mesh(h=H, **where):
    return dsc.initial_complex(DOMAIN, {1: disc(**where)}, edge_length=h)


def swirl(x, t):
    X, Y = np.pi * x.T
    return np.c_[np.sin(X)**2 * np.sin(2 * Y), -np.sin(Y)**2 * np.sin(2 * X)]

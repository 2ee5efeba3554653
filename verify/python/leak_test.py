# SPDX-License-Identifier: MIT
"""Memory must not grow over ten thousand steps, and an interruption must be quick even if steps are long."""
import gc
import os
import pickle
import resource
import signal
import threading
import time
import tracemalloc
import unittest

import dsc
import numpy as np
from meshes import BOX, DOMAIN, ball_mesh, disc_mesh, swirl, turn

STEPS = 10_000
H = 0.1


def resident():
    """Bytes."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


class Leaks(unittest.TestCase):
    def test_ten_thousand_steps_leave_nothing(self):
        mesh = disc_mesh(H)
        sim = dsc.Simulation(mesh, edge_length=H, topology="change")

        def failing(x, t):
            raise ValueError("no")

        def to_and_fro(x, t):
            return swirl(x, t) * np.cos(np.pi * t)

        flows = (to_and_fro, dsc.interface_flow(lambda one, t: to_and_fro(one.positions, t)), dsc.swirl(1, 2))

        def go(steps):
            for k in range(steps):
                sim.step(flows[k % 3], 0.01 * k, 0.01)
                if k % 10 == 0:
                    mesh.vertex_data["x"] = mesh.points[:, 0]
                    mesh.interface_curves(), mesh.outlines(1), mesh.figures, mesh.qualities, repr(sim)
                    for error, flow in ((ValueError, failing), (dsc.InputError, lambda x, t: None)):
                        with self.assertRaises(error):
                            sim.step(flow, 0, 0.01)
                if k % 1000 == 0:
                    pickle.loads(pickle.dumps(sim)).step(to_and_fro, 0, 0.01)

        self.expect_no_growth(go, STEPS)

    def test_steps_in_space_leave_nothing(self):
        mesh = ball_mesh(0.2)
        sim = dsc.Simulation(mesh, edge_length=0.2, threads=2)

        def failing(x, t):
            raise ValueError("no")

        def go(steps):
            for k in range(steps):
                sim.step(lambda x, t: turn(x, t) * np.cos(np.pi * t), 0.1 * k, 0.1)
                if k % 10 == 0:
                    mesh.vertex_data["x"] = mesh.points
                    mesh.interface_faces(), mesh.volumes, mesh.min_dihedrals, mesh.qualities, repr(mesh)
                    for error, flow in ((ValueError, failing), (dsc.InputError, lambda x, t: None)):
                        with self.assertRaises(error):
                            sim.step(flow, 0, 0.1)
                if k % 100 == 0:
                    pickle.loads(pickle.dumps(sim)).step(turn, 0, 0.1)
                    dsc.initial_complex(BOX, {1: lambda x: np.linalg.norm(x - 0.5, axis=1) - 0.3}, edge_length=0.2)

        self.expect_no_growth(go, STEPS // 10)

    def expect_no_growth(self, go, steps):
        tracemalloc.start()
        resident()
        go(steps // 10)  # first, so that imports and caches do not count
        gc.collect()
        first, rss = tracemalloc.take_snapshot(), resident()
        go(steps)
        gc.collect()
        grown = tracemalloc.take_snapshot().compare_to(first, "filename")
        tracemalloc.stop()
        ours = sum(one.size_diff for one in grown if "tracemalloc" not in one.traceback[0].filename)
        self.assertLess(ours, 20_000, grown[:5])  # one object leaked in each step would be more
        self.assertLess(resident() - rss, 4e6)


class Interrupted(unittest.TestCase):
    def test_control_c_ends_a_run_within_a_sub_step(self):
        h = 0.003
        for flow in (dsc.swirl(period=2), swirl):
            waits = []
            for _ in range(5):
                mesh = dsc.initial_complex(DOMAIN, {1: dsc.circle((0.5, 0.75), 0.15, h)},
                                           edge_length=h)
                sim = dsc.Simulation(mesh, edge_length=h, threads=2)

                def interrupt():
                    waits.append(-time.perf_counter())
                    os.kill(os.getpid(), signal.SIGINT)

                timer = threading.Timer(0.2, interrupt)
                timer.start()
                with self.assertRaises(KeyboardInterrupt):
                    while True:
                        sim.step(flow, 0, 1)
                waits[-1] += time.perf_counter()
                timer.join()
                self.assertEqual(mesh.validate(), "")
            self.assertLess(sorted(waits)[2], 0.05, waits)


if __name__ == "__main__":
    unittest.main()

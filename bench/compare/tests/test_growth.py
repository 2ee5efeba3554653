# SPDX-License-Identifier: MIT
"""The exponents of a step's work, with synthetic counts: a loop over the whole mesh has to be seen."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import growth  # noqa: E402

OF_A_VERTEX = 7000  # instructions, about what a step takes


def rows(of_a_triangle=0.0, of_a_vertex=lambda n: OF_A_VERTEX):
    """What a step counts in circles of radius 0.1."""
    found = []
    for triangles in growth.SIZES:
        vertices = 0.628 / growth.edge_length(triangles)
        found.append(growth.Row(triangles, vertices,
                                vertices * of_a_vertex(vertices) + of_a_triangle * triangles))
    return found


class Exponents(unittest.TestCase):
    def test_of_a_power(self):
        found = growth.fit([(x, 3 * x ** 0.7) for x in (10, 200, 3000)])
        for exponent in (found.exponent, found.low, found.high):
            self.assertAlmostEqual(exponent, 0.7)

    def test_the_spread_is_that_between_neighbours(self):
        found = growth.fit([(1, 1), (10, 10), (100, 1000)])
        self.assertAlmostEqual(found.low, 1)
        self.assertAlmostEqual(found.high, 2)
        self.assertAlmostEqual(found.exponent, 1.5)

    def test_work_along_the_interface(self):
        self.assertAlmostEqual(growth.of_step(rows()).exponent, 0.5, places=3)
        self.assertAlmostEqual(growth.of_vertex(rows()).exponent, 0, places=3)
        self.assertFalse(growth.is_too_much(rows()))

    def test_a_loop_over_the_mesh_is_too_much(self):
        for instructions in (1, 5, 100):
            self.assertTrue(growth.is_too_much(rows(of_a_triangle=instructions)), instructions)

    def test_what_is_done_once_in_a_step_is_not(self):
        """It weighs most in small meshes, so that work seems to fall."""
        found = rows(of_a_vertex=lambda n: OF_A_VERTEX + 50_000 / n)
        self.assertFalse(growth.is_too_much(found))

    def test_nothing_can_be_fitted_to_one_size(self):
        for points in ([], [(1, 1)], [(2, 1), (2, 3)], [(1, 0), (2, 1)]):
            with self.assertRaises(ValueError):
                growth.fit(points)

    def test_the_edge_length_fits_the_number(self):
        h = growth.edge_length(28_000)
        self.assertAlmostEqual(28_000 * h * h * 3 ** 0.5 / 4, 1)


if __name__ == "__main__":
    unittest.main()

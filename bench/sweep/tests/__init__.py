# SPDX-License-Identifier: MIT
"""Tests of bench/sweep: `python3 -m unittest tests.test_sweep` in bench/sweep."""

# SPDX-License-Identifier: MIT
"""Tests of the pictures and of the page, with small made-up results."""

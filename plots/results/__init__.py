# SPDX-License-Identifier: MIT
"""Readers of result files: every fault of a file is one sentence."""

# SPDX-License-Identifier: MIT
"""Pictures of steps and threads, from dsc_bench."""

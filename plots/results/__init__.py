# SPDX-License-Identifier: MIT
"""Readers of result files; errors of files are one sentence each."""

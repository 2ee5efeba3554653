# SPDX-License-Identifier: MIT
"""Pictures and tables of errors: dsc_precision and dsc_hard."""

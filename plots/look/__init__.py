# SPDX-License-Identifier: MIT
"""What all pictures share: palette, markers, layout, saving."""

# SPDX-License-Identifier: MIT
"""What the gallery takes from the other plots, in one place: their look, and their page."""
import page  # noqa: F401
import style  # noqa: F401

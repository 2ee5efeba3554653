# SPDX-License-Identifier: MIT
"""What the gallery takes from the other plots, in one place: their look, and their page."""
from look import style  # noqa: F401
from page import document as page  # noqa: F401

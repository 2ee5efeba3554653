# SPDX-License-Identifier: MIT
"""What the gallery takes from the other plots, in one place: their look, their page, their reader."""
from look import style  # noqa: F401
from page import document as page  # noqa: F401
from results import vtu  # noqa: F401

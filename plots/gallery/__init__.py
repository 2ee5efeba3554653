# SPDX-License-Identifier: MIT
"""The gallery: each figure and table of the thesis's section 10 in our own words, and ours.

Reading order: runs (dsc_scene and its frames), figures (what is run for which figure), layout (HTML),
build (all of these for each figure); make.py (the command).
"""
PART = "section.html"


def section(out):
    """The part of the report in the folder `out`: what make.py has written into the folder `gallery`
    within it; nothing where it has not."""
    part = out / "gallery" / PART
    return part.read_text(encoding="utf-8") if part.is_file() else ""

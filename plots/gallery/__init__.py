# SPDX-License-Identifier: MIT
"""The gallery: each figure and table of the thesis's section 10, described in our own words, beside ours.

Reading order: runs (dsc_scene and its frames), figures (what is run for which figure), layout (HTML),
build (all of these for each figure); make.py (the command).
"""
PART = "section.html"


def section(out):
    """The section of the report: the page that make.py has written into the folder `gallery` in the folder
    `out`; nothing if there is none."""
    part = out / "gallery" / PART
    return part.read_text(encoding="utf-8") if part.is_file() else ""

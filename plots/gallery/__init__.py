# SPDX-License-Identifier: MIT
"""The gallery: each figure and table of the thesis's section 10 in our own words, and ours.

Reading order: runs (dsc_scene and its frames), thesis (its facts), figures (what is run for which
figure); mesh, animation, charts (pictures); compare, distribution, busy, times (numbers); layout
(HTML); build (all of these for each figure); make.py (the command).
"""
import pathlib
import tempfile

from gallery import build, layout, thesis
from gallery.runs import NotRun, Program
from gallery.shared import page, style

PART = "section.html"


def write(program, out, quick=False):
    """Runs and draws everything; writes pictures, gallery.html and the part for the report into
    `out`. Returns a sentence for each run that failed. Throws NotRun where the program cannot be
    run at all."""
    with tempfile.TemporaryDirectory() as folder:
        builder = build.Builder(Program(program, folder), thesis.Facts(), quick)
        blocks = builder.blocks()
    out.mkdir(parents=True, exist_ok=True)
    for block in blocks:
        for picture in block.pictures:
            style.write_bytes(str(out / picture.name), picture.data)
    head = page.facts(builder.context)
    style.write_bytes(str(out / "gallery.html"), layout.document(blocks, head).encode("utf-8"))
    style.write_bytes(str(out / PART), layout.fragment(blocks, f"{out.name}/").encode("utf-8"))
    return builder.failures


def section(results, out):
    """The part of the report whose folder is `out`: what make.py wrote into the folder `gallery`
    within it. Where nothing is there yet and results["scene"] names the program, it is made;
    without either there is no section (None)."""
    folder = pathlib.Path(out) / "gallery"
    if not (folder / PART).is_file():
        if not results.get("scene"):
            return None
        write(results["scene"], folder, bool(results.get("quick")))
    return (folder / PART).read_text(encoding="utf-8")

#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of the thesis's section 10 with ours under them: gallery.html and pictures.

make.py --scene build/release/lib/scenes/dsc_scene --out DIR

All runs are made again, in less than a minute of CPU time. Exit 1: a run failed.
"""
import os
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from look import saving, script  # noqa: E402  (the folder above must be on the path first)

import gallery  # noqa: E402
from gallery import build, layout, runs  # noqa: E402
from page import document as page  # noqa: E402
from results import load  # noqa: E402

PUBLISHED = pathlib.Path(__file__).resolve().parents[2] / "reference" / "published"


def write(scene, out):
    """Returns a sentence for each run that failed."""
    with tempfile.TemporaryDirectory() as folder:
        blocks, failures = build.blocks(runs.Program(scene, folder), load.read_published(PUBLISHED))
    os.makedirs(out, exist_ok=True)
    for picture in (picture for block in blocks for picture in block.pictures):
        saving.write_bytes(os.path.join(out, picture.name), picture.data)
    parts = [layout.block_html(block) for block in blocks]
    whole = page.document(
        "The thesis's figures, and ours", "Each figure and table of section 10 of the thesis in "
        "our own words, and the same experiment with this library.", "",
        [(f"figure-{block.number.replace(' ', '-')}", block.number, part)
         for block, part in zip(blocks, parts)])
    for name, text in (("gallery.html", whole), (gallery.PART, "".join(parts))):
        saving.write_bytes(os.path.join(out, name), text.encode("utf-8"))
    return failures


def main(argv=None):
    words = script.parser(__doc__)
    words.add_argument("--scene", required=True, metavar="FILE", help="the program dsc_scene")
    words.add_argument("--out", required=True, metavar="DIR", help="folder for the gallery")
    given = words.parse_args(argv)
    failures = []
    status = script.attempt(words.prog, lambda: failures.extend(write(given.scene, given.out)))
    for failure in failures:
        sys.stderr.write(f"{words.prog}: {failure}\n")
    return 1 if failures else status


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: MIT
"""Draws the pictures of all sections, several at a time, and keeps the data that the page needs."""
import multiprocessing
import os
from dataclasses import dataclass, replace

from look import saving, style


@dataclass(frozen=True)
class Drawn:
    """A picture that has been drawn and saved."""

    picture: style.Picture  # without its figure
    webp: bytes
    size: tuple   # (width, height) in pixels
    files: tuple  # names beside the page


_work = []  # tasks of draw_all while it runs, inherited by its processes


def _draw(index):
    """Draws and saves pictures one by one, so that at most one figure is open."""
    draw, out, formats = _work[index]
    result = []
    for picture in draw():
        kept = [form for form in formats if form == "png" or not picture.is_mesh]
        png = saving.save(picture.figure, os.path.join(out, picture.name), kept, picture.is_mesh,
                         shown=True)
        result.append(Drawn(replace(picture, figure=None), *saving.for_page(png, picture.is_mesh),
                            tuple(f"{picture.name}.{form}" for form in kept)))
    return result


def draw_all(tasks, out, formats, jobs):
    """tasks: [(section, function without arguments that returns Pictures)]; the result is
    {section: [Drawn]} in the order of the tasks, for any number of jobs."""
    found = {}
    _work[:] = [(draw, out, formats) for _, draw in tasks]
    try:
        if jobs > 1 and len(tasks) > 1:
            with multiprocessing.get_context("fork").Pool(jobs) as pool:
                drawn = pool.map(_draw, range(len(tasks)), chunksize=1)
        else:
            drawn = [_draw(index) for index in range(len(tasks))]
    finally:
        _work.clear()
    for (section, _), pictures in zip(tasks, drawn):
        found.setdefault(section, []).extend(pictures)
    return found

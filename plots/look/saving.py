# SPDX-License-Identifier: MIT
"""Writes pictures: as PNG, as WebP for a page, or in a vector format."""
import io
import os
import uuid

import matplotlib.pyplot as plt
from PIL import Image

PNG_DPI = 120
MESH_DPI = 160      # of pictures without a vector format
RASTER_DPI = 220    # of images inside vector formats
PAGE_WIDTH = 1020   # pixels of a mesh: as wide as a page
MESH_QUALITY = 50   # of 100
UNDATED = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}  # formats that carry a date


def settle(fig):
    """Lays the figure out once for all formats, rounded to a millionth of its size: the last digits of
    the layout's solver depend on memory addresses and would change the files."""
    fig.draw_without_rendering()
    fig.set_layout_engine("none")
    for axes in fig.axes:
        axes.set_position([round(value, 6) for value in axes.get_position(original=True).bounds])


def png_bytes(fig, is_mesh=False):
    buffer = io.BytesIO()
    fig.savefig(buffer, format="png", dpi=MESH_DPI if is_mesh else PNG_DPI)
    return buffer.getvalue()


def for_page(png, is_mesh):
    """(bytes, (width, height)): the picture as WebP. Flat drawings are smallest lossless and at their
    original size; meshes of many triangles are smaller scaled and lossy."""
    image = Image.open(io.BytesIO(png)).convert("RGB")
    if is_mesh and image.width > PAGE_WIDTH:
        height = round(image.height * PAGE_WIDTH / image.width)
        image = image.resize((PAGE_WIDTH, height), Image.LANCZOS)
    buffer = io.BytesIO()
    image.save(buffer, format="WEBP", method=4,
               **({"quality": MESH_QUALITY} if is_mesh else {"lossless": True}))
    return buffer.getvalue(), image.size


def write_bytes(path, data):
    """Writes a file atomically: to a temporary name, which is renamed. Follows links; a device or a pipe is
    written to directly."""
    if os.path.exists(path) and not os.path.isfile(path):
        with open(path, "wb") as stream:
            stream.write(data)
        return
    place = os.path.realpath(path)
    part = os.path.join(os.path.dirname(place), f"{uuid.uuid4().hex}.part")
    try:
        with open(part, "xb") as stream:
            stream.write(data)
        os.replace(part, place)
    except OSError:
        if os.path.exists(part):
            os.remove(part)
        raise


def few_colours(png):
    """The PNG with a palette, which has a third of the size."""
    buffer = io.BytesIO()
    Image.open(io.BytesIO(png)).convert("RGB").quantize(
        256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(
            buffer, format="PNG", optimize=True)
    return buffer.getvalue()


def save(fig, stem, formats, is_mesh=False, shown=False):
    """Writes the figure to stem.FORMAT for every format and closes it; returns it as PNG with all colours
    if it is to be shown."""
    settle(fig)
    full = png_bytes(fig, is_mesh) if shown or "png" in formats else None
    for form in formats:
        if form == "png":
            data = few_colours(full)
        else:
            buffer = io.BytesIO()
            fig.savefig(buffer, format=form, dpi=RASTER_DPI, metadata=UNDATED.get(form))
            data = buffer.getvalue()
        write_bytes(f"{stem}.{form}", data)
    plt.close(fig)
    return full

# SPDX-License-Identifier: MIT
"""A flow as an animated WebP that loops: the frames of one run at equal times.

The pictures have few colours and are stored without loss: at this size that is sharper than loss,
which leaves traces where something has moved.
"""
import io

from PIL import Image

from gallery import mesh

PIXELS = 220
FRAMES = (24, 16, 10)  # at most so many; fewer where the result would be too large
LARGEST = 80_000       # bytes: a dozen share a page
COLOURS = 16
BEAT = 120             # milliseconds a frame
PAUSE = 1200           # for the last one
EDGE = "#C9D2D8"       # of a coarse mesh; those of a fine one would be a haze


def picked(count, most):
    """At most `most` of the numbers 0 to count - 1, evenly, both ends among them."""
    most = min(count, most)
    if most < 2:
        return list(range(most))
    return sorted({round(k * (count - 1) / (most - 1)) for k in range(most)})


def drawn(frames, look):
    """A picture of each frame, all in the same few colours."""
    coarse = len(frames[0].triangles) <= mesh.COARSE
    manner = {"fine": 1, "edge": EDGE} if coarse else {"fine": 3, "edge": mesh.NO_EDGE}
    images = [mesh.draw(f, PIXELS, **{**manner, **look(f)}) for f in frames]
    sample = Image.new("RGB", (PIXELS, 3 * images[0].height))
    for k in range(3):
        sample.paste(images[k * (len(images) - 1) // 2], (0, k * images[0].height))
    palette = sample.quantize(COLOURS, dither=Image.Dither.NONE)
    return [image.quantize(palette=palette, dither=Image.Dither.NONE).convert("RGB")
            for image in images]


def animate(frames, look=lambda frame: {}, largest=LARGEST):
    """(animation, still picture to stand in for it, number of frames), the first two as bytes, or
    None where it cannot be made small enough.

    frames: in order of time; look: what mesh.draw is told besides, of a frame."""
    for most in FRAMES:
        chosen = [frames[k] for k in picked(len(frames), most)]
        if len(chosen) < 2:
            return None
        images = drawn(chosen, look)
        buffer = io.BytesIO()
        images[0].save(buffer, "WEBP", save_all=True, append_images=images[1:], loop=0,
                       duration=[BEAT] * (len(images) - 1) + [PAUSE], lossless=True, quality=70,
                       method=4, kmin=0, kmax=1 << 20)
        if buffer.tell() <= largest:
            still = mesh.webp(images[len(images) // 2], lossless=True)
            return buffer.getvalue(), still, len(images)
    return None

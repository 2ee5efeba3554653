# SPDX-License-Identifier: MIT
"""A flow as an animated WebP that loops: the frames of one run at equal times."""
import io

from gallery import mesh

PIXELS = 230
MOST_FRAMES = 30
LARGEST = 50_000  # bytes: a dozen share a page
QUALITIES = (48, 36, 26, 18, 12, 6)  # the first one that is small enough
BEAT = 110    # milliseconds a frame
PAUSE = 1200   # for the last one
EDGES = ("#BAC4CB", "#D2D9DE")  # of coarse and fine meshes: lighter than where nothing moves


def picked(count, most):
    """At most `most` of the numbers 0 to count - 1, evenly, both ends among them."""
    most = min(count, most)
    if most < 2:
        return list(range(most))
    return sorted({round(k * (count - 1) / (most - 1)) for k in range(most)})


def still(frames, fills=mesh.phase_fills):
    """What is shown in its place where motion is unwelcome: the middle frame."""
    frame = frames[len(frames) // 2]
    return mesh.webp(mesh.draw(frame, PIXELS, fills(frame)), quality=40)


def animate(frames, fills=mesh.phase_fills, largest=LARGEST):
    """The bytes of the animation, or None where it cannot be made small enough.

    frames: in order of time; fills: the colours of the triangles of a frame."""
    chosen = [frames[k] for k in picked(len(frames), MOST_FRAMES)]
    if len(chosen) < 2:
        return None
    edge = EDGES[len(chosen[0].triangles) > mesh.COARSE]
    images = [mesh.draw(f, PIXELS, fills(f), fine=2, edge=edge) for f in chosen]
    pauses = [BEAT] * (len(images) - 1) + [PAUSE]
    for quality in QUALITIES:
        buffer = io.BytesIO()
        images[0].save(buffer, "WEBP", save_all=True, append_images=images[1:], duration=pauses,
                       loop=0, quality=quality, method=3, minimize_size=False,
                       kmin=0, kmax=1 << 20)
        if buffer.tell() <= largest:
            return buffer.getvalue()
    return None

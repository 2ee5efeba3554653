# SPDX-License-Identifier: MIT
"""Makes the runs of the table of figures, draws them, and returns one Block for each figure."""
import colorsys

from look import saving, style  # first: reports a Python without matplotlib

import numpy
from matplotlib.colors import ListedColormap

import frames
import histograms
from gallery import figures, layout
from results import load, load_frames

SIDE = 2.5  # inches of a frame
NONE = "–"
# The thesis's colours of section 10.5: shades of red, from black to white with the value.
REDS = ListedColormap([colorsys.hls_to_rgb(0, step / 255, 1) for step in range(256)])


def blocks(program, published):
    """(blocks, sentences on the runs that failed)"""
    made, failures = [], []
    for figure in figures.FIGURES:
        known = published["thesis"]["figures"][figure.number]
        block = layout.Block(figure.number, known["title"], known["shows"], known["source"],
                             [figure.see] if figure.see else [])
        for index, part in enumerate(figure.parts):
            add = frames_of if isinstance(part, figures.Row) else histogram_of
            try:
                add(block, part, program, published, f"-{'abcd'[index]}" if index else "")
            except load.InputFault as fault:
                failures.append(f"{layout.heading(block)}: {fault}")
                block.ours.append(str(fault))
        made.append(block)
    return made, failures


def frames_of(block, row, program, published, letter):
    run = program.run(row.plan, row.steps)
    block.ours.append(sentence(row, run.scene))
    block.notes.append(conditions(row, run.scene))
    block.rows += rows_of(row, run, published)
    pictures = [(f"step-{step}", step, None) for step in row.steps]
    pictures += [("near", row.steps[-1], row.near)] if row.near else []
    for name, step, window in pictures:
        if step not in run.frames:
            raise load.InputFault(f"{row.plan.scene} wrote no frame after step {step}.")
        frame = load_frames.read_frame(run.frames[step])
        text = f"a part of step {step}, {window[2]:g} of the domain wide" if window else \
            f"step {step}: {style.whole(len(frame.triangles))} triangles"
        text = f"{row.label}, {text}." if row.label else f"{text}."
        block.pictures.append(layout.Picture(
            f"figure-{block.number}{letter}-{name}.webp", drawn(row, frame, window),
            style.capital(text), letter))


def drawn(row, frame, window):
    """WebP of a frame."""
    low, high = frame.box()
    if window:
        low = numpy.array(window[:2])
        high = low + window[2]
    shaded = row.look == "shaded"
    fig, grid = style.figure(SIDE + 1.6 * shaded, SIDE * (high[1] - low[1]) / (high[0] - low[0]))
    axes = grid[0][0]
    values = None
    if row.look != "phases":
        values = next((v for v in frame.at_vertices.values() if v.ndim == 1), None)
        if values is None:
            raise load.InputFault("The frames have no value at their vertices.")
    fills = None if values is None or shaded else REDS(values[frame.triangles].mean(axis=1).clip(0, 1))
    frames.mesh(axes, frame, SIDE, low, high, fills, values is None,
                style.INTERFACE if values is None else style.SKY)
    if shaded:
        scale = axes.tripcolor(*frame.points.T, frame.triangles, values, shading="gouraud",
                               cmap="turbo", vmin=0, vmax=max(float(values.max()), 1e-9))
        fig.colorbar(scale, ax=axes, label="value at the vertices")
    axes.grid(False)
    return webp(fig)


def webp(fig):
    png = saving.png_bytes(fig)
    style.plt.close(fig)
    return saving.for_page(png, is_mesh=True)[0]


def histogram_of(block, part, program, published, _):
    run = program.run(part.plan, (part.step,))
    # Areas from the frame, because the bins of the program end before the largest triangles.
    areas = frames.triangle_areas(load_frames.read_frame(run.frames[part.step]))
    counts, edges = numpy.histogram(areas, bins=60, range=(0, areas.max()))
    run.scene.histograms = [load.Histogram(run.scene.name, run.scene.strategy, "area", list(edges),
                                           list(counts))]
    picture, = histograms.draw([run.scene], None, published, run.scene.context)
    block.ours.append(picture.sentence)
    block.pictures.append(layout.Picture(f"figure-{block.number}.webp", webp(picture.figure),
                                         f"{picture.title}.", is_wide=True))


def sentence(row, scene):
    """A sentence on the result of a run."""
    text = (f"{row.label + ': ' if row.label else ''}the scene {scene.name} goes from "
            f"{style.whole(scene.value('triangles_first'))} to "
            f"{style.whole(scene.value('triangles_last'))} triangles in "
            f"{style.counted(scene.value('steps'), 'step')}")
    error, sd, area = (scene.value(k) for k in ("attribute_error_last", "sd_last", "area_exact_last"))
    if error is not None:
        text += f"; its value, from 0 to 1, is off by at most {style.digits(error)} at the end"
    elif sd is not None and area:
        text += (f"; its symmetric difference with the exact shape is {style.digits(sd / area)} of "
                 "that shape's area at the end")
    bad = [f"{style.whole(scene.value(key))} {what}" for key, what in (
        ("inverted", "inverted triangles"), ("unreached", "vertices that did not arrive"))
        if scene.value(key)]
    text += f"; there were {style.listing(bad)}." if bad else \
        "; no triangle was inverted and every vertex arrived."
    return style.capital(text)


def conditions(row, scene):
    """A sentence with the command and the options of a run."""
    p = scene.data["parameters"]
    words = [f"h = {p['h']:g}", f"dt = {p['dt']:.4g}", str(p.get("integrator", "")),
             f"{row.insertion or p.get('insertion', '')} insertion", scene.strategy]
    return f"dsc_scene {' '.join(row.plan.words())}: " + ", ".join(w for w in words if w.strip()) + "."


def rows_of(row, run, published):
    """Rows of (what, thesis, ours, ours / thesis); none if the thesis gives no number."""
    before = f"{row.label}: " if row.label else ""
    rows = [(f"{before}triangles at step {item['step']}", style.whole(item["triangles"]),
             style.whole(ours), style.digits(ours / item["triangles"]))
            for item in load.values(published, "thesis", row.triangles)
            if (ours := run.counts.get(item["step"]))]
    area = run.scene.value("area_ratio")
    if row.area_ratio and area is not None:
        known = load.entry(published, "thesis", row.area_ratio)["value"]
        rows += [(f"{before}last area / first area", f"{known:.7f}", f"{area:.7f}",
                  style.digits(area / known, 5)),
                 (f"{before}area lost or gained / first area", style.digits(abs(known - 1)),
                  style.digits(abs(area - 1)), style.digits(abs(area - 1) / abs(known - 1)))]
        rows += [(f"{before}symmetric difference {when} / first area", NONE, style.digits(value), NONE)
                 for key, when in (("sd_rel_half", "half-way"), ("sd_rel_last", "at the end"))
                 if (value := run.scene.value(key)) is not None]
    return rows

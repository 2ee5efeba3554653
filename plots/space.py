#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the interface of a run in three dimensions at some of its times, side by side.

space.py FOLDER --out PICTURE.png

The folder is one of `dsc_scene run --frames FOLDER` with one run in three dimensions.
"""
import io
import math
import os
import pathlib
import re
import sys

from look import saving, script, style  # first: reports a Python without matplotlib

import numpy
from matplotlib import pyplot
from matplotlib.collections import PolyCollection
from PIL import Image

from page import document as page
from results import load

COLOUR = (0.44, 0.72, 0.94)
EDGES = (0.1, 0.25, 0.4)
TO_CAMERA = (-0.55, -1.0, 0.75)
SIDE = 3.0               # inches, the longer side of a panel
MOST_PANELS = 4
QUALITY = 80             # of WebP's 100, in the report
OF_REPORT = "enright"
PICTURE = OF_REPORT + ".png"
# The same flow by other programs (El Topo tracks the surface only): volume lost, CPU seconds, vertices.
PEERS = (("El Topo, a surface without a mesh around it", "0.25 %", "159", "6,291"),
         ("the official 3D DSC, 45,000 tets", "6.9 %", "", ""),
         ("FrontTrackingMethods.jl", "5.6 %", "", ""))
# The prototype of this module at h = 1/64: symmetric difference and vertices' error at T, over the volume and in
# units of the domain; CPU seconds; most vertices.
PROTOTYPE = {"h": 1 / 64, "sd": 0.00309, "rms": 2.0e-4, "cpu_s": 28, "vertices": 7775}


def read_ply(path):
    """(points, triangles) of a file of dsc3::write_ply."""
    content = pathlib.Path(path).read_bytes()
    head, mark, body = content.partition(b"end_header\n")
    counts = re.findall(rb"element (?:vertex|face) (\d+)", head)
    if not mark or len(counts) != 2 or b"binary_little_endian" not in head:
        raise load.InputFault(f"{path} is not a surface of dsc_scene.")
    vertices, faces = map(int, counts)
    face = numpy.dtype([("size", "u1"), ("of", "<i4", 3)])
    if len(body) != 24 * vertices + face.itemsize * faces:
        raise load.InputFault(f"{path} is not whole.")
    points = numpy.frombuffer(body, "<f8", 3 * vertices).reshape(-1, 3)
    return points, numpy.frombuffer(body, face, faces, 24 * vertices)["of"]


def view():
    """The unit vectors to the right, upwards and towards the camera."""
    towards = numpy.array(TO_CAMERA) / numpy.linalg.norm(TO_CAMERA)
    across = numpy.cross([0, 0, 1], towards)
    across /= numpy.linalg.norm(across)
    return across, numpy.cross(towards, across), towards


def panel(axes, surface):
    """Triangles from back to front, brighter if they face the light."""
    points, faces = surface
    across, up, towards = view()
    corners = points[faces]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    light = towards + 0.5 * up - 0.3 * across
    bright = numpy.clip(0.35 + 0.65 * normals @ (light / numpy.linalg.norm(light)), 0.3, 1)
    order = numpy.argsort(corners.mean(axis=1) @ towards, kind="stable")
    flat = numpy.stack([corners @ across, corners @ up], axis=-1)
    axes.add_collection(PolyCollection(flat[order], facecolors=numpy.outer(bright[order], COLOUR),
                                       edgecolors=EDGES, linewidths=0.15))


def frames_of(folder):
    """[(time, surface)] of the .ply files of the only collection in the folder."""
    collections = sorted(pathlib.Path(folder).glob("*.pvd"))
    if len(collections) != 1:
        raise load.InputFault(f"{folder} has {style.counted(len(collections), 'run')}, where one is needed.")
    found = re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)\.vtu"', collections[0].read_text(encoding="utf-8"))
    if not found:
        raise load.InputFault(f"{collections[0]} names no frame.")
    step = max(1, -(-(len(found) - 1) // (MOST_PANELS - 1)))
    chosen = found[::step] if found[::step][-1] == found[-1] else [*found[::step], found[-1]]
    return [(float(time), read_ply(os.path.join(folder, name + ".ply"))) for time, name in chosen]


def draw_scale(axes, low, high):
    """A bar of a round length below the surface: the view is orthographic, so it holds everywhere in its plane."""
    room = (high[0] - low[0]) / 3
    power = 10 ** math.floor(math.log10(room))
    length = max(digit * power for digit in (1, 2, 5) if digit * power <= room)
    foot = low[1] - 0.04 * (high[1] - low[1])
    axes.plot([low[0], low[0] + length], [foot, foot], color=style.INK, linewidth=1.5, solid_capstyle="butt",
              clip_on=False)
    axes.annotate(f"{length:g}", (low[0] + length, foot), (4, 0), textcoords="offset points", va="center",
                  fontsize=8, annotation_clip=False)


def draw(given):
    shown = frames_of(given.files[0])
    flat = numpy.concatenate([points for _, (points, _) in shown]) @ numpy.stack(view()[:2], axis=1)
    low, high = flat.min(axis=0), flat.max(axis=0)
    across, up = SIDE * (high - low) / (high - low).max()
    figure, panels = pyplot.subplots(1, len(shown), figsize=(across * len(shown), up + 0.3), squeeze=False)
    for axes, (time, surface) in zip(panels[0], shown):
        panel(axes, surface)
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.set_aspect("equal")
        axes.set_axis_off()
        axes.set_title(f"t = {time:g}", fontsize=9, pad=3)
    draw_scale(panels[0, 0], low, high)
    figure.tight_layout(pad=0.3)
    yield style.Picture(name=OF_REPORT, title="The interface", figure=figure, is_mesh=True, sentence=f"The interface at {style.counted(len(shown), 'time')}.")


def curves(results):
    """Error against h, and cost against the size of the interface, with a guide line each."""
    figure, (panels,) = style.figure(8.4, 3.9, 1, 2)
    error, cost = panels
    h = numpy.array([one["parameters"]["h"] for one in results])
    sizes = numpy.array([one["interface_vertices_max"] for one in results])
    seconds = numpy.array([one["cpu_s"] for one in results])
    series = [("symmetric difference / volume", "sd_rel_last", "o", PROTOTYPE["sd"]),
              ("distance of vertices from the sphere, rms", "vertex_error_rms", "s", PROTOTYPE["rms"])]
    for colour, (label, key, marker, prototype) in zip(("C0", "C1"), series):
        values = numpy.array([one[key] for one in results])
        error.plot(h, values, marker=marker, color=colour, label=label)
        error.plot(h, values[-1] * (h / h[-1]) ** 2, ":", color=colour, label="second order")
        error.plot([PROTOTYPE["h"]], [prototype], marker=marker, color=colour, fillstyle="none", linestyle="none",
                   label="the prototype")
    cost.plot(sizes, seconds, marker="o", color="C0", label="dsc3")
    cost.plot(sizes, seconds[-1] * (sizes / sizes[-1]) ** 1.5, ":", color="C0", label="vertices × steps")
    cost.plot([PROTOTYPE["vertices"]], [PROTOTYPE["cpu_s"]], "o", color="C0", fillstyle="none", label="the prototype")
    who, _, peer_seconds, peer_vertices = PEERS[0]
    cost.plot([float(peer_vertices.replace(",", ""))], [float(peer_seconds)], "D", color="C3", label=who)
    for axes, across, up in ((error, "edge length h", "error at T"), (cost, "interface vertices, most", "CPU s")):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(across)
        axes.set_ylabel(up)
        axes.legend(fontsize=6.5)
    style.finish(figure, "Enright's test: error and cost", "One thread. Filled: measured with this report. Hollow and "
                 "diamond: measured earlier, on other days.")
    return figure


def section(out):
    """The section of the report if bench/run.sh has left a picture and results of Enright's test in several
    sizes in the folder `out`; else nothing."""
    path = pathlib.Path(out) / PICTURE
    results = [load.read_json(file) for file in sorted(pathlib.Path(out).glob(OF_REPORT + "-*.json"))]
    if not path.is_file() or not results:
        return ""
    results.sort(key=lambda one: -one["parameters"]["h"])
    rows = [[f"1/{1 / one['parameters']['h']:.0f}", f"{one['interface_vertices_max']:,}",
             f"{100 * one['sd_rel_last']:.3f} %", f"{100 * one['sd_rel_half']:.2f} %",
             f"{100 * abs(one['volume_ratio'] - 1):.3f} %",
             f"{one['vertex_error_rms'] / one['parameters']['h']:.3f} h",
             f"{one['min_dihedral_deg_ever']:.1f}", str(one["unreached"]), f"{one['cpu_s']:.2f}",
             f"{one['us_per_vertex_and_sub_step']:.1f}"] for one in results]
    rows += [[who, vertices, "", "", lost, "", "", "", seconds, ""] for who, lost, seconds, vertices in PEERS]
    head = ["h", "vertices, most", "symmetric difference", "half-way", "volume off", "vertices off, rms",
            "smallest dihedral angle ever", "not arrived", "CPU s", "us a vertex and sub-step"]
    picture = io.BytesIO()
    Image.open(path).convert("RGB").save(picture, format="WEBP", quality=QUALITY)
    drawn, _ = saving.for_page(saving.png_bytes(curves(results)), False)
    return (f'<figure><img alt="A ball becomes a film and a ball again" src="{page.inline(picture.getvalue())}">'
            "<figcaption>Enright's test: a ball, the film that it becomes at half of the period, and the ball that "
            "comes back, with the triangles of the interface, seen from far away; the bar is in units of the domain, "
            "a cube of edge 1. Peers were measured by us or others, elsewhere."
            "</figcaption></figure>\n"
            f'<figure><img alt="Error against edge length, and CPU time against vertices" src="{page.inline(drawn)}">'
            "<figcaption>Dotted: second order, and vertices times steps, through the smallest edge length. With edges "
            "longer than 1/32 the film is thinner than half an edge.</figcaption></figure>\n" + page.table(head, rows))


def main(argv=None):
    return script.main(__doc__, draw, argv)


if __name__ == "__main__":
    sys.exit(main())

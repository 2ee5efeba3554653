# SPDX-License-Identifier: MIT
"""The table of the gallery: our runs and pictures for each figure of the thesis's section 10.

Edge lengths are those with the number of triangles nearest to that of the thesis's first mesh
(translation, vortex, interpolation; our number changes by whole rows of triangles) or with the
thesis's first edges (the swirling circle, with 48 edges by its area).
"""
from dataclasses import dataclass

from gallery.runs import Plan

LARGE = ("h", 0.0525)   # 858 triangles, where the thesis has 884
VORTEX = ("h", 0.051)   # 939, where it has 903
SMALL = ("h", 0.02)
SWIRL = ("h", 0.0196)
TOP = (0.4, 0.76, 0.2)  # at the top of the circle, where a jagged edge is visible
LEGS = ("h", 0.01)      # thin legs need short edges

# The thesis's choices where the library's defaults differ.
CHOICES = (("integrator", "centred"), ("insertion", "linear"), ("coarsening", "length"))


@dataclass(frozen=True)
class Row:
    """Frames of one run."""

    plan: Plan
    steps: tuple              # of the frames shown
    label: str = ""           # distinguishes the rows of a figure
    look: str = "phases"      # phases, values (the thesis's reds) or shaded (Gouraud)
    triangles: str = ""       # the thesis's counts of triangles: an entry of the published figures
    area_ratio: str = ""      # the thesis's ratio of areas: such an entry
    insertion: str = ""       # if the scene has an insertion of its own, not that of --set
    near: tuple = ()          # a close-up of the last frame: (low x, low y, width) of a square


@dataclass(frozen=True)
class Histogram:
    """The distribution of the triangles' areas after a step."""

    plan: Plan
    step: int


@dataclass(frozen=True)
class Figure:
    number: str               # as in the thesis
    parts: tuple = ()         # of Row and Histogram
    see: str = ""             # where our pictures are, if not in the gallery


VARYING = Plan("quality-varying", (SMALL, ("steps", 100)))
HISTOGRAMS = "Ours are in the section \"Areas and qualities of the triangles\" of the report."


def rotation(scene):
    return (Row(Plan(scene, (LARGE,)), (0, 45, 360)),)


def interpolation(edge, look, steps, **more):
    """The value rises linearly with the radius, as in the thesis."""
    return Row(Plan("interpolation", (edge, ("steps", 160), ("ramp", "linear"))), steps, look=look,
               **more)


def combination(inside, outside):
    """One of the four panels of figure 10.15."""
    return Row(Plan("quality-combinations", (("inside", inside), ("outside", outside))), (30,),
               label=f"{inside} inside, {outside} outside")


FIGURES = (
    Figure("10.1", (Row(Plan("translation", (LARGE,)), (0, 120, 240, 360),
                        triangles="translation_triangles"),)),
    Figure("10.2", (Row(Plan("translation-phase", (LARGE,)), (0, 120, 240, 360)),)),
    Figure("10.3", (Row(Plan("scaling", (LARGE, ("steps", 100))), (0, 50, 100)),
                    Row(Plan("scaling-round", (LARGE, ("steps", 100))), (100,),
                        label="vertices put on the circle", insertion="the scene's own"))),
    Figure("10.4", rotation("rotation-rectangle")),
    Figure("10.5", rotation("rotation-crescent")),
    Figure("10.6", (Row(Plan("vortex-square", (VORTEX,)), (0, 250, 500),
                        triangles="vortex_triangles", area_ratio="vortex_area_ratio"),)),
    Figure("10.7", (interpolation(LARGE, "values", (0, 60, 100, 160),
                                  triangles="interpolation_triangles"),)),
    Figure("10.8", (interpolation(SMALL, "values", (0, 60, 100, 160)),)),
    Figure("10.9", (interpolation(LARGE, "shaded", (60,), label="large triangles"),
                    interpolation(SMALL, "shaded", (60,), label="small triangles"))),
    Figure("10.10", (Row(Plan("zalesak", (SWIRL,)), (0, 314, 628)),)),
    Figure("10.11", (Row(Plan("swirl", (SWIRL, ("steps", 260))), (0, 260, 520),
                         label="2 x 260 steps", area_ratio="swirl_260_area_ratio", near=TOP),
                     Row(Plan("swirl", (SWIRL, ("steps", 420))), (420, 840),
                         label="2 x 420 steps", area_ratio="swirl_420_area_ratio", near=TOP),
                     Row(Plan("swirl", (SWIRL, ("steps", 260), *CHOICES)), (520,),
                         label="2 x 260 steps, the thesis's choices",
                         area_ratio="swirl_260_area_ratio", near=TOP))),
    Figure("10.12", (Row(Plan("swirl-zalesak", (LEGS, ("steps", 800), ("dt", 0.005))),
                         (0, 400, 800), near=(0.42, 0.14, 0.06)),)),
    Figure("Table 10.1", see="Ours are in the section \"Several threads\" of the report, with the "
                             "thesis's beside them."),
    Figure("10.13", see=HISTOGRAMS),
    Figure("10.14", see=HISTOGRAMS),
    Figure("10.15", tuple(combination(inside, outside) for inside in ("coarse", "fine")
                           for outside in ("coarse", "fine"))),
    Figure("10.16", (Row(VARYING, (0, 50, 100)),)),
    Figure("10.17", (Histogram(VARYING, 100),)),
)

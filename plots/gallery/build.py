# SPDX-License-Identifier: MIT
"""Runs what the table of figures names, draws it, and gives one Block for each figure."""
from gallery import animation, charts, compare, distribution, figures, layout, mesh, runs, times
from gallery.shared import style

PIXELS = 300         # of a frame
MOVING_FRAMES = 24   # of an animation


def value_of(frame):
    """The attribute at the vertices; throws NotRun where a frame has none."""
    if not frame.values:
        raise runs.NotRun("The frames carry no value at their vertices.")
    return next(iter(frame.values.values()))


def look_of(row):
    """The function from a frame to what mesh.draw is told about it."""
    if row.look == "values":
        return lambda frame: {"fills": mesh.value_fills(frame, value_of(frame)),
                              "edge": mesh.NO_EDGE, "line": style.SKY}
    return lambda frame: {}


def labelled(row, text):
    """A sentence with the row's label before it, beginning with a capital."""
    text = f"{row.label}, {text}" if row.label else text
    return text[0].upper() + text[1:]


class Builder:
    def __init__(self, program, facts, quick=False):
        self.program, self.facts, self.quick = program, facts, quick
        self.context = []   # of (name, text): where the runs were made
        self.failures = []  # sentences; a scene that is not there yet is no failure

    def blocks(self):
        return [self.block(figure) for figure in figures.FIGURES]

    def block(self, figure):
        known = self.facts.figure(figure.number)
        section = known.source.split("section ")[1].split(",")[0]
        block = layout.Block(figure.number, section, known.title, known.shows, known.source,
                             [], [], [], [])
        add = {figures.Row: self.frames, figures.Histogram: self.histogram,
               figures.Times: self.times}
        for index, part in enumerate(figure.parts):
            try:
                add[type(part)](block, part, index)
            except runs.NotRun as fault:
                if not isinstance(fault, runs.Missing):
                    self.failures.append(f"{layout.heading(block)}: {fault}")
                if str(fault) not in block.ours:
                    block.ours.append(str(fault))
        if all(theirs == compare.NONE for _, theirs, _, _ in block.rows):
            block.rows = []  # nothing to compare with
        return block

    def frames(self, block, row, index):
        moves = row.moves and not self.quick
        run = self.program.run(row.plan, row.steps, MOVING_FRAMES if moves else 0)
        self.context = self.context or compare.machine(run)
        block.ours.append(compare.sentence(row, run, self.facts))
        block.notes.append(compare.conditions(run, row.insertion))
        block.rows += compare.rows_of(row, run, self.facts)
        pictures = [*stills(row, run), *close_up(row, run), *(moving(row, run) if moves else ())]
        letter = f"-{'abcd'[index]}" if index else ""
        for picture in pictures:
            picture.name = f"figure-{block.number}{letter}-{picture.name}.webp"
            picture.row = index
        block.pictures += pictures

    def histogram(self, block, part, _):
        found = [(label, self.program.run(plan, (part.frame,) if part.frame else ()))
                 for label, plan in part.runs]
        shown = [(label, distribution.measure(run, part)) for label, run in found]
        block.ours.append(distribution.sentence(part, shown))
        others = "; dashed: the first panel's outline" if len(shown) > 1 else ""
        block.notes.append(f"Dotted: the median{others}. {compare.conditions(found[0][1])}")
        block.pictures.append(layout.Picture(
            f"figure-{block.number}.webp", charts.histogram(part.quantity, shown),
            f"The {distribution.MEANING[part.quantity]} of the triangles after the last step.",
            wide=2))
        block.rows += distribution.rows_of(part, shown, self.facts)

    def times(self, block, part, index):
        text, note, rows = times.table(self.program, part, self.facts)
        block.ours.append(text)
        block.notes += [] if index else [note]
        block.rows += rows


def stills(row, run):
    """A picture of each step, or of the frames nearest to them."""
    pictures = {}
    for step in row.steps:
        number, path = run.nearest(step)
        if number in pictures:
            continue  # fewer frames were written than are wanted
        frame = run.frame(path)
        nearest = "" if number == step else f" (the frame nearest to step {step})"
        text = labelled(row, f"step {number}{nearest}: "
                             f"{style.whole(len(frame.triangles))} triangles.")
        if row.look == "shaded":
            data = charts.shaded(frame, value_of(frame), row.label)
        else:
            data = mesh.webp(mesh.draw(frame, PIXELS, **look_of(row)(frame)))
        pictures[number] = layout.Picture(f"step-{number}", data, text,
                                          wide=1 if row.look == "shaded" else 0)
    return pictures.values()


def close_up(row, run):
    """A part of the last frame, where the row asks for it."""
    if not row.near:
        return []
    step, path = run.nearest(row.steps[-1])
    frame = run.frame(path)
    image = mesh.draw(frame, PIXELS, window=row.near, **look_of(row)(frame))
    text = f"a part of step {step}, {row.near[2]:g} of the domain wide."
    return [layout.Picture("near", mesh.webp(image), labelled(row, text))]


def moving(row, run):
    """The animation; none where it cannot be made small enough."""
    made = animation.animate([run.frame(path) for _, path in run.frames], look_of(row))
    if made is None:
        return []
    data, still, count = made
    text = f"the run in motion, in {style.counted(count, 'frame')}."
    return [layout.Picture("moving", data, labelled(row, text), still)]

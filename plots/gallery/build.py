# SPDX-License-Identifier: MIT
"""Runs what the table of figures names, draws it, and gives one Block for each figure."""
from gallery import animation, charts, compare, figures, layout, mesh, runs, times
from gallery.shared import style

PIXELS = 300           # of a frame
UNITS = {"area": " domain units²", "quality": ""}
MEANING = {"area": "areas", "quality": "qualities, 2/√3 times the sine of the smallest angle,"}
MOVING_FRAMES = 24     # of an animation


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
        for index, part in enumerate(figure.parts):
            try:
                {figures.Row: self.row, figures.Histogram: self.histogram,
                 figures.Times: self.times}[type(part)](block, part, index)
            except runs.NotRun as fault:
                if not isinstance(fault, runs.Missing):
                    self.failures.append(f"{layout.heading(block)}: {fault}")
                if str(fault) not in block.ours:
                    block.ours.append(str(fault))
        return block

    def row(self, block, row, index):
        moves = row.moves and not self.quick
        run = self.program.run(row.plan, row.steps, MOVING_FRAMES if moves else 0)
        block.ours.append(compare.sentence(row, run, self.facts))
        block.notes.append(compare.conditions(run))
        name = f"figure-{block.number}" + (f"-{'abcd'[index]}" if index else "")
        shown = set()
        for step in row.steps:
            number, path = run.nearest(step)
            if number in shown:
                continue  # fewer frames were written than are wanted
            shown.add(number)
            frame = run.frame(path)
            text = f"{row.label}, step {number}" if row.label else f"Step {number}"
            if number != step:
                text += f" (the frame nearest to step {step})"
            text += f": {style.whole(len(frame.triangles))} triangles."
            text = text[0].upper() + text[1:]
            if row.look == "shaded":
                data = charts.shaded(frame, value_of(frame), row.label)
                block.pictures.append(layout.Picture(f"{name}-step-{number}.webp", data, text,
                                                     wide=row.look == "shaded", row=index))
            else:
                data = mesh.webp(mesh.draw(frame, PIXELS, **look_of(row)(frame)))
                block.pictures.append(layout.Picture(f"{name}-step-{number}.webp", data, text,
                                                     wide=row.look == "shaded", row=index))
        if row.near:
            step, path = run.nearest(row.steps[-1])
            frame = run.frame(path)
            data = mesh.webp(mesh.draw(frame, PIXELS, window=row.near, **look_of(row)(frame)))
            block.pictures.append(layout.Picture(
                f"{name}-near.webp", data,
                f"A part of step {step}, {row.near[2]:g} of the domain wide.", row=index))
        block.rows += compare.rows_of(row, run, self.facts)
        self.context = self.context or compare.machine(run)
        if moves:
            self.moving(block, row, index, run, name)

    def moving(self, block, row, index, run, name):
        frames = [run.frame(path) for _, path in run.frames]
        made = animation.animate(frames, look_of(row))
        if made is None:
            return
        data, still, count = made
        text = f"The run in motion, in {style.counted(count, 'frame')}."
        if row.label:
            text = f"{row.label}: {text[0].lower()}{text[1:]}"
        block.pictures.append(layout.Picture(f"{name}-moving.webp", data, text, still, row=index))

    def histogram(self, block, part, index):
        found = [(label, self.program.run(plan, (part.frame,) if part.frame else ()))
                 for label, plan in part.runs]
        shown = []
        for label, run in found:
            item = run.result.get("histograms", {}).get(part.quantity)
            if part.frame:
                item = charts.areas(run.frame(run.nearest(run.last_step)[1]))
            if item is None:
                raise runs.NotRun(f"{run.plan.scene} wrote no histogram of {part.quantity}.")
            shown.append((label, item))
        base = shown[0][1]
        middle = charts.median(base["edges"], base["counts"])
        mean = charts.mean(base["edges"], base["counts"])
        full = max(base["counts"]) / sum(base["counts"])
        text = (f"There are {style.whole(sum(base['counts']))} triangles. Their median "
                f"{part.quantity} is {compare.number(middle)}{UNITS[part.quantity]}, "
                f"{compare.number(middle / mean)} times the mean; "
                f"{compare.percent(full, 0)} of them lie in the fullest bin")
        if len(shown) > 1:
            gap, label = max((charts.largest_gap(item, base), label) for label, item in shown[1:]
                             if item["edges"] == base["edges"])
            text += ("; the other cumulative curves differ from it by at most "
                     f"{compare.percent(gap, 1)} of the triangles ({label})")
        else:
            text += "; the median of an exponential distribution is 0.693 times its mean"
        block.ours.append(text + ".")
        block.notes.append("Dotted: the median" + ("; dashed: the first panel's outline. "
                                                   if len(shown) > 1 else ". ")
                           + compare.conditions(found[0][1]))
        block.pictures.append(layout.Picture(
            f"figure-{block.number}.webp", charts.histogram(part.quantity, shown),
            f"The {MEANING[part.quantity]} of the triangles after the last step.",
            wide=2))
        known = self.facts.value(part.triangles) if part.triangles else None
        for label, item in shown:
            count = sum(item["counts"])
            rows = known if item is base else None
            block.rows.append((f"triangles, {label}", style.whole(rows) if rows else compare.NONE,
                               style.whole(count), compare.ratio(count, rows)))

    def times(self, block, part, index):
        text, note, rows = times.table(self.program, part, self.facts)
        block.ours.append(text)
        block.rows += rows
        if index == 0:
            block.notes.append(note)

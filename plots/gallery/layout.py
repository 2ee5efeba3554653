# SPDX-License-Identifier: MIT
"""The gallery as HTML: pictures embedded while they fit into a budget, tables, sentences."""
import base64
from dataclasses import dataclass

from gallery.shared import page

BUDGET = 2_000_000  # characters of the whole fragment, pictures in base64 included
IMAGE = ("display:block;width:100%;height:auto;padding:.5rem;background:#fff;"
         "border:1px solid var(--line);border-radius:8px")
# On a narrow screen a wide picture keeps a size at which its words can be read, and is scrolled.
WIDE = "min-width:40rem;"
TAGS = 600  # at most so many characters around a picture, its words left aside
GRID = ("display:grid;grid-template-columns:repeat(auto-fill,minmax(min({}rem,45%),1fr));"
        "gap:1rem 1.2rem;align-items:start;margin:1rem 0")


@dataclass
class Picture:
    """A picture, its one sentence, and what stands in for it where nothing may move."""

    name: str           # of the file beside the page
    data: bytes         # WebP
    sentence: str       # also the alternative text
    still: bytes = b""  # of an animation: its first choice where motion is unwelcome
    wide: int = 0       # 1: half of the width at least, for axes; 2: all of it
    row: int = 0        # pictures of one row stand together

    @property
    def size(self):
        """Characters of the picture in a page."""
        return sum(4 * -(-len(part) // 3) for part in (self.data, self.still))


@dataclass
class Block:
    """One figure of the thesis and ours."""

    number: str
    section: str
    title: str
    shows: str          # the thesis's, in our words
    source: str
    ours: list          # sentences: what came out
    notes: list         # sentences: conditions
    pictures: list
    rows: list          # of (what, thesis, ours, ratio)


def heading(block):
    kind = "" if block.number[0].isalpha() else "Figure "
    return f"{kind}{block.number}: {block.title}"


def embedded(blocks, budget=BUDGET):
    """The names of the pictures that fit: still ones first, then animations, in order."""
    left = budget - sum(len(block_html(block, ())) for block in blocks)
    names = set()
    pictures = [picture for block in blocks for picture in block.pictures]
    for picture in sorted(pictures, key=lambda picture: bool(picture.still)):
        if picture.size + TAGS <= left:
            left -= picture.size + TAGS
            names.add(picture.name)
    return names


def grids(pictures):
    """The pictures by rows; few are one row."""
    if len(pictures) <= 5:
        return [pictures] if pictures else []
    rows = {}
    for picture in pictures:
        rows.setdefault(picture.row, []).append(picture)
    return list(rows.values())


def _uri(data):
    return f"data:image/webp;base64,{base64.b64encode(data).decode('ascii')}"


def _picture(picture, within, beside):
    text = page.escape(picture.sentence)
    style = f' style="margin:0{";grid-column:1/-1" if picture.wide > 1 else ""}"'
    if not within:
        link = page.escape(beside + picture.name)
        return (f'<figure{style}><figcaption><a href="{link}">{text}</a> <small>Beside this '
                "page.</small></figcaption></figure>")
    least = WIDE if picture.wide > 1 else ""
    image = (f'<img alt="{text}" style="{least}{IMAGE}" '
             f'src="{_uri(picture.still or picture.data)}">')
    if picture.still:
        image = ('<picture><source media="(prefers-reduced-motion: no-preference)" '
                 f'srcset="{_uri(picture.data)}">{image}</picture>')
    if picture.wide > 1:
        image = (f'<div style="overflow-x:auto" tabindex="0" role="region" aria-label="{text}">'
                 f"{image}</div>")
    return f"<figure{style}>{image}<figcaption>{text}</figcaption></figure>"


def block_html(block, names, beside=""):
    """names: of the pictures that are embedded; beside: the way from the page to the others."""
    parts = [f'<h3 id="thesis-{block.number.replace(" ", "-").lower()}">'
             f"{page.escape(heading(block))}</h3>",
             f"<p><strong>The thesis.</strong> {page.escape(block.shows)} "
             f"<small>{page.escape(block.source)}</small></p>"]
    parts += [f"<p><strong>{'' if k else 'Ours. '}</strong>{page.escape(text)}</p>"
              for k, text in enumerate(block.ours)]
    parts += ['<p class="note">' + "<br>".join(map(page.escape, block.notes)) + "</p>"]
    for inside in grids(block.pictures):
        # Five come to stand side by side where there is room.
        least = 24 if inside[0].wide else 11.5 if len(inside) == 5 else 13
        parts.append(f'<div style="{GRID.format(least)}">'
                     + "".join(_picture(p, p.name in names, beside) for p in inside) + "</div>")
    if block.rows:
        parts.append(page.table(["what", "thesis", "ours", "ours / thesis"], block.rows))
    return "\n".join(parts) + "\n"


def fragment(blocks, beside="", budget=BUDGET):
    """The gallery as a part of another page."""
    names = embedded(blocks, budget)
    return "".join(block_html(block, names, beside) for block in blocks)


def document(blocks, head):
    """The gallery as a page of its own."""
    names = embedded(blocks)
    sections = {}
    for block in blocks:
        sections.setdefault(block.section, []).append(block)
    return page.document(
        "The thesis's figures, and ours", "Each figure and table of section 10 of the thesis in "
        "our own words, and what this library makes of the same experiment.", head,
        [(f"section-{number.replace('.', '-')}", f"{number} {TITLES.get(number, '')}".strip(),
          "".join(block_html(block, names) for block in inside))
         for number, inside in sections.items()])


TITLES = {"10.1": "Translation", "10.2": "Scaling", "10.3": "Rotation", "10.4": "Vortex",
          "10.5": "Interpolation", "10.6": "Enright's tests", "10.7": "Speed-up",
          "10.8": "Quality"}

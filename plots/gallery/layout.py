# SPDX-License-Identifier: MIT
"""The gallery as HTML: pictures, tables, sentences."""
from dataclasses import dataclass, field

from page import document as page

IMAGE = ("display:block;width:100%;height:auto;padding:.5rem;background:#fff;"
         "border:1px solid var(--line);border-radius:8px")
# On a narrow screen a wide picture keeps a readable size and is scrolled.
WIDE = "min-width:40rem;"
GRID = ("display:grid;grid-template-columns:repeat(auto-fill,minmax(min(13rem,45%),1fr));"
        "gap:1rem 1.2rem;align-items:start;margin:1rem 0")


@dataclass
class Picture:
    name: str           # of the file beside the page
    data: bytes         # WebP
    sentence: str       # also the alternative text
    row: str = ""       # pictures of one row are side by side
    is_wide: bool = False


@dataclass
class Block:
    """One figure of the thesis and ours."""

    number: str
    title: str
    shows: str          # the thesis's figure, in our words
    source: str
    ours: list          # sentences on our results
    notes: list = field(default_factory=list)     # sentences: conditions
    pictures: list = field(default_factory=list)
    rows: list = field(default_factory=list)      # of (what, thesis, ours, ratio)


def heading(block):
    kind = "" if block.number[0].isalpha() else "Figure "
    return f"{kind}{block.number}: {block.title}"


def _picture(picture):
    text = page.escape(picture.sentence)
    image = (f'<img alt="{text}" style="{WIDE if picture.is_wide else ""}{IMAGE}" '
             f'src="{page.inline(picture.data)}">')
    if picture.is_wide:
        image = (f'<div style="overflow-x:auto" tabindex="0" role="region" aria-label="{text}">'
                 f"{image}</div>")
    style = f"margin:0{';grid-column:1/-1' if picture.is_wide else ''}"
    return f'<figure style="{style}">{image}<figcaption>{text}</figcaption></figure>'


def block_html(block):
    parts = [f'<h3 id="thesis-{block.number.replace(" ", "-").lower()}">'
             f"{page.escape(heading(block))}</h3>",
             f"<p><strong>The thesis.</strong> {page.escape(block.shows)} "
             f"<small>{page.escape(block.source)}</small></p>"]
    parts += [f"<p><strong>{'' if k else 'Ours. '}</strong>{page.escape(text)}</p>"
              for k, text in enumerate(block.ours)]
    parts += ['<p class="note">' + "<br>".join(map(page.escape, block.notes)) + "</p>"]
    few = len(block.pictures) <= 5
    for row in dict.fromkeys("" if few else p.row for p in block.pictures):
        parts.append(f'<div style="{GRID}">' + "".join(
            _picture(p) for p in block.pictures if few or p.row == row) + "</div>")
    if block.rows:
        parts.append(page.table(["what", "thesis", "ours", "ours / thesis"], block.rows))
    return "\n".join(parts) + "\n"

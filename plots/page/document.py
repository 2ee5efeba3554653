# SPDX-License-Identifier: MIT
"""The parts of a self-contained HTML page: texts, sortable tables, pictures.
Every function returns HTML; texts are escaped only here.
"""
import base64
import html
import os
import re

from look import style

HERE = os.path.dirname(os.path.abspath(__file__))
UNITS = {"ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1.0}
NUMBER = re.compile(r"(?P<sign>[-+])?(?P<number>\d[\d,]*(\.\d+)?(e-?\d+)?)(/(?P<below>\d+))?"
                    r"( ?(?P<unit>ns|µs|ms|s|%|°))?( .*)?")
NOTHING = ("", "–")


def escape(text):
    return html.escape(str(text))


def paragraph(text, kind=""):
    return f'<p{f" class={kind!r}" if kind else ""}>{escape(text)}</p>'


def listed(sentences, kind):
    return f'<ul class="{kind}">' + "".join(f"<li>{escape(s)}</li>" for s in sentences) + "</ul>\n"


def value_of(text):
    """The number by which a cell is sorted, in the same unit for all durations; None if it has none."""
    found = NUMBER.fullmatch(text)
    if not found:
        return None
    value = float(found["number"].replace(",", "")) * UNITS.get(found["unit"], 1.0)
    return (-value if found["sign"] == "-" else value) / float(found["below"] or 1)


def _values(cells):
    """The values of a column, or None if it does not consist of numbers."""
    values = [value_of(text) for text in cells]
    missing = [text for text, value in zip(cells, values) if value is None]
    return values if len(missing) < len(cells) and set(missing) <= set(NOTHING) else None


def table(header, rows, classes=None, name="table"):
    """A sortable table; columns of numbers are right-aligned.
    classes: {(row, column): CSS class}; name: the label for screen readers.
    """
    classes = classes or {}
    cells = [[str(cell) for cell in row] for row in rows]
    columns = [[row[k] for row in cells] for k in range(len(header))]
    values = [_values(column) for column in columns]
    most = [max((len(text) for text in column), default=0) for column in columns]

    def kinds(row, column):
        words = ["n" if values[column] and most[column] < 24 else "",
                 "wide" if most[column] > 60 else "tight" if most[column] < 24 else "some",
                 classes.get((row, column), "")]
        words = " ".join(word for word in words if word)
        return f' class="{words}"' if words else ""

    def cell(text, row, column):
        key = ""
        if values[column]:
            value = values[column][row]
            key = f' data-v="{"NaN" if value is None else f"{value:.9g}"}"'
        return f"<td{kinds(row, column)}{key}>{escape(text)}</td>"

    head = "".join(f'<th scope="col"{kinds(-1, k)} aria-sort="none"><button type="button">'
                   f'{escape(text or "remarks")}</button></th>' for k, text in enumerate(header))
    body = "".join("<tr>" + "".join(cell(text, r, k) for k, text in enumerate(row)) + "</tr>\n"
                   for r, row in enumerate(cells))
    return (f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(name)}"><table>'
            f"<thead><tr>{head}</tr></thead>\n<tbody>{body}</tbody></table></div>\n")


def fold(summary, inside):
    return f"<details><summary>{escape(summary)}</summary>{inside}</details>\n"


def link(path, text):
    return f'<a href="{escape(path)}">{escape(text)}</a>'


def inline(webp):
    """The data URL of an embedded image."""
    return "data:image/webp;base64," + base64.b64encode(webp).decode("ascii")


def figure(drawn):
    """An embedded picture with its sentence; its numbers and files are folded."""
    picture, (width, height) = drawn.picture, drawn.size
    title = escape(picture.title)
    sentence = style.capital(picture.sentence)  # some begin with a scene's name
    inside = (f'<figure><div class="picture" tabindex="0" role="region" aria-label="{title}">'
              f'<img alt="{title}" width="{width}" height="{height}" style="max-width:{width}px" '
              f'src="{inline(drawn.webp)}"></div>\n'
              f"<figcaption>{escape(sentence)}</figcaption></figure>\n")
    more = table(picture.header, picture.rows,
                 name=f"The numbers of: {picture.title}") if picture.rows else ""
    if drawn.files:
        more += ("<p>The picture as " + ", ".join(
            link(name, name.rpartition(".")[2].upper()) for name in drawn.files) + ".</p>")
    return inside + (fold("The numbers" if picture.rows else "Files", more) if more else "")


def facts(pairs):
    return "<dl>" + "".join(f"<dt>{escape(k)}</dt><dd>{escape(v)}</dd>"
                            for k, v in pairs if v) + "</dl>"


def _section(identifier, title, inside, lead=None):
    """A section, folded if it has a lead, which says what is in it."""
    if lead is None:
        return f'<section id="{identifier}"><h2>{escape(title)}</h2>\n{inside}</section>\n'
    return (f'<details class="part" id="{identifier}"><summary>{escape(title)} '
            f"<small>{escape(lead)}</small></summary>\n{inside}</details>\n")


def _beside(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as stream:
        return stream.read()


def document(title, lead, head, sections):
    """sections: [(identifier, title, html)], with a lead as the fourth entry for folded ones."""
    links = "".join(f'<a href="#{i}">{escape(t)}</a>' for i, t, *_ in sections)
    body = "".join(_section(*words) for words in sections)
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f'<link rel="icon" href="data:,"><title>{escape(title)}</title>'
            f"<style>{_beside('page.css')}</style></head>\n<body>"
            f"<header><h1>{escape(title)}</h1>{paragraph(lead)}{head}</header>\n"
            f'<nav aria-label="Sections">{links}</nav>\n<main>{body}</main>\n'
            "<footer>Every sentence and picture above is computed from the result files linked at "
            f"the end; the same files give the same page.</footer>\n"
            f"<script>{_beside('page.js')}</script></body></html>\n")

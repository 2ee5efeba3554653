# SPDX-License-Identifier: MIT
"""The report as one HTML page that needs nothing besides itself: pictures are embedded."""
import base64
import html

CSS = """
:root { color-scheme: light dark; --ink: #22303a; --muted: #5d6b75; --line: #dde3e8;
  --ground: #fbfcfd; --card: #ffffff; --accent: #0072b2; --good: #00795b; --bad: #b84700; }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e8ec; --muted: #9aa7b1; --line: #33404a;
  --ground: #161c21; --card: #1d252c; --accent: #6fbdf0; --good: #4fc9a2; --bad: #f0935a; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink);
  font: 16px/1.6 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main, header, nav { max-width: 68rem; margin: 0 auto; padding: 0 1.5rem; }
header { padding-top: 3rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .4rem; letter-spacing: -.01em; }
h2 { font-size: 1.3rem; margin: 3.2rem 0 .6rem; padding-top: .9rem;
  border-top: 1px solid var(--line); }
p { max-width: 46rem; margin: .5rem 0; }
header p, .note { color: var(--muted); }
nav { margin-top: 1.4rem; font-size: .92rem; display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; }
nav a { color: var(--accent); text-decoration: none; }
nav a:hover { text-decoration: underline; }
figure { margin: 1.6rem 0 2.4rem; }
figure img { display: block; width: 100%; height: auto; padding: .6rem; background: #ffffff;
  border: 1px solid var(--line); border-radius: 8px; }
figcaption { max-width: 50rem; margin-top: .7rem; }
figcaption small { color: var(--muted); }
.scroll { overflow-x: auto; margin: 1rem 0 1.6rem; border: 1px solid var(--line);
  border-radius: 8px; background: var(--card); }
table { border-collapse: collapse; width: 100%; font-size: .87rem; line-height: 1.4;
  font-variant-numeric: tabular-nums; }
th, td { padding: .42rem .75rem; text-align: left; border-bottom: 1px solid var(--line);
  vertical-align: top; }
td.n, th.n { text-align: right; white-space: nowrap; }
th { color: var(--muted); font-weight: 600; white-space: nowrap; }
tr:last-child td { border-bottom: 0; }
td.wide { min-width: 20rem; }
.good { color: var(--good); font-weight: 600; } .bad { color: var(--bad); font-weight: 600; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1.2rem; margin: 1rem 0;
  font-size: .92rem; } dt { color: var(--muted); } dd { margin: 0; }
details summary { cursor: pointer; color: var(--accent); margin: .4rem 0; font-size: .92rem; }
footer { max-width: 68rem; margin: 3rem auto; padding: 0 1.5rem; color: var(--muted);
  font-size: .88rem; }
@media print { nav, summary { display: none; } figure { break-inside: avoid; } }
"""


def escape(text):
    return html.escape(str(text))


def paragraph(text, kind=""):
    return f'<p{f" class={kind!r}" if kind else ""}>{escape(text)}</p>'


def _numeric(text):
    return bool(text) and (text[0].isdigit() or text[0] in "-–+.") and len(text) < 24


def table(header, rows, classes=None):
    """A table; columns of numbers are set flush right. classes: {(row, column): CSS class}."""
    classes = classes or {}
    cells = [[str(cell) for cell in row] for row in rows]
    right = [bool(cells) and all(_numeric(row[k]) or not row[k] for row in cells)
             and any(row[k] for row in cells) for k in range(len(header))]
    long = [any(len(row[k]) > 60 for row in cells) for k in range(len(header))]

    def cell(tag, text, row, column):
        kinds = [k for k in ("n" if right[column] else "", "wide" if long[column] else "",
                             classes.get((row, column), "")) if k]
        kind = f' class="{" ".join(kinds)}"' if kinds else ""
        return f"<{tag}{kind}>{escape(text)}</{tag}>"

    head = "".join(cell("th", text, -1, k) for k, text in enumerate(header))
    body = "".join("<tr>" + "".join(cell("td", text, r, k) for k, text in enumerate(row))
                   + "</tr>\n" for r, row in enumerate(cells))
    return (f'<div class="scroll"><table><thead><tr>{head}</tr></thead>\n<tbody>{body}</tbody>'
            "</table></div>")


def fold(summary, inside):
    return f"<details><summary>{escape(summary)}</summary>{inside}</details>"


def figure(picture, png, others):
    """A picture embedded as a data URI, its sentence, and the names of the other formats."""
    data = base64.b64encode(png).decode("ascii")
    beside = (" <small>Beside this page: " + escape(", ".join(others)) + ".</small>"
              if others else "")
    inside = (f'<figure><img alt="{escape(picture.title)}" src="data:image/png;base64,{data}">\n'
              f"<figcaption>{escape(picture.sentence)}{beside}</figcaption></figure>\n")
    if picture.rows:
        inside += fold("The numbers", table(picture.header, picture.rows))
    return inside


def facts(pairs):
    return "<dl>" + "".join(f"<dt>{escape(k)}</dt><dd>{escape(v)}</dd>"
                            for k, v in pairs if v) + "</dl>"


def document(title, lead, head, sections):
    """sections: [(identifier, title, html)]"""
    links = "".join(f'<a href="#{i}">{escape(t)}</a>' for i, t, _ in sections)
    body = "".join(f'<section id="{i}"><h2>{escape(t)}</h2>\n{inside}</section>\n'
                   for i, t, inside in sections)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(title)}</title><style>{CSS}</style></head>\n<body>"
            f"<header><h1>{escape(title)}</h1>{paragraph(lead)}{head}</header>\n"
            f"<nav>{links}</nav>\n<main>{body}</main>\n"
            "<footer>Every sentence and picture above is computed from the result files named in "
            "it; the same files give the same page.</footer></body></html>\n")

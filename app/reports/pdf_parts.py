"""Building blocks of a report as Typst source. Every text passes :func:`app.reports.typst.literal`."""

from collections.abc import Collection, Sequence

from app.reports.typst import literal

_MANY_COLUMNS = 6
"""A table with more columns is set in smaller type."""

LAYOUT = """
#let muted = rgb("#56606b")
#let line-colour = rgb("#c3c8ce")
#let ok = rgb("#17603c")
#let tight = rgb("#8a4b00")
#let fails = rgb("#9b1c15")
#let not-checked = muted
#set page(
  paper: "a4",
  margin: (x: 20mm, top: 24mm, bottom: 20mm),
  header: text(size: 8pt, fill: muted)[#running-title #h(1fr) Drivewright],
  footer: context text(size: 8pt, fill: muted)[
    #h(1fr) #page-word #counter(page).display("1 / 1", both: true)
  ],
)
#set text(font: "Libertinus Serif", size: 10pt)
#set par(leading: 0.55em)
#show heading.where(level: 1): it => block(above: 1.6em, below: 0.8em, text(size: 13pt, it.body))
#show heading.where(level: 2): it => block(above: 1.3em, below: 0.7em, text(size: 11pt, it.body))
#show heading: set block(sticky: true)
#show figure: set block(breakable: false)
#show math.equation.where(block: true): set align(left)
#set table(stroke: none, inset: (x: 4pt, y: 3pt))
#let note(words) = text(size: 7.5pt, fill: muted, words)
#let fitted(body) = layout(size => {
  let width = measure(body).width
  if width > size.width { scale(size.width / width * 100%, reflow: true, body) } else { body }
})
#let step(label, source, lines) = block(breakable: false, above: 1em, below: 1em, width: 100%)[
  #grid(columns: (1fr, 60mm), align: (left, right), text(weight: 600, label), text(size: 8pt, fill: muted, source))
  #pad(left: 5mm, stack(spacing: 0.7em, ..lines))
]
#let decision(what, reason) = block(above: 1em, below: 1em, inset: (left: 6pt), stroke: (left: 1.5pt + line-colour))[
  #text(weight: 600, what) #linebreak() #text(fill: muted, reason)
]
#let bar(fill, limit, colour) = box(width: 20mm, height: 2mm, fill: rgb("#e6e9ed"))[
  #place(rect(width: fill, height: 2mm, fill: colour, stroke: none))
  #place(dx: limit, line(angle: 90deg, length: 2mm, stroke: 0.6pt))
]
"""
"""Page, type and the functions ``step``, ``decision`` and ``bar``; asks for ``running-title`` and ``page-word``."""


def text(words: str) -> str:
    """A text, inert whatever it holds."""
    return f"#{literal(words)}"


def heading(words: str, level: int = 1) -> str:
    """A heading."""
    return f"#heading(level: {level}, {literal(words)})"


def chart(svg: str, width: str) -> str:
    """A picture from SVG source, as an expression."""
    return f'image(bytes({literal(svg)}), format: "svg", width: {width})'


def bar(fill: float, limit: float, verdict: str) -> str:
    """A utilisation bar; both numbers in percent of its track. Nothing for a check that could not be made."""
    return "" if verdict == "not_checked" else f"#bar({fill:g}%, {limit:g}%, {verdict})"


def grid(
    columns: Sequence[str], rows: Sequence[Sequence[str]], *, widths: str = "", numeric: Collection[int] = ()
) -> str:
    """A table; cells are markup already, headings plain texts. Without ``columns`` it has no head."""
    count = len(columns) or len(rows[0])
    aligned = ", ".join("right" if index in numeric else "left" for index in range(count))
    head = f"table.header({', '.join(f'[*{text(name)}*]' for name in columns)}), table.hline(stroke: 0.8pt), "
    cells = ", ".join(f"[{cell}]" for row in rows for cell in row)
    settings = f"columns: {widths or count}, align: ({aligned},), stroke: (_, y) => (bottom: 0.4pt + line-colour)"
    size = "8pt" if count > _MANY_COLUMNS else "9pt"
    return f"#[#set text(size: {size})\n#table({settings}, {head if columns else ''}{cells})]"

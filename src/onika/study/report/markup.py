"""Parts of the page as HTML: text, tables, numbers; nothing that came from a file is taken for markup."""

import math
from collections.abc import Iterable, Sequence
from html import escape
from itertools import zip_longest

NOTHING = "–"
"""What stands where there is no number."""


def number(value: float, digits: int = 2) -> str:
    """A number with so many digits behind the point, a whole one without; a dash for none."""
    if not math.isfinite(value):
        return NOTHING
    if isinstance(value, int):
        return str(value)
    return f"{value:.{digits}f}"


def percent(share: float) -> str:
    """A share as a percentage, small ones as less than a hundredth."""
    if not math.isfinite(share):
        return NOTHING
    if share < 1e-4:
        return "< 0.01 %"
    return f"{100.0 * share:.2f} %"


def paragraph(text: str, kind: str = "") -> str:
    """A paragraph of plain text."""
    return f"<p{_class(kind)}>{escape(text)}</p>"


def heading(level: int, text: str, anchor: str = "") -> str:
    """A heading."""
    if not anchor:
        return f"<h{level}>{escape(text)}</h{level}>"
    return f'<h{level} id="{escape(anchor)}">{escape(text)}</h{level}>'


def listing(texts: Iterable[str]) -> str:
    """A list of plain texts."""
    return "<ul>" + "".join(f"<li>{escape(text)}</li>" for text in texts) + "</ul>"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], kinds: Sequence[str] = ()) -> str:
    """A table of plain texts whose first column names the row; `kinds` are classes of rows."""
    titles = "".join(f'<th scope="col">{escape(title)}</th>' for title in head)
    body = "".join(_row(row, kind) for row, kind in zip_longest(rows, kinds, fillvalue=""))
    return f'<div class="wide"><table><thead><tr>{titles}</tr></thead><tbody>{body}</tbody></table></div>'


def figure(picture: str, caption: str = "") -> str:
    """A picture, which is markup, and what it shows."""
    if not caption:
        return f"<figure>{picture}</figure>"
    return f"<figure>{picture}<figcaption>{escape(caption)}</figcaption></figure>"


def _row(cells: Sequence[str], kind: str) -> str:
    first, rest = cells[0], cells[1:]
    return (
        f'<tr{_class(kind)}><th scope="row">{escape(first)}</th>'
        + "".join(f"<td>{escape(cell)}</td>" for cell in rest)
        + "</tr>"
    )


def _class(kind: str) -> str:
    if not kind:
        return ""
    return f' class="{escape(kind)}"'

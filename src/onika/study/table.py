"""A table of a study as CSV: who is in which group, figures that are known already, answers to questionnaires (H02).

Parted by commas or, as spreadsheets do where numbers have a decimal comma, by semicolons. Each row is a subject.
"""

import csv
import io
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from onika.words.fault import Fault, Place
from onika.words.reason import Reason

SUBJECT = "subject"
_LONGEST = 60


@dataclass(frozen=True, slots=True)
class SubjectRow:
    """A row: its line, the subject, and its cells by the names of columns; empty cells are not among them."""

    line: int
    subject: str
    cells: Mapping[str, str]

    def number(self, column: str) -> float | None:
        """The number in a column, with a point or a comma; None where there is none."""
        return number_of(self.cells.get(column, ""))


def number_of(text: str) -> float | None:
    """A finite number of a cell; None where it is none."""
    try:
        number = float(text.strip().replace(",", "."))
    except ValueError:
        return None
    if not math.isfinite(number):
        return None
    return number


def read(text: str, name: str) -> tuple[tuple[SubjectRow, ...], tuple[Fault, ...]]:
    """The rows of a table, and what of it cannot be read."""
    text = text.removeprefix("\ufeff")
    head = next((line for line in text.split("\n") if line.strip() and not line.startswith("#")), "")
    lines = csv.reader(io.StringIO(text), delimiter=";" if ";" in head else ",")
    rows: list[SubjectRow] = []
    faults: list[Fault] = []
    try:
        columns = next(_filled(lines), [])
        if wrong := _wrong_head([column.strip().lower() for column in columns]):
            return (), (Fault(Place(name, lines.line_num), wrong, Reason.of("study.table_left_out")),)
        for cells in _filled(lines):
            row = _row(lines.line_num, [column.strip().lower() for column in columns], cells)
            if isinstance(row, Reason):
                faults.append(Fault(Place(name, lines.line_num), row, Reason.of("study.line_left_out")))
            else:
                rows.append(row)
    except csv.Error as wrong_table:
        why = Reason.of("study.no_table", why=Reason.plain(str(wrong_table)))
        faults.append(Fault(Place(name, lines.line_num), why, Reason.of("study.rest_left_out")))
    return tuple(_once(rows)), (*faults, *_repeated(rows, name))


def written(columns: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A table as text; a number that is none is an empty cell, and no cell is taken for a formula."""
    out = io.StringIO()
    table = csv.writer(out, lineterminator="\n")
    table.writerow(columns)
    table.writerows([[_cell(value) for value in row] for row in rows])
    return out.getvalue()


def _filled(lines: Iterator[list[str]]) -> Iterator[list[str]]:
    """The lines with something in them that are no remarks."""
    return (cells for cells in lines if any(map(str.strip, cells)) and not cells[0].startswith("#"))


def _wrong_head(columns: Sequence[str]) -> Reason | None:
    if SUBJECT not in columns:
        return Reason.of("study.no_subject_column", column=SUBJECT)
    twice = sorted({column for column in columns if column and columns.count(column) > 1})
    if not twice:
        return None
    return Reason.of("study.column_twice", column=twice[0][:_LONGEST])


def _row(line: int, columns: Sequence[str], cells: Sequence[str]) -> SubjectRow | Reason:
    if len(cells) > len(columns):
        return Reason.of("study.too_many_cells", count=len(cells), columns=len(columns))
    filled = {column: cell.strip() for column, cell in zip(columns, cells, strict=False) if cell.strip()}
    subject = filled.pop(SUBJECT, "")
    if not subject:
        return Reason.of("study.no_subject")
    return SubjectRow(line, subject, filled)


def _once(rows: Sequence[SubjectRow]) -> list[SubjectRow]:
    counts = Counter(row.subject for row in rows)
    return [row for row in rows if counts[row.subject] == 1]


def _repeated(rows: Sequence[SubjectRow], name: str) -> Iterator[Fault]:
    """Subjects of one name: nobody knows which row is whose."""
    first: dict[str, int] = {}
    for row in rows:
        if row.subject in first:
            twice = Reason.of("study.subject_twice", subject=row.subject[:_LONGEST], line=first[row.subject])
            yield Fault(Place(name, row.line), twice, Reason.of("study.both_left_out"))
        first.setdefault(row.subject, row.line)


def _cell(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.10g}".removesuffix("nan")
    text = str(value)
    if text[:1] in ("=", "+", "-", "@"):
        return f"'{text}"
    return text

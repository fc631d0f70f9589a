"""Keeps the states of docs/requirements.md true against the marks of the tests (`# R-C07`).

Usage: python tools/requirements.py [--check] [--root ROOT]. The last cell of a row says `works: FILE`, `in part: WHAT
IS MISSING` or `not there`. A file that bears no mark of its row any more is replaced by the one that bears most. With
--check nothing is written. The tool ends with 1 where a row that works has no test, a mark has no row, or a row that
is not there has a mark.
"""

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = "docs/requirements.md"

_ROW = re.compile(r"^\| ([A-Z]\d\d) \|.*\| ([^|]*) \|$", re.MULTILINE)
_MARK = re.compile(r"\bR-([A-Z]\d\d)\b")
_WORKS = re.compile(r"works: `([^`]+)`")
_TESTS = (("tests", ".py"), ("browser/test", ".ts"))


@dataclass(frozen=True)
class Row:
    """One requirement with what is said of its state."""

    id: str
    state: str

    @property
    def test(self) -> str | None:
        """The test that is named for it, where it works."""
        match = _WORKS.fullmatch(self.state)
        return match.group(1) if match else None


def rows(page: str) -> list[Row]:
    """All requirements of the page."""
    return [Row(match.group(1), match.group(2)) for match in _ROW.finditer(page)]


def marks(root: Path) -> dict[str, Counter[str]]:
    """For each requirement the files that bear its mark, and how often."""
    files: dict[str, Counter[str]] = {}
    for folder, suffix in _TESTS:
        for path in sorted((root / folder).rglob(f"*{suffix}")):
            for mark in _MARK.findall(path.read_text(encoding="utf-8")):
                files.setdefault(mark, Counter())[path.relative_to(root).as_posix()] += 1
    return files


def complaints(page: str, files: dict[str, Counter[str]]) -> Iterator[str]:
    """Everything in which the page and the marks contradict each other."""
    requirements = rows(page)
    for row in requirements:
        bearers = files.get(row.id, Counter())
        if row.test is not None and row.test not in bearers:
            yield f"{row.id} works, says {PAGE}, but {row.test} bears no mark R-{row.id}"
        elif row.state == "not there" and bearers:
            yield f"{row.id} is not there, says {PAGE}, but {_most(bearers)} bears its mark"
        elif row.test is None and row.state != "not there" and not re.match(r"in part: \S", row.state):
            yield f"{row.id} has no state: expected works, in part or not there, found {row.state!r}"
    ids = Counter(row.id for row in requirements)
    yield from (f"{name} has {count} rows" for name, count in ids.items() if count > 1)
    for mark in sorted(files.keys() - ids.keys()):
        yield f"{_most(files[mark])} bears the mark R-{mark}, and {PAGE} has no such row"


def mended(page: str, files: dict[str, Counter[str]]) -> str:
    """The page with every file that bears no mark of its row replaced by the one that bears most."""
    for row in rows(page):
        bearers = files.get(row.id, Counter())
        if row.test is not None and bearers and row.test not in bearers:
            line = next(line for line in page.splitlines() if line.startswith(f"| {row.id} |"))
            page = page.replace(line, line.replace(row.test, _most(bearers)))
    return page


def _most(bearers: Counter[str]) -> str:
    return min(bearers, key=lambda path: (-bearers[path], path))


def main(words: list[str]) -> int:
    """Mend the page, or with --check only compare; 1 if there is a contradiction."""
    parser = argparse.ArgumentParser(description="Keeps docs/requirements.md true against the marks of the tests.")
    parser.add_argument("--check", action="store_true", help="write nothing")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    given = parser.parse_args(words)
    path, files = given.root / PAGE, marks(given.root)
    page = path.read_text(encoding="utf-8")
    if not given.check:
        page = mended(page, files)
        path.write_text(page, encoding="utf-8")
    contradictions = list(complaints(page, files))
    for contradiction in contradictions:
        print(contradiction)
    return bool(contradictions)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

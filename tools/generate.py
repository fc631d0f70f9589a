"""Writes what is drawn from the code into docs/: the pictures of the lifecycles.

Usage: python tools/generate.py [--check] [--root ROOT]. Writes each file anew; with --check it writes nothing, names
the files that differ from the code and ends with 1 if any does.
"""

import argparse
import sys
from collections.abc import Callable, Mapping
from inspect import cleandoc, getsourcefile
from pathlib import Path
from types import ModuleType

from onika.engine import flow
from onika.link import state
from onika.model import lifecycle

ROOT = Path(__file__).parents[1]

_LIFECYCLES = (("A task", lifecycle), ("A flow", flow), ("A link", state))

_HEAD = """\
# Lifecycles

Each lifecycle is one table in one file; what the table does not list cannot happen. This page is drawn from the tables
by `python tools/generate.py`: change a table, then call it again.
"""


def lifecycles() -> str:
    """The page of the three lifecycles: what the file says of itself, then its diagram."""
    return "\n".join([_HEAD, *(_section(title, code) for title, code in _LIFECYCLES)])


PAGES: Mapping[str, Callable[[], str]] = {"docs/lifecycles.md": lifecycles}
"""Every generated file by its path in the repository."""


def stale(root: Path) -> list[str]:
    """The generated files under `root` that are missing or differ from what the code says now."""
    return [path for path, page in PAGES.items() if _content(root / path) != page()]


def write(root: Path) -> list[str]:
    """Bring every generated file under `root` up to date; those that were changed."""
    changed = stale(root)
    for path in changed:
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(PAGES[path](), encoding="utf-8")
    return changed


def _content(path: Path) -> str | None:
    return path.read_text(encoding="utf-8") if path.is_file() else None


def _section(title: str, code: ModuleType) -> str:
    source = "/".join(Path(getsourcefile(code) or "").parts[-4:])
    said = cleandoc(code.__doc__ or "")
    return f"## {title}\n\n`{source}` says:\n\n```text\n{said}\n```\n\n```mermaid\n{code.diagram()}```\n"


def main(words: list[str]) -> int:
    """Write, or with --check only compare; 1 if a file differs."""
    parser = argparse.ArgumentParser(description="Writes what is drawn from the code into docs/.")
    parser.add_argument("--check", action="store_true", help="write nothing; 1 if a file is not up to date")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    given = parser.parse_args(words)
    if not given.check:
        for path in write(given.root):
            print(path)
        return 0
    found = stale(given.root)
    for path in found:
        print(f"{path} is not what the code says: python tools/generate.py")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

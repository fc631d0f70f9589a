"""Which file of src/onika imports which, read from the sources without importing anything."""

import ast
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

_DATA = PurePosixPath("onika/labs")
"""The laboratories are data that is loaded by path; what they import says nothing of the house."""


def sources(root: Path) -> list[PurePosixPath]:
    """Every Python file of the package, as `onika/desk/plan/compile.py`, in order."""
    found = (
        PurePosixPath(path.relative_to(root / "src").as_posix()) for path in (root / "src" / "onika").rglob("*.py")
    )
    return sorted(path for path in found if not path.is_relative_to(_DATA))


def imports(root: Path) -> set[tuple[PurePosixPath, PurePosixPath]]:
    """Every pair of an importing and an imported file, imports inside functions included."""
    files = set(sources(root))
    pairs = set()
    for path in files:
        tree = ast.parse((root / "src" / path).read_text(encoding="utf-8"))
        targets = (_file(name, files) for name in _names(tree))
        pairs |= {(path, target) for target in targets if target is not None and target != path}
    return pairs


def _names(tree: ast.AST) -> Iterator[str]:
    """The dotted names a file imports; for `from a import b` that is `a.b`, whether module or not."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def _file(name: str, files: set[PurePosixPath]) -> PurePosixPath | None:
    """The file in which a dotted name is defined; None where it is another distribution's."""
    target = PurePosixPath(*name.split("."))
    while target.name:
        for file in (target.with_name(f"{target.name}.py"), target / "__init__.py"):
            if file in files:
                return file
        target = target.parent
    return None

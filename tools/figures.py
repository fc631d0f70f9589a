"""Counts what makes code hard to read: vague and ambiguous names, conditionals, complex functions, crowded folders.

Usage: python tools/figures.py [--check] [--root ROOT]. Prints a table of what is counted in src/onika (folders also in
browser/src and tests) and where the worst stand. The limits stand in pyproject.toml under [tool.onika.figures]; with
--check the tool ends with 1 if a figure is above its limit. A limit may only be lowered.
"""

import argparse
import ast
import re
import sys
import tomllib
from collections import Counter
from dataclasses import dataclass, field
from itertools import zip_longest
from pathlib import Path, PurePosixPath

import shared_names
from import_graph import imports

ROOT = Path(__file__).parents[1]

VAGUE = frozenset({"one", "found", "told", "said", "asked", "heard", "known"})
"""Names that say nothing of what they hold."""

COMPLEX = 15
"""A function of this complexity is named in the table."""

_BRANCHES = (
    ast.If,
    ast.For,
    ast.While,
    ast.IfExp,
    ast.ExceptHandler,
    ast.comprehension,
    ast.Assert,
    ast.match_case,
)
_CUTTERS = frozenset({"startswith", "endswith", "removeprefix", "removesuffix", "partition", "rpartition", "split"})
_PAGE = (".ts", ".svelte")
_PLACEHOLDER = re.compile(r"\((?:\?:|\?<\w+>)?(?:\.|\\S|\\w|\\d|\[\^?[^]]+\])[+*]")
"""The part of a regular expression that stands for any words."""
_PROSE = re.compile(r"[a-z]{2,},? [a-z]{2,}")
_LITERAL = re.compile(r"(?<![\w)\]/<])/(?![/*\s])((?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n\[])+)/[dgimsuvy]*")
"""A regular expression in TypeScript."""
_COMMENT = re.compile(r"\s*(?:/?\*|//)")
_GROUP_NAME = re.compile(r"\?<\w+>")
_TAG = re.compile("[<>]")
"""Between the slashes of two tags there is no regular expression."""


@dataclass
class Figures:
    """What was counted; each list names the worst first."""

    names: int = 0
    vague: Counter[str] = field(default_factory=Counter)
    lines: int = 0
    conditionals: Counter[str] = field(default_factory=Counter)
    functions: list[tuple[int, str]] = field(default_factory=list)
    folders: Counter[str] = field(default_factory=Counter)
    sentences: list[str] = field(default_factory=list)
    mutual: list[str] = field(default_factory=list)
    ambiguous: list[str] = field(default_factory=list)

    def rows(self) -> list[tuple[str, str, float, list[str]]]:
        """The rows of the table: the name of the limit, what it is, the figure, and where the worst stand."""
        dense = [row for row in self.functions if row[0] >= COMPLEX]
        shown = [f"{complexity} {where}" for complexity, where in self.functions]
        folders = [f"{count} {folder}" for folder, count in self.folders.most_common()]
        vague = round(100 * self.vague.total() / max(self.names, 1), 2)
        conditionals = round(1000 * self.conditionals.total() / max(self.lines, 1), 1)
        return [
            ("vague-names", "vague names in 100 identifiers", vague, _worst(self.vague)),
            ("conditionals", "conditional expressions in 1,000 lines", conditionals, _worst(self.conditionals)),
            ("complex-functions", f"functions of complexity {COMPLEX} or more", len(dense), shown),
            ("complexity", "complexity of the most complex function", max(self.functions, default=(0, ""))[0], []),
            ("folder", "files in the largest folder", max(self.folders.values(), default=0), folders),
            ("sentences", "our own sentences taken apart", len(self.sentences), self.sentences),
            ("mutual-imports", "pairs of packages that import each other", len(self.mutual), self.mutual),
            (
                "ambiguous-names",
                "class names of several packages without a reason",
                len(self.ambiguous),
                self.ambiguous,
            ),
        ]


def count(root: Path) -> Figures:
    """All figures of the repository at `root`."""
    figures = Figures()
    for path in sorted((root / "src" / "onika").rglob("*.py")):
        _count_file(figures, path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))
    for path in sorted((root / "browser" / "src").rglob("*")):
        if path.is_file():
            _count_page(figures, path.relative_to(root).as_posix(), path)
    for path in (root / "tests").rglob("*.py"):
        figures.folders[path.parent.relative_to(root).as_posix()] += 1
    figures.functions.sort(key=lambda row: (-row[0], row[1]))
    figures.mutual = sorted(f"{left} and {right}" for left, right in _mutual(root))
    figures.ambiguous = shared_names.unexplained(root)
    return figures


def complexity(function: ast.AST) -> int:
    """How many ways lead through a function: one, and one more for each branch in it."""
    branches = sum(isinstance(node, _BRANCHES) for node in ast.walk(function))
    return 1 + branches + sum(len(node.values) - 1 for node in ast.walk(function) if isinstance(node, ast.BoolOp))


def _worst(counts: Counter[str]) -> list[str]:
    return [f"{number} {where}" for where, number in counts.most_common()]


def _count_file(figures: Figures, name: str, text: str) -> None:
    figures.lines += text.count("\n")
    figures.folders[str(PurePosixPath(name).parent)] += 1
    for node in ast.walk(ast.parse(text)):
        identifier = node.id if isinstance(node, ast.Name) else node.arg if isinstance(node, ast.arg) else None
        if identifier is not None:
            figures.names += 1
            figures.vague[name] += identifier in VAGUE
        if isinstance(node, ast.IfExp):
            figures.conditionals[name] += 1
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            figures.functions.append((complexity(node), f"{name}:{node.lineno} {node.name}"))
        if (cut := _sentence(node)) is not None:
            figures.sentences.append(f"{name}:{getattr(node, 'lineno', 1)} {cut}")


def _sentence(node: ast.AST) -> str | None:
    """The sentence a piece of code takes apart: by a regular expression, or by a method of strings."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and _is_pattern_of_prose(node.value):
        return node.value
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in _CUTTERS:
        constants = (arg.value for arg in node.args if isinstance(arg, ast.Constant) and isinstance(arg.value, str))
        return next((text for text in constants if _PROSE.search(text)), None)
    return None


def _is_pattern_of_prose(text: str) -> bool:
    return bool(_PLACEHOLDER.search(text) and _PROSE.search(text))


def _count_page(figures: Figures, name: str, path: Path) -> None:
    figures.folders[str(PurePosixPath(name).parent)] += 1
    if path.suffix not in _PAGE:
        return
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if _COMMENT.match(line):
            continue
        for pattern in _LITERAL.findall(line):
            if _PROSE.search(pattern) and not _TAG.search(_GROUP_NAME.sub("", pattern)):
                figures.sentences.append(f"{name}:{number} {pattern}")


def _mutual(root: Path) -> set[tuple[str, str]]:
    """The pairs that import each other: neighbours in one package, or a package and one within it."""
    packages = {(importer.parent, imported.parent) for importer, imported in imports(root)}
    facing = {_facing(importer, imported) for importer, imported in packages if importer != imported}
    return {(left, right) for left, right in facing if left < right and (right, left) in facing}


def _facing(importer: PurePosixPath, imported: PurePosixPath) -> tuple[str, str]:
    """The two as neighbours: `desk/run/review` and `desk/plan` face each other as `desk/run` and `desk/plan`."""
    shared = 0
    for mine, theirs in zip_longest(importer.parts, imported.parts):
        if mine != theirs:
            break
        shared += 1
    return "/".join(importer.parts[: shared + 1]), "/".join(imported.parts[: shared + 1])


def limits(root: Path) -> dict[str, float]:
    """What pyproject.toml allows."""
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    return dict(project["tool"]["onika"]["figures"])


def main(words: list[str]) -> int:
    """Print the table; with --check 1 if a figure is above its limit."""
    parser = argparse.ArgumentParser(description="Counts what makes the code hard to read.")
    parser.add_argument("--check", action="store_true", help="print only what is above its limit; 1 if anything is")
    parser.add_argument("--worst", type=int, default=5, help="how many of the worst places are named")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    given = parser.parse_args(words)
    allowed = limits(given.root)
    above = False
    for name, meaning, figure, places in count(given.root).rows():
        is_above = figure > allowed[name]
        above |= is_above
        if is_above or not given.check:
            print(f"{figure:8g}  {meaning} (limit {allowed[name]:g}{', ABOVE IT' if is_above else ''})")
            for place in places[: given.worst]:
                print(f"{'':10}{place}")
    return int(given.check and above)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

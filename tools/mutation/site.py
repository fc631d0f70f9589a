"""A site is where a node stands in a syntax tree; another node can be put there."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Site:
    """A field of a node, or one element of it."""

    parent: ast.AST
    field: str
    index: int | None = None

    @property
    def node(self) -> Any:
        """What stands there."""
        value = getattr(self.parent, self.field)
        return value if self.index is None else value[self.index]

    def put(self, node: ast.AST | None) -> None:
        """Let this node stand there."""
        if self.index is None:
            setattr(self.parent, self.field, node)
        else:
            getattr(self.parent, self.field)[self.index] = node


def sites(parent: ast.AST) -> Iterator[Site]:
    """Where the nodes just below this one stand, in the order of the text."""
    for field, value in ast.iter_fields(parent):
        if isinstance(value, ast.AST):
            yield Site(parent, field)
        elif isinstance(value, list):
            yield from (Site(parent, field, at) for at, node in enumerate(value) if isinstance(node, ast.AST))

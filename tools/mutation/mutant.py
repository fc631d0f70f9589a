"""A mutant: one node of a file has become another, and so the file behaves in another way, or should."""

import ast
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from types import CodeType
from typing import Any

from mutation.site import Site, sites
from mutation.variants import variants

_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_NAMED = (*_FUNCTIONS, ast.ClassDef)


@dataclass(frozen=True, slots=True)
class Place:
    """Where something stands: in classes and functions by name, in a function of the file, in which lines.

    function    name and first line of the outermost function around it; None: it is carried out as the file is loaded
    lines       first and last line of the statement; of one with a body, of its head
    """

    scope: tuple[str, ...] = ()
    function: tuple[str, int] | None = None
    lines: tuple[int, int] = (0, 0)


@dataclass(frozen=True, slots=True)
class Mutant:
    """Its name says where and what; `node` stands at the site in place of what was there."""

    name: str
    site: Site
    node: ast.AST | None
    place: Place


class MutatedFile:
    """One file and all its mutants, in the order of the text."""

    def __init__(self, text: str, path: str) -> None:
        self._path = path
        self._tree = ast.parse(text, path)
        self.original = compile(text, path, "exec", dont_inherit=True)
        self._met: Counter[str] = Counter()
        self.mutants = list(self._below(self._tree, Place()))

    @contextmanager
    def _planted(self, mutant: Mutant) -> Iterator[None]:
        original = mutant.site.node
        mutant.site.put(mutant.node)
        try:
            yield
        finally:
            mutant.site.put(original)

    def code(self, mutant: Mutant) -> CodeType:
        """The module with this mutant; raises SyntaxError or ValueError where it can be none."""
        with self._planted(mutant):
            return compile(ast.fix_missing_locations(self._tree), self._path, "exec", dont_inherit=True)

    def function_code(self, mutant: Mutant) -> CodeType:
        """The code of the function in which it stands; raises ValueError where it stands in none."""
        return _code(self.code(mutant), mutant.place.function)

    def is_local(self, mutant: Mutant) -> bool:
        """Whether it changes the code of a function only, and not how that is bound to what is around it."""
        if mutant.place.function is None:
            return False
        return self.function_code(mutant).co_freevars == _code(self.original, mutant.place.function).co_freevars

    def _below(self, parent: ast.AST, place: Place) -> Iterator[Mutant]:
        for site in sites(parent):
            if _is_left_out(site):
                continue
            here = _place(parent, site, place)
            for other in variants(site.node, is_table=here.function is None):
                yield self._mutant(site, other, here)
            yield from self._below(site.node, _inside(site.node, here))

    def _mutant(self, site: Site, other: ast.AST | None, place: Place) -> Mutant:
        if isinstance(other, ast.stmt | ast.expr | ast.excepthandler):
            ast.fix_missing_locations(ast.copy_location(other, site.node))
        name = f"{'.'.join(place.scope) or 'module'}: {_shown(site.node)} -> {_shown(other)}"
        self._met[name] += 1
        if self._met[name] > 1:
            name = f"{name} ({self._met[name]})"
        return Mutant(name, site, other, place)


def _place(parent: ast.AST, site: Site, place: Place) -> Place:
    """Where the node at this site stands, `place` being what is known of its parent."""
    function = place.function
    if isinstance(parent, _FUNCTIONS) and function is not None and function[0] == ".".join(place.scope):
        # What stands beside the body, such as a default, is carried out when the function is made.
        function = function if site.field == "body" else None
    return replace(place, function=function, lines=_lines(site.node) or place.lines)


def _inside(node: ast.AST, place: Place) -> Place:
    """Where things stand in this node."""
    if not isinstance(node, _NAMED):
        return place
    scope = (*place.scope, node.name)
    if isinstance(node, ast.ClassDef) or place.function is not None:
        return replace(place, scope=scope)
    return replace(place, scope=scope, function=(".".join(scope), _first_line(node)))


def _lines(node: Any) -> tuple[int, int] | None:
    """The lines of a statement or of its head; None: it is none."""
    if not isinstance(node, ast.stmt | ast.ExceptHandler | ast.match_case):
        return None
    first = node.pattern.lineno if isinstance(node, ast.match_case) else node.lineno
    if isinstance(node, ast.Match):
        return first, node.cases[0].pattern.lineno
    if hasattr(node, "body"):
        return first, max(first, node.body[0].lineno - 1)
    return first, node.end_lineno or first


def _first_line(node: Any) -> int:
    return min([node.lineno, *(decorator.lineno for decorator in node.decorator_list)])


def _is_left_out(site: Site) -> bool:
    """What is not carried out, or is no behaviour: annotations, docstrings, imports, protocols, types."""
    node: Any = site.node
    if site.field in ("annotation", "returns", "decorator_list", "bases", "ctx"):
        return True
    match node:
        case ast.Expr(value=ast.Constant()) | ast.Import() | ast.ImportFrom():
            return True
        case ast.If(test=ast.Name(id="TYPE_CHECKING")) | ast.Assign(targets=[ast.Name(id="__slots__")]):
            return True
        case ast.Assign(value=ast.Subscript(value=ast.Name(id="Callable" | "tuple"))):
            return True
        case ast.Assign(value=ast.Call(func=ast.Name(id="TypeVar"))):
            return True
        case ast.ClassDef():
            return any(isinstance(base, ast.Name) and base.id == "Protocol" for base in node.bases)
    return False


def _shown(node: ast.AST | None) -> str:
    """A node as short text: the heads of statements only."""
    if node is None:
        return "nothing"
    text = ast.unparse(node) if not isinstance(node, ast.match_case) else ast.unparse(node.pattern)
    head = text.splitlines()[0] if text else type(node).__name__
    if isinstance(node, ast.Match):
        return f"{head} {', '.join(ast.unparse(case.pattern) for case in node.cases)}"
    if isinstance(node, ast.ExceptHandler):
        return " ".join(line.strip() for line in text.splitlines()[:2])
    return head if len(text.splitlines()) == 1 or not isinstance(node, ast.expr) else " ".join(text.split())


def _code(module: CodeType, function: tuple[str, int] | None) -> CodeType:
    code = None if function is None else _inner(module, *function)
    if code is None:
        raise ValueError(f"expected a function, found {function}")
    return code


def _inner(code: CodeType, name: str, line: int) -> CodeType | None:
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            if constant.co_qualname == name and constant.co_firstlineno == line:
                return constant
            if name.startswith(f"{constant.co_qualname}."):
                inner = _inner(constant, name, line)
                if inner is not None:
                    return inner
    return None

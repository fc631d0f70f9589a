"""The variants of a node: what a slip of the pen could have made of it.

Comparisons move their boundary or turn round, `and` and `or` change places and lose a side, numbers move by one, texts
change, conditions hold always or never, statements are left out, values and arguments are None, tables lose or
exchange an element, handlers handle nothing.
"""

import ast
from collections.abc import Callable, Iterator
from copy import copy
from typing import Any

_COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
_OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.Mod: ast.Mult,
    ast.Pow: ast.Mult,
    ast.BitOr: ast.BitAnd,
    ast.BitAnd: ast.BitOr,
    ast.LShift: ast.RShift,
    ast.RShift: ast.LShift,
}
_OPPOSITES = {
    "min": "max",
    "max": "min",
    "any": "all",
    "all": "any",
    "ceil": "floor",
    "argmax": "argmin",
    "append": "count",
    "add": "discard",
    "discard": "add",
}
"""Functions and methods that take the same and mean the opposite, or nothing."""


def variants(node: ast.AST, is_table: bool) -> Iterator[ast.AST | None]:
    """Other nodes that could stand in its place; None: nothing at all.

    is_table    it is carried out once, when the module is loaded: then elements are exchanged, too
    """
    for variation in _VARIATIONS.get(type(node), ()):
        yield from variation(node)
    if is_table and isinstance(node, ast.Tuple | ast.Dict):
        yield from _table(node)


def _with(node: Any, **fields: Any) -> Any:
    other = copy(node)
    for field, value in fields.items():
        setattr(other, field, value)
    return other


def _without(nodes: list[Any], at: int) -> list[Any]:
    return nodes[:at] + nodes[at + 1 :]


def _instead(nodes: list[Any], at: int, node: Any) -> list[Any]:
    return [*nodes[:at], node, *nodes[at + 1 :]]


def _constant(value: Any) -> ast.Constant:
    return ast.Constant(value)


def _is_none(node: ast.AST | None) -> bool:
    return node is None or (isinstance(node, ast.Constant) and node.value is None)


def _is_plain(node: ast.AST) -> bool:
    """Whether it is a constant, which has variants of its own."""
    return isinstance(node.operand if isinstance(node, ast.UnaryOp) else node, ast.Constant)


def _compare(node: ast.Compare) -> Iterator[ast.AST]:
    for at, operator in enumerate(node.ops):
        for other in _COMPARISONS[type(operator)]:
            yield _with(node, ops=_instead(node.ops, at, other()))


def _connect(node: ast.BoolOp) -> Iterator[ast.AST]:
    yield _with(node, op=ast.Or() if isinstance(node.op, ast.And) else ast.And())
    for at in range(len(node.values)):
        values = _without(node.values, at)
        yield values[0] if len(values) == 1 else _with(node, values=values)


def _sign(node: ast.UnaryOp) -> Iterator[ast.AST]:
    yield node.operand


def _calculate(node: ast.BinOp) -> Iterator[ast.AST]:
    if type(node.op) in _OPERATORS:
        yield _with(node, op=_OPERATORS[type(node.op)]())


def _augment(node: ast.AugAssign) -> Iterator[ast.AST]:
    if type(node.op) in _OPERATORS:
        yield _with(node, op=_OPERATORS[type(node.op)]())
    yield ast.Assign([node.target], node.value)
    yield ast.Pass()


def _value(node: ast.Constant) -> Iterator[ast.AST]:
    match node.value:
        case bool():
            yield _constant(not node.value)
        case int():
            yield _constant(node.value + 1)
            yield _constant(node.value - 1)
        case float():
            others = dict.fromkeys((node.value + 1.0, node.value * 2.0 or -1.0))
            yield from map(_constant, others)
        case str():
            yield _constant(f"~{node.value}")
        case bytes():
            yield _constant(b"~" + node.value)


def _decide(node: ast.If | ast.IfExp) -> Iterator[ast.AST]:
    for value in (True, False):
        yield _with(node, test=_constant(value))


def _repeat(node: ast.While) -> Iterator[ast.AST]:
    yield _with(node, test=_constant(False))


def _go_through(node: ast.For) -> Iterator[ast.AST]:
    yield _with(node, iter=ast.Tuple([], ast.Load()))


def _comprehend(node: ast.comprehension) -> Iterator[ast.AST]:
    for at in range(len(node.ifs)):
        yield _with(node, ifs=_without(node.ifs, at))
        yield _with(node, ifs=_instead(node.ifs, at, _constant(False)))


def _give_back(node: ast.Return) -> Iterator[ast.AST]:
    if node.value is not None and not _is_plain(node.value):
        yield ast.Return(None)


def _bring_forth(node: ast.Yield) -> Iterator[ast.AST]:
    if not _is_none(node.value):
        yield ast.Yield(None)


def _assign(node: ast.Assign | ast.AnnAssign) -> Iterator[ast.AST]:
    if node.value is None:
        return
    if not _is_plain(node.value):
        yield _with(node, value=_constant(None))
    yield ast.Pass()


def _leave_out(_: ast.stmt) -> Iterator[ast.AST]:
    yield ast.Pass()


def _leave(_: ast.Continue) -> Iterator[ast.AST]:
    yield ast.Break()


def _stay(_: ast.Break) -> Iterator[ast.AST]:
    yield ast.Continue()


def _call(node: ast.Call) -> Iterator[ast.AST]:
    for at, argument in enumerate(node.args):
        if not (_is_plain(argument) or isinstance(argument, ast.Starred)):
            yield _with(node, args=_instead(node.args, at, _constant(None)))
    for at, keyword in enumerate(node.keywords):
        if keyword.arg and not _is_plain(keyword.value):
            yield _with(node, keywords=_instead(node.keywords, at, ast.keyword(keyword.arg, _constant(None))))
        yield _with(node, keywords=_without(node.keywords, at))
    name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
    if name in _OPPOSITES:
        field = "id" if isinstance(node.func, ast.Name) else "attr"
        yield _with(node, func=_with(node.func, **{field: _OPPOSITES[name]}))


def _compute(node: ast.Lambda) -> Iterator[ast.AST]:
    if not _is_none(node.body):
        yield _with(node, body=_constant(None))


def _handle(node: ast.ExceptHandler) -> Iterator[ast.AST]:
    yield _with(node, body=[ast.Raise()])
    if isinstance(node.type, ast.Tuple):
        for at in range(len(node.type.elts)):
            yield _with(node, type=_with(node.type, elts=_without(node.type.elts, at)))


def _distinguish(node: ast.Match) -> Iterator[ast.AST]:
    for at in range(len(node.cases)):
        if len(node.cases) > 1:
            yield _with(node, cases=_without(node.cases, at))


def _fit(node: ast.match_case) -> Iterator[ast.AST]:
    if node.guard is not None:
        yield _with(node, guard=None)


def _table(node: ast.Tuple | ast.Dict) -> Iterator[ast.AST]:
    """A row of names has one exchanged for the next that differs; else an element is missing."""
    if isinstance(node, ast.Dict):
        for at in range(len(node.keys)):
            yield _with(node, keys=_without(node.keys, at), values=_without(node.values, at))
            other = _next(node.values, at)
            if other is not None:
                yield _with(node, values=_instead(node.values, at, other))
        return
    for at, element in enumerate(node.elts):
        other = _next(node.elts, at)
        if isinstance(element, ast.Name) and other is not None:
            yield _with(node, elts=_instead(node.elts, at, other))
        elif not isinstance(element, ast.Constant):
            yield _with(node, elts=_without(node.elts, at))


def _next(nodes: list[Any], at: int) -> Any:
    """The next element that is another name, or nothing."""
    text = ast.dump(nodes[at])
    others = [node for node in nodes[at + 1 :] + nodes[:at] if isinstance(node, ast.Name | ast.Attribute)]
    return next((node for node in others if ast.dump(node) != text), None)


_VARIATIONS: dict[type[ast.AST], tuple[Callable[[Any], Iterator[ast.AST]], ...]] = {
    ast.Compare: (_compare,),
    ast.BoolOp: (_connect,),
    ast.UnaryOp: (_sign,),
    ast.BinOp: (_calculate,),
    ast.AugAssign: (_augment,),
    ast.Constant: (_value,),
    ast.If: (_decide,),
    ast.IfExp: (_decide,),
    ast.While: (_repeat,),
    ast.For: (_go_through,),
    ast.comprehension: (_comprehend,),
    ast.Return: (_give_back,),
    ast.Yield: (_bring_forth,),
    ast.Assign: (_assign,),
    ast.AnnAssign: (_assign,),
    ast.Expr: (_leave_out,),
    ast.Raise: (_leave_out,),
    ast.Delete: (_leave_out,),
    ast.Continue: (_leave,),
    ast.Break: (_stay,),
    ast.Call: (_call,),
    ast.Lambda: (_compute,),
    ast.ExceptHandler: (_handle,),
    ast.Match: (_distinguish,),
    ast.match_case: (_fit,),
}

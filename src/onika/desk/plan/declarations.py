"""What a module's class declares of inputs and ports, read from its text: before any runtime has run it (B10).

Only what is written down as it is counts: texts and numbers. A runtime that has executed the class knows better, and
what it says comes first.
"""

import ast
from functools import lru_cache
from pathlib import Path
from typing import Any

from onika.files import text
from onika.wire.sheet import InputSheet, PortSheet

_PORTS = {"InConst", "OutConst", "InVar", "OutVar", "InBoth", "OutBoth"}
_NAMES = ("shape", "unit", "meaning")


def declared_inputs(code: Path) -> tuple[InputSheet, ...]:
    """The inputs of the class in a file, in their order; none where it cannot be read or says them in another way."""
    return tuple(sheet for sheet in _of_file(code) if isinstance(sheet, InputSheet))


def declared_ports(code: Path) -> tuple[PortSheet, ...]:
    """Its ports."""
    return tuple(sheet for sheet in _of_file(code) if isinstance(sheet, PortSheet))


def _of_file(code: Path) -> tuple[InputSheet | PortSheet, ...]:
    try:
        status = code.stat()
    except OSError:
        return ()
    return _declared(code, status.st_mtime_ns, status.st_size)


@lru_cache(maxsize=1024)  # asked for whenever the libraries are looked at anew
def _declared(code: Path, _written_ns: int, _size: int) -> tuple[InputSheet | PortSheet, ...]:
    source, _ = text.load(code, str(code))
    try:
        tree = ast.parse(source or "")
    except (SyntaxError, ValueError, RecursionError):
        return ()  # a runtime says what is wrong with it
    bodies = (statement.body for statement in tree.body if isinstance(statement, ast.ClassDef))
    sheets = (_sheet(statement) for body in bodies for statement in body)
    return tuple(sheet for sheet in sheets if sheet is not None)


def _sheet(statement: ast.stmt) -> InputSheet | PortSheet | None:
    """The declaration `name = Input("double", …)` or `NAME = InVar("double", …)`, where that is one."""
    match statement:
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=kind)) as call):
            arguments = dict(zip(_NAMES, map(_literal, call.args), strict=False))
            arguments |= {keyword.arg: _literal(keyword.value) for keyword in call.keywords if keyword.arg}
            if not isinstance(arguments.get("shape"), str):
                return None
            described = (arguments["shape"], str(arguments.get("unit", "-")), str(arguments.get("meaning", "")))
            if kind in _PORTS:
                return PortSheet(kind.upper(), str(arguments.get("name") or name), *described)
            if kind == "Input":
                return InputSheet(
                    name, *described, arguments.get("low"), arguments.get("high"), arguments.get("default")
                )
    return None


def _literal(expression: ast.expr) -> Any:
    """A text, number or list that is written down; None for everything else."""
    try:
        return ast.literal_eval(expression)
    except ValueError:
        return None

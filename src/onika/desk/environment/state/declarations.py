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
    return tuple(one for one in _of_file(code) if isinstance(one, InputSheet))


def declared_ports(code: Path) -> tuple[PortSheet, ...]:
    """Its ports."""
    return tuple(one for one in _of_file(code) if isinstance(one, PortSheet))


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
    bodies = (one.body for one in tree.body if isinstance(one, ast.ClassDef))
    found = (_sheet(statement) for body in bodies for statement in body)
    return tuple(one for one in found if one is not None)


def _sheet(statement: ast.stmt) -> InputSheet | PortSheet | None:
    """The declaration `name = Input("double", …)` or `NAME = InVar("double", …)`, where that is one."""
    match statement:
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=kind)) as call):
            said = dict(zip(_NAMES, map(_literal, call.args), strict=False))
            said |= {one.arg: _literal(one.value) for one in call.keywords if one.arg}
            if not isinstance(said.get("shape"), str):
                return None
            told = (said["shape"], str(said.get("unit", "-")), str(said.get("meaning", "")))
            if kind in _PORTS:
                return PortSheet(kind.upper(), str(said.get("name") or name), *told)
            if kind == "Input":
                return InputSheet(name, *told, said.get("low"), said.get("high"), said.get("default"))
    return None


def _literal(expression: ast.expr) -> Any:
    """A text, number or list that is written down; None for everything else."""
    try:
        return ast.literal_eval(expression)
    except ValueError:
        return None

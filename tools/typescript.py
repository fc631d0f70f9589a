"""The messages of the page as TypeScript, drawn from the structs of `wire/`."""

import types
import typing
from collections.abc import Iterator
from inspect import cleandoc
from types import ModuleType

from msgspec import NODEFAULT, Struct, inspect

from onika.wire import act, class_board, page, view

_HEAD = "// Drawn from src/onika/wire/{act,view,page,class_board}.py by tools/generate.py: change those.\n"
_IMPORTS = "import type { Reason } from './texts/say';\n"
_UNIONS = {"AnyAct": act.AnyAct, "AnyMessage": page.AnyMessage, "AnyShow": view.AnyShow}
_BASES = (act.Act, view.View, view.Destination, page.Message)


def source() -> str:
    """The whole file."""
    structs = [one for module in (act, view, page, class_board) for one in _structs(module)]
    unions = [f"export type {name} = {_union(kinds)};" for name, kinds in _UNIONS.items()]
    return "\n".join((_HEAD, _IMPORTS, *map(_interface, structs), *unions)) + "\n"


def _structs(module: ModuleType) -> Iterator[type[Struct]]:
    for one in vars(module).values():
        is_struct = isinstance(one, type) and issubclass(one, Struct)
        if is_struct and one.__module__.startswith(module.__name__) and one not in _BASES:
            yield one


def _union(kinds: types.UnionType) -> str:
    return " | ".join(one.__name__ for one in typing.get_args(kinds))


def _interface(struct: type[Struct]) -> str:
    told = inspect.type_info(struct)
    assert isinstance(told, inspect.StructType)
    omits = struct.__struct_config__.omit_defaults
    lines = [f"/** {' '.join(cleandoc(struct.__doc__ or '').split())} */", f"export interface {struct.__name__} {{"]
    if told.tag_field:
        lines.append(f"  {told.tag_field}: '{told.tag}';")
    for field in told.fields:
        free = omits and (field.default is not NODEFAULT or field.default_factory is not NODEFAULT)
        lines.append(f"  {field.encode_name}{'?' if free else ''}: {_type(field.type)};")
    return "\n".join((*lines, "}", ""))


def _type(kind: inspect.Type) -> str:
    match kind:
        case inspect.IntType() | inspect.FloatType():
            return "number"
        case inspect.StrType():
            return "string"
        case inspect.BoolType():
            return "boolean"
        case inspect.NoneType():
            return "null"
        case inspect.AnyType():
            return "unknown"
        case inspect.LiteralType():
            return " | ".join(f"'{one}'" for one in kind.values)
        case inspect.ListType() | inspect.VarTupleType():
            return f"({_type(kind.item_type)})[]"
        case inspect.TupleType():
            return f"[{', '.join(map(_type, kind.item_types))}]"
        case inspect.DictType():
            return f"Record<{_type(kind.key_type)}, {_type(kind.value_type)}>"
        case inspect.UnionType():
            return _of_union(kind)
        case inspect.StructType():
            return kind.cls.__name__
    raise TypeError(f"expected a type that TypeScript has, found {kind}")


def _of_union(kind: inspect.UnionType) -> str:
    structs = {one.cls for one in kind.types if isinstance(one, inspect.StructType)}
    for name, kinds in _UNIONS.items():
        if structs == set(typing.get_args(kinds)):
            rest = [_type(one) for one in kind.types if not isinstance(one, inspect.StructType)]
            return " | ".join((name, *rest))
    return " | ".join(map(_type, kind.types))

"""The code guard: it finds functions and classes of ours that module code has replaced since (law 14)."""

import builtins
import select
import sys
import time
from collections.abc import Iterable, Mapping
from operator import itemgetter
from types import BuiltinFunctionType, FunctionType, ModuleType
from typing import Any, NamedTuple

_PACKAGE = "onika"
_OF_TASKS = "onika_task_"
"""How the namespace of a module that a task executes begins."""
_KINDS = (FunctionType, BuiltinFunctionType, type, property, staticmethod, classmethod)


class Replaced(NamedTuple):
    """What was replaced, and the module whose code stands there now; "" where that cannot be seen."""

    what: str
    module: str


class CodeGuard:
    """Remembers what namespaces hold; to look again costs a tenth of a millisecond, for it only compares identities.

    What is set on one instance alone, or within a function, it does not see.
    """

    def __init__(self, modules: Iterable[ModuleType]) -> None:
        self._places = [place for module in modules for place in _places(module)]

    def replaced(self) -> Replaced | None:
        """The first that is not what it was; None where all is as it was."""
        for place in self._places:
            if place.is_changed():
                return place.replaced()
        return None


class _Place:
    """A namespace: of a module, or of a class."""

    def __init__(self, name: str, namespace: Mapping[str, Any], names: tuple[str, ...]) -> None:
        self._name = name
        self._namespace = namespace
        self._names = names
        self._take = itemgetter(*self._names, self._names[0])  # one name alone would give no tuple
        self._values: tuple[Any, ...] = self._take(namespace)

    def is_changed(self) -> bool:
        """Whether something else stands there under a name, or nothing."""
        try:
            return bool(self._take(self._namespace) != self._values)
        except KeyError:
            return True

    def replaced(self) -> Replaced:
        """The first name under which something else stands."""
        for name, former in zip(self._names, self._values, strict=False):
            if self._namespace.get(name) is not former:
                return Replaced(f"{self._name}.{name}", _module_of(self._namespace.get(name)))
        return Replaced(self._name, "")


def own_code() -> list[ModuleType]:
    """The modules of ours that are loaded by now, and those of the library on which a unit's loop depends."""
    ours = [module for name, module in sorted(sys.modules.items()) if name.partition(".")[0] == _PACKAGE]
    return [*ours, sys.modules["__main__"], builtins, select, time]


def _places(module: ModuleType) -> list[_Place]:
    name, namespace = module.__name__, vars(module)
    classes = [cls for cls in namespace.values() if isinstance(cls, type) and cls.__module__ == name]
    spaces: dict[str, Mapping[str, Any]] = {name: namespace}
    if module is not builtins:  # its classes cannot be changed
        spaces |= {f"{name}.{cls.__qualname__}": vars(cls) for cls in classes}
    return [_Place(name, space, names) for name, space in spaces.items() if (names := _code_in(space))]


def _code_in(namespace: Mapping[str, Any]) -> tuple[str, ...]:
    return tuple(name for name, value in namespace.items() if isinstance(value, _KINDS))


def _module_of(value: object) -> str:
    """The module of a task from whose code a function or class comes; nothing of the stranger's is called for it."""
    space: object = ""
    if type(value) is FunctionType:
        space = value.__globals__.get("__name__")
    elif type(value) is type:
        space = vars(value).get("__module__")
    return space.removeprefix(_OF_TASKS) if type(space) is str and space.startswith(_OF_TASKS) else ""

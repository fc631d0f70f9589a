"""The declarations in a module class: its ports, the input it takes, the parameters of its LOCAL block."""

from collections.abc import Callable
from functools import lru_cache
from operator import attrgetter
from types import CodeType
from typing import Any, ClassVar

import numpy as np

from onika.model.port import Port, PortKind
from onika.words import letters
from onika.words.name import SVAR_NAME
from onika.words.reason import Reason, reason_of
from onika.words.shape import Shape
from onika.words.value import ValueType

Bound = float | str
"""A number, or the name of an INCONST that holds one (a vector bounds element by element)."""


Step = float | str | tuple[float | str, ...] | None
"""What a step may be: a number, the name of a port or parameter that holds it, several of them to be multiplied."""


class PortDeclaration:
    """A port as a class attribute; on an instance it is the module's own copy of the variable.

    A vector is a NumPy array (inputs cannot be written), a scalar a number, a text or character a str, several of them
    a list. `name` is the coded name where it is no Python name, as in `Q^_REF`. Assigning writes into place, whole.
    `step` is what an input of a hardware task may step by in one cycle at a reconfiguration: `math.inf` where it steps
    by nature, as a valve; None: nobody knows, it is only told (law 33).
    """

    kind: ClassVar[PortKind]

    def __init__(self, shape: str, unit: str = "-", meaning: str = "", *, name: str = "", step: Step = None) -> None:
        self.shape = Shape.parse(shape)
        self.unit = unit
        self.meaning = meaning
        self.name = name
        self.step = step

    def port(self, attribute: str) -> Port:
        """The port as a value."""
        name = self.name or attribute
        if not SVAR_NAME.match(name):
            raise ValueError(Reason.of("runtime.port_name", name=name))
        return Port(self.kind, name, self.shape, self.unit, self.meaning)

    def accessor(self, attribute: str) -> property:
        """The property that stands in the class in place of the declaration."""
        key = slot(attribute)
        return property(_getter(key, self.shape), _setter(key, attribute, self), doc=self.meaning)


class InConst(PortDeclaration):
    """Read once, at initialisation."""

    kind = PortKind.INCONST


class OutConst(PortDeclaration):
    """Written once, by `init`."""

    kind = PortKind.OUTCONST


class InVar(PortDeclaration):
    """Read before every cycle."""

    kind = PortKind.INVAR


class OutVar(PortDeclaration):
    """Written after every cycle."""

    kind = PortKind.OUTVAR


class InBoth(PortDeclaration):
    """A first value at initialisation, then read before every cycle."""

    kind = PortKind.INBOTH


class OutBoth(PortDeclaration):
    """A first value written by `init`, then after every cycle."""

    kind = PortKind.OUTBOTH


class Input:
    """What a task takes from its argument line when it goes on, else asks the user for (dissertation §C.4)."""

    def __init__(
        self,
        shape: str,
        unit: str = "-",
        meaning: str = "",
        *,
        low: Bound | None = None,
        high: Bound | None = None,
        default: Any = None,
    ) -> None:
        self.shape = Shape.parse(shape)
        self.unit = unit
        self.meaning = meaning
        self.low = low
        self.high = high
        self.default = default


class Local:
    """A parameter that the LOCAL block of the `.rmod` gives; its key is the attribute's name.

    Without a default the line must be there. On an instance it is a number, a str, or a list of them; numbers beyond
    `low` and `high` are refused before the task lives.
    """

    def __init__(
        self,
        shape: str,
        unit: str = "-",
        meaning: str = "",
        *,
        default: Any = None,
        low: float | None = None,
        high: float | None = None,
    ) -> None:
        self.shape = Shape.parse(shape)
        self.unit = unit
        self.meaning = meaning
        self.default = default
        self.low = low
        self.high = high


def slot(attribute: str) -> str:
    """The name under which an instance keeps the buffer of a port."""
    return "_port_" + attribute


def memory_slot(attribute: str) -> str:
    """The name under which an instance keeps the memory of an output that is a vector."""
    return "_memory_" + attribute


def _getter(key: str, shape: Shape) -> Callable[[Any], Any]:
    buffer = attrgetter(key)
    if _is_lettered(shape):
        is_vector = bool(shape.dims)
        return lambda module: letters.decode(buffer(module).tobytes(), shape.type, is_vector)
    if not shape.dims:
        return lambda module: buffer(module)[0].item()
    return buffer  # attrgetter runs in C: the fast way for vectors


def _is_lettered(shape: Shape) -> bool:
    return shape.type.is_text or shape.type is ValueType.CHAR


def _setter(key: str, attribute: str, declaration: PortDeclaration) -> Callable[[Any, Any], None]:
    kind = declaration.kind
    if kind.is_input:

        def refuse(_module: Any, _value: Any) -> None:
            raise AttributeError(Reason.of("runtime.input_written", attribute=attribute, kind=kind.value))

        return refuse
    buffer = attrgetter(key)
    if _is_lettered(declaration.shape):

        def write_letters(module: Any, value: Any) -> None:
            target = buffer(module).reshape(-1)
            try:
                target[:] = bytearray(letters.encode(value, declaration.shape.type, target.size))
            except ValueError as wrong:
                raise ValueError(
                    Reason.of("runtime.attribute_wrong", attribute=attribute, why=reason_of(wrong))
                ) from None

        return write_letters

    def write(module: Any, value: Any) -> None:
        if value is None:
            raise ValueError(Reason.of("runtime.value_missing", attribute=attribute, shape=str(declaration.shape)))
        try:
            buffer(module)[...] = value
        except ValueError as wrong:
            why = reason_of(wrong)
            raise ValueError(
                Reason.of("runtime.value_unfit", attribute=attribute, shape=str(declaration.shape), why=why)
            ) from None

    return _vector_writer(attribute, write) if len(declaration.shape.dims) == 1 else write


_VECTOR_WRITER = """
def write(module, value):
    if type(value) is array_type:
        try:
            module.{memory}[everything] = value
            return
        except ValueError:
            pass
    write_any(module, value)
"""


def _vector_writer(attribute: str, write_any: Callable[[Any, Any], None]) -> Callable[[Any, Any], None]:
    """The same, faster for an array of the very type and length, as most are: as memory, found without a call."""
    space: dict[str, Any] = {"array_type": np.ndarray, "everything": slice(None), "write_any": write_any}
    exec(_vector_writer_code(memory_slot(attribute)), space)  # noqa: S102 - the text is ours, the attribute a name
    write: Callable[[Any, Any], None] = space.pop("write")
    return write


@lru_cache
def _vector_writer_code(memory: str) -> CodeType:
    return compile(_VECTOR_WRITER.format(memory=memory), "<port>", "exec")

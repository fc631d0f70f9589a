"""The type and shape of a state variable or an input: `double[NDOF,4]`, `int`, `byte[128,128]` (requirement A03)."""

import math
import re
from collections.abc import Mapping

from msgspec import Struct

from onika.words.name import SVAR_NAME
from onika.words.reason import Reason
from onika.words.value import ValueType

_FORM = re.compile(r"([a-z]+)(?:\[([^\[\]]*)\])?\Z")


class Shape(Struct, frozen=True):
    """A value type and its dimensions, each a whole number or the name of an INCONST; no dimension is a scalar."""

    type: ValueType
    dims: tuple[int | str, ...] = ()

    @classmethod
    def parse(cls, text: str) -> "Shape":
        """Read `double[NDOF,4]`; raises ValueError that says what was expected."""
        match = _FORM.match(text.replace(" ", ""))
        if not match or match[1] not in ValueType._value2member_map_:
            raise ValueError(Reason.of("words.shape", text=text))
        if match[2] is None:
            return cls(ValueType(match[1]))
        return cls(ValueType(match[1]), tuple(_dimension(part, text) for part in match[2].split(",")))

    @property
    def names(self) -> tuple[str, ...]:
        """The constants this shape depends on."""
        return tuple(dim for dim in self.dims if isinstance(dim, str))

    def resolve(self, constants: Mapping[str, int]) -> "Shape":
        """The same shape with every name replaced by its number; raises KeyError for a missing constant."""
        dims = tuple(dim if isinstance(dim, int) else int(constants[dim]) for dim in self.dims)
        if any(dim < 1 for dim in dims):
            raise ValueError(Reason.of("words.dimensions_positive", shape=str(self), constants=str(dict(constants))))
        return Shape(self.type, dims)

    @property
    def count(self) -> int:
        """Number of elements of a resolved shape."""
        return math.prod(int(dim) for dim in self.dims)

    @property
    def size(self) -> int:
        """Bytes in memory of a resolved shape."""
        return self.count * self.type.size

    def __str__(self) -> str:
        return self.type.value + (f"[{','.join(map(str, self.dims))}]" if self.dims else "")


def _dimension(part: str, whole: str) -> int | str:
    if part.isdigit() and int(part) > 0:
        return int(part)
    if SVAR_NAME.match(part):
        return part
    raise ValueError(Reason.of("words.dimension", part=part, whole=whole))

"""A condition on a state variable: `LAMP == 1`, `flow0/Q_MEZ[2] > 1.5`; a grammar of its own, never code (law 8)."""

import math
import operator
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from onika.words.reason import Reason

_FORM = re.compile(
    r"""\s*(?P<address>(?:[A-Za-z][\w.-]*/){0,2}[A-Z][A-Z0-9_^]*)   # RUNTIME/SUBSYSTEM/NAME
        (?:\[(?P<index>\d+(?:\s*,\s*\d+)*)\])?
        \s*(?P<relation>==|!=|<=|>=|<|>)\s*
        (?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*\Z""",
    re.VERBOSE | re.ASCII,
)

_RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<=": operator.le,
    ">=": operator.ge,
    "<": operator.lt,
    ">": operator.gt,
}


@dataclass(frozen=True, slots=True)
class Condition:
    """A variable, a relation and a number."""

    text: str
    address: str
    """`[SUBSYSTEM/]NAME`."""
    index: tuple[int, ...]
    relation: str
    number: float

    @classmethod
    def parse(cls, text: str) -> "Condition":
        """Read one; raises ValueError that says what was expected."""
        match = _FORM.match(text)
        if not match or not math.isfinite(float(match["number"])):
            raise ValueError(Reason.of("words.condition", text=text))
        parts = match["address"].split("/")
        index = tuple(int(part) for part in match["index"].split(",")) if match["index"] else ()
        return cls(text.strip(), "/".join(parts[-2:]), index, match["relation"], float(match["number"]))

    def value_of(self, values: dict[str, Any]) -> Any:
        """The value the condition speaks of; None where there is none, a vector where no element is named."""
        value = values.get(self.address)
        for place in self.index:
            if not isinstance(value, list) or place >= len(value):
                return None
            value = value[place]
        return value

    def holds(self, values: dict[str, Any]) -> bool:
        """Whether the value stands in the relation; a missing value, a text or a vector never does."""
        value = self.value_of(values)
        return isinstance(value, int | float) and _RELATIONS[self.relation](value, self.number)

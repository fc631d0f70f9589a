"""The values of a module's ports, and where they lie in the memory that a task and its sandbox share.

Both ends have one: the task puts what its module is to see, the sandbox takes it; outputs come back the same way.
"""

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from onika.runtime.declaration import PortDeclaration
from onika.runtime.modules.binding import Binding
from onika.runtime.sandbox.sandbox_messages import PortPlace
from onika.words.reason import Reason

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Bytes = NDArray[np.uint8]


class PortCopy(NamedTuple):
    """The bytes of a port on this side, and their place in the shared memory."""

    own: "Bytes"
    place: "Bytes"


class PortCopies:
    """Of one binding; raises ValueError where the memory has no room."""

    def __init__(
        self, binding: Binding, ports: Mapping[str, PortDeclaration], places: Iterable[PortPlace], memory: "Bytes"
    ) -> None:
        self.every: list[PortCopy] = []
        self.inputs: list[PortCopy] = []
        """What is read in every cycle."""
        self.outputs: list[PortCopy] = []
        for (name, _, array), place, port in zip(binding.values, places, ports.values(), strict=True):
            end = place.offset + place.size
            if end > memory.size:
                raise ValueError(Reason.of("runtime.sandbox_small", size=memory.size, name=name))
            copy = PortCopy(array.view(np.uint8), memory[place.offset : end])
            self.every.append(copy)
            if not port.kind.is_input:
                self.outputs.append(copy)
            elif port.kind.at_cycle:
                self.inputs.append(copy)


def put(copies: list[PortCopy]) -> None:
    """Have these values where the other end sees them."""
    for own, place in copies:
        place[:] = own


def take(copies: list[PortCopy]) -> None:
    """Have these values as the other end has put them."""
    for own, place in copies:
        own[:] = place

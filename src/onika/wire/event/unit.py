"""Processing units and other processes of a runtime that come and go."""

from msgspec import Struct

from onika.words.reason import Reason


class Lost(Struct, frozen=True, tag=True):
    """A process of the runtime is gone, and why; its tasks are."""

    name: str
    cause: Reason
    at_s: float


class UnitUp(Struct, frozen=True, tag=True):
    """A processing unit is up that was added, or started anew after its loss; it is empty."""

    name: str
    at_s: float

"""The clock of a driver: the time of its runtime, in wall or in virtual time."""

from typing import Protocol


class DriverClock(Protocol):
    """What everything that looks at a driver learns of time."""

    @property
    def now(self) -> int:
        """The runtime's time in ns since its start."""
        ...

    @property
    def is_virtual(self) -> bool:
        """Whether time is virtual."""
        ...

    @property
    def turn(self) -> int:
        """In virtual time: how often everything due at the present instant has been carried out."""
        ...

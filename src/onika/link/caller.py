"""The caller of a runtime: who it is, and what it may do there."""

from dataclasses import dataclass
from enum import IntEnum


class Role(IntEnum):
    """Each may do what those before it may."""

    VIEWER = 1
    """Looks, and stops."""
    OPERATOR = 2
    """Runs what the runtime knows."""
    PROGRAMMER = 3
    """Brings code."""
    OWNER = 4
    """Ends the runtime, and opens it to others or closes it."""

    @property
    def word(self) -> str:
        """As it is written in a file of users."""
        return self.name.lower()


@dataclass(frozen=True, slots=True)
class Caller:
    """A user, his role and the address he calls from; near: from this machine."""

    user: str
    role: Role
    address: str
    is_near: bool


PARENT = Caller("owner", Role.OWNER, "parent", True)
"""The program that launched the runtime."""

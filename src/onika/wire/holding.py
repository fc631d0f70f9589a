"""What is asked about who may change a subsystem: take, hand over, only watch (law 27, requirement X12)."""

from msgspec import Struct

COMPANY = "@company"
"""Attended to, alone or with `*`, it brings the event Company whenever somebody comes or goes."""


class Hand(Struct, frozen=True, tag=True):
    """Offer a subsystem that one holds to another session, which takes it or not; replied by Done or Refused.

    What is ON stays ON meanwhile and afterwards. With nobody named the offer is withdrawn.
    """

    subsystem: str
    to: str = ""
    """The name of a session, or of a user who has only one."""


class Decline(Struct, frozen=True, tag=True):
    """Say no to what was offered; a yes is `live.Take`."""

    subsystem: str


class OnlyWatch(Struct, frozen=True, tag=True):
    """From now on this session changes nothing any more, as long as it lasts; it may still stop everything."""


class Sessions(Struct, frozen=True, tag=True):
    """Ask who is there; replied by Company."""


HoldingRequest = Hand | Decline | OnlyWatch | Sessions


class SessionStanding(Struct, frozen=True):
    """A session of a runtime."""

    name: str
    role: str
    is_here: bool = True
    """Whether it is heard at present."""
    only_watches: bool = False
    lease_s: float = 0.0
    """For how long it may be silent before it holds nothing any more; 0: for ever."""


class Company(Struct, frozen=True, tag=True):
    """Who is there, and by which name the runtime knows the one who asks."""

    you: str
    sessions: tuple[SessionStanding, ...]

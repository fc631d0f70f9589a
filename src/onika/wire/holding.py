"""What is asked about who may change a subsystem, and who may come in at all (law 27, requirements X12, A16)."""

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


class Listen(Struct, frozen=True, tag=True):
    """Open the runtime to others at `place`, `HOST:PORT`; replied by Listening. Files are those of its machine."""

    place: str
    role: str = "viewer"
    """Of whoever comes with the token that is made for it: on this machine only, until it is closed."""
    certificate: str = ""
    key: str = ""
    users: str = ""
    names: tuple[str, ...] = ()


class StopListening(Struct, frozen=True, tag=True):
    """Let nobody in any more; those who are inside are told good-bye, and count as lost."""


HoldingRequest = Hand | Decline | OnlyWatch | Sessions | Listen | StopListening


class SessionStanding(Struct, frozen=True):
    """A session of a runtime."""

    name: str
    role: str
    is_here: bool = True
    """Whether it is heard at present."""
    only_watches: bool = False
    lease_s: float = 0.0
    """For how long it may be silent before it holds nothing any more; 0: for ever."""


class Listening(Struct, frozen=True, tag=True):
    """Where others reach the runtime from now on."""

    addresses: tuple[str, ...]
    token_at: str = ""
    """The file with the token of this machine's user, who is its owner; empty: it does not count there."""
    token: str = ""
    """One more, that is told here and never again; empty: only users with names are let in."""
    role: str = ""
    """Of whoever comes with it."""


class Company(Struct, frozen=True, tag=True):
    """Who is there, and by which name the runtime knows the one who asks."""

    you: str
    sessions: tuple[SessionStanding, ...]

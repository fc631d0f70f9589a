"""What a rendezvous orders: of who begins at the agreed time by himself, and of who walks through the flows."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Appoint:
    """Be ready to begin at this time of the own clock; only with a permit, and never late. It says what came of it."""

    attempt: int
    at_ns: int


@dataclass(frozen=True, slots=True)
class Permit:
    """It may begin."""

    attempt: int


@dataclass(frozen=True, slots=True)
class Revoke:
    """It is not to begin. It may have done so already, and says so."""

    attempt: int


@dataclass(frozen=True, slots=True)
class Confirm:
    """All have begun: what began is not to be held."""

    attempt: int


@dataclass(frozen=True, slots=True)
class HoldNow:
    """What began is to be held at once: somebody says that he has not begun."""

    attempt: int


@dataclass(frozen=True, slots=True)
class AllMet:
    """All have begun, or have been there: the flows may go on. `is_free`: nothing was agreed, they begin at once."""

    is_free: bool = False


@dataclass(frozen=True, slots=True)
class Alone:
    """The flows have begun and are held, for these runtimes were not heard to have begun."""

    absent: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class MeetAgain:
    """What was cleared waits at the tag once more."""


@dataclass(frozen=True, slots=True)
class RepeatStep:
    """What was cleared repeats its step at once: all had begun."""


RendezvousOrder = Appoint | Permit | Revoke | Confirm | HoldNow | AllMet | Alone | MeetAgain | RepeatStep

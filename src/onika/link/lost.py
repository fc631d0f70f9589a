"""LinkLost, the exception raised when the other program cannot be reached any more, with its cause."""

from enum import Enum

from onika.wire.packet import VERSION
from onika.words.reason import NOTHING, Reason


class LossCause(Enum):
    """What ended a connection."""

    CLOSED = "closed"
    """The other side closed it, or is gone."""
    SILENT = "silent"
    """Nothing was heard for too long."""
    VERSION = "version"
    """The two speak different versions of the link."""
    GARBAGE = "garbage"
    """What came was no packet, or one that has no place here."""
    BEHIND = "behind"
    """The reader fell so far behind that its buffer was full."""
    HERE = "here"
    """This side closed it."""
    REFUSED = "refused"
    """The runtime does not take this connection: too many sessions, or another user's."""
    UNREACHABLE = "unreachable"
    """Nobody answers at that address."""
    TIMEOUT = "timeout"
    """Somebody is there, but the connection did not come about in time."""
    CERTIFICATE = "certificate"
    """The other side's certificate is not one to trust."""
    TOKEN = "token"  # noqa: S105 - a word, not a secret
    """The token is wrong or missing."""
    FORBIDDEN = "forbidden"
    """The role, the address or the name under which it was called is not allowed."""
    OVER = "over"
    """What was reached was there for this connection only, and is no more."""


_FINAL = (LossCause.VERSION, LossCause.CERTIFICATE, LossCause.TOKEN, LossCause.FORBIDDEN, LossCause.OVER)


class LinkLost(Exception):
    """The connection is no more; `cause` says which kind, `reason` says it to people."""

    def __init__(self, cause: LossCause, reason: Reason) -> None:
        self.cause = cause
        self.reason = reason
        super().__init__(reason)

    @property
    def is_final(self) -> bool:
        """Whether trying again as it stands mends nothing."""
        return self.cause in _FINAL


def closed(why: Reason = NOTHING) -> LinkLost:
    """The other side closed the connection or ceased to be."""
    return LinkLost(LossCause.CLOSED, Reason.of("link.closed", why=_because(why)))


def silent(seconds: float) -> LinkLost:
    """The other side said nothing for so long."""
    return LinkLost(LossCause.SILENT, Reason.of("link.silent", seconds=seconds))


def version(mine: int, theirs: int) -> LinkLost:
    """The other side speaks another version."""
    return LinkLost(LossCause.VERSION, Reason.of("link.version", mine=mine, theirs=theirs))


def garbage(detail: Reason) -> LinkLost:
    """The other side sent something that is no packet, or none that has its place there."""
    return LinkLost(LossCause.GARBAGE, Reason.of("link.garbage", detail=detail))


def link_lost(cause: str, why: Reason) -> LinkLost:
    """What the other side's good-bye says."""
    if cause == "closed":
        return closed(why)
    if cause == "version":
        return LinkLost(LossCause.VERSION, Reason.of("link.version_there", mine=VERSION, why=_because(why)))
    return LinkLost(LossCause(cause), Reason.of("link.ended_there", why=_because(why)))


def behind(detail: Reason) -> LinkLost:
    """A reader was too slow."""
    return LinkLost(LossCause.BEHIND, Reason.of("link.behind", detail=detail))


def here(why: Reason = NOTHING) -> LinkLost:
    """This side closed the connection itself."""
    return LinkLost(LossCause.HERE, Reason.of("link.ended_here", why=_because(why)))


def _because(why: Reason) -> Reason:
    return Reason.of("link.because", why=why) if why else NOTHING

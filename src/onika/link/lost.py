"""LinkLost, the exception raised when the other program cannot be reached any more, with its cause."""

from enum import Enum


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


class LinkLost(Exception):
    """The connection is no more; `cause` says which kind, the text says it in words."""

    def __init__(self, cause: LossCause, text: str) -> None:
        super().__init__(text)
        self.cause = cause

    @property
    def is_final(self) -> bool:
        """Whether trying again as it stands mends nothing."""
        return self.cause in (LossCause.VERSION, LossCause.CERTIFICATE, LossCause.TOKEN, LossCause.FORBIDDEN)


def closed(detail: str = "") -> LinkLost:
    """The other side closed the connection or ceased to be."""
    return LinkLost(LossCause.CLOSED, "the other side closed the connection" + (f": {detail}" if detail else ""))


def silent(seconds: float) -> LinkLost:
    """The other side said nothing for so long."""
    return LinkLost(LossCause.SILENT, f"the other side has been silent for {seconds:.1f} s")


def version(mine: int, theirs: int) -> LinkLost:
    """The other side speaks another version."""
    return LinkLost(LossCause.VERSION, f"the other side speaks version {theirs} of the link, this side version {mine}")


def garbage(detail: str) -> LinkLost:
    """The other side sent something that is no packet."""
    return LinkLost(LossCause.GARBAGE, f"garbage was received: {detail}")


def link_lost(cause: str, reason: str) -> LinkLost:
    """What the other side's good-bye says."""
    if cause == "closed":
        return closed(reason)
    return LinkLost(LossCause(cause), f"the other side ended the connection: {reason}")


def behind(detail: str) -> LinkLost:
    """A reader was too slow."""
    return LinkLost(LossCause.BEHIND, f"the reader fell too far behind: {detail}")


def here(detail: str = "closed") -> LinkLost:
    """This side closed the connection itself."""
    return LinkLost(LossCause.HERE, f"this side ended the connection: {detail}")

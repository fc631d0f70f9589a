"""LinkLost: there is no talking to the other program any more, and why."""

from enum import Enum


class Cause(Enum):
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


class LinkLost(Exception):
    """The connection is no more; `cause` says which kind, the text says it in words."""

    def __init__(self, cause: Cause, text: str) -> None:
        super().__init__(text)
        self.cause = cause


def closed(detail: str = "") -> LinkLost:
    """The other side closed the connection or ceased to be."""
    return LinkLost(Cause.CLOSED, "the other side closed the connection" + (f": {detail}" if detail else ""))


def silent(seconds: float) -> LinkLost:
    """The other side said nothing for so long."""
    return LinkLost(Cause.SILENT, f"the other side has been silent for {seconds:.1f} s")


def version(mine: int, theirs: int) -> LinkLost:
    """The other side speaks another version."""
    return LinkLost(Cause.VERSION, f"the other side speaks version {theirs} of the link, this side version {mine}")


def garbage(detail: str) -> LinkLost:
    """The other side sent something that is no packet."""
    return LinkLost(Cause.GARBAGE, f"garbage was received: {detail}")


def behind(detail: str) -> LinkLost:
    """A reader was too slow."""
    return LinkLost(Cause.BEHIND, f"the reader fell too far behind: {detail}")


def here(detail: str = "closed") -> LinkLost:
    """This side closed the connection itself."""
    return LinkLost(Cause.HERE, f"this side ended the connection: {detail}")

"""What a user does to an open document: new, open, save, close, undo; `doc` is its id."""

from typing import Literal

from onika.wire.act.act import Act


class New(Act, frozen=True):
    """Open a blank configuration."""


class Open(Act, frozen=True):
    """Open a configuration, by its file or by its name on the search path, beside the others (reading 15)."""

    path: str


class OpenInPlace(Act, frozen=True):
    """Open a configuration in place of one, which reconfigures what lives there (C15); told before it happens."""

    doc: str
    path: str
    confirmed: bool = False


class Peek(Act, frozen=True):
    """Ask what is in a configuration or an application, by its file, to draw it in small; `view.PeekView`."""

    path: str


class Close(Act, frozen=True):
    """Close a document; one that is not saved is refused unless `discards`, one whose tasks are ON is asked about.

    alive   what becomes of tasks that live: they end with it where none is ON; else `end` or `leave` says it
    """

    doc: str
    discards: bool = False
    alive: Literal["ask", "end", "leave"] = "ask"


class Save(Act, frozen=True):
    """Save a document where it was opened, or under a name (in a base directory, else its own)."""

    doc: str
    name: str = ""
    base: str = ""
    overwrites: bool = False


class Reload(Act, frozen=True):
    """Take over what stands in the file now; what was changed here can be had back by Undo."""

    doc: str


class Keep(Act, frozen=True):
    """Go on with what is here although the file has changed; the next Save overwrites it."""

    doc: str


class Undo(Act, frozen=True):
    """Take the last step back, in the running system too (law 22): of a document, or of what belongs to none (X10).

    Without a document only the latter. What was done later goes first. Replied with the name of the step.
    """

    doc: str
    confirmed: bool = False


class Redo(Act, frozen=True):
    """Do the step again that was taken back last; replied with its name."""

    doc: str
    confirmed: bool = False

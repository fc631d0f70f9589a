"""What a user does to libraries and to their tasks."""

from typing import Literal

from onika.wire.act.act import Act, Names


class OpenLibrary(Act, frozen=True):
    """Add a base directory to the libraries that are open."""

    path: str


class CloseLibrary(Act, frozen=True):
    """Close a library; what is placed stays."""

    library: str


class Alias(Act, frozen=True):
    """Give the state variable behind a coded name; an empty one means the coded name (C04, C23)."""

    task: str
    pin: str
    svar: str
    doc: str = ""
    """Where it was done: the configuration of a placed task, whose it is then and whose Undo takes it back."""


class LibraryRate(Act, frozen=True):
    """A task's rate in Hz for later placements of this session (reading 10)."""

    task: str
    hz: float


class Local(Act, frozen=True):
    """The LOCAL lines of a task, each a key and its words."""

    task: str
    lines: tuple[tuple[str, Names], ...]
    doc: str = ""


class SaveTask(Act, frozen=True):
    """Write what was changed of a task to its `.rmod`."""

    task: str
    overwrites: bool = False
    doc: str = ""
    """The configuration whose lines of its own are meant."""


class ForgetTask(Act, frozen=True):
    """Take a task as its file says again."""

    task: str
    doc: str = ""


class ReadText(Act, frozen=True):
    """Ask for the text of a task's `.rmod`, of its module's code or of its test; replied by `view.TextView`."""

    task: str
    kind: Literal["rmod", "code", "test"]


class WriteText(Act, frozen=True):
    """Save such a text where the file is still what was read (`stamp`), and tell its faults."""

    task: str
    kind: Literal["rmod", "code", "test"]
    text: str
    stamp: str
    overwrites: bool = False


class NewModule(Act, frozen=True):
    """Write a new module with its `.rmod` and its test from a template (C31); replied with the name of the task."""

    name: str
    base: str = ""
    """Empty: the user's own base directory."""


class LoadModule(Act, frozen=True):
    """Have the runtime load a task's module as its file is now; replied by `view.LoadedView`."""

    task: str


class ArrangeTask(Act, frozen=True):
    """Put a task before another of its library (D24)."""

    task: str
    before: str = ""
    """Empty: behind all of them."""

"""Messages between a page and the environment: acts one way; snapshot, patches, answers and frames the other."""

from typing import Any, Literal

import msgspec
from msgspec import Struct

from onika.wire.act import AnyAct
from onika.wire.view import AnyShow, Remedy, Tree
from onika.words.reason import Reason

Path = tuple[str, ...]
Change = tuple[Path, Any]
"""A place in the tree and what stands there now; None: nothing any more."""


class Ordered(Struct, frozen=True, forbid_unknown_fields=True):
    """An act with the number by which it is answered."""

    cid: int
    act: AnyAct


class Message(Struct, frozen=True, tag_field="t", tag=True, omit_defaults=True):
    """What the environment sends."""


class Snapshot(Message, frozen=True):
    """Everything, at a revision; first of all, and whenever a browser was too slow for patches."""

    rev: int
    tree: Tree
    version: str
    you: str
    """The name of this browser."""
    user: str = ""
    """Who has signed in there; empty: whoever sits at this machine."""
    role: str = ""
    """What he may do: `viewer`, `operator`, `programmer` or `owner`; empty: everything."""


class Patch(Message, frozen=True):
    """What has changed from one revision to the next, and who did it."""

    rev: int
    changes: tuple[Change, ...]
    by: str = ""


class Ok(Message, frozen=True):
    """An act is done, or accepted where its outcome is a fact that comes later."""

    cid: int
    rev: int
    value: Any = None


class Refused(Message, frozen=True):
    """An act changed nothing, and why."""

    cid: int
    reason: Reason
    remedies: tuple[Remedy, ...] = ()
    fields: dict[str, Reason] = {}
    """Of forms: what is wrong with each field."""


class Frame(Message, frozen=True):
    """The newest values of what this browser watches; late ones are dropped."""

    at_s: float
    """The runtime's own time, as in events."""
    values: dict[str, Any] = {}
    """By `DOC/NAME`, of a running application by `@SUBSYSTEM/NAME`."""
    figures: dict[str, dict[str, Any]] = {}
    """Of tasks by `DOC/TASK` or `@SUBSYSTEM/TASK`, columns by their names in §A.5."""
    poses: dict[str, Any] = {}
    """By world: `rows`, for each body its place x y z in m and its quaternion w x y z; `lit`, what shines.

    By camera, as `WORLD:CAMERA`: its newest picture, `file`, JPEG or PNG in base64, `number` and `at_s`.
    """


class Say(Message, frozen=True):
    """A line of the log, or a word beside something; `where` it is about, with its document."""

    level: Literal["info", "warning", "error", "success", "end"]
    text: Reason
    doc: str = ""
    where: AnyShow | None = None
    at_s: float = 0.0
    """Seconds since 1970, when it was said."""
    is_quiet: bool = False
    """Whether it goes into the log alone."""
    remedies: tuple[Remedy, ...] = ()
    """What can be done instead; while there is something, it stays on the screen."""


AnyMessage = Snapshot | Patch | Ok | Refused | Frame | Say


class Numbered(Struct, frozen=True):
    """What is left of an act that cannot be read: the number by which it is answered."""

    cid: int = 0


_NUMBERED = msgspec.json.Decoder(Numbered)
_ORDERED = msgspec.json.Decoder(Ordered)
_ENCODER = msgspec.json.Encoder()


def decode(text: str | bytes) -> Ordered:
    """An act as a page sends it; raises `msgspec.DecodeError` (a ValueError) for anything else."""
    try:
        return _ORDERED.decode(text)
    except RecursionError:
        raise msgspec.DecodeError("it is nested too deeply") from None


def number_of(text: str | bytes) -> int:
    """The number by which what is no act can be answered all the same; 0 where it has none."""
    try:
        return _NUMBERED.decode(text).cid
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return 0


def encode(message: AnyMessage) -> bytes:
    """A message as a page reads it."""
    return _ENCODER.encode(message)

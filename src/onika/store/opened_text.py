"""An opened file: its value and the text it was read from, which saving changes (requirements B01, B07)."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from onika.files import text, whole
from onika.store.shipped import is_shipped, not_written
from onika.words.fault import Fault, Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason

_T = TypeVar("_T")
Faults = tuple[Fault, ...]
Read = Callable[[str, str, str], tuple[_T | None, Faults]]
"""Of a text, a name and a place."""


@dataclass(frozen=True, slots=True)
class OpenedText(Generic[_T]):
    """A value, the file it was read from or saved to, and what stood there then."""

    value: _T
    path: Path
    text: str


def open_file(path: Path, name: str, read: Read[_T]) -> tuple[OpenedText[_T] | None, Faults]:
    """What `read` makes of the file; None with the faults where that is nothing."""
    content, faults = text.load(path, str(path))
    if content is None:
        return None, faults
    value, faults = read(content, name, str(path))
    return (None if value is None else OpenedText(value, path, content)), faults


def save(
    path: Path, value: _T, write: Callable[[_T, str], str], former: OpenedText[_T] | None, *, overwrites: bool
) -> OpenedText[_T] | Refusal:
    """Save a value, with the comments of `former`; gives what is opened now.

    Refused where the file is another than `former` was read from, and, without `former` or under another name, where
    there is a file already. `overwrites`: whatever stands there is replaced, and the comments of a text are kept.
    """
    expected = whole.stamp(former.text) if former and former.path == path else whole.ABSENT
    kept = former.text if former else ""
    if overwrites:
        expected, kept = whole.ANYTHING, text.load(path, str(path))[0] or kept
    return put(path, value, write(value, kept), expected)


def put(path: Path, value: _T, content: str, expected: whole.Stamp) -> OpenedText[_T] | Refusal:
    """Write the text of a value where the stamp `expected` is, and make the directory if need be.

    What comes with Onika is never written, whoever may write there: a copy of the user's own stands before it.
    """
    if is_shipped(path):
        return Refusal(not_written(path), (whole.ELSEWHERE,))
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = Reason.of("files.not_savable", path=str(path), why=system_reason(error))
        return Refusal(reason, (whole.ELSEWHERE,))
    written = whole.write(path, content, expected)
    if isinstance(written, Refusal):
        return written
    return OpenedText(value, path, content)

"""Reads the text of a file: decodes UTF-8, with faults where it is none (requirement B07)."""

import codecs
import os
import stat
from pathlib import Path

from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

LARGEST = 24 * 2**20
"""Bytes of the largest file that is read; an application of ten thousand icons has two thirds of it."""

_HOW = os.O_RDONLY | os.O_CLOEXEC | os.O_NOCTTY | os.O_NONBLOCK


def load(path: Path, file: str) -> tuple[str | None, tuple[Fault, ...]]:
    """The text at a path, line ends as they are; None with the fault where it cannot be read. `file` names it.

    Never waits: a pipe or device is a fault.
    """
    data, faults = load_bytes(path, file)
    return (None, faults) if data is None else decode(data, file)


def load_bytes(path: Path, file: str) -> tuple[bytes | None, tuple[Fault, ...]]:
    """What a file holds, whatever it is; None with the fault where it cannot be read."""
    try:
        return _data(path), ()
    except OSError as error:
        reason = system_reason(error)
        return None, (
            Fault(Place(file), Reason.of("files.unreadable", reason=reason), Reason.of("words.file_left_out")),
        )
    except ValueError as wrong:
        return None, (
            Fault(
                Place(file), Reason.of("files.unreadable_why", why=reason_of(wrong)), Reason.of("words.file_left_out")
            ),
        )


def decode(data: bytes, file: str) -> tuple[str | None, tuple[Fault, ...]]:
    """These bytes as text; None with a fault that names the line of the first byte that is no UTF-8."""
    try:
        return data.decode("utf-8"), ()
    except UnicodeDecodeError as error:
        place = Place(file, data.count(b"\n", 0, error.start) + 1)
        return None, (
            Fault(
                place, Reason.of("files.not_utf8", byte=f"0x{data[error.start]:02x}"), Reason.of("words.file_left_out")
            ),
        )


def decode_foreign(content: bytes, file: str) -> tuple[str, tuple[Fault, ...]]:
    """The text of a file of another system, with a fault where it is none: what is no letter is replaced.

    Other systems mark its encoding at its beginning, or part its lines by \\r alone.
    """
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return _in_lines(content.decode("utf-16", "replace")), ()
    content = content.removeprefix(codecs.BOM_UTF8)
    text, torn = decode(content, file)
    return _in_lines(content.decode("utf-8", "replace") if text is None else text), torn


def _in_lines(text: str) -> str:
    return text if "\n" in text else text.replace("\r", "\n")


def _data(path: Path) -> bytes:
    """Raises ValueError for what is no plain file, or too large; looked at before it is opened, as devices mind."""
    _size(os.stat(path))  # noqa: PTH116 - the same on a descriptor
    descriptor = os.open(path, _HOW)
    try:
        left = _size(os.fstat(descriptor)) + 1
        parts = []
        while left > 0 and (part := os.read(descriptor, left)):
            parts.append(part)
            left -= len(part)
        return b"".join(parts)
    finally:
        os.close(descriptor)


def _size(status: os.stat_result) -> int:
    if not stat.S_ISREG(status.st_mode):
        raise ValueError(_kind(status.st_mode))
    if status.st_size > LARGEST:
        raise ValueError(Reason.of("files.too_large", size=status.st_size, most=LARGEST))
    return status.st_size


def _kind(mode: int) -> Reason:
    """What it is that is no plain file."""
    match stat.S_IFMT(mode):
        case stat.S_IFDIR:
            return Reason.of("files.a_directory")
        case stat.S_IFIFO:
            return Reason.of("files.a_pipe")
        case stat.S_IFSOCK:
            return Reason.of("files.a_socket")
    return Reason.of("files.a_device")

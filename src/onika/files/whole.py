"""Saving a file whole or not at all: whoever reads it sees the old text or the new one (requirement B07).

A stamp tells one content of a file from another. Who saves says by stamp what he has read; where something else
stands there now, nothing is written. Savings of one directory wait for each other, so between two programs of ours no
change is lost. Any other program may still write in the moment between the look at the file and its exchange.
"""

import fcntl
import os
import pwd
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

from onika.files import text as texts
from onika.words.fault import Fault, Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason

Stamp = str
"""What a file holds: the SHA-256 of its bytes."""

ABSENT: Stamp = ""
"""The stamp of a file that is not there."""

ANYTHING: Stamp = "*"
"""In place of a stamp: whatever stands there is overwritten, as the user has said."""

ELSEWHERE = Reason.of("files.save_elsewhere")
"""What can be done where a file cannot be written."""

_ALL_THE_SAME = Reason.of("files.save_all_the_same")
_OVERWRITE = Reason.of("files.overwrite")
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC | os.O_NOFOLLOW


def stamp(text: str) -> Stamp:
    """The stamp of a file that holds `text`."""
    return sha256(text.encode("utf-8")).hexdigest()


def read(path: Path) -> tuple[tuple[str, Stamp] | None, tuple[Fault, ...]]:
    """The text at `path` with its stamp; None with the fault where it cannot be read."""
    content, faults = texts.load(path, str(path))
    return (None if content is None else (content, stamp(content))), faults


def write(path: Path, text: str, expected: Stamp) -> Stamp | Refusal:
    """Put `text` in UTF-8 in place of the content with the stamp `expected`; gives the new stamp.

    Refused where something else stands there, and where the system refuses: then the old file is as it was and nothing
    is left behind. Once it returns, the file outlasts a loss of power. A link is followed; mode and, as far as may be,
    owner are kept. A process killed meanwhile leaves at most one hidden file `.NAME.saving`, which the next saving
    removes. Raises ValueError for text that UTF-8 cannot hold.
    """
    data = text.encode("utf-8")
    try:
        target = path.resolve(strict=False)
        with _directory(target.parent) as folder:
            refusal = _differs(path, target.name, folder, expected)
            if refusal is None:
                _exchange(target.name, data, folder)
    except OSError as error:
        return Refusal(Reason.of("files.not_savable", path=str(path), why=system_reason(error)), (ELSEWHERE,))
    except RuntimeError:  # Python 3.11 and 3.12 say so of links that lead to themselves
        return Refusal(Reason.of("files.is_linked_to_itself", path=str(path)), (ELSEWHERE,))
    return refusal or sha256(data).hexdigest()


@contextmanager
def _directory(path: Path) -> Iterator[int]:
    """The directory, for this process alone as far as our programs go; where a network's disk has no locks, without."""
    folder = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        with suppress(OSError):
            fcntl.flock(folder, fcntl.LOCK_EX)
        yield folder
    finally:
        os.close(folder)


def _differs(path: Path, name: str, folder: int, expected: Stamp) -> Refusal | None:
    """Why the file may not be replaced, if so."""
    try:
        status = os.stat(name, dir_fd=folder)
    except FileNotFoundError:
        if expected in (ABSENT, ANYTHING):
            return None
        return Refusal(Reason.of("files.removed_since", path=str(path)), (_ALL_THE_SAME, ELSEWHERE))
    if not stat.S_ISREG(status.st_mode):
        return Refusal(Reason.of("files.not_plain", path=str(path)), (ELSEWHERE,))
    if not os.access(name, os.W_OK, dir_fd=folder, effective_ids=True):
        return Refusal(Reason.of("files.not_writable", path=str(path)), (ELSEWHERE,))
    if expected == ANYTHING:
        return None
    if expected == ABSENT:
        return Refusal(Reason.of("files.is_there", path=str(path), who=_who(status)), (ELSEWHERE, _OVERWRITE))
    if _stamp_at(name, folder) == expected:
        return None
    reason = Reason.of("files.changed_since", path=str(path), who=_who(status))
    return Refusal(reason, (Reason.of("files.read_again"), _OVERWRITE))


def _stamp_at(name: str, folder: int) -> Stamp:
    with os.fdopen(os.open(name, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK, dir_fd=folder), "rb") as file:
        return sha256(file.read()).hexdigest()


def _who(status: os.stat_result) -> Reason:
    """Whose file it is and when it was written."""
    try:
        owner = pwd.getpwuid(status.st_uid).pw_name
    except KeyError:
        owner = str(status.st_uid)
    moment = datetime.fromtimestamp(status.st_mtime, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")
    return Reason.of("files.written_by", moment=moment, owner=owner)


def _exchange(name: str, data: bytes, folder: int) -> None:
    """The new file, whole and on the disk, in place of the old one; raises OSError, and then all is as before."""
    fresh = f".{name}.saving"
    try:
        with suppress(FileNotFoundError):
            os.unlink(fresh, dir_fd=folder)
        _write_new(fresh, data, _former(name, folder), folder)
        os.rename(fresh, name, src_dir_fd=folder, dst_dir_fd=folder)
    except BaseException:
        with suppress(OSError):
            os.unlink(fresh, dir_fd=folder)
        raise
    os.fsync(folder)  # the new name lasts only once the directory is on the disk


def _former(name: str, folder: int) -> os.stat_result | None:
    try:
        return os.stat(name, dir_fd=folder)
    except FileNotFoundError:
        return None


def _write_new(name: str, data: bytes, former: os.stat_result | None, folder: int) -> None:
    descriptor = os.open(name, _NEW, 0o666, dir_fd=folder)
    with os.fdopen(descriptor, "wb") as file:
        if former is not None:
            with suppress(OSError):  # only an administrator, or a member of the group, gives files away
                os.fchown(descriptor, former.st_uid, former.st_gid)
            os.fchmod(descriptor, stat.S_IMODE(former.st_mode))
        file.write(data)
        file.flush()
        os.fsync(descriptor)

"""What others may do with files of ours: rights too many are taken back, or nothing begins (requirement X12).

Whoever else may write what Onika keeps could let himself in, or change what was noted; whoever may read it has the
token.
"""

import os
import pwd
import stat
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from onika.words.reason import Reason
from onika.words.system_error import system_reason

WRITING = 0o022
"""The rights of all others to write."""
ANYTHING = 0o077
"""All rights of all others."""
STRANGERS = 0o027
"""The rights of all others but that of the group to read, as keys of certificates have it."""
_NAMED = 4
_ROOT = 0


@dataclass(frozen=True, slots=True)
class Access:
    """A file or folder, and the rights that others may not have; it need not be there."""

    path: Path
    denied: int


@dataclass(frozen=True, slots=True)
class AccessReport:
    """What was mended, and why nothing should begin; both empty where all is as it should be."""

    mended: tuple[Path, ...] = ()
    refused: tuple[Reason, ...] = ()

    @property
    def sentences(self) -> tuple[Reason, ...]:
        """All there is to say."""
        if not self.mended:
            return self.refused
        paths = tuple(str(path) for path in self.mended[:_NAMED])
        more = len(self.mended) - len(paths)
        key = "files.access_mended_more" if more else "files.access_mended"
        about = {"more": more} if more else {}
        return (Reason.of(key, paths=paths, **about), *self.refused)


def guard(wanted: Iterable[Access], user: int | None = None) -> AccessReport:
    """Look at each, and take back what others may not do; `user` is the number of our own user.

    What can be looked at by nobody is left to whoever opens it. A link is looked through.
    """
    mended: list[Path] = []
    refused: list[Reason] = []
    ours = os.geteuid() if user is None else user
    for access in wanted:
        try:
            status = access.path.stat()
        except OSError:
            continue
        if not stat.S_ISREG(status.st_mode) and not stat.S_ISDIR(status.st_mode):
            continue
        if status.st_uid not in (ours, _ROOT):
            refused.append(Reason.of("files.access_of_another", path=str(access.path), owner=_owner(status)))
        elif status.st_mode & access.denied:
            wrong = _mend(access, status.st_mode)
            if wrong is None:
                mended.append(access.path)
            else:
                refused.append(wrong)
    return AccessReport(tuple(mended), tuple(refused))


def _mend(access: Access, mode: int) -> Reason | None:
    """Why it cannot be mended; None: it is."""
    path, rights = str(access.path), f"{access.denied:03o}"
    try:
        access.path.chmod(stat.S_IMODE(mode) & ~access.denied)
        if not access.path.stat().st_mode & access.denied:
            return None
    except OSError as wrong:
        return Reason.of("files.access_open", path=path, rights=rights, why=system_reason(wrong))
    return Reason.of("files.access_open", path=path, rights=rights, why=Reason.of("files.access_not_kept"))


def _owner(status: os.stat_result) -> str:
    try:
        return pwd.getpwuid(status.st_uid).pw_name
    except KeyError:
        return str(status.st_uid)

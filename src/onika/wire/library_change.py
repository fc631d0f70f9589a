"""What is sent to a site that keeps a library: changed files, and what the site answers (requirement F03)."""

from msgspec import Struct

from onika.words.reason import Reason


class ChangedFile(Struct, frozen=True):
    """One file as it is to be.

    path    in the library, as `module/pd.rmod`
    base    the SHA-256, in hexadecimal, of what it was when the change was begun; empty: it was not there
    """

    path: str
    base: str
    content: bytes


class LibraryChange(Struct, frozen=True):
    """Changed files of a library: all of them become so, or none.

    note    what was changed, in the words of whoever did it; it stands in the audit trail of the site
    """

    library: str
    files: tuple[ChangedFile, ...]
    note: str = ""


class ChangeTaken(Struct, frozen=True, tag_field="onika", tag="taken"):
    """It is so now, and published anew."""

    library: str
    version: int


class PresentFile(Struct, frozen=True):
    """What a file of the site is now; None: it is not there."""

    path: str
    content: bytes | None


class ChangedMeanwhile(Struct, frozen=True, tag_field="onika", tag="changed_meanwhile"):
    """Nothing was written: these files are no more what the change was begun with."""

    files: tuple[PresentFile, ...]


class ChangeRefused(Struct, frozen=True, tag_field="onika", tag="change_refused"):
    """Nothing was written."""

    reason: Reason


ChangeAnswer = ChangeTaken | ChangedMeanwhile | ChangeRefused

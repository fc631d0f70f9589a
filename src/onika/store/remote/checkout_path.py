"""Where libraries of others stand as files: below the cache, in a folder of their lock and one of their name."""

import re
from hashlib import sha256
from pathlib import Path

_FOLDER = "libraries"
_LETTERS = 16
_CHECKED_OUT = re.compile(rf"/onika/{_FOLDER}/[0-9a-f]{{{_LETTERS}}}/[^/]+(?:/|\Z)")


def checkout_path(cache: Path, base: Path, library: str) -> Path:
    """The folder of a library that is locked in a base directory."""
    of_lock = sha256(str(base.absolute()).encode()).hexdigest()[:_LETTERS]
    return cache / _FOLDER / of_lock / library


def is_checked_out(path: Path) -> bool:
    """Whether a file or directory is of a library of others."""
    return checked_out_folder(path) is not None


def checked_out_folder(path: Path) -> Path | None:
    """The folder of the library of others that a file is of; None where it is of none."""
    match = _CHECKED_OUT.search(path.as_posix())
    return None if match is None else Path(path.as_posix()[: match.end()])

"""What is read and never written: the laboratories and files that come with Onika, and libraries of others."""

from importlib import resources
from pathlib import Path

from onika.store.remote.checkout_path import is_checked_out
from onika.words.reason import Reason

FOLDERS = ("module", "conf", "dict", "appl")
"""Of a base directory."""


def is_shipped(path: Path) -> bool:
    """Whether a file or directory comes with Onika or from a library of others, or leads to one that does.

    Either is read and never written: a copy of the user's own stands before it.
    """
    try:
        whole = path.resolve()
        return whole.is_relative_to(shipped().resolve()) or is_checked_out(whole)
    except (OSError, RuntimeError):  # no access, or links that lead to themselves
        return False


def not_written(path: Path) -> Reason:
    """Why a file or directory of which `is_shipped` is true is not written."""
    if is_checked_out(path):
        return Reason.of("store.library_stays", path=str(path))
    return Reason.of("store.shipped_stays", path=str(path))


def shipped() -> Path:
    """The directory of the laboratories that come with Onika; its `prefs` are the installation's."""
    return Path(str(resources.files("onika") / "labs"))


def shipped_directories() -> tuple[Path, ...]:
    """The base directories of the shipped laboratories, by name."""
    labs = shipped()
    if not labs.is_dir():
        return ()
    return tuple(sorted(path for path in labs.iterdir() if any((path / folder).is_dir() for folder in FOLDERS)))

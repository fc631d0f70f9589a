"""What comes with Onika: its laboratories, and the installation's own files. It is read and never written."""

from importlib import resources
from pathlib import Path

FOLDERS = ("module", "conf", "dict", "appl")
"""Of a base directory."""


def is_shipped(path: Path) -> bool:
    """Whether a file or directory comes with Onika, or leads to one that does."""
    try:
        return path.resolve().is_relative_to(shipped().resolve())
    except (OSError, RuntimeError):  # no access, or links that lead to themselves
        return False


def shipped() -> Path:
    """The directory of the laboratories that come with Onika; its `prefs` are the installation's."""
    return Path(str(resources.files("onika") / "labs"))


def shipped_directories() -> tuple[Path, ...]:
    """The base directories of the shipped laboratories, by name."""
    labs = shipped()
    if not labs.is_dir():
        return ()
    return tuple(sorted(path for path in labs.iterdir() if any((path / folder).is_dir() for folder in FOLDERS)))

"""A path as a user writes it: `~` is his home, and what no file system allows is said before anything is tried.

Where a program was started means nothing to whoever types into its page, so a relative path begins elsewhere.
"""

from pathlib import Path

from onika.words.reason import Reason

_LONGEST, _LONGEST_NAME = 4000, 255
"""Bytes of a path, and of each name in it, on the systems that Onika runs on."""


def user_path(text: str, start: Path | None) -> Path | Reason:
    """The absolute path, or why there can be none; a relative one begins at `start`, a user's own base directory.

    Where the user has none, it begins in the current directory.
    """
    if "\0" in text:
        return Reason.of("store.path_null")
    if len(text.encode()) > _LONGEST or any(len(name.encode()) > _LONGEST_NAME for name in text.split("/")):
        return Reason.of("store.path_long", most=_LONGEST, longest=_LONGEST_NAME)
    try:
        path = Path(text).expanduser()
    except RuntimeError:
        return Reason.of("store.path_home", path=text)
    return (path if start is None else start / path).absolute()

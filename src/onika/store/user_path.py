"""A path as a user writes it: `~` is his home, and what no file system allows is said before anything is tried."""

from pathlib import Path

from onika.words.reason import Reason

_LONGEST, _LONGEST_NAME = 4000, 255
"""Bytes of a path, and of each name in it, on the systems that Onika runs on."""


def user_path(text: str) -> Path | Reason:
    """The absolute path, or why there can be none."""
    if "\0" in text:
        return Reason.of("store.path_null")
    if len(text.encode()) > _LONGEST or any(len(name.encode()) > _LONGEST_NAME for name in text.split("/")):
        return Reason.of("store.path_long", most=_LONGEST, longest=_LONGEST_NAME)
    try:
        return Path(text).expanduser().absolute()
    except RuntimeError:
        return Reason.of("store.path_home", path=text)

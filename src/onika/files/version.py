"""File versions: which are read, and under which a text is written (requirements B06, B09)."""

import re

VERSION = "1.3"
"""The version of the thesis, written wherever it can say what is to be said."""

EXTENDED = "2.0"
"""The version with lines of our own, of applications, icons and configurations; written only where one is needed."""

_FORM = re.compile(r"[0-9]{1,9}(?:\.[0-9]{1,9})*\Z")


def is_version(text: str) -> bool:
    """Whether a text is numbers with points between them."""
    return _FORM.match(text) is not None


def is_older(text: str) -> bool:
    """Whether a version comes before that of the thesis, so that lines may be lacking."""
    return _parts(text) < _parts(VERSION)


def is_extended(text: str) -> bool:
    """Whether a version is the one with lines of our own."""
    return _parts(text) == _parts(EXTENDED)


def is_known(text: str, *, extended: bool) -> bool:
    """Whether files of a version can be read; `extended`: the format has lines of our own."""
    return _parts(text) <= _parts(VERSION) or (extended and is_extended(text))


def _parts(version: str) -> tuple[int, ...]:
    """Its numbers without closing zeros: 1.3.0 is 1.3."""
    parts = [int(part) for part in version.split(".")]
    while parts and parts[-1] == 0:
        parts.pop()
    return tuple(parts)

"""A piece of a file on a server: a long file comes in pieces over several connections, in fewer round trips (F03).

What a server may send at first over a new connection is about ten packets; it doubles with every round trip. So six
connections carry six times as much at once.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

FIRST = 8_000
"""Bytes that come at once over a new connection: the tickets of TLS and the head of the answer take some packets."""

_RANGE = re.compile(r"bytes ([0-9]{1,12})-([0-9]{1,12})/([0-9]{1,12})\Z")


@dataclass(frozen=True, slots=True)
class Span:
    """Bytes `begin` to `end`, which is not among them."""

    begin: int
    end: int

    @property
    def header(self) -> str:
        """How a request asks for it."""
        return f"bytes={self.begin}-{self.end - 1}"


@dataclass(frozen=True, slots=True)
class Piece:
    """Some bytes of a file, or all of them where the server knows no pieces."""

    content: bytes
    size: int
    """Bytes of the whole file."""
    mark: str
    """What the server calls what the file holds now: pieces of one mark are of one file."""

    @property
    def is_whole(self) -> bool:
        """Whether there is no other piece."""
        return len(self.content) == self.size


def size_of_whole(span: Span, header: str) -> int | None:
    """The bytes of the whole file as an answer names them; None where it is not the answer to what was asked."""
    found = _RANGE.match(header)
    if found is None:
        return None
    begin, last, size = map(int, found.groups())
    if (begin, last + 1) != (span.begin, min(span.end, size)):
        return None
    return size


def shares(size: int, begin: int, count: int) -> Sequence[Span]:
    """The bytes from `begin` on in spans of nearly one length, at most `count` of them."""
    length = -(-(size - begin) // count)
    return [Span(at, min(at + length, size)) for at in range(begin, size, max(length, 1))]


def joined(pieces: Sequence[Piece]) -> bytes | None:
    """The file of all its pieces, in their order; None where they are not of one file."""
    content = b"".join(piece.content for piece in pieces)
    first = pieces[0]
    is_one = all((piece.size, piece.mark) == (first.size, first.mark) for piece in pieces)
    if not is_one or len(content) != first.size:
        return None
    return content

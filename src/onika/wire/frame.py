"""A frame: one payload on a byte stream, behind its length as four bytes, most significant first."""

import struct

from onika.words.reason import NOTHING, Reason, reason_of

FRAME_LIMIT = 1 << 20
"""Longest payload in bytes that a reader accepts unless told otherwise."""

_LENGTH = struct.Struct(">I")


def frame(payload: bytes, limit: int = FRAME_LIMIT) -> bytes:
    """Put the length before the payload (1..limit bytes); raises ValueError when it is empty or too long."""
    _check(len(payload), limit)
    return _LENGTH.pack(len(payload)) + payload


class FrameReader:
    """Cuts a stream of bytes, in whatever pieces they come, into payloads; after a fault it stays faulty."""

    def __init__(self, limit: int = FRAME_LIMIT) -> None:
        self._limit = limit
        self._rest = bytearray()
        self._fault = NOTHING

    @property
    def is_between_frames(self) -> bool:
        """Whether every byte so far belongs to a whole frame."""
        return not self._rest

    def feed(self, data: bytes) -> list[bytes]:
        """Take bytes, give the payloads that are now whole; raises ValueError at an impossible length.

        Payloads that came before the impossible length in the same call are lost with it: the connection is to be cut.
        """
        if self._fault:
            raise ValueError(self._fault)
        self._rest += data
        payloads: list[bytes] = []
        at = 0
        while len(self._rest) - at >= _LENGTH.size:
            (length,) = _LENGTH.unpack_from(self._rest, at)
            self._check(length)
            end = at + _LENGTH.size + length
            if end > len(self._rest):
                break
            payloads.append(bytes(self._rest[at + _LENGTH.size : end]))
            at = end
        del self._rest[:at]
        return payloads

    def _check(self, length: int) -> None:
        try:
            _check(length, self._limit)
        except ValueError as fault:
            self._fault = reason_of(fault)
            self._rest.clear()
            raise


def _check(length: int, limit: int) -> None:
    if not 1 <= length <= limit:
        raise ValueError(Reason.of("link.frame_limit", limit=limit, length=length))

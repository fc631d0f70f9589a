"""Readings of a runtime at a bounded rate: the newest value under a key, dropped when late."""

from typing import Any

import msgspec
from msgspec import Struct


class Variable(Struct, frozen=True, tag=True):
    """A state variable under the key `SUBSYSTEM/NAME`."""

    now_ns: int
    """The runtime's time when it was read."""
    count: int
    """How often it was written."""
    value: Any


class Poses(Struct, frozen=True, tag=True):
    """The bodies of a world under the key `world:NAME`."""

    at_ns: int
    """The world's time."""
    rows: bytes
    """Little-endian float32: x y z (m) and quaternion w x y z for each body, in the order of the scene."""
    lit: tuple[str, ...] = ()
    """The names of the shapes that shine, such as a lamp."""


class CameraPicture(Struct, frozen=True, tag=True):
    """What a camera sees, under the key `world:WORLD:CAMERA`."""

    at_ns: int
    """The world's time when it was taken."""
    number: int
    """How many there were since somebody wanted any."""
    file: bytes
    """JPEG or PNG."""


Reading = Variable | Poses | CameraPicture

encode = msgspec.msgpack.Encoder().encode
decode = msgspec.msgpack.Decoder(Reading).decode

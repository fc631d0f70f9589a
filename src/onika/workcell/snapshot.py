"""A snapshot: one instant of a world, enough to draw it elsewhere without the world's code."""

import msgspec


class WorldSnapshot(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The document of everything that is seen, where it is then, and the world's time."""

    mjcf: str
    time_s: float


def encode(snapshot: WorldSnapshot) -> bytes:
    """As msgpack."""
    return msgspec.msgpack.encode(snapshot)


def decode(data: bytes) -> WorldSnapshot:
    """From msgpack; raises ValueError that says what is wrong with the bytes."""
    return msgspec.msgpack.decode(data, type=WorldSnapshot)

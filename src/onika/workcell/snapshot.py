"""A snapshot: one instant of a world, enough to draw it elsewhere without the world's code."""

import msgspec


class WorldSnapshot(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The drawn world's document, the positions of all its joints, its time and whether the lamp is lit."""

    mjcf: str
    qpos: tuple[float, ...]
    time_s: float
    lit: bool


def encode(snapshot: WorldSnapshot) -> bytes:
    """As msgpack."""
    return msgspec.msgpack.encode(snapshot)


def decode(data: bytes) -> WorldSnapshot:
    """From msgpack; raises ValueError that says what is wrong with the bytes."""
    return msgspec.msgpack.decode(data, type=WorldSnapshot)

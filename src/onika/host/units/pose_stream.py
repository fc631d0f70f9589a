"""Tells where the bodies of a world are, thirty times a second, to everybody who asked: the runner, a recording."""

from time import monotonic_ns

from msgspec import Struct, msgpack

from onika.host.processes.process_socket import ProcessSocket

_EVERY_NS = 33_000_000
_MOST_WAITING = 100
"""Datagrams that may wait for one who does not come to take them; more are counted and thrown away."""


class WorldPoses(Struct, frozen=True, tag=True):
    """Where the bodies of a world are."""

    world: str
    at_ns: int
    rows: bytes
    lit: tuple[str, ...]
    told_ns: int = 0
    """When it was told, by the machine's clock: a world may lie behind."""
    left_out: int = 0
    """Datagrams before this one for which there was no room."""


_encode = msgpack.Encoder().encode


class PoseStream:
    """Of one world."""

    def __init__(self, world: str) -> None:
        self._world = world
        self._due = 0
        self._left_out: dict[ProcessSocket, int] = {}

    def add(self, post: ProcessSocket) -> None:
        """From now on tell this one too."""
        self._left_out.setdefault(post, 0)

    def is_due(self, now: int) -> bool:
        """Whether somebody is to be told now."""
        return bool(self._left_out) and now >= self._due

    def tell(self, now: int, at_ns: int, rows: bytes, lit: tuple[str, ...]) -> None:
        """Tell everybody who is still there; never wait for one."""
        self._due = now + _EVERY_NS
        for post, left_out in list(self._left_out.items()):
            post.flush()
            if post.waiting >= _MOST_WAITING:
                self._left_out[post] += 1
                continue
            post.send(_encode(WorldPoses(self._world, at_ns, rows, lit, monotonic_ns(), left_out)))
            self._left_out[post] = 0
            if post.is_closed:
                post.close()
                del self._left_out[post]

    def close(self) -> None:
        """Tell nobody any more."""
        for post in self._left_out:
            post.close()
        self._left_out.clear()

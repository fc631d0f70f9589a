"""The files of worlds that came with plans, as a runtime keeps them and hands them to its processes (decision 49)."""

from collections.abc import Iterable

from msgspec import msgpack

from onika.ring.segment import Segment
from onika.wire.world_source import WorldSource


class WorldSources:
    """The newest files of each world, by its name; a copy of a world is made of the files of that one."""

    def __init__(self) -> None:
        self._files: dict[str, WorldSource] = {}

    def take(self, worlds: Iterable[WorldSource]) -> tuple[WorldSource, ...]:
        """Keep these; gives those that say something new."""
        new = tuple(files for files in worlds if self.digest(files.world) != files.digest)
        self._files |= {files.world: files for files in new}
        return new

    def find(self, world: str) -> WorldSource | None:
        """The files of a world; None where none came."""
        return self._files.get(world.partition("@")[0])

    def digest(self, world: str) -> str:
        """What names its files; empty where none came."""
        files = self.find(world)
        return "" if files is None else files.digest


def packed(files: WorldSource) -> Segment:
    """These files in memory that another process can be handed; raises SharedMemoryRefused."""
    content = msgpack.encode(files)
    segment = Segment.create(f"files-{files.world}", len(content))
    segment.view[:] = content
    return segment


def unpacked(descriptor: int) -> WorldSource:
    """The files that another process has handed over."""
    segment = Segment.attach(descriptor)
    try:
        return msgpack.decode(bytes(segment.view), type=WorldSource)
    finally:
        segment.close()

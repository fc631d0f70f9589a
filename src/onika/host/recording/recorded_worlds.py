"""The worlds of a runtime as they are recorded: what they consist of once, then where everything is (law 29)."""

from collections.abc import Callable, Mapping
from typing import Protocol

from onika.host.recording.recording_place import RecordingWriter
from onika.host.recording.recording_sink import AddScene
from onika.host.units.driver_clock import DriverClock
from onika.host.units.pose_stream import WorldPoses
from onika.host.units.world_views import WorldViews

_POSED_EVERY_NS = 33_000_000


class RecordedDriver(DriverClock, Protocol):
    """The driver, as far as it is recorded."""

    options: tuple[str, ...]
    """What the runtime was started with beside, which changes what happens."""

    @property
    def with_fifo(self) -> bool:
        """Whether processes ask for real-time scheduling."""
        ...

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds that are open."""
        ...

    @property
    def views(self) -> WorldViews:
        """What whoever looks sees of them."""
        ...

    def each_instant(self, look: Callable[[], None]) -> None:
        """In virtual time: call this one too at the end of every instant."""
        ...

    def leave_instants(self, look: Callable[[], None]) -> None:
        """Call it no more."""
        ...


class RecordedWorlds:
    """Of one recording."""

    def __init__(self, seen: RecordedDriver) -> None:
        self._seen = seen
        self._shown: dict[str, int] = {}

    def show(self, writer: RecordingWriter, now: int) -> None:
        """What has come since the last time; `now` counts from the recording's begin, in ns."""
        for world in self._seen.worlds:
            self._show(writer, world, now)

    # Inner

    def _show(self, writer: RecordingWriter, world: str, now: int) -> None:
        if world not in self._shown:
            scene = self._seen.views.scene(world)
            if scene is None:
                return
            writer.take(AddScene(world, _shapes(scene)))
            self._shown[world] = now
            if writer.inlet is not None:
                self._seen.views.pose_to(world, writer.inlet)
        if writer.inlet is None and now >= self._shown[world]:
            self._shown[world] = now + _POSED_EVERY_NS
            poses = self._seen.views.poses(world)
            if poses is not None:
                writer.take(WorldPoses(world, now, poses[1], poses[2]))


def _shapes(scene: Mapping[str, object]) -> tuple[dict[str, object], ...]:
    shapes = scene.get("shapes")
    if isinstance(shapes, list | tuple):
        return tuple(shapes)
    return ()

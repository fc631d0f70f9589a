"""What whoever looks sees of the worlds of a driver."""

from collections.abc import Collection
from typing import Protocol

from onika.runtime.bus import Poses
from onika.runtime.picture import SmallPicture


class WorldViews(Protocol):
    """Scenes, poses and pictures; to look changes nothing in a world."""

    def scene(self, world: str) -> dict[str, object] | None:
        """What an open world consists of; None where it cannot be known now."""
        ...

    def poses(self, world: str) -> Poses | None:
        """The newest poses of an open world, their time and what shines; see `bus.Poses`."""
        ...

    def picture(self, device: str) -> SmallPicture | None:
        """The newest picture of the camera `world:device`; from now on somebody looks at it."""
        ...

    def look_only_at(self, cameras: Collection[str]) -> None:
        """Nobody looks at any other camera any more."""
        ...

    def pose_to(self, world: str, inlet: int) -> None:
        """Have whoever steps an open world say its poses at this socket, where that is another process."""
        ...

"""Pictures of cameras on the device bus: a ring each, behind the states, filled only while somebody uses it.

A ring has room for four pictures, so that whoever reads one is never in the way of the next (decision 50).
"""

from collections.abc import Callable, Sequence
from math import prod
from typing import TYPE_CHECKING, Any, Protocol, cast

import numpy as np

from onika.ring.device import DeviceSheet
from onika.ring.slots import Ring

if TYPE_CHECKING:
    from numpy.typing import NDArray

SmallPicture = tuple[int, int, bytes]
"""A picture for whoever looks: its number, the world's time in ns when it was taken, JPEG or PNG."""

COLOURS = 3
"""Bytes of a pixel: red, green, blue."""
_NUMBER = 2
"""Where the number of the newest picture stands in the state of a camera."""


class CameraWorld(Protocol):
    """What a world with cameras has besides."""

    def look(self, device: str, is_wanted: bool) -> None:
        """From now on somebody wants the pictures of this camera, or nobody any more."""
        ...

    def show(self, device: str, is_shown: bool) -> None:
        """From now on somebody looks at its pictures, or nobody any more."""
        ...

    def take_small(self) -> dict[str, SmallPicture]:
        """The newest pictures at which somebody looks, since the last call."""
        ...

    def picture(self, device: str) -> Any:
        """The newest picture, uint8[H,W,3]; the same array always."""
        ...

    def state(self, device: str) -> Any:
        """The doubles that the camera publishes."""
        ...


class Pictures:
    """The cameras of one world: their rings from `start` on in the memory of its bus."""

    def __init__(self, view: memoryview, world: object, sheets: Sequence[DeviceSheet], start: int) -> None:
        self._view, self._world = view, cast(CameraWorld, world)
        self._sheets = {sheet.name: sheet for sheet in sheets if sheet.picture}
        self._offsets: dict[str, int] = {}
        for name, sheet in self._sheets.items():
            self._offsets[name] = start
            start += Ring.footprint(picture_size(sheet.picture))
        self._users: dict[str, int] = {}
        self._shown: set[str] = set()
        self._publishers: dict[str, Callable[[], None]] = {}

    def use(self, device: str) -> int:
        """One more user; where the ring lies. Of what is no camera nothing happens."""
        if device not in self._sheets:
            return 0
        self._users[device] = self._users.get(device, 0) + 1
        if device not in self._publishers:
            self._world.look(device, True)
            self._publishers[device] = self._publisher(device)
        return self._offsets[device]

    def leave(self, device: str) -> None:
        """One user less; with the last one nothing is seen any more."""
        if device not in self._publishers:
            return
        self._users[device] -= 1
        if not self._users[device]:
            del self._publishers[device]
            self._world.look(device, False)

    @property
    def cameras(self) -> list[dict[str, Any]]:
        """Each with its name, the width and height of its pictures, and how many it takes in a second."""
        return [
            {"name": name, "width": sheet.picture[1], "height": sheet.picture[0], "rate": sheet.identity["RATE"][0]}
            for name, sheet in self._sheets.items()
        ]

    def show(self, device: str, is_shown: bool) -> None:
        """Somebody looks at the pictures of a camera from now on, or nobody any more."""
        self._world.show(device, is_shown)
        if is_shown:
            self._shown.add(device)
        else:
            self._shown.discard(device)

    def take_small(self) -> dict[str, SmallPicture]:
        """The newest pictures at which somebody looks, since the last call."""
        return self._world.take_small() if self._shown else {}

    def publish(self) -> None:
        """Every picture that has come since the last call."""
        for publish in self._publishers.values():
            publish()

    def _publisher(self, device: str) -> Callable[[], None]:
        state, picture = self._world.state(device), self._world.picture(device)
        write = Ring(self._view, self._offsets[device], picture.nbytes).writer(picture.data.cast("B"))
        published = 0.0

        def publish() -> None:
            nonlocal published
            number = state[_NUMBER]
            if number != published:
                published = number
                write()

        return publish


class PictureReader:
    """A task's end of a camera's ring."""

    def __init__(self, ring: Ring, size: tuple[int, ...]) -> None:
        self._pixels: NDArray[np.uint8] = np.zeros((*size, COLOURS), dtype=np.uint8)
        self._fetch = ring.refresher(self._pixels.data.cast("B"))
        self._shown = self._pixels.view()
        self._shown.flags.writeable = False

    def read(self) -> "NDArray[np.uint8]":
        """The newest picture; the same array each time."""
        self._fetch()
        return self._shown


def picture_size(size: tuple[int, ...]) -> int:
    """Bytes of a picture of this height and width."""
    return prod(size) * COLOURS

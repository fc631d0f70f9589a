"""A device on a bench: publishes what a test says and keeps the last command (law 16)."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from onika.ring.device import DeviceSheet
from onika.ring.slots import Ring
from onika.runtime import command

SEGMENT = "bus:bench"
"""The name of the memory that stands for the bus."""


class BenchDevice:
    """A device that says what it is told: write `state`, look at `commands`.

    `state` and `command` are the names of its values (time and drive state excepted), `identity` what it says of
    itself. It publishes before each cycle, with the bench's time. `picture` is the height and width of the pictures of
    a camera: write into `pixels`, uint8[H,W,3].
    """

    def __init__(
        self,
        state: Iterable[str],
        command: Iterable[str] = (),
        identity: Mapping[str, Any] | None = None,
        picture: tuple[int, ...] = (),
    ) -> None:
        self.sheet = DeviceSheet("bench", ("time", "drive", *state), tuple(command), dict(identity or {}), picture)
        self.pixels = np.zeros((*picture, 3), np.uint8)
        self.values = np.zeros(len(self.sheet.state))
        self._bytes = Ring.footprint(8 * len(self.sheet.state))
        self._heard = np.zeros(2 + len(self.sheet.command))
        self._picture_at = self._bytes + Ring.footprint(8 * self._heard.size)
        view = memoryview(bytearray(self._picture_at + Ring.footprint(self.pixels.nbytes)))
        self.view = view
        self._state = Ring(view, 0, 8 * self.values.size)
        self._command = Ring(view, self._bytes, 8 * self._heard.size)
        self._picture = Ring(view, self._picture_at, self.pixels.nbytes)

    @property
    def state(self) -> Any:
        """The values it will publish, an array to write into."""
        return self.values[2:]

    @property
    def epoch(self) -> int:
        """Whose the last command was."""
        return int(self._last()[0])

    @property
    def order(self) -> int:
        """The last command's order: 0 hold, 1 drive, 2 clear."""
        return int(self._last()[1])

    @property
    def commands(self) -> Any:
        """The values of the last command."""
        return self._last()[2:].copy()

    def publish(self, now_ns: int) -> None:
        """Publish `state` with this time."""
        self.values[0] = now_ns * 1e-9
        if self.sheet.picture:
            self._picture.write(self.pixels.data)
        self._state.write(self.values.data)

    def grant(self) -> command.DeviceGrant:
        """The grant with which a task is spawned."""
        sheet = self.sheet
        at = self._bytes if sheet.command else None

        identity = dict(sheet.identity)
        picture = sheet.picture, self._picture_at if sheet.picture else 0
        return command.DeviceGrant(SEGMENT, sheet.name, sheet.state, sheet.command, identity, 1, 0, at, *picture)

    def _last(self) -> Any:
        self._command.reader(self._heard.data.cast("B"))()
        return self._heard

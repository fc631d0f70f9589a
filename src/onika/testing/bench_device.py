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
    itself. It publishes before each cycle, with the bench's time.
    """

    def __init__(
        self, state: Iterable[str], command: Iterable[str] = (), identity: Mapping[str, Any] | None = None
    ) -> None:
        self.sheet = DeviceSheet("bench", ("time", "drive", *state), tuple(command), dict(identity or {}))
        self.values = np.zeros(len(self.sheet.state))
        self._bytes = Ring.footprint(8 * len(self.sheet.state))
        self._heard = np.zeros(2 + len(self.sheet.command))
        view = memoryview(bytearray(self._bytes + Ring.footprint(8 * self._heard.size)))
        self.view = view
        self._state = Ring(view, 0, 8 * self.values.size)
        self._command = Ring(view, self._bytes, 8 * self._heard.size)

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
        self._state.write(self.values.data)

    def grant(self) -> command.DeviceGrant:
        """The grant with which a task is spawned."""
        sheet = self.sheet
        at = self._bytes if sheet.command else None

        identity = dict(sheet.identity)
        return command.DeviceGrant(SEGMENT, sheet.name, sheet.state, sheet.command, identity, 1, 0, at)

    def _last(self) -> Any:
        self._command.reader(self._heard.data.cast("B"))()
        return self._heard

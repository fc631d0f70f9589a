"""A device of a world from within: its sheet, its drive, its claim and the doubles it publishes.

Units stay the same when the world is compiled anew; `bind` gives them the arrays of the new plant.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from onika.laws.frames import Array
from onika.ring.device import DeviceSheet
from onika.ring.drive import DriveUnit
from onika.workcell.plant import Plant


class DeviceUnit:
    """What all devices have; a device does what is said here unless it says otherwise.

    `side` is the arm it belongs to ("" for none), `holds` says that holding needs a servo at each step.
    """

    def __init__(self, sheet: DeviceSheet, side: str = "", holds: bool = False) -> None:
        self.sheet, self.side, self.holds = sheet, side, holds
        self.drive = DriveUnit()
        self.count = len(sheet.command)
        self.epoch: int | None = None  # who claims it
        self.follows: int | None = None  # the same while it is driven: whom it follows
        self.state: Array = np.zeros(len(sheet.state))
        self.state[1] = self.drive.shown
        self.row = row_of(self.state)

    def bind(self, plant: Plant) -> None:
        """Take the arrays of a new plant."""
        raise NotImplementedError

    def follow(self, values: Sequence[float] | Array) -> bool:
        """Follow these values from the next step on; False, and nothing of them done then, if any is not finite."""
        raise NotImplementedError

    def capture(self) -> None:
        """Hold what is there now; by itself a device keeps its last signals."""

    def hold(self) -> None:
        """Write the signals of holding for one step."""

    def sense(self) -> None:
        """Publish what touch sensors feel, every 10 ms, after `Plant.sense`."""

    def restart(self) -> None:
        """Go to the posture of start, at rest."""

    def refresh(self, time: float) -> None:
        """Publish: write `state` anew, at `time` seconds."""
        self.row[0] = time


def row_of(array: Array) -> Any:
    """A memoryview on the doubles of an array: short rows copy three times as fast through it as through arrays."""
    return memoryview(array)  # type: ignore[arg-type]

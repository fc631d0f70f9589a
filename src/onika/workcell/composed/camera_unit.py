"""A camera as a device: it publishes how many pictures it has taken and how old the newest is (requirement F05).

What it says of itself: W and H, width and height in pixels; RATE, pictures in a second; FOCAL, its focal length in
pixels.
"""

import numpy as np
import numpy.typing as npt

from onika.model.camera import CameraBlock
from onika.ring.device import DeviceSheet, DriveState
from onika.ring.drive import NEVER_NS
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit

STATE = ("time", "drive", "number", "age")


class CameraUnit(DeviceUnit):
    """A camera, which takes no commands; `eye` is what it is called in the document of the world.

    It takes its pictures at multiples of its period, while somebody wants them.
    """

    def __init__(self, name: str, camera: CameraBlock, eye: str, focal: float, place: str = "") -> None:
        width, height = camera.size
        identity = {"W": (float(width),), "H": (float(height),), "RATE": (camera.rate,), "FOCAL": (focal,)}
        super().__init__(DeviceSheet(name, STATE, (), identity, (height, width)), place)
        self.eye = eye
        self.source = camera.device
        """Of a real camera what is opened; empty: it is rendered."""
        self.pixels: npt.NDArray[np.uint8] = np.zeros((height, width, 3), dtype=np.uint8)
        self.state[1] = DriveState.DRIVEN
        self.due_ns = NEVER_NS
        self.period_ns = round(1e9 / camera.rate)
        self._taken_ns = 0

    def bind(self, plant: Plant) -> None:
        """It has nothing of the plant's."""

    def refresh(self, time: float) -> None:
        """The time, and the age of the newest picture; 0 before the first."""
        self.state[0] = time
        self.state[3] = time - self._taken_ns * 1e-9 if self.state[2] else 0.0

    def schedule(self, now_ns: int) -> None:
        """The next picture is due at the next multiple of the period."""
        self.due_ns = (now_ns // self.period_ns + 1) * self.period_ns

    def rest(self) -> None:
        """Nobody wants pictures; whoever does next begins with the first."""
        self.due_ns = NEVER_NS
        self.state[2:] = 0.0

    def take(self, pixels: npt.NDArray[np.uint8], taken_ns: int, now_ns: int) -> None:
        """A picture of the instant `taken_ns` has come."""
        np.copyto(self.pixels, pixels)
        self._taken_ns = taken_ns
        self.state[2] += 1
        self.refresh(now_ns * 1e-9)

    @property
    def is_dark(self) -> bool:
        """Whether it can take no pictures."""
        return bool(self.state[1] == DriveState.TRIPPED)

    def darken(self) -> None:
        """It can take no pictures."""
        self.state[1] = DriveState.TRIPPED
        self.rest()

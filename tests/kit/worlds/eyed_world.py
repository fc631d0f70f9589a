"""The world of masses with a camera, whose picture is what its number says."""

import numpy as np

from kit.worlds.mass_world import MassWorld
from onika.ring.device import DeviceSheet

_SHEET = DeviceSheet("eye", ("time", "drive", "number", "age"), (), {"RATE": (10.0,)}, (2, 3))


class EyedWorld(MassWorld):
    """Takes a picture with each step; `shown` says whether somebody looks, `used` whether a task does."""

    def __init__(self) -> None:
        super().__init__()
        self.shown = self.used = False
        self._eye = np.zeros(4)
        self._pixels = np.zeros((2, 3, 3), np.uint8)

    def devices(self) -> tuple[DeviceSheet, ...]:
        """The masses, the scale, the camera."""
        return (*super().devices(), _SHEET)

    def state(self, device: str) -> np.ndarray:
        """Of the camera: the number of its pictures."""
        return self._eye if device == "eye" else super().state(device)

    def picture(self, _device: str) -> np.ndarray:
        """The newest picture."""
        return self._pixels

    def look(self, _device: str, is_wanted: bool) -> None:
        """A task wants pictures, or none does."""
        self.used = is_wanted

    def show(self, _device: str, is_shown: bool) -> None:
        """Somebody looks, or nobody does."""
        self.shown = is_shown

    def take_small(self) -> dict[str, tuple[int, int, bytes]]:
        """The picture, where somebody looks."""
        return {"eye": (int(self._eye[2]), self.now_ns, b"file")} if self.shown else {}

    def release(self, device: str, epoch: int) -> None:
        """Nothing of a camera."""
        if device != "eye":
            super().release(device, epoch)

    def step(self, until_ns: int) -> None:
        """As any, with one more picture."""
        super().step(until_ns)
        self._eye[2] += 1
        self._pixels[:] = int(self._eye[2])

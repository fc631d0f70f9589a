"""A task's end of a device: newest state in, commands out, over the same rings as the state variables (law 16)."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from onika.ring.device import DeviceOrder, DeviceSheet, DriveState
from onika.ring.slots import Ring
from onika.runtime.picture import PictureReader
from onika.words.reason import Reason

if TYPE_CHECKING:
    from numpy.typing import NDArray

_DRIVE = float(DeviceOrder.DRIVE)
_DRIVEN, _TRIPPED, _PRESSED = (
    int(state) for state in (DriveState.DRIVEN, DriveState.TRIPPED, DriveState.PRESSED)
)  # plain numbers compare quicker than names
_HEADER = 2  # world time and drive state before the values; writer's epoch and order before a command's values
_HEARD_AFTER = 2  # publications: the first may have been under way when the command was written
SILENCE_NS = 60_000_000
"""A device that publishes nothing for so long is taken for dead (law 17: it holds by itself after 50 ms)."""


class Device:
    """Latest-value access to one device; `write` and `hold` command it, where the task claimed it."""

    def __init__(
        self, sheet: DeviceSheet, epoch: int, state: Ring, command: Ring | None, picture: Ring | None = None
    ) -> None:
        self.sheet = sheet
        self._picture = None if picture is None else PictureReader(picture, sheet.picture)
        self._state = np.zeros(len(sheet.state))
        self._words = state.words
        self._flat = self._state.data
        self._fetch: Callable[[], int] = state.reader(self._state.data.cast("B"))
        self._order = np.zeros(_HEADER + len(sheet.command))
        self._order[0] = epoch
        self._numbers: Any = self._order.data
        self._wanted = self._order[_HEADER:]
        self._send = None if command is None else command.writer(self._order.data.cast("B"))
        self._values = self._state[_HEADER:]
        self._values.flags.writeable = False
        self._seen = -1
        self._fresh_at_ns = 0
        self._holding = False
        self._clears_until = 0

    @classmethod
    def absent(cls) -> "Device":
        """Stands where a task names no device; every use says so."""
        return _Absent()

    @property
    def identity(self) -> Mapping[str, tuple[float, ...] | str]:
        """What the device says of itself."""
        return self.sheet.identity

    @property
    def is_held(self) -> bool:
        """Whether the drive held (or had tripped) at the last `read`."""
        return bool(self._flat[1] != _DRIVEN)

    @property
    def is_tripped(self) -> bool:
        """Whether the drive had tripped at the last `read`; `clear` brings it back to hold.

        Right after a `clear` it is taken for cleared, until the device had the time to say otherwise.
        """
        return bool(self._flat[1] == _TRIPPED) and not self._still_clears()

    @property
    def is_pressed(self) -> bool:
        """Whether its panic button was pressed at the last `read`; no `clear` helps before it is let go."""
        return bool(self._flat[1] == _PRESSED)

    def read(self) -> "NDArray[np.float64]":
        """The newest values, in the order of `sheet.state` without time and drive state; the same array each time."""
        self._fetch()
        return self._values

    def newest(self) -> "tuple[int, NDArray[np.float64]]":
        """How often the device has published, and all that it says: time and drive state, then the values."""
        self._fetch()
        return self._words[0], self._state

    def picture(self) -> "NDArray[np.uint8]":
        """The newest picture of a camera, uint8[H,W,3] as red, green, blue from the top left; the same array each time.

        Zeros before the first one. Raises ValueError for a device that is no camera.
        """
        if self._picture is None:
            raise ValueError(Reason.of("runtime.takes_no_pictures", name=self.sheet.name))
        return self._picture.read()

    def write(self, values: Sequence[float]) -> None:
        """Command these values, in the order of `sheet.command`, from the world's next step on.

        While the task still waits for fresh inputs (law 4) a hold is sent instead. Raises ValueError for NaN or
        infinity: they never reach an actuator.
        """
        if self._send is None:
            raise ValueError(Reason.of("runtime.takes_no_commands", name=self.sheet.name))
        if self._holding or self._still_clears():
            self.hold()
            return
        self._wanted[:] = values
        if not math.isfinite(sum(self._numbers)):  # a sum of finite torques is finite
            self.hold()
            raise ValueError(Reason.of("runtime.commands_not_finite", name=self.sheet.name, values=str(list(values))))
        self._numbers[1] = _DRIVE
        self._send()

    def hold(self) -> None:
        """Command the drive to hold by itself; harmless for a device that takes no commands."""
        self._fetch()
        is_tripped = self._flat[1] == _TRIPPED
        self._plain(DeviceOrder.CLEAR if self._still_clears() and is_tripped else DeviceOrder.HOLD)

    def clear(self) -> None:
        """Bring a tripped drive back to hold. Whatever is commanded next waits until the device has heard of it."""
        self._clears_until = self._words[0] + _HEARD_AFTER
        self.hold()

    # For the running task

    def holding(self, is_holding: bool) -> None:
        """Turn every command into a hold, or no longer."""
        self._holding = is_holding

    def silent_ns(self, now_ns: int) -> int:
        """How long the device has published nothing new, as far as calls of this function could see."""
        count = self._words[0]
        if count != self._seen:
            self._seen, self._fresh_at_ns = count, now_ns
        return now_ns - self._fresh_at_ns

    def listen_from(self, now_ns: int) -> None:
        """Count silence from now."""
        self._fresh_at_ns = now_ns

    def _still_clears(self) -> bool:
        """Only the newest command reaches a device: a clear stays the newest one until it has been heard."""
        return bool(self._words[0] < self._clears_until)

    def _plain(self, order: DeviceOrder) -> None:
        if self._send is not None:
            self._order[1] = order
            self._order[_HEADER:] = 0.0
            self._send()


class _Absent(Device):
    """No device: says what is missing."""

    def __init__(self) -> None:
        pass

    def __getattribute__(self, name: str) -> Any:
        if name.startswith("__"):
            return super().__getattribute__(name)
        raise AttributeError(Reason.of("runtime.names_no_device"))

"""The words of the device bus: what a device of a world declares, receives as orders and reports."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum

from onika.words.reason import NOTHING, Reason


class DeviceOrder(IntEnum):
    """What a command asks of a device's drive."""

    HOLD = 0
    DRIVE = 1
    CLEAR = 2


class DriveState(IntEnum):
    """The state of a device's drive; the number stands in `state[1]` of every device."""

    DRIVEN = 0
    HELD = 1
    TRIPPED = 2
    PRESSED = 3
    """Its panic button is pressed: it holds, and cannot be cleared before the button is let go."""


@dataclass(frozen=True, slots=True)
class DeviceSheet:
    """A device by name: the doubles it publishes, the doubles a command carries and who it is.

    `state[0]` is always the world's time in seconds and `state[1]` the state of the drive. `command` is empty for a
    device that only publishes. `picture` is the height and width of what a camera sees, in pixels, and empty for all
    others; `state[2]` of a camera counts its pictures.
    """

    name: str
    state: tuple[str, ...]
    command: tuple[str, ...]
    identity: Mapping[str, tuple[float, ...] | str]
    picture: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class DriveEvent:
    """One change of a drive's state, in world time: when, at which step before, after which last command, why.

    `last_command_ns` is -1 where no command came since the claim. Where an arm begins to hold, its world may say where
    it stands, and what it presses against.
    """

    device: str
    state: int
    at_ns: int
    previous_step_ns: int
    last_command_ns: int
    cause: Reason
    stands: Reason = NOTHING
    touches: tuple[Reason, ...] = ()


@dataclass(frozen=True, slots=True)
class MishapEvent:
    """What happens in a simulated world that no program means, such as a hand that touches a box; when in its time.

    devices to which it happens
    poses    float32[bodies,7] as bytes, as `World.poses` has them
    lit     the names of the shapes that shone then
    """

    text: Reason
    at_ns: int
    devices: tuple[str, ...]
    poses: bytes
    lit: tuple[str, ...] = ()

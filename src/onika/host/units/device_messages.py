"""What a runtime and a device server say to each other (law 16)."""

from typing import Any

from msgspec import Struct, msgpack

from onika.host.units.pose_stream import WorldPoses
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.runtime.command import DeviceGrant
from onika.words.reason import NOTHING, Reason


class OpenWorld(Struct, frozen=True, tag=True):
    """Open a world; the memory of its bus comes with this datagram, and its files where it is made of some."""

    world: str


class ClaimDevice(Struct, frozen=True, tag=True):
    """Grant `world:device` to the writer of this epoch."""

    device: str
    epoch: int


class ReleaseDevice(Struct, frozen=True, tag=True):
    """The claim ends."""

    device: str
    epoch: int


class FenceWriter(Struct, frozen=True, tag=True):
    """The writer of this epoch is dead."""

    epoch: int


class StopAll(Struct, frozen=True, tag=True):
    """Every drive in hold, latched (law 27)."""


class AllowMotion(Struct, frozen=True, tag=True):
    """After a stop: commands are heard again; nothing moves by itself."""


class TouchPart(Struct, frozen=True, tag=True):
    """A hand touches a part of a world."""

    world: str
    part: str
    value: float


class PutWorldBack(Struct, frozen=True, tag=True):
    """Everything in a world goes to where it stood at the start."""

    world: str


class TakeDisplaced(Struct, frozen=True, tag=True):
    """Ask what does not stand where it stood at the start."""


class TakeModes(Struct, frozen=True, tag=True):
    """Ask how every drive stands from within."""


class TakeSnapshots(Struct, frozen=True, tag=True):
    """Ask for the worlds as they stand."""


class DescribeWorld(Struct, frozen=True, tag=True):
    """Ask what a world consists of."""

    world: str


class StreamPoses(Struct, frozen=True, tag=True):
    """From now on tell the poses of a world, 30 times a second; to the socket that comes with this datagram, if any."""

    world: str


class ShowCamera(Struct, frozen=True, tag=True):
    """From now on tell the pictures of a camera as they come, or no more."""

    world: str
    camera: str
    is_shown: bool


class Granted(Struct, frozen=True, tag=True):
    """The answer to a Claim."""

    grant: DeviceGrant


class Denied(Struct, frozen=True, tag=True):
    """The answer to an Open, a Claim, a Touch or a PutWorldBack that cannot be."""

    reason: Reason


class WorldOpened(Struct, frozen=True, tag=True):
    """The world is there and steps; in a simulated one nothing outside the program moves."""

    world: str
    is_simulated: bool


class PartTouched(Struct, frozen=True, tag=True):
    """The answer to a Touch."""


class WorldPutBack(Struct, frozen=True, tag=True):
    """The answer to PutWorldBack: it is as at the start."""


class DisplacedTaken(Struct, frozen=True, tag=True):
    """The answer to TakeDisplaced, by world."""

    displaced: dict[str, tuple[Displacement, ...]]


class DriveChanged(Struct, frozen=True, tag=True):
    """A drive has changed its state."""

    world: str
    device: str
    state: int
    at_ns: int
    previous_step_ns: int
    last_command_ns: int
    cause: Reason
    behind_ns: int = 0
    """How far the world's time is behind the runtime's."""
    stands: Reason = NOTHING
    touches: tuple[Reason, ...] = ()


class ModesTaken(Struct, frozen=True, tag=True):
    """The answer to TakeModes, by `world:device`."""

    modes: dict[str, DriveMode]


class SnapshotsTaken(Struct, frozen=True, tag=True):
    """The answer to TakeSnapshots, with what the worlds say in sentences of how they stand."""

    snapshots: dict[str, bytes]
    standings: dict[str, tuple[Reason, ...]] = {}


class WorldDescribed(Struct, frozen=True, tag=True):
    """The answer to Show."""

    scene: dict[str, Any]


class PictureTaken(Struct, frozen=True, tag=True):
    """A picture of a camera at which somebody looks, as JPEG or PNG."""

    world: str
    camera: str
    number: int
    taken_ns: int
    file: bytes


class ServerReady(Struct, frozen=True, tag=True):
    """The process is up; what the operating system granted it."""

    granted: dict[str, bool]


Order = (
    OpenWorld
    | ClaimDevice
    | ReleaseDevice
    | FenceWriter
    | StopAll
    | AllowMotion
    | TouchPart
    | PutWorldBack
    | TakeDisplaced
    | TakeModes
    | TakeSnapshots
    | DescribeWorld
    | StreamPoses
    | ShowCamera
)
Word = (
    Granted
    | Denied
    | WorldOpened
    | PartTouched
    | WorldPutBack
    | DisplacedTaken
    | DriveChanged
    | ModesTaken
    | SnapshotsTaken
    | WorldDescribed
    | WorldPoses
    | PictureTaken
    | ServerReady
)

encode = msgpack.Encoder().encode
Question = (
    OpenWorld | ClaimDevice | TouchPart | PutWorldBack | DescribeWorld | TakeDisplaced | TakeModes | TakeSnapshots
)
"""What is answered, in the order in which it was asked."""

decode_order = msgpack.Decoder(Order).decode
decode_word = msgpack.Decoder(Word).decode

"""What happens at devices and in their worlds."""

from msgspec import Struct

from onika.words.reason import NOTHING, Reason


class Drive(Struct, frozen=True, tag=True):
    """A drive's state has changed, in the world's own time: at which step, the step before, the last command."""

    device: str
    state: str
    at_ns: int
    previous_step_ns: int
    last_command_ns: int
    cause: Reason
    at_s: float = 0.0
    """As all else: of the run that uses the device, or of the runtime where none does."""
    stands: Reason = NOTHING
    """Where the device stands that begins to hold, as far as its world knows."""
    touches: tuple[Reason, ...] = ()
    """What it presses against then, each a sentence."""


class Mishap(Struct, frozen=True, tag=True):
    """In a simulated world that is watched, something has happened that no program means (E16)."""

    world: str
    text: Reason
    devices: tuple[str, ...]
    """Those to which it happened, `world:device`."""
    at_s: float
    """When it began: of the run that uses the first of the devices, or of the runtime where none does."""
    poses: bytes
    """Where the bodies of the world were then, float32[bodies,7]."""
    lit: tuple[str, ...] = ()
    """The shapes of it that shone then."""


class Stepped(Struct, frozen=True, tag=True):
    """How far an input of a hardware task has stepped at a reconfiguration (X04); in a run only if it was too far."""

    subsystem: str
    task: str
    variable: str
    unit: str
    index: int
    """The element that stepped farthest, as a share of what it may."""
    step: float
    """From one cycle to the next, as it was wanted."""
    given: float
    """The largest step that reached the task."""
    limit: float
    """What one cycle may change it by; 0: nobody has said."""
    cycles: int
    """Over how many cycles it was blended; 0: it was not."""
    at_s: float

    @property
    def is_too_far(self) -> bool:
        """Whether it was more than one cycle may change."""
        return 0.0 < self.limit < self.step


class Outdated(Struct, frozen=True, tag=True):
    """The files of an open world say something else than what was loaded; or, if not `is_outdated`, the same again."""

    world: str
    is_outdated: bool
    text: Reason
    """Which file it is, as a sentence."""
    at_s: float


class Touched(Struct, frozen=True, tag=True):
    """A hand has touched a part of a simulated world, such as a panic button: 1 presses, 0 lets go."""

    world: str
    part: str
    value: float
    at_s: float

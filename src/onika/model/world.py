"""A world as its file says: what stands where, what moves freely, and what of it makes a device (requirement X19)."""

from dataclasses import dataclass, field

from onika.model.camera import CameraBlock
from onika.model.robot import Lines, Numbers, SensorBlock

UNNAMED = "-"
"""In place of a name: things keep the names of their file, with nothing before them."""

CONES = ("pyramidal", "elliptic")
"""Shapes of the cone of friction."""

STEP_S = 0.002
GRAVITY = 9.81

Names = tuple[tuple[str, str], ...]
"""What people call something: a language and the words in it, each language once; empty: by the name of its block."""


def _no_lines() -> Lines:
    return {}


@dataclass(frozen=True, slots=True)
class Spot:
    """Where something stands: x, y, z (m) and a turn about z (degrees), from the world's middle or from a site.

    `on` is a site of another part as `PART.SITE`.
    """

    at: Numbers = (0.0, 0.0, 0.0, 0.0)
    on: str = ""


@dataclass(frozen=True, slots=True)
class PartBlock:
    """A thing from a model's file; `free`: it moves, and where things are shaken it is up to so many metres away."""

    name: str
    file: str
    spot: Spot = Spot()
    free: float | None = None
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    names: Names = ()


@dataclass(frozen=True, slots=True)
class PlaceBlock:
    """A place where one robot stands; the first of `robots` does as long as nobody claims another one.

    is_empty  nothing stands there before one of them, or the hand, is claimed
    hand      a robot that is the hand of whichever stands there, and the site of that at which it is
    names     what people call the arm that stands there
    """

    name: str
    robots: tuple[str, ...]
    spot: Spot = Spot()
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    is_empty: bool = False
    hand: tuple[str, str] | None = None
    names: Names = ()
    hand_names: Names = ()


@dataclass(frozen=True, slots=True)
class SwitchBlock:
    """1 while all that it says holds, else 0.

    near     two sites that are at most so many metres apart
    pressed  a touch sensor that feels more than so many newtons
    above    a sensor whose number with this place, from 0, is above a bound
    touched  a hand has touched it, and not yet let it go
    """

    name: str
    near: tuple[str, str, float] | None = None
    pressed: tuple[str, float] | None = None
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    above: tuple[str, float, int] | None = None
    is_touched: bool = False

    @property
    def elements(self) -> tuple[str, ...]:
        """The sites and sensors that it names."""
        sensors = [rule[0] for rule in (self.pressed, self.above) if rule is not None]
        return (*(self.near[:2] if self.near else ()), *sensors)


@dataclass(frozen=True, slots=True)
class LampBlock:
    """A lamp that shines while all these switches are 1; `shines` are the shapes that are then lit.

    glows  shapes that nobody sees but while it shines: its light in the air, in pictures
    """

    name: str
    when: tuple[str, ...]
    shines: tuple[str, ...] = ()
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    glows: tuple[str, ...] = ()
    names: Names = ()


@dataclass(frozen=True, slots=True)
class ButtonBlock:
    """A panic button that a hand can press; it stops the robots at these places."""

    name: str
    stops: tuple[str, ...]
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)


Block = PartBlock | PlaceBlock | SwitchBlock | LampBlock | ButtonBlock | SensorBlock | CameraBlock


@dataclass(frozen=True, slots=True)
class WorldText:
    """What a `.world` file says.

    step_s    one step of its physics (s)
    gravity   acceleration of free fall (m/s2)
    contact   the cone of friction, and how much firmer friction is than contact
    floor     height of an endless floor (m); None: there is none
    """

    name: str
    description: str = ""
    step_s: float = STEP_S
    gravity: float = GRAVITY
    contact: tuple[str, float] = (CONES[0], 1.0)
    floor: float | None = None
    blocks: tuple[Block, ...] = ()
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)

    @property
    def parts(self) -> tuple[PartBlock, ...]:
        """Its things."""
        return tuple(block for block in self.blocks if isinstance(block, PartBlock))

    @property
    def places(self) -> tuple[PlaceBlock, ...]:
        """The places of its robots."""
        return tuple(block for block in self.blocks if isinstance(block, PlaceBlock))

    @property
    def switches(self) -> tuple[SwitchBlock, ...]:
        """Its switches."""
        return tuple(block for block in self.blocks if isinstance(block, SwitchBlock))

    @property
    def lamps(self) -> tuple[LampBlock, ...]:
        """Its lamps."""
        return tuple(block for block in self.blocks if isinstance(block, LampBlock))

    @property
    def sensors(self) -> tuple[SensorBlock, ...]:
        """What is measured in it."""
        return tuple(block for block in self.blocks if isinstance(block, SensorBlock))

    @property
    def buttons(self) -> tuple[ButtonBlock, ...]:
        """Its panic buttons."""
        return tuple(block for block in self.blocks if isinstance(block, ButtonBlock))

    @property
    def cameras(self) -> tuple[CameraBlock, ...]:
        """Its cameras, but for those of its robots."""
        return tuple(block for block in self.blocks if isinstance(block, CameraBlock))

    @property
    def robots(self) -> tuple[str, ...]:
        """The robots that stand, or may stand, in it, each once."""
        hands = (place.hand[0] for place in self.places if place.hand is not None)
        return tuple(dict.fromkeys((*(robot for place in self.places for robot in place.robots), *hands)))

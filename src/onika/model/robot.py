"""A robot as its file says: its model, and which joints and actuators of it make a device (requirement X19).

Names of sites, bodies, actuators and sensors are those of the model. Where a line is lacking, the model says it.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from onika.model.camera import CameraBlock

Numbers = tuple[float, ...]
Lines = Mapping[str, int]
"""Where each keyword of a block stands in its file; 0 for one that is not there."""

DRIVES = ("position", "velocity", "torque")
"""What a command to an arm, or to axes, is: joint values and speeds, speeds, or torques."""

GRIPPER_DRIVES = ("opening", "signal")
"""What a command to a gripper is: opening and force, or one signal that opens or closes it."""

AXIS_WORDS = ("x", "y", "z", "-x", "-y", "-z")
"""Directions in the frame of a tool's site or body."""


def _no_lines() -> Lines:
    return {}


@dataclass(frozen=True, slots=True)
class RobotArm:
    """A chain of joints that moves a tool.

    tool      a site or body below the last joint; `offset` from it in its frame (m)
    approach  the direction in that frame in which the tool approaches, `fingers` the one along which fingers move
    start     the body in which the chain begins; empty: the one above its first joint
    home      joint values (rad; m where one slides); empty: the keyframe `home` of the model, else zero within limits
    speed     highest joint speeds (rad/s; m/s), `torque` highest torques (N m; N); empty: as the model says
    armature  inertia of the motors (kg m2; kg), added to each joint; None: as the model says
    gains     stiffness (N m/rad; N/m) and damping (N m s/rad; N s/m) of each joint by which a drive that takes torques
              holds, and which its device tells; empty: it holds by a servo within the step of physics
    """

    name: str
    tool: str
    offset: Numbers = (0.0, 0.0, 0.0)
    approach: str = "z"
    fingers: str = "y"
    start: str = ""
    drive: str = DRIVES[0]
    home: Numbers = ()
    speed: Numbers = ()
    torque: Numbers = ()
    armature: float | None = None
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    gains: tuple[Numbers, Numbers] | None = None


@dataclass(frozen=True, slots=True)
class RobotAxes:
    """Servos that are no chain, by their actuators: fingers, legs, lifts."""

    name: str
    moves: tuple[str, ...]
    drive: str = DRIVES[0]
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class RobotGripper:
    """A gripper by its actuators, which all take one signal.

    open, closed   the signal, and how far apart the fingers then are (m)
    force          sensors whose mean is the force of a finger (N); empty: that of the actuators
    drive          what a command is: how far open and how hard, or one signal, above 0 to open and below to close
    """

    name: str
    moves: tuple[str, ...]
    open: Numbers
    closed: Numbers
    force: tuple[str, ...] = ()
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    drive: str = "opening"


@dataclass(frozen=True, slots=True)
class RobotBase:
    """A base that drives, by its actuators: on two wheels beside each other, or on two slides and a turn.

    wheels         the left and the right one, their `radius` and how far apart they stand, `track` (m)
    slides         along x, along y, and the turn about z
    speed          the highest speed (m/s) and the highest rate of turning (rad/s)
    """

    name: str
    wheels: tuple[str, ...] = ()
    radius: float = 0.0
    track: float = 0.0
    slides: tuple[str, ...] = ()
    speed: tuple[float, float] = (0.5, 2.0)
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class SensorBlock:
    """What is measured: sensors of the model, whose numbers stand in a row, or where a body is."""

    name: str
    reads: tuple[str, ...] = ()
    body: str = ""
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)


RobotDevice = RobotArm | RobotAxes | RobotGripper | RobotBase | SensorBlock


@dataclass(frozen=True, slots=True)
class RobotText:
    """What a `.robot` file says. `file` is the model, `hand` another one that is attached to it at the site `on`.

    `links` are models too, each attached at the site `on` of the one before it, the first to the model; then the hand
    is at that of the last. Names of the first stand behind `1.`, those of the second behind `2.`, and so on.
    """

    name: str
    file: str
    description: str = ""
    hand: str = ""
    on: str = ""
    devices: tuple[RobotDevice, ...] = ()
    lines: Lines = field(default_factory=_no_lines, compare=False, repr=False)
    links: tuple[str, ...] = ()
    cameras: tuple[CameraBlock, ...] = ()
    given_kind: str = ""

    @property
    def kind(self) -> str:
        """What kind of robot its devices say they are; by itself the name of its file."""
        return self.given_kind or self.name

    @property
    def models(self) -> tuple[str, ...]:
        """The files of its models."""
        return tuple(dict.fromkeys((self.file, *self.links, *((self.hand,) if self.hand else ()))))

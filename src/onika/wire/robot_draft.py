"""The first draft of a robot's description, made of its model alone: on its way from the program that knows MuJoCo."""

from msgspec import Struct

from onika.words.reason import NOTHING, Reason


class RobotDraft(Struct, frozen=True):
    """What a model says of a robot, what had to be guessed, and a little motion with which it can be tried."""

    text: str = ""
    """Its `.robot` file, without comments."""
    comments: tuple[tuple[str, str, Reason], ...] = ()
    """The keyword of a block (empty: the head), the keyword of a line below it, and where that line comes from."""
    notes: tuple[Reason, ...] = ()
    """What the model does not say, and what happens instead."""
    floor: float = 0.0
    """How high the floor is below a robot that stands at 0 (m)."""
    home: tuple[float, ...] = ()
    """Joint values (rad; m where one slides)."""
    away: tuple[float, ...] = ()
    """Joint values a little beside home."""
    seconds: float = 0.0
    """How long the way from one to the other takes."""
    line: tuple[float, ...] = ()
    """A pose as a Cartesian target has it, in a straight line from `away`; empty: there is none, or few joints."""
    line_s: float = 0.0
    """How long that line takes."""
    opening: tuple[float, ...] = ()
    """The widths of a gripper, open and closed (m), and a force (N); empty: there is none."""
    pictures: tuple[tuple[str, ...], ...] = ()
    """The rows of pictures of home and of what is beside it; empty: there is nothing to see."""
    ahead: tuple[float, ...] = ()
    """A place before a base, x y (m) and turn (rad); empty: the robot does not drive."""
    refusal: Reason = NOTHING
    """Why there is no draft."""
    undriven: tuple[str, ...] = ()
    """Joints of an arm that would have to be driven for a draft."""
    unusable: tuple[str, ...] = ()
    """Files that the model needs and MuJoCo does not take, by their contents."""

"""What a user does to dictionaries, their icons and their targets."""

from onika.wire.act.act import Act
from onika.wire.act.application import Values


class OpenDictionary(Act, frozen=True):
    """Add the dictionary of a base directory to those that are open."""

    path: str


class CloseDictionary(Act, frozen=True):
    """Close a dictionary; what is placed stays."""

    dictionary: str


class MakeTarget(Act, frozen=True):
    """Write a new target, or an icon that does nothing, into a dictionary (D08); `picture` is its digits."""

    name: str
    type: str
    values: Values
    picture: str
    description: str = ""
    base: str = ""
    """Empty: the user's own base directory."""
    overwrites: bool = False
    arm: str = ""
    """The task of the arm that it is made for, whose joints its values are; empty: any."""


class EditOnikon(Act, frozen=True):
    """Change an icon of a dictionary; icons already placed stay as they are (D05). What is None stays."""

    onikon: str
    description: str | None = None
    values: Values | None = None
    picture: str | None = None
    base: str = ""
    """Where a copy of it is saved in its place; empty: where it is."""
    overwrites: bool = False


class RemoveOnikon(Act, frozen=True):
    """Delete the file of an icon; what is placed stays."""

    onikon: str
    confirmed: bool = False


class Teach(Act, frozen=True):
    """Ask for what the robot measures now, as the values of a type of target (D13); replied by `view.TaughtView`."""

    type: str
    """Empty: the first that is measured."""
    subsystem: str = ""
    """Where several measure it; empty: the one of an open configuration, else the first."""
    doc: str = ""
    """The open application whose arm is meant: it is measured whether it runs or not."""
    flow: str = "0"
    after: int = 0
    """A place in it: the arm of the job nearest before it is meant."""
    arm: str = ""
    """The task of the arm that is meant, where the application moves several."""
    or_another: bool = False
    """Whether another type will do where nothing measures this one."""


class PointAt(Act, frozen=True):
    """Ask for a place of a workcell as the values of a type of target (D25); replied by `view.TaughtView`."""

    type: str
    world: str
    position: tuple[float, float, float]
    """Where the tool shall be, in m."""
    approach: tuple[float, float, float]
    """Where it shall point, of any length."""
    normal: tuple[float, float, float] = (1.0, 0.0, 0.0)
    """How it shall be turned about the approach, as far as the arm reaches it so."""
    doc: str = ""
    """The open application whose arm is meant."""
    flow: str = "0"
    after: int = 0
    """A place in it: the arm of the job nearest before it is meant."""
    arm: str = ""
    """The task of the arm that is meant, where the application moves several."""


class FitTargets(Act, frozen=True):
    """Ask which targets a state variable makes as it is now (C30); replied by `view.TargetFitsView`."""

    variable: str
    doc: str = ""
    """The configuration in whose subsystem it is."""
    subsystem: str = ""
    """Where it is, if no open configuration shows it."""


class ArrangeIcon(Act, frozen=True):
    """Put an icon before another of its type in its dictionary (D24)."""

    onikon: str
    before: str = ""
    """Empty: behind all of its type."""

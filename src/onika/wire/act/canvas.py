"""What a user does on the canvas of a configuration."""

from typing import Literal

from msgspec import field

from onika.wire.act.act import Act, Names, Point


class Place(Act, frozen=True):
    """Place a task; where the document is connected, it is spawned, OFF."""

    doc: str
    task: str
    x: int
    y: int
    rtpu: str = ""
    in_left: bool = True


class Exchange(Act, frozen=True):
    """Place a task where another stands, in its stead."""

    doc: str
    old: str
    new: str


class Remove(Act, frozen=True):
    """Remove tasks, and kill them where they live."""

    doc: str
    tasks: Names


class Move(Act, frozen=True):
    """Move tasks and loci to these corners, as one step."""

    doc: str
    tasks: dict[str, Point] = field(default_factory=dict)
    loci: dict[str, Point] = field(default_factory=dict)


class Flip(Act, frozen=True):
    """Turn the direction of data flow in the icons of tasks."""

    doc: str
    tasks: Names


class Align(Act, frozen=True):
    """Bring tasks onto one line, or to equal distances."""

    doc: str
    tasks: Names
    edge: Literal["left", "right", "top", "bottom", "columns", "rows"]


class Arrange(Act, frozen=True):
    """Lay out the tasks of a configuration, or these, in columns along the flow of data."""

    doc: str
    tasks: Names = ()


class Show(Act, frozen=True):
    """Show or hide the connections of variables."""

    doc: str
    svars: Names
    is_shown: bool


class Copy(Act, frozen=True):
    """Take tasks into the buffer; replied with their text, which may travel by mail."""

    doc: str
    tasks: Names


class Cut(Act, frozen=True):
    """Take tasks into the buffer and remove them."""

    doc: str
    tasks: Names


class Paste(Act, frozen=True):
    """Place what is in the buffer, or in a text that was copied elsewhere, with its upper left corner here."""

    doc: str
    x: int
    y: int
    text: str = ""


class Group(Act, frozen=True):
    """Handle tasks as one from now on, under a name: a supermodule; in this order they come (C17)."""

    doc: str
    name: str
    tasks: Names


class Ungroup(Act, frozen=True):
    """Expand a supermodule into its parts."""

    doc: str
    name: str


class SaveGroup(Act, frozen=True):
    """Save a supermodule as a configuration of its own, which Insert recalls; where no base is named, in its own."""

    doc: str
    name: str
    base: str = ""
    overwrites: bool = False


class Insert(Act, frozen=True):
    """Place all tasks of a configuration as a supermodule of its name, with its upper left corner here; all or none."""

    doc: str
    path: str
    x: int
    y: int


class TurnGroup(Act, frozen=True):
    """Turn a supermodule ON in its order, or OFF the other way round."""

    doc: str
    name: str
    is_on: bool


class Rate(Act, frozen=True):
    """The rate of a task in this configuration in Hz; 0: as its file says."""

    doc: str
    task: str
    hz: float


class Unit(Act, frozen=True):
    """The processing unit that a task of this configuration lives on."""

    doc: str
    task: str
    rtpu: str


class Check(Act, frozen=True):
    """Check the configuration: all rules and warnings (C26); replied with the sentences."""

    doc: str

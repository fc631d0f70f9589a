"""Dictionaries, their icons and the types of these, as a page shows them."""

from typing import Any, Literal

from msgspec import field

from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason

Role = Literal["", "job", "application", "target", "nop", "start", "end"]


class ItemView(View, frozen=True):
    """A datum of a target; unit and bounds are those of the task that takes it, where one is known."""

    name: str
    type: str
    count: int
    unit: str = ""
    meaning: str = ""
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None
    default: tuple[Any, ...] | None = None
    dimension: str = ""
    """The constant that says how many values there are, `count` being what is usual; empty: it is `count`."""
    each: int = 1
    """How many there are for each that the constant counts."""
    place: Literal["", "pose", "joints"] = ""
    """Whether it says where an arm goes: as the pose of its tool, or as the values of its joints."""


class TypeView(View, frozen=True):
    """A type of icon of the syntax definition."""

    order: int
    role: Role
    left: str
    """Its edges, by their keys in `Tree.edges`."""
    right: str
    items: tuple[ItemView, ...] = ()
    takes: str = ""
    """The type of the target behind it."""


class DictionaryView(View, frozen=True):
    """An open dictionary."""

    name: str
    path: str
    """Of its base directory."""
    order: int
    onikons: int
    faults: tuple[Reason, ...] = ()
    arranged: tuple[str, ...] = ()
    """Its icons in the order in which a user has put them; those that are not named come behind (D24)."""
    is_shipped: bool = False


class OnikonView(View, frozen=True):
    """An icon of a dictionary."""

    type: str
    role: Role
    order: int
    """In its dictionary: grouped by type."""
    dictionary: str
    """The path of its base directory."""
    left: str
    right: str
    picture: str
    """Its key in `Tree.pictures`."""
    description: str = ""
    words: dict[str, str] = field(default_factory=dict)
    """Descriptions in other languages, by their codes."""
    values: tuple[tuple[str, ...], ...] = ()
    takes: tuple[str, ...] = ()
    """The types of the targets that follow it."""
    path: str = ""
    source: str = ""
    """The file of the configuration or application behind it."""
    trouble: Reason = NOTHING
    """Why it cannot run: what it stands for is missing, or makes another type of icon now (reading 36)."""
    hardware: tuple[str, ...] = ()
    """Of a job: the tasks of its configuration that have a device."""
    arm: str = ""
    """Of a target: the task of the arm that it was made for; it is not offered behind jobs of others (D08)."""


class TaughtView(View, frozen=True):
    """What is measured now, as the values of a target."""

    values: dict[str, tuple[float, ...]]
    """By item; those that nothing measures are left out (D23)."""
    source: Reason = NOTHING
    """What was read, in words."""
    subsystem: str = ""
    """Where it was read."""
    others: tuple[str, ...] = ()
    """The other subsystems that measure it."""
    type: str = ""
    """The type of target that it is."""
    arm: str = ""
    """The task of the arm that was measured."""
    device: str = ""
    """The arm itself, as `WORLD:NAME`."""
    arms: tuple[str, ...] = ()
    """All arms that the application moves."""
    made_for: str = ""
    """The arm's task as the application names it, where the values are those of joints, and so of this arm alone."""
    joints: tuple[float, ...] = ()
    """Where a place was pointed at: the joints with which that arm comes to it."""


class TargetFitView(View, frozen=True):
    """A datum of a type of target that a state variable gives, with its values as words."""

    type: str
    item: str
    values: tuple[str, ...]


class TargetFitsView(View, frozen=True):
    """The targets that a state variable makes as it is now."""

    variable: str
    shape: str
    source: Reason
    """What was read, in words."""
    fits: tuple[TargetFitView, ...]

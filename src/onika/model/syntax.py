"""The syntax of the upper level: the types of onikons, their data items and their edges (dissertation §5.7.1, §A.7)."""

from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

from onika.words.value import ValueType

START = "Application start"
END = "Application end"
COMPLETE_JOB = "Complete job"
COMPLETE_APPLICATION = "Complete application"
COMPLETE_NOP = "Complete NOP"
SPECIAL_TYPES = (START, END, COMPLETE_JOB, COMPLETE_APPLICATION, COMPLETE_NOP)
"""The types with a meaning of their own, which every syntax defines."""

GUARDED = "guarded object"
"""The type of target that says how hard may be pressed: who places one means to touch something (D25)."""


@dataclass(frozen=True, slots=True)
class DataItem:
    """One datum of a target type: its name, the type of its elements and how many there are."""

    name: str
    type: ValueType
    count: int
    dimension: str = ""
    """The constant that says how many there really are, as NDOF of the robot; `count` is then what is usual (D13)."""
    each: int = 1
    """How many there are for each that the constant counts, as coefficients of each joint."""

    def takes(self, number: int) -> bool:
        """Whether so many elements can be meant; where a constant says how many, that is seen before the run."""
        return number == self.count or (bool(self.dimension) and number > 0 and number % self.each == 0)


@dataclass(frozen=True, slots=True)
class IconType:
    """A type of onikon; its role follows from the words of its name, without case (requirement D22)."""

    name: str
    left_edge: int
    right_edge: int
    items: tuple[DataItem, ...] = ()

    @property
    def is_start(self) -> bool:
        """The type of the icon that begins every flow."""
        return _meaning(self.name).is_start

    @property
    def is_end(self) -> bool:
        """The type of the icon that ends every flow."""
        return _meaning(self.name).is_end

    @property
    def is_noop(self) -> bool:
        """An action that does nothing (requirement D11)."""
        return _meaning(self.name).is_noop

    @property
    def is_target(self) -> bool:
        """Data for the action before it."""
        return _meaning(self.name).is_target

    @property
    def is_complete(self) -> bool:
        """An action that never takes a target."""
        return _meaning(self.name).is_complete

    @property
    def is_application(self) -> bool:
        """An action that runs an application."""
        return _meaning(self.name).is_application

    @property
    def is_job(self) -> bool:
        """An action that runs a configuration."""
        return _meaning(self.name).is_job

    @property
    def is_action(self) -> bool:
        """An action of any kind: job, application or no-op."""
        meaning = _meaning(self.name)
        return meaning.is_job or meaning.is_application or meaning.is_noop

    @property
    def needs_target(self) -> bool:
        """An action that is followed by its target."""
        meaning = _meaning(self.name)
        return (meaning.is_job or meaning.is_application) and not meaning.is_complete


@dataclass(frozen=True, slots=True)
class Edge:
    """The drawn border of an onikon: colour (0 to 255 each) and relative movements of the pen in pixels."""

    number: int
    rgb: tuple[int, int, int]
    vertices: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Syntax:
    """All types and edges of one syntax definition."""

    types: tuple[IconType, ...]
    edges: tuple[Edge, ...]
    _by_words: dict[tuple[str, ...], IconType] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Know the types by their names; of two of one name the first counts."""
        object.__setattr__(self, "_by_words", {_words(kind.name): kind for kind in reversed(self.types)})

    def find(self, name: str) -> IconType | None:
        """The type of this name, compared without case (reading 37)."""
        return self._by_words.get(_words(name))

    def acting(self, name: str) -> IconType | None:
        """The type an icon of type `name` acts as: its own, or for unknown jobs and applications the complete one.

        None for an unknown target and for a name that is none of these (requirement D16).
        """
        if icon_type := self.find(name):
            return icon_type
        if has_word(name, "object"):
            return None
        if has_word(name, "job"):
            return self.find(COMPLETE_JOB)
        if has_word(name, "application"):
            return self.find(COMPLETE_APPLICATION)
        return None

    def target_type_of(self, name: str) -> str | None:
        """The target type that goes with an action type by its words: "Joint job" gives "Joint object".

        None where the action takes no target or the syntax lacks that type (reading 32).
        """
        kind = self.find(name)
        if kind is None or not kind.needs_target:
            return None
        target = self.find(object_name(kind.name))
        return target.name if target else None

    def object_of(self, kind: IconType) -> str:
        """The type of the target behind an action of this type: by its words, else the only one whose edge fits.

        Where the syntax has neither, the name that its words say (reading 32).
        """
        name = object_name(kind.name)
        if icon_type := self.find(name):
            return icon_type.name
        fitting = [
            icon_type.name for icon_type in self.types if icon_type.is_target and icon_type.left_edge == kind.right_edge
        ]
        return fitting[0] if len(fitting) == 1 else name

    def edge(self, number: int) -> Edge | None:
        """The edge of this number."""
        return next((edge for edge in self.edges if edge.number == number), None)


def has_word(name: str, word: str) -> bool:
    """Whether a type's name contains a word, without case (requirement D22)."""
    return word in _words(name)


def object_name(name: str) -> str:
    """The name of the target that goes with an action type by its words, whether or not a syntax has it."""
    return " ".join("object" if word.lower() in ("job", "application") else word for word in name.split())


def application_name(name: str) -> str:
    """The name of the type of application that takes a target of this type."""
    return " ".join("application" if word.lower() == "object" else word for word in name.split())


def same_type(name: str, other: str) -> bool:
    """Whether two names mean one type: without case (reading 37)."""
    return _words(name) == _words(other)


@lru_cache(maxsize=1024)  # asked for every icon, again and again, and there are few types
def _words(name: str) -> tuple[str, ...]:
    return tuple(name.lower().split())


class _Meaning(NamedTuple):
    """What the words of a type's name say (requirement D22)."""

    is_start: bool
    is_end: bool
    is_noop: bool
    is_target: bool
    is_complete: bool
    is_application: bool
    is_job: bool


@lru_cache(maxsize=1024)
def _meaning(name: str) -> _Meaning:
    is_start, is_end, is_target = same_type(name, START), same_type(name, END), has_word(name, "object")
    return _Meaning(
        is_start=is_start,
        is_end=is_end,
        is_noop=same_type(name, COMPLETE_NOP),
        is_target=is_target,
        is_complete=has_word(name, "complete"),
        is_application=has_word(name, "application") and not (is_start or is_end or is_target),
        is_job=has_word(name, "job") and not is_target,
    )

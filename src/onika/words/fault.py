"""What is wrong with something a user gave us, as values that are collected and shown (requirement B07)."""

from collections.abc import Iterable
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True, order=True)
class Place:
    """Where a fault stands: a file (or the name of a thing that is no file) and its line; line 0 is the whole."""

    file: str
    line: int = 0

    def __str__(self) -> str:
        return f"{self.file}:{self.line}" if self.line else self.file


@dataclass(frozen=True, slots=True, order=True)
class Fault:
    """One thing that is wrong: where, what was expected, what was found and what happens instead."""

    place: Place
    expected: str
    found: str
    instead: str
    is_note: bool = False
    """Whether it is only worth knowing: what happens instead is what everybody would want, and nothing is refused."""
    where: str = field(default="", compare=False)
    """The flow and the action of a run that it concerns, in words, where its place does not say so."""
    remedies: tuple[str, ...] = field(default=(), compare=False)
    """What could be done or taken instead, likeliest first."""

    def __str__(self) -> str:
        at = f" ({self.where})" if self.where else ""
        text = f"{self.place}: expected {self.expected}, found {self.found}{at}; instead: {self.instead}"
        return f"{text} (you can: {'; '.join(self.remedies)})" if self.remedies else text


def parted(faults: Iterable[Fault]) -> tuple[tuple[Fault, ...], tuple[Fault, ...]]:
    """What is wrong, and the notes: each once, in the order given."""
    every = tuple(dict.fromkeys(faults))
    return tuple(one for one in every if not one.is_note), tuple(one for one in every if one.is_note)


@dataclass(frozen=True, slots=True)
class Refusal:
    """A "no" with its reason in words and what the user could do instead, likeliest first."""

    reason: str
    remedies: tuple[str, ...] = ()

    def __str__(self) -> str:
        return self.reason if not self.remedies else f"{self.reason} (you can: {'; '.join(self.remedies)})"

"""What is wrong with something a user gave us, as values that are collected and shown (requirement B07)."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import lru_cache

from onika.words.reason import NOTHING, Reason

NOT_RUN = Reason.of("words.application_not_run")
"""What happens instead of running an application with faults."""

_KEPT = 4096
"""Sentences that are made once: an icon that stays greyed says the same at every click."""


@dataclass(frozen=True, slots=True, order=True)
class Place:
    """Where a fault stands: a file (or the name of a thing that is no file) and its line; line 0 is the whole."""

    file: str
    line: int = 0

    def __str__(self) -> str:
        if self.line:
            return f"{self.file}:{self.line}"
        return self.file


@dataclass(frozen=True, slots=True, order=True)
class Fault:
    """One thing that is wrong: where, what was expected and found, and what happens instead."""

    place: Place
    reason: Reason
    """What was expected, and what was found."""
    instead: Reason
    is_note: bool = False
    """Whether it is only worth knowing: what happens instead is what everybody would want, and nothing is refused."""
    where: Reason = field(default=NOTHING, compare=False)
    """The flow and the action of a run that it concerns, in words, where its place does not say so."""
    remedies: tuple[Reason, ...] = field(default=(), compare=False)
    """What could be done or taken instead, likeliest first."""
    because: tuple[Place, ...] = field(default=(), compare=False)
    """Where the faults stand of which this one is a consequence, if they are there; empty: it is a cause by itself."""

    @property
    def sentence(self) -> Reason:
        """All of it in one sentence."""
        place, reason, instead = str(self.place), self.reason, self.instead
        if self.where:
            line = Reason.of("words.fault_in", place=place, reason=reason, where=self.where, instead=instead)
        else:
            line = Reason.of("words.fault", place=place, reason=reason, instead=instead)
        return _with_remedies(line, self.remedies)

    def __str__(self) -> str:
        return str(self.sentence)


def parted(faults: Iterable[Fault]) -> tuple[tuple[Fault, ...], tuple[Fault, ...]]:
    """What is wrong, and the notes: each once, in the order given."""
    every = tuple(dict.fromkeys(faults))
    return tuple(fault for fault in every if not fault.is_note), tuple(fault for fault in every if fault.is_note)


@dataclass(frozen=True, slots=True)
class Refusal:
    """A "no" with its reason and what the user could do instead, likeliest first."""

    reason: Reason
    remedies: tuple[Reason, ...] = ()

    @property
    def sentence(self) -> Reason:
        """All of it in one sentence."""
        return _with_remedies(self.reason, self.remedies)

    def __str__(self) -> str:
        return str(self.sentence)


@lru_cache(_KEPT)
def _with_remedies(reason: Reason, remedies: tuple[Reason, ...]) -> Reason:
    if remedies:
        return Reason.of("words.with_remedies", reason=reason, remedies=remedies)
    return reason

"""A console command: its name, its usage, what it does, and the words it takes."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from onika.desk.console.session import ConsoleSession, Faults
from onika.words import argument
from onika.words.reason import NOTHING, Reason

Words = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Command:
    """One command. `raw` words stand before a rest that is taken as it is written; -1: all is words."""

    name: str
    usage: str
    purpose: Reason
    """What it does, in one line."""
    carry_out: Callable[[ConsoleSession, Words], Faults]
    takes: Words = ()
    """What stands at each place, for completion; the last holds for all further places."""
    least: int = 0
    most: int | None = None
    raw: int = -1
    more: Reason = NOTHING
    """What `help NAME` says besides, in lines."""

    def words(self, rest: str) -> Words:
        """What follows its name, as it takes it; raises ValueError where that is not as it is written."""
        words = _raw(rest, self.raw) if self.raw >= 0 else tuple(argument.split(rest))
        if len(words) < self.least or (self.most is not None and len(words) > self.most):
            raise ValueError(f"`{self.name} {rest}`".replace(" `", "`"))
        return words


def find(name: str, commands: Iterable[Command]) -> list[Command]:
    """The command of this name, else all that begin with it."""
    every = list(commands)
    exact = [command for command in every if command.name == name]
    return exact or [command for command in every if name and command.name.startswith(name)]


def _raw(rest: str, count: int) -> Words:
    """So many words, parted by blanks, and the rest."""
    words = rest.split(None, count)
    return tuple(word.strip() for word in words)

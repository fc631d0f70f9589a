"""A puzzle: what a workcell shall have come to, and how well a program brings it there (requirements G10, H07)."""

from dataclasses import dataclass

from onika.model.world import Names

MOST_LEVEL = 9


@dataclass(frozen=True, slots=True)
class GoalWords:
    """What one or several conditions, one after the other, mean for people."""

    conditions: int
    words: Names
    """By language."""


@dataclass(frozen=True, slots=True)
class Puzzle:
    """A goal, by what must hold at the end of a run, with what is asked of a program beyond that.

    A puzzle with a program to begin with is one of mending: the program has a fault.
    """

    name: str
    titles: Names
    """By language."""
    tasks: Names
    """What shall be done, by language."""
    expectations: tuple[str, ...]
    """Conditions, all of which must hold at the end."""
    level: int = 1
    """How hard it is, from 1."""
    program: str = ""
    """The program to begin with: an application, or a text beside the puzzle; empty: none."""
    actions: int = 0
    """How many actions a good program has; 0: nobody counts."""
    seconds: float = 0.0
    """How long a good run lasts, in s; 0: nobody measures."""
    hints: tuple[Names, ...] = ()
    """One after the other, each by language."""
    solution: str = ""
    """A program that reaches the goal, named as `program`; empty: none is told."""
    goals: tuple[GoalWords, ...] = ()
    """The conditions in words, from the first one on; those that are left over are shown as they are."""

    @property
    def is_fault(self) -> bool:
        """Whether a program is to be mended."""
        return bool(self.program)

    def stars(self, actions: int, seconds: float) -> int:
        """Of a run that has reached the goal: one for that, one for few actions, one for little time."""
        is_short = self.actions == 0 or actions <= self.actions
        is_quick = self.seconds == 0.0 or seconds <= self.seconds
        return 1 + is_short + is_quick

"""The program of a flow: its instructions, and what can be read off them before the first one is carried out."""

from collections.abc import Sequence
from typing import NamedTuple

from onika.wire.plan import (
    Again,
    Choose,
    Do,
    Fork,
    Halt,
    Instruction,
    Join,
    Jump,
    Meet,
    PlannedAction,
    PlannedFlow,
    Rest,
    Unless,
)


class Loop(NamedTuple):
    """A loop and the places of its first and its last instruction."""

    name: str
    first: int
    last: int


class Program:
    """Raises ValueError for instructions that lead nowhere or name actions that are not there."""

    def __init__(self, planned: PlannedFlow) -> None:
        self.instructions = planned.program or straight(planned.actions)
        self.is_noop = tuple(action.is_noop for action in planned.actions)
        self._check(len(planned.actions))
        self.entries = self._entries(len(planned.actions))
        """Where each action begins: at its tag, if it has one."""
        self.breakpoints = {
            one.action: one.condition for one in self.instructions if isinstance(one, Rest) and one.action >= 0
        }
        """The conditions of the breakpoints behind single actions; empty: always."""
        self.loops = tuple(self._loops())
        self._stretches = [place for place, one in enumerate(self.instructions) if isinstance(one, Halt)]
        self._parallel = tuple(self._parallels())

    def loops_at(self, place: int) -> list[Loop]:
        """The loops around a place, outermost first."""
        around = [loop for loop in self.loops if loop.first <= place <= loop.last]
        return sorted(around, key=lambda loop: (loop.first, -loop.last))

    def stretch(self, place: int) -> int:
        """Which stretch up to a Halt a place belongs to."""
        return sum(end < place for end in self._stretches)

    def parallel_at(self, place: int) -> tuple[int, ...]:
        """The nested parallel applications a place stands in, by the places of their Forks."""
        return tuple(first for first, last in self._parallel if first < place <= last)

    def tags_from(self, place: int) -> set[str]:
        """The tags of the stretch that begins at a place."""
        end = next(one for one in self._stretches if one >= place)
        return {one.tag for one in self.instructions[place:end] if isinstance(one, Meet)}

    @property
    def end(self) -> int:
        """The place of the last Halt."""
        return self._stretches[-1]

    @property
    def tags(self) -> list[str]:
        """Every tag, in the order of the program."""
        return list(dict.fromkeys(one.tag for one in self.instructions if isinstance(one, Meet)))

    def _entries(self, actions: int) -> dict[int, int]:
        entries: dict[int, int] = {}
        for place, one in enumerate(self.instructions):
            if isinstance(one, Do):
                before = self.instructions[place - 1] if place else None
                entries.setdefault(one.action, place - 1 if isinstance(before, Meet) else place)
        if len(entries) != actions:
            raise ValueError(f"expected a Do for each of {actions} actions, found {len(entries)}")
        return entries

    def _loops(self) -> list[Loop]:
        found = []
        for place, one in enumerate(self.instructions):
            if isinstance(one, Again) or (isinstance(one, Jump) and one.loop):
                found.append(Loop(one.loop, one.to, place))
        return found

    def _parallels(self) -> list[tuple[int, int]]:
        """Forks and their Joins; one within another ends before it."""
        found, open_forks = [], []
        for place, one in enumerate(self.instructions):
            if isinstance(one, Fork):
                open_forks.append(place)
            elif isinstance(one, Join):
                if not open_forks:
                    raise ValueError(f"expected a Fork before the Join at {place}, found none")
                found.append((open_forks.pop(), place))
        if open_forks:
            raise ValueError(f"expected a Join for the Fork at {open_forks[0]}, found none")
        return found

    def _check(self, actions: int) -> None:
        size = len(self.instructions)
        if not size or not isinstance(self.instructions[-1], Halt):
            raise ValueError("expected a program that ends with a Halt")
        for place, one in enumerate(self.instructions):
            for to in _leads_to(one):
                if not 0 <= to < size:
                    raise ValueError(f"expected a place below {size} at {place}, found {to}")
            if isinstance(one, Do) and not 0 <= one.action < actions:
                raise ValueError(f"expected an action below {actions} at {place}, found {one.action}")
            if isinstance(one, Choose) and (not one.to or (one.conditions and len(one.conditions) != len(one.to) - 1)):
                raise ValueError(f"expected one condition fewer than ways at {place}, found {one}")


def straight(actions: Sequence[PlannedAction]) -> tuple[Instruction, ...]:
    """One action after the other, each with its tag and its breakpoint."""
    program: list[Instruction] = []
    for index, action in enumerate(actions):
        program += [Meet(action.synch_tag)] if action.synch_tag is not None else []
        program += [Do(index)]
        program += [Rest(index)] if action.marker else []
    return (*program, Halt())


def _leads_to(one: Instruction) -> tuple[int, ...]:
    match one:
        case Choose():
            return one.to
        case Again() | Unless() | Jump():
            return (one.to,)
    return ()

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
from onika.words.reason import Reason


class ProgramLoop(NamedTuple):
    """A loop and the places of its first and its last instruction."""

    name: str
    first: int
    last: int


class FlowProgram:
    """Raises ValueError for instructions that lead nowhere or name actions that are not there."""

    def __init__(self, planned: PlannedFlow) -> None:
        self.instructions = planned.program or straight(planned.actions)
        self.is_noop = tuple(action.is_noop for action in planned.actions)
        self._check(len(planned.actions))
        self.entries = self._entries(len(planned.actions))
        """Where each action begins: at its tag, if it has one."""
        self.breakpoints = {
            instruction.action: instruction.condition
            for instruction in self.instructions
            if isinstance(instruction, Rest) and instruction.action >= 0
        }
        """The conditions of the breakpoints behind single actions; empty: always."""
        self.loops = tuple(self._loops())
        self._stretches = [
            place for place, instruction in enumerate(self.instructions) if isinstance(instruction, Halt)
        ]
        self._parallel = tuple(self._parallels())

    def loops_at(self, place: int) -> list[ProgramLoop]:
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
        end = next(stretch for stretch in self._stretches if stretch >= place)
        return {instruction.tag for instruction in self.instructions[place:end] if isinstance(instruction, Meet)}

    @property
    def end(self) -> int:
        """The place of the last Halt."""
        return self._stretches[-1]

    @property
    def tags(self) -> list[str]:
        """Every tag, in the order of the program."""
        return list(
            dict.fromkeys(instruction.tag for instruction in self.instructions if isinstance(instruction, Meet))
        )

    def _entries(self, actions: int) -> dict[int, int]:
        entries: dict[int, int] = {}
        for place, instruction in enumerate(self.instructions):
            if isinstance(instruction, Do):
                before = self.instructions[place - 1] if place else None
                entries.setdefault(instruction.action, place - 1 if isinstance(before, Meet) else place)
        if len(entries) != actions:
            raise ValueError(Reason.of("engine.form_actions", actions=actions, found=len(entries)))
        return entries

    def _loops(self) -> list[ProgramLoop]:
        loops = []
        for place, instruction in enumerate(self.instructions):
            if isinstance(instruction, Again) or (isinstance(instruction, Jump) and instruction.loop):
                loops.append(ProgramLoop(instruction.loop, instruction.to, place))
        return loops

    def _parallels(self) -> list[tuple[int, int]]:
        """Forks and their Joins; one within another ends before it."""
        pairs, open_forks = [], []
        for place, instruction in enumerate(self.instructions):
            if isinstance(instruction, Fork):
                open_forks.append(place)
            elif isinstance(instruction, Join):
                if not open_forks:
                    raise ValueError(Reason.of("engine.form_fork", place=place))
                pairs.append((open_forks.pop(), place))
        if open_forks:
            raise ValueError(Reason.of("engine.form_join", place=open_forks[0]))
        return pairs

    def _check(self, actions: int) -> None:
        size = len(self.instructions)
        if not size or not isinstance(self.instructions[-1], Halt):
            raise ValueError(Reason.of("engine.form_halt"))
        for place, instruction in enumerate(self.instructions):
            for to in _leads_to(instruction):
                if not 0 <= to < size:
                    raise ValueError(Reason.of("engine.form_place", size=size, place=place, to=to))
            if isinstance(instruction, Do) and not 0 <= instruction.action < actions:
                action = instruction.action
                raise ValueError(Reason.of("engine.form_action", actions=actions, place=place, action=action))
            if isinstance(instruction, Choose) and (
                not instruction.to
                or (instruction.conditions and len(instruction.conditions) != len(instruction.to) - 1)
            ):
                raise ValueError(Reason.of("engine.form_conditions", place=place, instruction=str(instruction)))


def straight(actions: Sequence[PlannedAction]) -> tuple[Instruction, ...]:
    """One action after the other, each with its tag and its breakpoint."""
    program: list[Instruction] = []
    for index, action in enumerate(actions):
        program += [Meet(action.synch_tag)] if action.synch_tag is not None else []
        program += [Do(index)]
        program += [Rest(index)] if action.marker else []
    return (*program, Halt())


def _leads_to(instruction: Instruction) -> tuple[int, ...]:
    match instruction:
        case Choose():
            return instruction.to
        case Again() | Unless() | Jump():
            return (instruction.to,)
    return ()

"""What a flow can do from one wait to the next, whatever its tasks return (requirement X03)."""

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import cache
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
from onika.words.reason import NOTHING, Reason


class ReturnValue(IntEnum):
    """What is known before the run of the value that the last action has returned."""

    NONE = 0
    """There is none: branches take flow 0, loops are left (readings 21 and 22)."""
    NOOP = 1
    """That of a no-op: flow 0, go on (requirement D11)."""
    ANY = 2


class FlowStop(NamedTuple):
    """Where a flow stands still: at a Meet or a Join of its program, or for good."""

    at: int
    value: ReturnValue


IDLE = FlowStop(-1, ReturnValue.NONE)
"""It has come to its end, or has not been begun by its parent."""
ENDLESS = FlowStop(-2, ReturnValue.NONE)
"""It goes round in a loop that waits for nobody and is never left."""

Said = tuple[Reason, "Said"] | None
"""The choices made, the latest first."""


@dataclass(frozen=True, slots=True)
class FlowOutcome:
    """One thing a flow can come to: where it stops, the flows it begins before, and an example of the choices to it."""

    stop: FlowStop
    forks: tuple[tuple[int, int], ...]
    choices: tuple[Reason, ...]


def program_of(flow: PlannedFlow) -> tuple[Instruction, ...]:
    """The program of a flow; without one its actions follow each other, each with its tag and its breakpoint."""
    if flow.program:
        return flow.program
    return (*(step for index, action in enumerate(flow.actions) for step in _plain(index, action)), Halt())


def ways(flow: PlannedFlow, program: Sequence[Instruction], at: int, value: ReturnValue) -> tuple[FlowOutcome, ...]:
    """Everything a flow can come to from this place of its program; every choice is free unless its value is known.

    A loop that can be left is left some time; one that cannot, and waits nowhere, is ENDLESS.
    """
    at, value = _straight_on(flow, program, at, value)
    if isinstance(program[at] if at < len(program) else None, Meet):
        return (FlowOutcome(FlowStop(at, _kept(program, at, value)), (), ()),)
    outcomes: dict[tuple[FlowStop, tuple[tuple[int, int], ...]], FlowOutcome] = {}
    ahead: deque[tuple[int, ReturnValue, tuple[tuple[int, int], ...], Said]] = deque([(at, value, (), None)])
    seen = set()
    while ahead:
        at, value, forks, choices = ahead.popleft()
        if (at, value, forks) in seen:
            continue
        seen.add((at, value, forks))
        here = program[at] if at < len(program) else Halt()
        stop = _stop(here, program, at, value)
        if stop is not None:
            outcomes.setdefault((stop, forks), FlowOutcome(stop, forks, _in_order(choices)))
            continue
        if isinstance(here, Do):
            value = _returned(flow, here)
        elif isinstance(here, Fork):
            forks += tuple(flow for flow in here.flows if flow not in forks)
        ahead.extend(
            (to, value, forks, (choice, choices) if choice else choices) for to, choice in _onward(here, at, value)
        )
    return tuple(outcomes.values()) or (FlowOutcome(ENDLESS, (), ()),)


def _stop(here: Instruction, program: Sequence[Instruction], at: int, value: ReturnValue) -> FlowStop | None:
    """Where a flow stands still at an instruction; None: it goes on."""
    if isinstance(here, Halt):
        return IDLE
    if isinstance(here, Meet | Join):
        return FlowStop(at, _kept(program, at, value))
    return None


def _returned(flow: PlannedFlow, here: Do) -> ReturnValue:
    if flow.actions[here.action].is_noop:
        return ReturnValue.NOOP
    return ReturnValue.ANY


def _plain(index: int, action: PlannedAction) -> Iterator[Instruction]:
    if action.synch_tag is not None:
        yield Meet(action.synch_tag)
    yield Do(index)
    if action.marker:
        yield Rest(index)


def _straight_on(
    flow: PlannedFlow, program: Sequence[Instruction], at: int, value: ReturnValue
) -> tuple[int, ReturnValue]:
    """As far as there is nothing to choose: most of what there is, in one go."""
    while at < len(program):
        here = program[at]
        if type(here) is Do:
            value = _returned(flow, here)
        elif type(here) is not Rest:
            break
        at += 1
    return at, value


def _onward(here: Instruction, at: int, value: ReturnValue) -> list[tuple[int, Reason]]:
    """The places that can follow, each with the choice that leads there; nothing where there is none."""
    match here:
        case Choose():
            if here.conditions or value is ReturnValue.ANY:
                return [(to, _taking(way, here.name)) for way, to in enumerate(here.to)]
            return [(here.to[0], NOTHING)]
        case Again():
            return _either(here.loop, here.condition, value, stay=here.to, leave=at + 1)
        case Unless():
            return _either(here.loop, here.condition, value, stay=at + 1, leave=here.to)
        case Jump():
            return [(here.to, NOTHING)]
        case _:
            return [(at + 1, NOTHING)]


def _either(loop: str, condition: str, value: ReturnValue, stay: int, leave: int) -> list[tuple[int, Reason]]:
    if condition or value is ReturnValue.ANY:
        leaving, staying = _of_loop(loop)
        return [(leave, leaving), (stay, staying)]
    return [(stay if value is ReturnValue.NOOP else leave, NOTHING)]


@cache
def _taking(way: int, name: str) -> Reason:
    """The same choice is met in state after state."""
    return Reason.of("rules.takes_flow", number=way, branch=name or Reason.of("rules.branch"))


@cache
def _of_loop(loop: str) -> tuple[Reason, Reason]:
    return Reason.of("rules.leaves_loop", loop=loop), Reason.of("rules.stays_in_loop", loop=loop)


def _kept(program: Sequence[Instruction], at: int, value: ReturnValue) -> ReturnValue:
    """The value, or ANY where the next action makes it nobody's business: so equal futures are one."""
    following = program[at + 1] if at + 1 < len(program) else None
    if isinstance(following, Do):
        return ReturnValue.ANY
    return value


def _in_order(unordered: Said) -> tuple[Reason, ...]:
    choices = []
    while unordered is not None:
        choice, unordered = unordered
        choices.append(choice)
    return tuple(reversed(choices))

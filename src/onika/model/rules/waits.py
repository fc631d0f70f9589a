"""Flows that wait for each other: all that their programs can come to, tried before the run (requirement X03).

A state is where each flow stops. From one state to the next all flows go on that can: those that have met, and those
whose nested flows have ended. No meeting can hinder another, since a flow waits at one place only; so it does no harm
that all happen at once. Which flow comes to a tag first makes no difference either: it waits for the others anyway,
and therefore its n-th visit is the n-th of each of them.
"""

from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

from onika.model.rules.stretch import ENDLESS, IDLE, FlowOutcome, FlowStop, ReturnValue, program_of, ways
from onika.wire.plan import Join, Meet, PlannedFlow
from onika.words.reason import Reason

State = tuple[FlowStop, ...]
"""Where each flow of the plan stops; flows that are not looked at are idle."""


@dataclass(frozen=True, slots=True, order=True)
class FlowWait:
    """A flow that waits at a place of its program for another one."""

    flow: int
    at: int
    other: int


@dataclass(frozen=True, slots=True)
class Deadlock:
    """Flows that can never go on: each waits for the next one, the last one for the first or for one that has ended."""

    waits: tuple[FlowWait, ...]
    is_circle: bool
    choices: tuple[tuple[int, Reason], ...]
    """An example of how they come there: who chooses what."""


@dataclass(frozen=True, slots=True)
class Exploration:
    """What was found among flows that have to do with each other."""

    deadlocks: tuple[Deadlock, ...]
    is_certain: bool
    """Whether every run comes to one of the knots."""
    idling: tuple[FlowWait, ...]
    """Who can come to wait for a flow that goes round in a loop for ever, unless the user lets it leave that."""
    is_whole: bool
    """Whether everything was looked at."""
    states: int


class Waits:
    """The flows of a plan, as what can stop them."""

    def __init__(self, flows: Sequence[PlannedFlow]) -> None:
        self._flows = flows
        self.programs = [program_of(flow) for flow in flows]
        self.parties: dict[str, list[int]] = {}
        for number, program in enumerate(self.programs):
            for tag in dict.fromkeys(instruction.tag for instruction in program if isinstance(instruction, Meet)):
                self.parties.setdefault(tag, []).append(number)
        self._ways: dict[tuple[int, int, ReturnValue], tuple[FlowOutcome, ...]] = {}

    def families(self) -> list[tuple[int, ...]]:
        """The flows that have to do with each other, by tags or as parent and nested flow, in groups."""
        group = list(range(len(self._flows)))
        bonds = [*self.parties.values(), *([n, f.parent] for n, f in enumerate(self._flows) if f.parent is not None)]
        for bond in bonds:
            old = {group[number] for number in bond}
            group = [min(old) if number in old else number for number in group] if len(old) > 1 else group
        members: dict[int, list[int]] = {}
        for number, party in enumerate(group):
            members.setdefault(party, []).append(number)
        return [tuple(member) for member in members.values()]

    def explore(self, family: Sequence[int], limit: int) -> Exploration:
        """Every state that these flows can come to, at most so many."""
        return _Exploration(self, limit).explore(self._first(family))

    def steps(self, state: State, released: Sequence[int]) -> Iterator[tuple[State, tuple[tuple[int, Reason], ...]]]:
        """The states that can follow when these flows go on, each with the choices that lead there."""
        return self._starts(state, [(number, state[number].at + 1, state[number].value) for number in released])

    def released(self, state: State) -> list[int]:
        """The flows that wait for nobody any more."""
        waiting, present = [], dict[str, list[int]]()
        for number, stop in enumerate(state):
            here = self.programs[number][stop.at] if stop.at >= 0 else None
            if isinstance(here, Meet):
                present.setdefault(here.tag, []).append(number)
            elif isinstance(here, Join) and all(state[child] == IDLE for child in here.flows):
                waiting.append(number)
        for tag, there in present.items():
            if len(there) == len(self.parties[tag]):
                waiting += there
        return sorted(waiting)

    def waits_for(self, state: State, number: int) -> list[int]:
        """Whom a flow waits for; one that its parent must begin waits for that, an ended one for nobody."""
        stop, parent = state[number], self._flows[number].parent
        if stop.at < 0:
            if stop == IDLE and parent is not None:
                return [parent]
            return []
        here = self.programs[number][stop.at]
        if isinstance(here, Join):
            return [child for child in here.flows if state[child] != IDLE]
        if isinstance(here, Meet):
            return [other for other in self.parties[here.tag] if not self._is_at(state, other, here.tag)]
        raise TypeError(f"expected a stop at Join or Meet, found {here}")

    def has_ended(self, state: State, number: int) -> bool:
        """Whether a flow has come to its last end."""
        return state[number] == IDLE and self._flows[number].parent is None

    def _first(self, family: Sequence[int]) -> Iterator[tuple[State, tuple[tuple[int, Reason], ...]]]:
        nowhere = (IDLE,) * len(self._flows)
        roots = [number for number in family if self._flows[number].parent is None]
        return self._starts(nowhere, [(number, 0, ReturnValue.NONE) for number in roots])

    def _starts(
        self, state: State, starts: Sequence[tuple[int, int, ReturnValue]]
    ) -> Iterator[tuple[State, tuple[tuple[int, Reason], ...]]]:
        """Let flows go on, each from a place of its program, and those that they begin as well."""
        for each in product(*(self._ways_of(*start) for start in starts)):
            new = list(state)
            for (number, _, _), way in zip(starts, each, strict=True):
                new[number] = way.stop
            choices = tuple(
                (start[0], choice) for start, way in zip(starts, each, strict=True) for choice in way.choices
            )
            begun = [(child, at, ReturnValue.NONE) for way in each for child, at in way.forks]
            if not begun:
                yield tuple(new), choices
                continue
            for further, more in self._starts(tuple(new), begun):
                yield further, choices + more

    def _ways_of(self, number: int, at: int, value: ReturnValue) -> tuple[FlowOutcome, ...]:
        if (number, at, value) not in self._ways:
            self._ways[number, at, value] = ways(self._flows[number], self.programs[number], at, value)
        return self._ways[number, at, value]

    def _is_at(self, state: State, number: int, tag: str) -> bool:
        at = state[number].at
        here = self.programs[number][at] if at >= 0 else None
        return isinstance(here, Meet) and here.tag == tag


class _Exploration:
    """One walk through all states of some flows, the near ones first, so that examples are short."""

    def __init__(self, waits: Waits, limit: int) -> None:
        self._waits = waits
        self._limit = limit
        self._came: dict[State, tuple[State | None, tuple[tuple[int, Reason], ...]]] = {}
        self._steps: dict[State, list[State]] = {}
        self._knots: dict[tuple[FlowWait, ...], Deadlock] = {}
        self._idling: dict[FlowWait, None] = {}
        self._has_good_end = False
        self._ahead: deque[State] = deque()

    def explore(self, first: Iterator[tuple[State, tuple[tuple[int, Reason], ...]]]) -> Exploration:
        is_whole = self._reach(None, first)
        while is_whole and self._ahead:
            is_whole = self._look_at(self._ahead.popleft())
        is_certain = bool(self._knots) and is_whole and not self._has_good_end and not _has_circle(self._steps)
        return Exploration(tuple(self._knots.values()), is_certain, tuple(self._idling), is_whole, len(self._came))

    def _look_at(self, state: State) -> bool:
        """Look at one state and what follows from it; False where the limit is reached."""
        released = self._waits.released(state)
        stuck = self._stuck(state, released)
        if stuck:
            self._tie(state, stuck)
            return True
        if not released:
            self._has_good_end = True
            self._find_idling(state)
            return True
        return self._reach(state, self._waits.steps(state, released))

    def _reach(self, state: State | None, steps: Iterator[tuple[State, tuple[tuple[int, Reason], ...]]]) -> bool:
        for new, choices in steps:
            if state is not None:
                self._steps.setdefault(state, []).append(new)
            if new not in self._came:
                if len(self._came) >= self._limit:
                    return False
                self._came[new] = (state, choices)
                self._ahead.append(new)
        return True

    def _stuck(self, state: State, released: Sequence[int]) -> set[int]:
        """The waiting flows that can never go on, whatever the others do: for all they wait for must come."""
        waiting = {number for number, stop in enumerate(state) if stop.at >= 0} - set(released)
        if not waiting:
            return set()
        free = set(released) | {number for number, stop in enumerate(state) if stop == ENDLESS}
        pending = {number: self._waits.waits_for(state, number) for number in range(len(state)) if number not in free}
        while freed := [number for number, others in pending.items() if others and free.issuperset(others)]:
            free.update(freed)
            for number in freed:
                del pending[number]
        return waiting & pending.keys()

    def _tie(self, state: State, stuck: set[int]) -> None:
        for number in sorted(stuck):
            waits, is_circle = self._chain(state, number, stuck)
            if waits not in self._knots:
                self._knots[waits] = Deadlock(waits, is_circle, self._example(state))

    def _chain(self, state: State, number: int, stuck: set[int]) -> tuple[tuple[FlowWait, ...], bool]:
        """From a stuck flow to whom it waits for and so on: the circle at its end, or the wait for an ended flow."""
        chain: dict[int, FlowWait] = {}
        while number not in chain:
            others = self._waits.waits_for(state, number)
            other = next(other for other in others if self._is_dead(state, other, stuck))
            chain[number] = FlowWait(number, state[number].at, other)
            if self._waits.has_ended(state, other):
                return _last_wait(list(chain.values())), False
            number = other
        circle = list(chain.values())[list(chain).index(number) :]
        start = circle.index(min(wait for wait in circle if wait.at >= 0))
        return tuple(circle[start:] + circle[:start]), True

    def _is_dead(self, state: State, number: int, stuck: set[int]) -> bool:
        """Whether a flow never goes on: it is stuck, has ended, or could be begun only by one that never goes on."""
        if state[number] != IDLE or self._waits.has_ended(state, number):
            return number in stuck or state[number] == IDLE
        return all(self._is_dead(state, parent, stuck) for parent in self._waits.waits_for(state, number))

    def _find_idling(self, state: State) -> None:
        for number, stop in enumerate(state):
            for other in self._waits.waits_for(state, number) if stop.at >= 0 else ():
                if state[other] == ENDLESS:
                    self._idling[FlowWait(number, stop.at, other)] = None

    def _example(self, state: State) -> tuple[tuple[int, Reason], ...]:
        parts, at = [], state
        while True:
            before, choices = self._came[at]
            parts.append(choices)
            if before is None:
                return tuple(choice for part in reversed(parts) for choice in part)
            at = before


def _last_wait(chain: list[FlowWait]) -> tuple[FlowWait, ...]:
    """The end of a chain from the last flow on that stands at a wait; those behind it have not been begun."""
    start = max(place for place, wait in enumerate(chain) if wait.at >= 0)
    return tuple(chain[start:])


def _has_circle(steps: Mapping[State, Sequence[State]]) -> bool:
    """Whether one can go round for ever: some states are left when those without a successor are taken away."""
    before: dict[State, list[State]] = {}
    left = {state: len(after) for state, after in steps.items()}
    for state, after in steps.items():
        for successor in after:
            before.setdefault(successor, []).append(state)
    ends = [state for state in before if state not in steps]
    while ends:
        for state in before.get(ends.pop(), ()):
            left[state] -= 1
            if not left[state]:
                del left[state]
                ends.append(state)
    return bool(left)

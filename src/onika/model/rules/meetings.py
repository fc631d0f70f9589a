"""Whether the flows of a plan can meet at their synchronisation tags (requirement X03, readings 21, 22 and 26).

What must end in a deadlock is a fault; what may, depending on what tasks return, is a note with an example. Skips and
passes are not considered: they are the user's way out.
"""

from collections.abc import Iterator

from onika.model.rules.waits import Deadlock, Exploration, FlowWait, Waits
from onika.wire.plan import Do, Meet, Plan, PlannedAction
from onika.words.fault import NOT_RUN, Fault, Place, parted
from onika.words.reason import Reason

LIMIT = 100_000
"""States that are looked at; more are beyond what a person can have meant."""
EXAMPLES = 8
"""Knots and choices that are told."""


def faults(plan: Plan) -> tuple[Fault, ...]:
    """The deadlocks to which every run must come, and tags that one of several flows bears alone."""
    return parted(findings(plan))[0]


def notes(plan: Plan) -> tuple[Fault, ...]:
    """The deadlocks to which a run can come."""
    return parted(findings(plan))[1]


def findings(plan: Plan, limit: int = LIMIT) -> tuple[Fault, ...]:
    """Faults and notes together, for one look at the plan; at most `limit` states of flows are looked at."""
    return _Finder(plan).find(limit)


class _Finder:
    """A plan under examination, and the words for what is found."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._waits = Waits(plan.flows)

    def find(self, limit: int) -> tuple[Fault, ...]:
        faults: list[Fault] = []
        for family in self._waits.families():
            if len(family) > 1:
                faults += self._told(self._waits.explore(family, limit), family)
        return tuple(dict.fromkeys(faults))

    def _told(self, explored: Exploration, family: tuple[int, ...]) -> Iterator[Fault]:
        for deadlock in explored.deadlocks[:EXAMPLES]:
            yield self._certain(deadlock) if explored.is_certain else self._possible(deadlock)
        for wait in explored.idling[:EXAMPLES]:
            yield Fault(
                self._place(wait),
                Reason.of("rules.tag_in_endless_loop", wait=self._waiting(wait)),
                Reason.of("rules.is_run"),
                is_note=True,
            )
        if not explored.is_whole:
            yield Fault(
                Place(self._file(family)),
                Reason.of("rules.tags_too_many", states=explored.states, flows=tuple(map(self._flow, family))),
                Reason.of("rules.deadlocks_unforeseen"),
                is_note=True,
            )

    def _certain(self, deadlock: Deadlock) -> Fault:
        wait = self._deadlock(deadlock)
        reason = (
            Reason.of("rules.tags_in_order", wait=wait)
            if deadlock.is_circle
            else Reason.of("rules.tags_as_often", wait=wait)
        )
        return Fault(self._place(deadlock.waits[0]), reason, NOT_RUN)

    def _possible(self, deadlock: Deadlock) -> Fault:
        when = self._when(deadlock)
        wait = self._deadlock(deadlock)
        if deadlock.is_circle:
            reason = Reason.of("rules.tags_in_order_always", wait=wait, when=when)
        else:
            reason = Reason.of("rules.tags_as_often_always", wait=wait, when=when)
        return Fault(self._place(deadlock.waits[0]), reason, Reason.of("rules.flow_may_pass"), is_note=True)

    def _when(self, deadlock: Deadlock) -> Reason:
        """By which choices it comes to that; of many the last ones."""
        shown: list[Reason | str] = ["…"] if len(deadlock.choices) > EXAMPLES else []
        for flow, choice in deadlock.choices[-EXAMPLES:]:
            shown.append(Reason.of("rules.chooses", flow=self._flow(flow), choice=choice))
        if shown:
            return Reason.of("rules.when_chosen", choices=tuple(shown))
        return Reason.of("rules.in_some_runs")

    def _deadlock(self, deadlock: Deadlock) -> Reason:
        wait = self._waiting(deadlock.waits[0])
        for further in deadlock.waits[1:]:
            wait = Reason.of("rules.wait_which", wait=wait, further=self._waits_on(further))
        return wait

    def _waiting(self, wait: FlowWait) -> Reason:
        return Reason.of("rules.flow_waits", flow=self._flow(wait.flow), wait=self._waits_on(wait))

    def _waits_on(self, wait: FlowWait) -> Reason:
        other = self._flow(wait.other)
        if wait.at < 0:
            return Reason.of("rules.begun_by", other=other)
        here = self._waits.programs[wait.flow][wait.at]
        if not isinstance(here, Meet):
            return Reason.of("rules.waits_for_end", other=other)
        tag, place, action = _name(here.tag), str(self._place(wait)), self._action_name(wait)
        return Reason.of("rules.waits_at", tag=tag, place=place, action=action, other=other)

    def _action(self, wait: FlowWait) -> PlannedAction | None:
        """The action that a flow would go on with, or where there is none the one before."""
        program = self._waits.programs[wait.flow]
        near = (*program[max(wait.at, 0) :], *reversed(program[: max(wait.at, 0)]))
        index = next((instruction.action for instruction in near if isinstance(instruction, Do)), None)
        if index is None:
            return None
        return self._plan.flows[wait.flow].actions[index]

    def _action_name(self, wait: FlowWait) -> Reason | str:
        action = self._action(wait)
        if action:
            return action.name
        return Reason.of("rules.its_end")

    def _place(self, wait: FlowWait) -> Place:
        action = self._action(wait)
        if action:
            return Place(action.place, action.line)
        return Place(self._plan.application)

    def _file(self, family: tuple[int, ...]) -> str:
        places = [action.place for number in family for action in self._plan.flows[number].actions]
        return places[0] if places else self._plan.application

    def _flow(self, number: int) -> str:
        return self._plan.flows[number].subsystem


def _name(tag: str) -> Reason | str:
    """A tag as its file has it, and the nested application it belongs to."""
    *within, name = tag.rsplit(" ", 1)
    if within:
        return Reason.of("rules.tag_of", tag=name, application=within[0])
    return name

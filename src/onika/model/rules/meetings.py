"""Whether the flows of a plan can meet at their synchronisation tags (requirement X03, readings 21, 22 and 26).

What must end in a deadlock is a fault; what may, depending on what tasks return, is a note with an example. Skips and
passes are not considered: they are the user's way out.
"""

from collections.abc import Iterator

from onika.model.rules.waits import Explored, FlowWait, Knot, Waits
from onika.wire.plan import Do, Meet, Plan, PlannedAction
from onika.words.fault import Fault, Place, parted

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
        found: list[Fault] = []
        for family in self._waits.families():
            if len(family) > 1:
                found += self._told(self._waits.explore(family, limit), family)
        return tuple(dict.fromkeys(found))

    def _told(self, explored: Explored, family: tuple[int, ...]) -> Iterator[Fault]:
        for knot in explored.knots[:EXAMPLES]:
            yield self._certain(knot) if explored.is_certain else self._possible(knot)
        for wait in explored.idling[:EXAMPLES]:
            yield Fault(
                self._place(wait),
                "tags that every flow comes to",
                f"{self._waiting(wait)}, which goes round in a loop that ends only when the user lets it leave",
                "the application is run",
                is_note=True,
            )
        if not explored.is_whole:
            yield Fault(
                Place(self._file(family)),
                f"tags that can be looked at in {explored.states} states of the flows",
                f"more in {', '.join(map(self._flow, family))}",
                "the application is run; not every deadlock is foretold",
                is_note=True,
            )

    def _certain(self, knot: Knot) -> Fault:
        return Fault(self._place(knot.waits[0]), _expected(knot), self._knot(knot), "the application is not run")

    def _possible(self, knot: Knot) -> Fault:
        choices = [f"{self._flow(flow)} {choice}" for flow, choice in knot.choices]
        told = choices if len(choices) <= EXAMPLES else ["…", *choices[-EXAMPLES:]]
        when = f"when {', '.join(told)}" if told else "in some runs"
        return Fault(
            self._place(knot.waits[0]),
            f"{_expected(knot)}, whatever is chosen",
            f"{self._knot(knot)}, {when}",
            "the application is run; a flow that stands there can be let pass",
            is_note=True,
        )

    def _knot(self, knot: Knot) -> str:
        ending = "" if knot.is_circle else ", which has ended by then"
        return ", which ".join([self._waiting(knot.waits[0]), *map(self._waits_on, knot.waits[1:])]) + ending

    def _waiting(self, wait: FlowWait) -> str:
        return f"{self._flow(wait.flow)} {self._waits_on(wait)}"

    def _waits_on(self, wait: FlowWait) -> str:
        other = self._flow(wait.other)
        if wait.at < 0:
            return f"is begun by {other} only"
        here = self._waits.programs[wait.flow][wait.at]
        if not isinstance(here, Meet):
            return f"waits for the end of {other}"
        return f"waits at {_name(here.tag)} ({self._place(wait)}, {self._action_name(wait)}) for {other}"

    def _action(self, wait: FlowWait) -> PlannedAction | None:
        """The action that a flow would go on with, or where there is none the one before."""
        program = self._waits.programs[wait.flow]
        near = (*program[max(wait.at, 0) :], *reversed(program[: max(wait.at, 0)]))
        index = next((one.action for one in near if isinstance(one, Do)), None)
        return None if index is None else self._plan.flows[wait.flow].actions[index]

    def _action_name(self, wait: FlowWait) -> str:
        action = self._action(wait)
        return action.name if action else "its end"

    def _place(self, wait: FlowWait) -> Place:
        action = self._action(wait)
        return Place(action.place, action.line) if action else Place(self._plan.application)

    def _file(self, family: tuple[int, ...]) -> str:
        places = [action.place for number in family for action in self._plan.flows[number].actions]
        return places[0] if places else self._plan.application

    def _flow(self, number: int) -> str:
        return self._plan.flows[number].subsystem


def _expected(knot: Knot) -> str:
    return "tags in an order in which the flows can meet" if knot.is_circle else "tags as often in each flow"


def _name(tag: str) -> str:
    """A tag as its file has it, and the nested application it belongs to."""
    *within, name = tag.rsplit(" ", 1)
    return f"{name} of {within[0]}" if within else name

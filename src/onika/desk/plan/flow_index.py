"""An index of an application's flows: finds a flow by number or subsystem, and an action by number or name."""

import re
from collections.abc import Iterable
from dataclasses import dataclass

from onika.wire.plan import Plan, PlannedFlow
from onika.wire.steer import Position
from onika.words.name import resolve
from onika.words.reason import Reason

_NUMBER = re.compile(r"[0-9]{1,6}\Z")
_SHOWN = 8


@dataclass(frozen=True, slots=True)
class IndexedFlow:
    """One flow: its subsystem, its actions by name, the variables of its tasks; None where they are not known."""

    subsystem: str
    actions: tuple[str, ...] | None = None
    variables: frozenset[str] | None = None
    is_nested: bool = False


@dataclass(frozen=True, slots=True)
class FlowIndex:
    """All flows of an application, nested ones last, in the order of the plan."""

    parts: tuple[IndexedFlow, ...]

    @classmethod
    def of(cls, plan: Plan) -> "FlowIndex":
        """Those of a plan."""
        return cls(
            tuple(
                IndexedFlow(
                    flow.subsystem,
                    tuple(action.name for action in flow.actions),
                    variables(flow),
                    flow.parent is not None,
                )
                for flow in plan.flows
            )
        )

    @classmethod
    def seen(cls, positions: Iterable[Position]) -> "FlowIndex":
        """Those that a runtime told of: what their actions are called is not known."""
        names = [position.subsystem for position in positions]
        return cls(tuple(IndexedFlow(name, is_nested=name.rpartition(".")[0] in names) for name in names))

    @property
    def subsystems(self) -> tuple[str, ...]:
        """The flows by their subsystems."""
        return tuple(part.subsystem for part in self.parts)

    @property
    def lone(self) -> str:
        """The only flow that is not nested; empty where there are several."""
        chief = [part.subsystem for part in self.parts if not part.is_nested]
        return chief[0] if len(chief) == 1 else ""

    def flow(self, word: str) -> str:
        """The subsystem of a flow by its subsystem or number, counted from 0; empty: there is none such."""
        if word in self.subsystems:
            return word
        number = int(word) if _NUMBER.match(word) else len(self.parts)
        if number < len(self.parts):
            return self.parts[number].subsystem
        return ""

    def action(self, subsystem: str, word: str) -> int:
        """The index of an action by its number, counted from 1, or by its name; raises ValueError that says what is."""
        names = next(part.actions for part in self.parts if part.subsystem == subsystem)
        if names is None:
            if _NUMBER.match(word) and int(word) > 0:
                return int(word) - 1
            raise ValueError(Reason.of("desk.action_number", word=word))
        if _NUMBER.match(word):
            if 0 < int(word) <= len(names):
                return int(word) - 1
            raise ValueError(Reason.of("desk.action_range", subsystem=subsystem, count=len(names), word=word))
        places = [index for index, name in enumerate(names) if name == word]
        if len(places) == 1:
            return places[0]
        if places:
            numbers = tuple(index + 1 for index in places)
            raise ValueError(Reason.of("desk.action_ambiguous", word=word, numbers=numbers, subsystem=subsystem))
        names_shown = ", ".join(dict.fromkeys(names[:_SHOWN])) + (" …" if len(names) > _SHOWN else "")
        raise ValueError(Reason.of("desk.action_unknown", subsystem=subsystem, names=names_shown, word=word))

    def name(self, subsystem: str, index: int) -> str:
        """What an action is called; empty where that is not known."""
        names = next((part.actions for part in self.parts if part.subsystem == subsystem), None)
        if names is not None and 0 <= index < len(names):
            return names[index]
        return ""

    def count(self, subsystem: str) -> int:
        """How many actions a flow has; 0 where that is not known."""
        names = next((part.actions for part in self.parts if part.subsystem == subsystem), None)
        return 0 if names is None else len(names)

    def home(self, address: str) -> tuple[str, str]:
        """Subsystem and name of a variable `[SUBSYSTEM/]NAME`; the first flow that has it where none is named.

        Raises ValueError where no task reads or writes it.
        """
        subsystem, slash, name = address.rpartition("/")
        for part in self.parts:
            is_meant = part.subsystem == subsystem or not slash
            if is_meant and (part.variables is None or name in part.variables):
                return part.subsystem, name
        raise ValueError(Reason.of("desk.variable_unknown", address=address))


def variables(flow: PlannedFlow) -> frozenset[str]:
    """What the tasks of a flow read and write, by the names in its table."""
    ports = [(task.inconst + task.outconst + task.invar + task.outvar, dict(task.aliases)) for task in flow.tasks]
    return frozenset(name for names, aliases in ports for name in resolve(names, aliases))

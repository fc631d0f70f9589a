"""What an application does, read a second time: a plain interpreter of lists of actions, without orders or lifecycles.

Written from §5.5.4, §5.9.2, Table 9, E02, E04 and readings 16, 17, 26 and 28; it shares no code with the engine.
There is nobody to decide, so that an error that is not a passive task's ends the run (E08).
"""

from dataclasses import dataclass, field

Event = tuple[object, ...]


@dataclass(frozen=True)
class Action:
    tasks: tuple[str, ...]
    triggers: tuple[str, ...]
    tag: str | None


@dataclass
class Flow:
    actions: list[Action]
    at: int = -1
    waits: str | None = None
    is_done: bool = False
    was_waiting: bool = False
    """Whether it has said that it waits since it last began."""
    on: set[str] = field(default_factory=set)
    said_so: set[str] = field(default_factory=set)
    """Of those ON: who has said that it is, since it was last turned on."""
    broken: set[str] = field(default_factory=set)

    @property
    def is_running(self) -> bool:
        return self.at >= 0 and self.waits is None and not self.is_done

    def leave(self, task: str) -> None:
        self.on.discard(task)
        self.said_so.discard(task)


class Performance:
    """Told what tasks say, it answers with what is to be seen: (what, flow, …)."""

    def __init__(self, flows: list[list[Action]], passive: set[str]) -> None:
        self.flows = [Flow(actions) for actions in flows]
        self.passive = passive
        self.is_over = False

    def begin(self) -> list[Event]:
        return self._go_on(*range(len(self.flows)))

    def turned_on(self, number: int, task: str) -> list[Event]:
        if task in self.flows[number].on:
            self.flows[number].said_so.add(task)
        return []

    def finished(self, number: int, task: str) -> list[Event]:
        flow = self.flows[number]
        counts = task in flow.said_so
        if counts:
            flow.leave(task)
        if not counts or not flow.is_running or task not in flow.actions[flow.at].triggers:
            return [("ignored", number, task)]
        return [("done", number, flow.at), *self._go_on(number)]

    def switched_off(self, number: int, task: str) -> list[Event]:
        if task in self.flows[number].said_so:
            self.flows[number].leave(task)
        return [("fell silent", number, task)]

    def failed(self, number: int, task: str) -> list[Event]:
        if task not in self.passive:
            return self.ended()
        self.flows[number].leave(task)
        self.flows[number].broken.add(task)
        return [("stays off", number, task)]

    def ended(self) -> list[Event]:
        self.is_over = True
        return [("ends",)]

    def _go_on(self, *numbers: int) -> list[Event]:
        """What is said at this instant, then who begins together, then each who begins."""
        events: list[Event] = []
        starting: list[int] = []
        tag = ""
        for number in numbers:
            flow = self.flows[number]
            if flow.at + 1 == len(flow.actions):
                events += self._complete(number)
                continue
            flow.waits = flow.actions[flow.at + 1].tag
            if flow.waits is None:
                starting.append(number)
            elif self._absent(flow.waits):
                events.append(self._waits(number))
                flow.was_waiting = True
            else:
                tag = flow.waits
                starting += self._parties(tag)
        together: list[Event] = [("together", tag, sorted(starting))] if len(starting) > 1 else []
        begun = [event for number in sorted(starting) for event in self._start(number)]
        self.is_over = all(flow.is_done for flow in self.flows)
        return events + together + begun + ([("all done",)] if self.is_over else [])

    def _complete(self, number: int) -> list[Event]:
        self.flows[number].is_done = True
        waiting = [other for other, flow in enumerate(self.flows) if flow.waits and number in self._parties(flow.waits)]
        return [("is done", number), *(self._waits(other) for other in waiting)]

    def _waits(self, number: int) -> Event:
        tag = self.flows[number].waits or ""
        absent = self._absent(tag)
        return ("waits", number, tag, absent, [other for other in absent if self.flows[other].is_done])

    def _absent(self, tag: str) -> list[int]:
        return [other for other in self._parties(tag) if self.flows[other].waits != tag]

    def _parties(self, tag: str) -> list[int]:
        return [number for number, flow in enumerate(self.flows) if tag in [action.tag for action in flow.actions]]

    def _start(self, number: int) -> list[Event]:
        flow = self.flows[number]
        flow.at, flow.waits = flow.at + 1, None
        had_waited, flow.was_waiting = flow.was_waiting, False
        action = flow.actions[flow.at]
        wanted = set(action.tasks) - flow.broken
        untouched = flow.on & wanted - set(action.triggers)
        off, on = flow.on - untouched, wanted - untouched
        flow.on, flow.said_so = wanted, flow.said_so & untouched
        begun: list[Event] = [("switches", number, sorted(off), sorted(on)), ("begins", number, flow.at)]
        return [*begun, ("runs again", number)] if had_waited else begun

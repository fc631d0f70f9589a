"""The status poll asks all processing units and puts their answers together (requirements A11, A17)."""

from collections.abc import Callable, Iterable

from onika.host.units.unit_registry import Units
from onika.runtime import command, news
from onika.words.reason import Reason

Then = Callable[[dict[str, news.Statuses]], None]
Answered = Callable[[news.Got | news.Refused], None]


class StatusPoll:
    """Who asked for statuses, or a module for a value, and what has come in so far."""

    def __init__(self, units: Units, alive: Callable[[], Iterable[str]]) -> None:
        self._units = units
        self._alive = alive
        self._askers: list[Then] = []
        self._awaited: set[str] = set()
        self._came: dict[str, news.Statuses] = {}
        self._questions: dict[tuple[str, str], list[tuple[str, Answered]]] = {}
        self.loads: dict[str, float] = {}
        """The last known load of each unit."""

    def call(self, then: Then) -> None:
        """Ask every unit; whoever asks meanwhile gets the same answer."""
        self._askers.append(then)
        if len(self._askers) > 1:
            return
        self._awaited = set(self._alive())
        self._came = {}
        for rtpu in sorted(self._awaited):
            self._units.send(rtpu, command.Report())
        self._tell()

    def hear(self, message: news.Statuses | news.Loads) -> None:
        """One unit's answer."""
        if isinstance(message, news.Statuses):
            self.loads[message.rtpu] = message.load
            if message.rtpu in self._awaited:
                self._awaited.discard(message.rtpu)
                self._came[message.rtpu] = message
                self._tell()

    def lost(self) -> None:
        """A unit is gone and will not answer."""
        alive = set(self._alive())
        self._awaited &= alive
        self._tell()
        for (subsystem, task), waiting in self._questions.items():
            for rtpu, then in [question for question in waiting if question[0] not in alive]:
                waiting.remove((rtpu, then))
                then(news.Refused(subsystem, task, "get or set", Reason.of("host.unit_is_gone", name=rtpu)))

    def ask(self, rtpu: str, order: command.Get | command.Set, then: Answered) -> None:
        """Ask a module; answers of one task come in the order of questions."""
        self._questions.setdefault((order.subsystem, order.task), []).append((rtpu, then))
        self._units.send(rtpu, order)

    def answered(self, message: news.Got | news.Refused) -> None:
        """A module's answer."""
        waiting = self._questions.get((message.subsystem, message.task), [])
        if waiting:
            _, then = waiting.pop(0)
            then(message)

    def _tell(self) -> None:
        if self._askers and not self._awaited:
            askers, self._askers = self._askers, []
            for then in askers:
                then(self._came)

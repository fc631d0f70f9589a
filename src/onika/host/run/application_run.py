"""One run of an application: its runner, who began it, and when its result can be told."""

from collections.abc import Callable, Mapping
from pathlib import Path
from time import monotonic_ns

from msgspec import structs

from onika.engine.news import Abort
from onika.host.loading.plan_preparation import Preparation
from onika.host.run.departure import after_departure
from onika.host.run.run_rendezvous import RunRendezvous
from onika.host.run.runner import Runner
from onika.host.units.unit_registry import Units
from onika.runtime import news
from onika.runtime.subsystem import Member, RunningSubsystem
from onika.wire import event
from onika.wire.request import Begin
from onika.words.reason import Reason

_OF_RUN = (event.Began, event.Done, event.Explained, event.LastSecondsKept, event.Result)
"""What may name no subsystem; it says whose it is."""

REST_NS = 300_000_000
"""How long the end of a run waits at most until every drive holds."""


class ApplicationRun:
    """A run from its beginning to its result."""

    def __init__(
        self,
        session: str,
        prepared: Preparation,
        begin: Begin,
        subsystems: Mapping[int, RunningSubsystem],
        units: Units,
        tell: Callable[[event.Event, str, str], None],
        lost: Mapping[str, Reason],
        rendezvous: RunRendezvous | None = None,
    ) -> None:
        self.session = session
        """Who holds it; empty: nobody any more."""
        self._told = session
        """Who is told of it in any case: who holds it, or held it last and may be heard again."""
        self.on_loss = begin.on_loss
        self.is_ended_at_wish = False
        """Whether whoever may end it has said so."""
        self.application = prepared.plan.application
        self.flows = prepared.plan.flows
        self.names = tuple(flow.subsystem for flow in prepared.plan.flows)
        self.variable_units = variable_units(prepared)
        """By subsystem, the units of its variables by name."""
        self.runner = Runner(prepared, begin, subsystems, units, self._tell, lost, rendezvous)
        self._code = prepared.code
        self._tell_all = tell
        self._subsystems = subsystems
        self._actions = sum(len(flow.actions) for flow in prepared.plan.flows)
        self._began_wall = monotonic_ns()
        self._over_since = 0

    def end_at_wish(self, cause: Reason, now: int) -> None:
        """Somebody who may end it wants it to end."""
        self.is_ended_at_wish = True
        self.runner.abort(cause, now)

    def members(self, subsystem: str) -> Mapping[str, Member]:
        """The tasks of one of its subsystems."""
        return self._subsystems[self.names.index(subsystem)].members

    def source(self, digest: str) -> str:
        """The code behind a task of it."""
        return self._code[digest].source

    def hear(self, rtpu: str, message: news.News, now: int) -> None:
        """Take in one piece of news of its tasks."""
        self.runner.hear(rtpu, message, now)

    def pass_on(self, session: str) -> None:
        """From now on this session holds it."""
        self.session = self._told = session

    def abandon(self, cause: Reason, now: int) -> None:
        """The session that began it is gone: it ends, finishes its actions and pauses, or runs on, as it was begun."""
        self.session = ""
        for message in after_departure(self.on_loss, self.names, cause):
            if isinstance(message, Abort):
                self.runner.abort(message.cause, now)
            else:
                self.runner.steer(message, now, lambda _refusal: None)

    def is_through(self, is_at_rest: Callable[[], bool]) -> bool:
        """Whether it is over, and every drive holds or had the time to."""
        if not self.runner.is_over:
            return False
        self._over_since = self._over_since or monotonic_ns()
        return is_at_rest() or monotonic_ns() - self._over_since > REST_NS

    def result(self, digest: str, outside: tuple[str, ...] = ()) -> event.Result:
        """What came of it; `outside` are the tasks that make it one which may not repeat (law 15)."""
        wall = (monotonic_ns() - self._began_wall) * 1e-9
        result = self.runner.statistics.result(self._actions, wall, digest)
        return structs.replace(
            result, outside=tuple(address for address in outside if address.split("/")[0] in self.names)
        )

    def end(self, result: event.Result) -> None:
        """Tell the result."""
        self._tell(result)

    def warn(self, text: Reason, at_s: float) -> None:
        """Tell whoever watches what is worth knowing of the run as a whole."""
        self._tell(event.Warned(self.names[0], "", text, at_s))

    def name_black_box(self, subsystem: str, at_s: float, path: Path) -> None:
        """Tell where the last seconds before a standstill stand."""
        self._tell(event.LastSecondsKept(subsystem, at_s, str(path)))

    def _tell(self, message: event.Event) -> None:
        flow = getattr(message, "flow", 0)
        if isinstance(message, _OF_RUN):
            message = structs.replace(message, run=self.names[0])
        self._tell_all(message, getattr(message, "subsystem", "") or self.names[flow], self._told)


def variable_units(prepared: Preparation) -> dict[str, dict[str, str]]:
    """By subsystem, the units of its variables by name, as the modules say them."""
    return {
        flow.subsystem: {port.svar: port.unit for wired in tasks for port in wired.ports}
        for flow, tasks in zip(prepared.plan.flows, prepared.flows, strict=True)
    }

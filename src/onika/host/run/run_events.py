"""The herald of a run: tells whoever watches what the engine ordered and what became of tasks, in the run's time."""

from collections.abc import Callable, Mapping

from onika.engine import orders
from onika.host.edit.task_events import stepped
from onika.host.run.run_statistics import Meeting
from onika.model.lifecycle import State
from onika.runtime import news
from onika.runtime.subsystem import RunningSubsystem
from onika.wire import event
from onika.wire.plan import Plan

Told = orders.Began | orders.Done | orders.Moved | orders.Note


class Herald:
    """Times are told in seconds since `began`."""

    def __init__(
        self, plan: Plan, subsystems: Mapping[int, RunningSubsystem], tell: Callable[[event.Event], None]
    ) -> None:
        self._plan = plan
        self._subsystems = subsystems
        self._tell = tell
        self.began = 0

    def name(self, flow: int) -> str:
        """The subsystem of a flow."""
        return self._subsystems[flow].name

    def seconds(self, now: int) -> float:
        """A time of the runtime as seconds since the run's start."""
        return round((now - self.began) * 1e-9, 9)

    def order(self, order: Told, now: int) -> None:
        """Where a flow is, by an order of the engine."""
        at, name = self.seconds(now), self.name(order.flow)
        match order:
            case orders.Began():
                actions = self._plan.flows[order.flow].actions
                self._tell(event.Began(order.flow, order.index, len(actions), actions[order.index].name, at))
            case orders.Done():
                self._tell(event.Done(order.flow, order.index, at))
            case orders.Moved():
                absent = tuple(self.name(one) for one in order.waits_for)
                self._tell(event.Moved(name, order.state, order.index, at, order.tag, absent, order.text))
            case orders.Note():
                self._tell(event.Warned(name, "", order.text, at))

    def state(self, flow: int, task: str, state: State, now: int) -> None:
        """A task's state has changed."""
        self._tell(event.TaskState(self.name(flow), task, state.value, self.seconds(now)))

    def warned(self, flow: int, task: str, text: str, now: int) -> None:
        """A task warns, or would not do something."""
        self._tell(event.Warned(self.name(flow), task, text, self.seconds(now)))

    def failed(self, heard: news.Failed) -> None:
        """A task has failed."""
        at = self.seconds(heard.now_ns)
        where = (heard.path, heard.line, heard.traceback, at, heard.entry, heard.values)
        self._tell(event.Failed(heard.subsystem, heard.task, f"{heard.entry}: {heard.text}", *where))

    def stepped(self, heard: news.Stepped) -> None:
        """An input of a hardware task has stepped; what was as far as it may is no word worth."""
        found = stepped(heard, self.seconds(heard.at_ns))
        if found.is_too_far:
            self._tell(found)

    def met(self, meeting: Meeting, now: int) -> None:
        """Flows have begun together."""
        names = tuple(self.name(one) for one in meeting.flows)
        self._tell(event.Met(meeting.tag, names, meeting.skew_us, self.seconds(now)))

"""Run events: what sessions are told of the flows of a run, in seconds since its start."""

from collections.abc import Callable, Sequence

from onika.engine import orders
from onika.host.run.run_statistics import Meeting
from onika.wire import event
from onika.wire.plan import Plan
from onika.words.reason import Reason

FlowNote = orders.Began | orders.Done | orders.Moved | orders.RunNote
"""What the engine says for whoever watches."""


class RunEvents:
    """Tells of the flows of one plan, each of which has a subsystem's name."""

    def __init__(self, plan: Plan, tell: Callable[[event.Event], None]) -> None:
        self._flows = plan.flows
        self._tell = tell
        self.began = 0

    def name(self, flow: int) -> str:
        """The subsystem of a flow."""
        return self._flows[flow].subsystem

    def names(self, flows: Sequence[int]) -> tuple[str, ...]:
        """The subsystems of these flows."""
        return tuple(self.name(flow) for flow in flows)

    def seconds(self, now: int) -> float:
        """A time of the runtime as seconds since the run's start."""
        return round((now - self.began) * 1e-9, 9)

    def note(self, note: FlowNote, now: int) -> None:
        """Tell where a flow is, as the engine says it."""
        at_s, name = self.seconds(now), self.name(note.flow)
        match note:
            case orders.Began():
                actions = self._flows[note.flow].actions
                self._tell(event.Began(note.flow, note.index, len(actions), actions[note.index].name, at_s))
            case orders.Done():
                self._tell(event.Done(note.flow, note.index, at_s))
            case orders.Moved():
                absent = self.names(note.waits_for)
                self._tell(event.Moved(name, note.state, note.index, at_s, note.tag, absent, note.text))
            case orders.RunNote():
                self._tell(event.Warned(name, "", note.text, at_s))

    def warn(self, text: Reason, now: int) -> None:
        """Tell what is worth knowing of the run as a whole."""
        self._tell(event.Warned(self.name(0), "", text, self.seconds(now)))

    def met(self, meeting: Meeting, now: int) -> None:
        """Flows have begun together."""
        self._tell(event.Met(meeting.tag, self.names(meeting.flows), meeting.skew_us, self.seconds(now)))

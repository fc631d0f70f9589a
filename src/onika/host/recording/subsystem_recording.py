"""The recording of one subsystem that is held by hand, from when it is asked for until it is written (X05, law 29).

What it takes is what the recording of a run takes: values as they are written, events, what was asked, poses. Its time
begins where it does. Tasks and variables come and go meanwhile; a variable that is there again with another shape is
left out from then on, and that is told.
"""

from collections.abc import Sequence
from time import monotonic_ns

from msgspec.structs import replace

from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.met_variables import MetVariables
from onika.host.recording.recorded_variable import VariablePlace
from onika.host.recording.recorded_worlds import RecordedDriver, RecordedWorlds
from onika.host.recording.recorder import look_period_ns
from onika.host.recording.recording_place import InProcessWriter, RecordingWriter, WriterProcess, complaints
from onika.host.recording.recording_sink import AddMessage, AddVariables, BeginRecording, FinishRecording
from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.record import topics
from onika.record.run import RunRecord, closing
from onika.wire import event, request
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

END_NS = 5_000_000_000
"""How long its end waits at most until it is written."""
_UNTOLD = (event.LastSecondsKept, event.Recording, event.Result, event.Stood)


class SubsystemRecording:
    """Raises OSError where the file cannot be made. It begins with `begin`, once whoever writes is up."""

    def __init__(self, live: LiveSubsystem, path: str, about: RunRecord, seen: RecordedDriver) -> None:
        self.live = live
        self.path = path
        self._seen = seen
        if seen.is_virtual:
            self._writer: RecordingWriter = InProcessWriter(path, about)
        else:
            self._writer = WriterProcess(path, about, look_period_ns(_rates(live)), seen.with_fifo)
        self._about = about
        self._worlds = RecordedWorlds(seen)
        self._met = MetVariables(live.name, live.table)
        self._shapes: dict[str, tuple[str, str]] = {}
        self._began = -1
        self._ended = -1
        self._end_at = 0

    @property
    def is_up(self) -> bool:
        """Whether it may begin."""
        return self._writer.is_up

    @property
    def reason(self) -> Reason:
        """Why nothing more is written; empty: all is well."""
        return self._writer.reason

    @property
    def is_begun(self) -> bool:
        """Whether it has begun."""
        return self._began >= 0

    @property
    def is_ending(self) -> bool:
        """Whether nothing more comes to it."""
        return self._end_at > 0

    @property
    def lasted_s(self) -> float:
        """How long it has gone on, or went on."""
        end = self._ended if self.is_ending else self._seen.now
        return round((end - self._began) * 1e-9, 9) if self.is_begun else 0.0

    def begin(self) -> None:
        """From now on what happens is in it; how everything stands is said first."""
        self._began = self._seen.now
        self._writer.take(BeginRecording(monotonic_ns()))
        at_s = self.live.executor.seconds(self._began)
        for task, member in self.live.members.items():
            self.hear(event.TaskState(self.live.name, task, member.state.value, at_s), self.live.name)
        self._meet(is_late=True)
        self._seen.each_instant(self.look)
        self.look()

    def hear(self, message: event.Event, subsystem: str) -> None:
        """Something is told."""
        is_meant = subsystem in ("", self.live.name) and not isinstance(message, _UNTOLD)
        if is_meant:
            self._say(topics.EVENTS, topics.encode(topics.EventRecord(subsystem, message)))

    def command(self, session: str, message: request.Request) -> None:
        """Something was asked and carried out that may change the course of things."""
        if getattr(message, "subsystem", self.live.name) in ("", self.live.name):
            topic = topics.ANSWERS if isinstance(message, request.Reply) else topics.COMMANDS
            self._say(
                topic, topics.encode(topics.RequestRecord(self._seen.turn, session, topics.without_files(message)))
            )

    def describe(self, about: RunRecord) -> Reason:
        """It consists of something else now; why that cannot be said, or nothing."""
        about = replace(about, began=self._about.began)
        if about == self._about or not about.prepare.plan.flows[0].tasks:  # of what is closed, as it was last
            return NOTHING
        self._about = about
        try:
            self._writer.describe(about)
        except OSError as wrong:
            return system_reason(wrong)
        return NOTHING

    def look(self) -> None:
        """What has come since the last time: variables, worlds; in virtual time the values too."""
        if not self.is_begun or self.is_ending:
            return
        now = self._seen.now - self._began
        self._meet()
        self._writer.look(now)
        self._worlds.show(self._writer, now)

    def serve(self) -> None:
        """Hear what becomes of it, now and then."""
        self.look()
        self._writer.serve()

    def end(self, cause: Reason) -> None:
        """Nothing more comes to it; what there is is written."""
        self.look()
        self._ended, self._end_at = self._seen.now, monotonic_ns() + END_NS
        self._writer.take(FinishRecording(closing(cause, self.lasted_s), self._writer.untold))

    @property
    def is_over(self) -> bool:
        """Whether it is written, or never will be."""
        return self._writer.is_done or (self.is_ending and monotonic_ns() >= self._end_at)

    def close(self) -> list[Reason]:
        """Let go of the file; what is to be known of one that is not what was asked for."""
        found = complaints(self._writer) if self.is_begun else []
        self._seen.leave_instants(self.look)
        self._writer.close()
        return found

    def readers(self) -> Sequence[ProcessSocket]:
        """What to wait for."""
        return self._writer.readers()

    # Inner

    def _say(self, topic: str, body: bytes) -> None:
        if self.is_begun and not self.is_ending:
            self._writer.take(AddMessage(topic, max(self._seen.now - self._began, 0), body))

    def _meet(self, *, is_late: bool = False) -> None:
        """Variables that have come, or gone."""
        units = {port.svar: port.unit for wired in self.live.wired for port in wired.ports}
        order = self._met.news(units)
        if order is None:
            return
        variables = tuple(place for place in order.variables if self._is_as_before(place))
        self._writer.take(AddVariables(self.live.name, variables, order.gone, is_late), self._met.memory)

    def _is_as_before(self, place: VariablePlace) -> bool:
        """Whether it has the shape and the unit that it had when it was met first: a series has one of each."""
        before = self._shapes.setdefault(place.name, (place.shape, place.unit))
        if before == (place.shape, place.unit):
            return True
        now, then = f"{place.shape} {place.unit}".strip(), " ".join(before).strip()
        self.live.warn("", Reason.of("host.recorded_otherwise", name=place.name, now=now, then=then))
        return False


def _rates(live: LiveSubsystem) -> list[float]:
    """At which rates its tasks cycle, in hertz."""
    rates = (live.desired.rate(task) or member.wired.task.frequency for task, member in live.members.items())
    return [rate for rate in rates if rate]

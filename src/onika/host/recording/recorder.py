"""The recorder: what a run says, shows and is asked, taken to whoever writes it (law 29); one run at a time.

It looks at nothing that is not there anyway. In wall time another process looks into the tables; here only what is
told goes by, and the poses of worlds as the device server says them.
"""

from collections.abc import Iterable, Sequence
from time import monotonic_ns

from onika.host.loading.loader_client import NotYet
from onika.host.loading.plan_preparation import Preparation
from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.recorded_variable import places_of
from onika.host.recording.recorded_worlds import RecordedDriver, RecordedWorlds
from onika.host.recording.recording_place import InProcessWriter, RecordingWriter, WriterProcess, complaints, not_whole
from onika.host.recording.recording_sink import AddMessage, AddVariables, BeginRecording, FinishRecording
from onika.host.recording.run_description import RunDescriptions
from onika.host.run.application_run import ApplicationRun, variable_units
from onika.host.sessions.request_server import RequestServer
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.record import topics
from onika.record.run import ending
from onika.wire import event, request
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason_with_place

_LOOKS = 4
"""Periods of the fastest task between two looks, where entries keep few values; else every second look is enough."""
_UNTOLD = (event.LastSecondsKept, event.Result, event.Stood)
_FASTEST_NS, _SLOWEST_NS = 2_000_000, 20_000_000
END_NS = 5_000_000_000
"""How long the end of a run waits at most for its recording to be finished."""


class Recorder:
    """`begin` raises NotYet until whoever writes is up; `has_come` says when to try again."""

    def __init__(
        self, subsystems: Subsystems, seen: RecordedDriver, server: RequestServer, descriptions: RunDescriptions
    ) -> None:
        self._subsystems = subsystems
        self._seen = seen
        self._server = server
        self._descriptions = descriptions
        self._writer: RecordingWriter | None = None
        self._session = self._path = ""
        self._was_up = False
        self._forget()

    def _forget(self) -> None:
        self._began = -1
        self._names: tuple[str, ...] = ()
        self._units: dict[str, dict[str, str]] = {}
        self._met: dict[str, int] = {}
        self._worlds = RecordedWorlds(self._seen)
        self._end_at = 0
        self._complaint = NOTHING

    def _at_s(self) -> float:
        return round((self._seen.now - self._began) * 1e-9, 9)

    @property
    def application(self) -> str:
        """What is being recorded; empty: nothing."""
        if self._writer is None or self._began < 0 or self._end_at:
            return ""
        return next((run.application for run in self._subsystems.runs if run.names == self._names), "")

    def lost(self, session: str) -> None:
        """A session is gone."""
        if self._writer is not None and self._session == session and self._began < 0:
            self._close()  # it never began

    def begin(self, session: str, message: request.Begin, prepared: Preparation) -> Reason:
        """Open the recording of a run that is to begin now; why that cannot be, or nothing."""
        if self._session == session and self._began < 0 and self._path != message.record:
            self._close()  # it was asked for once, and the run refused
        if not message.record:
            return NOTHING
        if self._writer is None:
            refusal = self._open(session, message, prepared)
            if refusal:
                return refusal
        elif self._session != session or self._began >= 0:
            return Reason.of("host.records_another")
        refusal = self._refusal_of_pen()
        if refusal:
            self._close()
            return refusal
        self._start(prepared)
        return NOTHING

    def give_up(self) -> None:
        """The run does not begin after all."""
        if self._writer is not None:
            self._close()

    def _refusal_of_pen(self) -> Reason:
        """Why whoever writes cannot; raises NotYet until it is up."""
        writer = self._writer
        if writer is not None and writer.reason:
            return Reason.of("host.no_recording", why=writer.reason)
        if writer is not None and not writer.is_up:
            raise NotYet
        return NOTHING

    def _start(self, prepared: Preparation) -> None:
        """The recording begins, with the run."""
        self._names = tuple(flow.subsystem for flow in prepared.plan.flows)
        self._units = variable_units(prepared)
        self._began = self._seen.now
        if self._writer is not None:
            self._writer.take(BeginRecording(monotonic_ns()))
        self._server.overhear(self._hear)
        self._seen.each_instant(self._look)

    def has_come(self) -> bool:
        """Whether whoever writes has come up, or failed, since the last call."""
        if self._writer is None or self._was_up:
            return False
        self._writer.serve()
        self._was_up = self._writer.is_up or bool(self._writer.reason)
        return self._was_up

    def readers(self) -> Sequence[ProcessSocket]:
        """What to wait for."""
        return () if self._writer is None else self._writer.readers()

    def command(self, session: str, message: request.Request) -> None:
        """Something was asked and carried out."""
        if self._began >= 0 and isinstance(message, topics.STEERING) and not self._end_at:
            topic = topics.ANSWERS if isinstance(message, request.Reply) else topics.COMMANDS
            self._say(topic, topics.encode(topics.RequestRecord(self._seen.turn, session, message)))

    def serve(self) -> None:
        """Look after it, now and then."""
        if self._writer is not None and self._began >= 0:
            self._look()
            self._writer.serve()
            if self._writer.reason and not self._complaint:
                self._complaint = not_whole(self._writer.reason)
                self._server.tell(event.Warned(self._names[0], "", self._complaint, self._at_s()), self._names[0])

    def may_end(self, run: ApplicationRun, result: event.Result) -> bool:
        """Whether the end of a run may be told: its recording, if one is made, has to be finished by then."""
        writer = self._writer
        if writer is None or run.names != self._names or self._began < 0:
            return True
        if not self._end_at:
            self._look()
            self._say(topics.EVENTS, topics.encode(topics.EventRecord("", result)))
            self._end_at = monotonic_ns() + END_NS
            writer.take(FinishRecording(ending(result), writer.untold))
        writer.serve()
        if not writer.is_done and monotonic_ns() < self._end_at:
            return False
        for text in complaints(writer):
            if text != self._complaint:  # that one was told at once
                run.warn(text, self._at_s())
        self._close()
        return True

    # Inner

    def _open(self, session: str, message: request.Begin, prepared: Preparation) -> Reason:
        run = self._descriptions.describe(session, message)
        if run is None:
            return Reason.of("host.none_prepared")
        try:
            if self._seen.is_virtual:
                self._writer = InProcessWriter(message.record, run)
            else:
                self._writer = WriterProcess(message.record, run, _every_ns(prepared), self._seen.with_fifo)
        except OSError as wrong:
            return Reason.of("host.no_recording", why=system_reason_with_place(wrong))
        self._session, self._path, self._was_up = session, message.record, False
        return NOTHING

    def _close(self) -> None:
        if self._began >= 0:
            self._server.leave(self._hear)
        self._seen.leave_instants(self._look)
        if self._writer is not None:
            self._writer.close()
        self._writer, self._session = None, ""
        self._forget()

    def _hear(self, message: event.Event, subsystem: str) -> None:
        is_ours = not subsystem or subsystem in self._names
        if is_ours and not self._end_at and not isinstance(message, _UNTOLD):
            self._say(topics.EVENTS, topics.encode(topics.EventRecord(subsystem, message)))

    def _say(self, topic: str, body: bytes) -> None:
        if self._writer is not None:
            self._writer.take(AddMessage(topic, max(self._seen.now - self._began, 0), body))

    def _look(self) -> None:
        """What has come since the last time: variables, worlds; in virtual time the values too."""
        writer, now = self._writer, self._seen.now - self._began
        if writer is None or self._end_at:
            return
        for name in self._names:
            table = self._subsystems.tables.get(name)
            if table is not None and len(table.entries) != self._met.get(name, 0):
                self._meet(writer, name)
        writer.look(now)
        self._worlds.show(writer, now)

    def _meet(self, writer: RecordingWriter, name: str) -> None:
        table, known = self._subsystems.tables[name], self._met.get(name, 0)
        variables = places_of(table, known, self._units.get(name, {}))
        self._met[name] = known + len(variables)
        is_needed = not known or self._seen.is_virtual
        writer.take(AddVariables(name, variables), table.segment if is_needed else None)


def _every_ns(prepared: Preparation) -> int:
    """How often the tables of a run are looked at, in wall time."""
    rates = [task.frequency for flow in prepared.plan.flows for task in flow.tasks if task.frequency]
    return look_period_ns(
        [*rates, *(hz for flow in prepared.plan.flows for action in flow.actions for _, hz in action.rates)]
    )


def look_period_ns(rates: Iterable[float]) -> int:
    """How often tables are looked at beside tasks of these rates in hertz, in wall time."""
    return min(max(round(_LOOKS * 1e9 / max(rates, default=50.0)), _FASTEST_NS), _SLOWEST_NS)

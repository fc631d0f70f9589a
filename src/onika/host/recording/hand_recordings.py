"""Recordings of subsystems that are held by hand: begun and ended when somebody says so (requirement X05).

Each ends too where its subsystem does, where the runtime does, and where its file takes nothing more; whatever becomes
of it, the tasks go on.
"""

from collections.abc import Callable

from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.recorded_worlds import RecordedDriver
from onika.host.recording.recording_place import not_whole
from onika.host.recording.run_description import RunDescriptions
from onika.host.recording.subsystem_recording import SubsystemRecording
from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.host.subsystems.subsystem_registry import Subsystems, Tell
from onika.record import topics
from onika.wire import event, live, request
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason_with_place

MOST = 4
"""Recordings at a time: each is written by a process of its own."""
Answer = Callable[[request.Response], None]


class HandRecordings:
    """All of a runtime; one at a time of each subsystem."""

    def __init__(self, subsystems: Subsystems, seen: RecordedDriver, descriptions: RunDescriptions, tell: Tell) -> None:
        self._subsystems = subsystems
        self._seen = seen
        self._descriptions = descriptions
        self._tell = tell
        self._recordings: dict[str, SubsystemRecording] = {}
        self._answers: dict[str, list[Answer]] = {}
        """By subsystem, who waits until its recording has begun, or is written."""
        self._changed: set[str] = set()

    def ask(self, message: live.Record, answer: Answer) -> None:
        """Begin or end one; answered when it has begun, or is written."""
        self.serve()  # what is over makes room
        recording = self._recordings.get(message.subsystem)
        if message.path:
            refusal = self._refusal(message, recording) or self._open(message)
        elif recording is None:
            refusal = Reason.of("host.not_recorded", subsystem=message.subsystem)
        else:
            refusal = NOTHING
            self._end(recording, NOTHING)
        if refusal:
            answer(request.Refused(refusal))
            return
        self._answers.setdefault(message.subsystem, []).append(answer)
        self.serve()

    def hear(self, message: event.Event, subsystem: str) -> None:
        """Something is told."""
        if isinstance(message, event.Edited):
            self._changed.add(message.subsystem)
        for recording in self._recordings.values():
            recording.hear(message, subsystem)

    def command(self, session: str, message: request.Request) -> None:
        """Something was asked and carried out."""
        if isinstance(message, topics.STEERING):
            for recording in self._recordings.values():
                recording.command(session, message)

    def serve(self) -> None:
        """Look after them, now and then."""
        for name, recording in list(self._recordings.items()):
            recording.serve()
            if not recording.is_begun:
                self._begin_if_up(name, recording)
            elif recording.is_ending:
                self._close_if_over(name, recording)
            else:
                self._judge(name, recording)
        self._changed.clear()

    def readers(self) -> list[ProcessSocket]:
        """What to wait for."""
        return [reader for recording in self._recordings.values() for reader in recording.readers()]

    def finish(self) -> None:
        """The runtime ends, and they with it."""
        for recording in self._recordings.values():
            if recording.is_begun and not recording.is_ending:
                recording.end(Reason.of("host.runtime_ended_first"))
            recording.close()
        self._recordings.clear()

    # Inner

    def _refusal(self, message: live.Record, recording: SubsystemRecording | None) -> Reason:
        """Why none can begin there; nothing: it can."""
        run = self._subsystems.run_in(message.subsystem)
        by_hand = self._subsystems.live.get(message.subsystem)
        if run is not None:
            return Reason.of("host.not_recorded_by_hand", application=run.application, subsystem=message.subsystem)
        if by_hand is None or by_hand.is_empty:
            return Reason.of("host.nothing_to_record", subsystem=message.subsystem)
        if recording is not None:
            return Reason.of("host.recorded_already", subsystem=message.subsystem, path=recording.path)
        if len(self._recordings) >= MOST:
            return Reason.of("host.too_many_recordings", most=MOST)
        if message.path in (other.path for other in self._recordings.values()):
            return Reason.of("host.file_recorded_into", path=message.path)
        return NOTHING

    def _open(self, message: live.Record) -> Reason:
        by_hand = self._subsystems.live[message.subsystem]
        about = self._descriptions.describe_by_hand(by_hand)
        try:
            recording = SubsystemRecording(by_hand, message.path, about, self._seen)
        except OSError as wrong:
            return Reason.of("host.no_recording", why=system_reason_with_place(wrong))
        self._recordings[message.subsystem] = recording
        return NOTHING

    def _begin_if_up(self, name: str, recording: SubsystemRecording) -> None:
        if recording.reason:
            del self._recordings[name]
            recording.close()
            self._answer(name, request.Refused(Reason.of("host.no_recording", why=recording.reason)))
        elif recording.is_up:
            recording.begin()
            recording.live.recording = recording.path
            self._say(recording, NOTHING, is_on=True)
            self._answer(name, request.Done())

    def _judge(self, name: str, recording: SubsystemRecording) -> None:
        """Whether it goes on."""
        by_hand = recording.live
        if recording.reason:
            self._end(recording, not_whole(recording.reason))
        elif self._subsystems.live.get(name) is not by_hand or by_hand.is_empty:
            self._end(recording, Reason.of("host.recorded_is_gone", subsystem=name))
        elif name in self._changed:
            wrong = recording.describe(self._descriptions.describe_by_hand(by_hand))
            if wrong:
                by_hand.warn("", not_whole(wrong))

    def _end(self, recording: SubsystemRecording, cause: Reason) -> None:
        if not recording.is_begun or recording.is_ending:
            return
        recording.end(cause)
        recording.live.recording = ""
        self._say(recording, cause, is_on=False)

    def _close_if_over(self, name: str, recording: SubsystemRecording) -> None:
        if not recording.is_over:
            return
        del self._recordings[name]
        was_told = bool(recording.reason)
        for complaint in recording.close():
            if not was_told or complaint != not_whole(recording.reason):
                self._warn(recording.live, complaint)
        self._answer(name, request.Done())

    def _answer(self, name: str, response: request.Response) -> None:
        for answer in self._answers.pop(name, []):
            answer(response)

    def _say(self, recording: SubsystemRecording, cause: Reason, *, is_on: bool) -> None:
        by_hand = recording.live
        at_s, lasted_s = by_hand.executor.seconds(self._seen.now), 0.0 if is_on else recording.lasted_s
        told = event.Recording(by_hand.name, at_s, recording.path, is_on, cause, lasted_s)
        self._tell(told, by_hand.name, by_hand.holder)

    def _warn(self, by_hand: LiveSubsystem, text: Reason) -> None:
        warned = event.Warned(by_hand.name, "", text, by_hand.executor.seconds(self._seen.now))
        self._tell(warned, by_hand.name, by_hand.holder)

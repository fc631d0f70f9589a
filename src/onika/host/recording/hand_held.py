"""Subsystems that are held by hand, as far as a black box is concerned (requirement X05).

Nothing that is held by hand has an end that could go badly. So its last seconds are held from the first task that comes
ON until nothing has been ON for as long as they reach, and are written where something goes wrong meanwhile: a task
fails at work, a drive trips, a process is gone, everything is stopped, its holder falls silent. What follows from that
belongs to the same incident.
"""

from collections import deque
from pathlib import Path

from msgspec.structs import replace

from onika.host.recording.black_box import BlackBox
from onika.host.recording.boxed_subject import Incident
from onika.host.recording.last_seconds import LASTS_NS
from onika.host.recording.run_description import RunDescriptions
from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.host.subsystems.subsystem_registry import DEVICE_SERVER, Subsystems, Tell
from onika.host.units.driver_clock import DriverClock
from onika.record.run import RunRecord
from onika.wire import event
from onika.words.reason import NOTHING, Reason

SETTLES_NS = 500_000_000
"""In wall time: what comes so soon after something has gone wrong is written with it."""
_JUST_NS = 1_000_000_000
"""Who was ON so shortly ago was at work."""
MOST_INCIDENTS, WITHIN_NS = 4, 600_000_000_000
"""Of a runtime so many are written in such a time: who tries again and again must not lose what happened before."""
_TRIPPED = ("TRIPPED", "PRESSED")


class HandHeldSubject:
    """One subsystem that is held by hand, from the first task that comes ON."""

    is_ended_at_wish = True

    def __init__(self, live: LiveSubsystem, about: RunRecord, tell: Tell) -> None:
        self.live = live
        self.about = about
        self.application = live.name
        self.names = (live.name,)
        self.on_at = 0
        """When something was ON last."""
        self.incident: Incident | None = None
        """What is still to be written."""
        self.incident_at = 0
        self._tell = tell

    @property
    def variable_units(self) -> dict[str, dict[str, str]]:
        """The units of its variables by name."""
        return {self.live.name: {port.svar: port.unit for wired in self.live.wired for port in wired.ports}}

    @property
    def is_on(self) -> bool:
        """Whether a task is ON, or would be if somebody answered it."""
        return any(self.live.is_on(task) for task in self.live.members)

    def warn(self, text: Reason, at_s: float) -> None:
        """Tell whoever watches that its last seconds are not kept; its events count from the runtime's start."""
        del at_s
        self.live.warn("", text)

    def name_black_box(self, subsystem: str, at_s: float, path: Path) -> None:
        """Tell where the last seconds before an incident stand."""
        self._tell(event.LastSecondsKept(subsystem, at_s, str(path)), self.live.name, self.live.holder)


class HandHeld:
    """All of a runtime."""

    def __init__(
        self,
        black_box: BlackBox,
        subsystems: Subsystems,
        descriptions: RunDescriptions,
        driver: DriverClock,
        tell: Tell,
    ) -> None:
        self._black_box = black_box
        self._subsystems = subsystems
        self._descriptions = descriptions
        self._driver = driver
        self._tell = tell
        self._subjects: list[HandHeldSubject] = []
        self._changed: set[str] = set()
        self._written_at: deque[int] = deque(maxlen=MOST_INCIDENTS)

    def hear(self, message: event.Event, subsystem: str) -> None:
        """Something is told."""
        live = self._subsystems.live.get(subsystem)
        if live is not None:
            self._follow(live, message)
        self._black_box.hear(message, subsystem)
        for subject in self._subjects:
            if subject.incident is None and subsystem in ("", subject.live.name) and self._is_at_work(subject):
                cause = incident_cause(message, subject.live)
                if cause:
                    now = self._driver.now
                    subject.incident = Incident(subject.live.name, cause, subject.live.executor.seconds(now))
                    subject.incident_at = now

    def serve(self) -> None:
        """Have written what is to be, and let go of what nobody works with any more."""
        for subject in list(self._subjects):
            if subject.is_on:
                subject.on_at = self._driver.now
            if subject.live.name in self._changed:
                self._describe(subject)
            if subject.incident is not None and self._driver.now >= self._due(subject):
                self._keep(subject, subject.incident)
            elif self._is_over(subject):
                self._forget(subject)
        self._changed.clear()

    def due_ns(self) -> int | None:
        """How long until something is to be written; None: nothing is."""
        waiting = [self._due(subject) for subject in self._subjects if subject.incident is not None]
        return max(min(waiting) - self._driver.now, 0) if waiting else None

    def finish(self) -> None:
        """The runtime ends: what is still to be written is written."""
        for subject in list(self._subjects):
            if subject.incident is not None:
                self._keep(subject, subject.incident)
            self._forget(subject)

    # Inner

    def _follow(self, live: LiveSubsystem, message: event.Event) -> None:
        """A task that comes ON has its last seconds held; what an edit has changed is described anew."""
        if isinstance(message, event.Edited):
            self._changed.add(live.name)
        elif isinstance(message, event.TaskState) and live.is_on(message.task):
            self._hold(live)

    def _hold(self, live: LiveSubsystem) -> None:
        subject = next((subject for subject in self._subjects if subject.live is live), None)
        if subject is None:
            subject = HandHeldSubject(live, self._descriptions.describe_by_hand(live), self._tell)
            self._subjects.append(subject)
        subject.on_at = self._driver.now
        if not self._black_box.holds(subject):
            self._black_box.begin(subject, subject.about)

    def _is_at_work(self, subject: HandHeldSubject) -> bool:
        return subject.is_on or self._driver.now - subject.on_at <= _JUST_NS

    def _describe(self, subject: HandHeldSubject) -> None:
        about = replace(self._descriptions.describe_by_hand(subject.live), began=subject.about.began)
        if about != subject.about and about.prepare.plan.flows[0].tasks:  # of what is closed, as it was last
            subject.about = about
            self._black_box.describe(subject, about)

    def _due(self, subject: HandHeldSubject) -> int:
        return subject.incident_at + (0 if self._driver.is_virtual else SETTLES_NS)

    def _keep(self, subject: HandHeldSubject, incident: Incident) -> None:
        now, subject.incident = self._driver.now, None
        if len(self._written_at) == MOST_INCIDENTS and now - self._written_at[0] < WITHIN_NS:
            return
        self._written_at.append(now)
        self._black_box.keep(subject, incident)

    def _is_over(self, subject: HandHeldSubject) -> bool:
        """Whether nothing can go wrong any more that would have begun in what is held of it."""
        if self._black_box.is_writing(subject):
            return False
        is_gone = self._subsystems.live.get(subject.live.name) is not subject.live
        return is_gone or self._driver.now - subject.on_at > LASTS_NS

    def _forget(self, subject: HandHeldSubject) -> None:
        self._subjects.remove(subject)
        self._black_box.forget(subject)


def incident_cause(message: event.Event, live: LiveSubsystem) -> Reason:
    """Why something goes wrong with this in a subsystem at work; nothing: it does not."""
    match message:
        case event.Failed() if live.is_on(message.task) or message.entry == "on":
            return Reason.of("host.of_task", task=message.task, why=message.text)
        case event.Stopped() if message.is_stopped:
            return message.cause
        case event.Held() if message.cause.key == "host.holder_silent":  # who says good-bye wants it to end
            return message.cause
        case event.Lost() if _concerns(message, live):
            return message.cause
        case event.Drive() if message.state in _TRIPPED and _drives(message.device, live):
            return Reason.of("host.of_drive", device=message.device, why=message.cause)
    return NOTHING


def _concerns(message: event.Lost, live: LiveSubsystem) -> bool:
    """Whether a process that is gone had to do with what is ON here: its unit, or the one of devices."""
    on = [member for task, member in live.members.items() if live.is_on(task)]
    if message.name == DEVICE_SERVER:
        return any(member.wired.sheet.hardware for member in on)
    return any(member.rtpu == message.name for member in on)


def _drives(device: str, live: LiveSubsystem) -> bool:
    return any(live.is_on(task) and member.wired.device == device for task, member in live.members.items())

"""The black box of a runtime: the last seconds of all that it executes, written where it goes badly (requirement X05).

A run ends badly where it does not complete, unless somebody has ended it as he wished and nothing had gone wrong; what
is held by hand has no end of its own (`hand_held`). What is held costs little (`last_seconds`); what ends well leaves
nothing behind.
"""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from time import monotonic_ns
from typing import Protocol

from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.black_box_holder import BlackBoxHolder
from onika.host.recording.black_box_orders import BlackBoxWritten, CloseBlackBox, KeepBlackBox, OpenBlackBox
from onika.host.recording.boxed_subject import BoxedSubject, Incident, incident_of, is_fault, standing_of
from onika.host.recording.last_seconds import TracedEvent
from onika.host.recording.met_variables import MetVariables
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.units.driver_clock import DriverClock
from onika.record import topics
from onika.record.black_box_folder import black_box_path, fault_path
from onika.record.run import RunRecord, ending, standing
from onika.wire import event, request
from onika.words.reason import Reason, reason_of

LOOKED_EVERY_NS = 28_000_000
"""An entry keeps sixty-three values; of what is written 500 times a second nothing is missed, nor if looks are late."""
_PATIENCE_NS = 1_000_000_000
"""How long the end of a run waits until its black box is written; it may be written later all the same."""
_UNTOLD = (event.Company, event.Stood, event.LastSecondsKept, event.Result)
MOST_FAULTS = 4
"""Of a run that goes on after each fault so many first ones have a black box; of the others only its end."""


class BoxedDriver(DriverClock, Protocol):
    """The driver, as far as a black box looks at it."""

    def each_instant(self, look: Callable[[], None]) -> None:
        """In virtual time: call this one too at the end of every instant."""
        ...


@dataclass(slots=True)
class _Box:
    """Of one run, or of one subsystem that is held by hand."""

    number: int
    path: Path
    began: int
    names: tuple[str, ...]
    met: dict[str, MetVariables]
    has_fault: bool = False
    unkept: Incident | None = None
    """The standstill before which the last seconds are still to be written, while the run goes on."""
    faults: list[Incident] = field(default_factory=list)
    """Those before which they were, in the order of their files."""
    answered: int = 0
    """Of how many of them it is known what became of their files."""
    closed_at: int = 0
    """When its end was told to whoever holds it; 0: it is open."""
    why_not: Reason | None = None
    """Why it could not be written; nothing: it is; None: nobody has said yet."""


class BlackBox:
    """All of a runtime. `make_holder` makes another holder where the first is gone."""

    def __init__(
        self,
        folder: Path,
        holder: BlackBoxHolder,
        make_holder: Callable[[], BlackBoxHolder],
        subsystems: Subsystems,
        driver: BoxedDriver,
    ) -> None:
        self._folder = folder
        self._make_holder = make_holder
        self._holder = holder
        self._subsystems = subsystems
        self._driver = driver
        self._boxes: dict[BoxedSubject, _Box] = {}
        self._count = 0
        self._look_at = 0
        driver.each_instant(self._look)

    def begin(self, run: BoxedSubject, about: RunRecord) -> None:
        """It begins now."""
        if self._holder.is_lost:
            self._lose()
            self._holder = self._make_holder()
        self._count += 1
        path = black_box_path(self._folder, run.application, datetime.now(UTC), os.getpid(), self._count)
        met = {name: MetVariables(name, self._subsystems.tables[name]) for name in run.names}
        box = _Box(self._count, path, self._driver.now, run.names, met)
        began = self._driver.now if self._driver.is_virtual else monotonic_ns()
        try:
            self._holder.open(OpenBlackBox(box.number, str(path), began, LOOKED_EVERY_NS), about)
        except OSError as refused:  # no memory to share, or no descriptor: the run goes on without
            run.warn(Reason.of("host.no_black_box", why=reason_of(refused)), 0.0)
            return
        self._boxes[run] = box

    def hear(self, message: event.Event, subsystem: str) -> None:
        """Something is told."""
        boxes = [box for _, box in self._open_boxes() if not subsystem or subsystem in box.names]
        if not boxes or isinstance(message, _UNTOLD):
            return
        body = topics.encode(topics.EventRecord(subsystem, message))
        for box in boxes:
            box.has_fault |= is_fault(message)
            box.unkept = incident_of(message) or box.unkept
            self._note(box, topics.EVENTS, body, standing_of(message))

    def command(self, session: str, message: request.Request) -> None:
        """Something was asked and carried out."""
        if isinstance(message, topics.STEERING):
            topic = topics.ANSWERS if isinstance(message, request.Reply) else topics.COMMANDS
            body = topics.encode(topics.RequestRecord(self._driver.turn, session, topics.without_files(message)))
            for _, box in self._open_boxes():
                self._note(box, topic, body)

    def serve(self) -> None:
        """Look after it, now and then."""
        for run, box in self._open_boxes():
            self._meet(run, box)
            incident, box.unkept = box.unkept, None
            if incident is not None and len(box.faults) < MOST_FAULTS:
                self.keep(run, incident)
        for word in self._holder.written():
            for run, box in list(self._boxes.items()):
                if box.number == word.number:
                    self._learn(run, box, word)
        if self._holder.is_lost:
            self._lose()

    def keep(self, run: BoxedSubject, incident: Incident) -> None:
        """Have the last seconds before an incident written, while it goes on."""
        box = self._boxes.get(run)
        if box is None:
            return
        box.faults.append(incident)
        self._look_now(run, box)
        path = fault_path(box.path, len(box.faults))
        self._holder.keep(KeepBlackBox(box.number, str(path), standing(incident.cause)))

    def describe(self, run: BoxedSubject, about: RunRecord) -> None:
        """What it consists of has changed."""
        box = self._boxes.get(run)
        if box is None:
            return
        try:
            self._holder.describe(box.number, about)
        except OSError as refused:
            self._warn(run, box, reason_of(refused))

    def forget(self, run: BoxedSubject) -> None:
        """It is over, and nothing is to be written of it any more."""
        box = self._boxes.pop(run, None)
        if box is not None:
            self._holder.close(CloseBlackBox(box.number, is_kept=False, words={}))

    def is_writing(self, run: BoxedSubject) -> bool:
        """Whether it is not known yet where the last seconds before an incident stand."""
        box = self._boxes.get(run)
        return box is not None and box.answered < len(box.faults)

    def holds(self, run: BoxedSubject) -> bool:
        """Whether its last seconds are held."""
        return run in self._boxes

    def end(self, run: BoxedSubject, result: event.Result) -> str | None:
        """Where the last seconds of a run stand that is over; empty: it left none, None: that is not known yet."""
        box = self._boxes.get(run)
        if box is None:
            return ""
        if not box.closed_at:
            is_kept = not result.completed and (box.has_fault or not run.is_ended_at_wish)
            if is_kept:
                self._note(box, topics.EVENTS, topics.encode(topics.EventRecord("", result)))
            self._close(run, box, ending(result), is_kept=is_kept)
            if not is_kept:
                del self._boxes[run]
                return ""
        self.serve()
        if box.why_not is None and monotonic_ns() - box.closed_at < _PATIENCE_NS and run in self._boxes:
            return None
        self._boxes.pop(run, None)
        if box.why_not:
            self._warn(run, box, box.why_not)
            return ""
        return str(box.path)

    def readers(self) -> Sequence[ProcessSocket]:
        """What to wait for."""
        return self._holder.readers()

    def finish(self) -> None:
        """The runtime ends; runs that are not over end with it."""
        words = {"completed": "no", "cause": str(Reason.of("host.runtime_ended_first")), "hash": "", "outside": ""}
        for run, box in self._boxes.items():
            if not box.closed_at:
                self._close(run, box, words, is_kept=box.has_fault or not run.is_ended_at_wish)
        self._holder.end()

    # Inner

    def _open_boxes(self) -> list[tuple[BoxedSubject, _Box]]:
        return [(run, box) for run, box in self._boxes.items() if not box.closed_at]

    def _learn(self, run: BoxedSubject, box: _Box, word: BlackBoxWritten) -> None:
        """A file of it is written, or why not."""
        if word.path == str(box.path):
            box.why_not = word.reason
            return
        box.answered += 1
        if word.reason:
            self._warn(run, box, word.reason)
        else:
            for number, incident in enumerate(box.faults, 1):
                path = fault_path(box.path, number)
                if word.path == str(path):
                    run.name_black_box(incident.subsystem, incident.at_s, path)

    def _warn(self, run: BoxedSubject, box: _Box, why: Reason) -> None:
        run.warn(Reason.of("host.no_black_box", why=why), (self._driver.now - box.began) * 1e-9)

    def _look_now(self, run: BoxedSubject, box: _Box) -> None:
        self._meet(run, box)
        if self._driver.is_virtual:
            self._holder.look(self._driver.now)

    def _close(self, run: BoxedSubject, box: _Box, words: dict[str, str], *, is_kept: bool) -> None:
        self._look_now(run, box)
        box.closed_at = monotonic_ns()
        self._holder.close(CloseBlackBox(box.number, is_kept, words))

    def _note(self, box: _Box, topic: str, body: bytes, standing: str = "") -> None:
        at = max(self._driver.now - box.began, 0)
        self._holder.take(TracedEvent(topic, at, body, standing), box.number)

    def _meet(self, run: BoxedSubject, box: _Box) -> None:
        """Variables that have come, or gone."""
        for name, met in box.met.items():
            order = met.news(run.variable_units.get(name, {}))
            if order is not None:
                self._holder.take(order, box.number, met.memory)

    def _look(self) -> None:
        """In virtual time: at the end of an instant."""
        now = self._driver.now
        if now >= self._look_at and self._boxes:
            self._look_at = now + LOOKED_EVERY_NS
            for run, box in self._open_boxes():
                self._meet(run, box)
            self._holder.look(now)

    def _lose(self) -> None:
        """Whoever held the last seconds is gone, and they with it; those who run are told once."""
        why = Reason.of("host.black_box_gone")
        for run, box in list(self._boxes.items()):
            if not box.closed_at:
                self._warn(run, box, why)
            del self._boxes[run]

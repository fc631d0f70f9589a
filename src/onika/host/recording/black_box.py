"""The black box of a runtime: the last seconds of each run, written where it ends badly (requirement X05).

A run ends badly where it does not complete, unless somebody has ended it as he wished and nothing had gone wrong. What
is held costs little (`last_seconds`); what ends well leaves nothing behind.
"""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from time import monotonic_ns
from typing import Protocol

from onika.host.recording.black_box_holder import BlackBoxHolder
from onika.host.recording.black_box_orders import BlackBoxWritten, CloseBlackBox, KeepBlackBox, OpenBlackBox
from onika.host.recording.last_seconds import TracedEvent, TracedVariables
from onika.host.recording.recorded_variable import places_of
from onika.host.run.application_run import ApplicationRun
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.units.driver_clock import DriverClock
from onika.host.units.process_socket import ProcessSocket
from onika.record import topics
from onika.record.black_box_folder import black_box_path, fault_path
from onika.record.run import RunRecord, ending, standing
from onika.wire import event, request
from onika.words.reason import Reason, reason_of

LOOKED_EVERY_NS = 28_000_000
"""An entry keeps fifteen values; of what is written 500 times a second nothing is missed."""
_PATIENCE_NS = 1_000_000_000
"""How long the end of a run waits until its black box is written; it may be written later all the same."""
_TRIPPED = ("TRIPPED", "PRESSED")
_UNTOLD = (event.Company, event.Stood, event.LastSecondsKept, event.Result)
_HARMLESS = ("asking", "user")
"""Kinds of standstills in which nothing has gone wrong."""
MOST_FAULTS = 4
"""Of a run that goes on after each fault so many first ones have a black box; of the others only its end."""


class BoxedDriver(DriverClock, Protocol):
    """The driver, as far as a black box looks at it."""

    def each_instant(self, look: Callable[[], None]) -> None:
        """In virtual time: call this one too at the end of every instant."""
        ...


@dataclass(slots=True)
class _Box:
    """Of one run."""

    number: int
    path: Path
    began: int
    names: tuple[str, ...]
    units: dict[str, dict[str, str]]
    met: dict[str, int] = field(default_factory=dict)
    has_fault: bool = False
    unkept: event.Explained | None = None
    """The standstill before which the last seconds are still to be written, while the run goes on."""
    faults: list[event.Explained] = field(default_factory=list)
    """Those before which they were, in the order of their files."""
    closed_at: int = 0
    """When its end was told to whoever holds it; 0: it is open."""
    why_not: Reason | None = None
    """Why it could not be written; nothing: it is; None: nobody has said yet."""


class BlackBox:
    """All runs of a runtime. `make_holder` makes another holder where the first is gone."""

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
        self._boxes: dict[ApplicationRun, _Box] = {}
        self._count = 0
        self._look_at = 0
        driver.each_instant(self._look)

    def begin(self, run: ApplicationRun, about: RunRecord) -> None:
        """A run begins now."""
        if self._holder.is_lost:
            self._lose()
            self._holder = self._make_holder()
        self._count += 1
        names = run.names
        path = black_box_path(self._folder, run.application, datetime.now(UTC), os.getpid(), self._count)
        box = _Box(self._count, path, self._driver.now, names, run.variable_units)
        began = self._driver.now if self._driver.is_virtual else monotonic_ns()
        try:
            self._holder.open(OpenBlackBox(box.number, str(path), began, LOOKED_EVERY_NS), about)
        except OSError as refused:  # no memory to share, or no descriptor: the run goes on without
            run.warn(Reason.of("host.no_black_box", why=reason_of(refused)), 0.0)
            return
        self._boxes[run] = box

    def hear(self, message: event.Event, subsystem: str) -> None:
        """Something is told."""
        boxes = [box for box in self._open_boxes() if not subsystem or subsystem in box.names]
        if not boxes or isinstance(message, _UNTOLD):
            return
        body = topics.encode(topics.EventRecord(subsystem, message))
        for box in boxes:
            box.has_fault |= _is_fault(message)
            if isinstance(message, event.Explained) and message.choices and _is_fault(message):
                box.unkept = message
            self._note(box, topics.EVENTS, body, _standing(message))

    def command(self, session: str, message: request.Request) -> None:
        """Something was asked and carried out."""
        if isinstance(message, topics.STEERING):
            topic = topics.ANSWERS if isinstance(message, request.Reply) else topics.COMMANDS
            body = topics.encode(topics.RequestRecord(self._driver.turn, session, message))
            for box in self._open_boxes():
                self._note(box, topic, body)

    def serve(self) -> None:
        """Look after it, now and then."""
        for box in self._open_boxes():
            self._meet(box)
            self._keep(box)
        for word in self._holder.written():
            for run, box in list(self._boxes.items()):
                if box.number == word.number:
                    self._learn(run, box, word)
        if self._holder.is_lost:
            self._lose()

    def end(self, run: ApplicationRun, result: event.Result) -> str | None:
        """Where the last seconds of a run stand that is over; empty: it left none, None: that is not known yet."""
        box = self._boxes.get(run)
        if box is None:
            return ""
        if not box.closed_at:
            is_kept = not result.completed and (box.has_fault or not run.is_ended_at_wish)
            if is_kept:
                self._note(box, topics.EVENTS, topics.encode(topics.EventRecord("", result)))
            self._close(box, ending(result), is_kept=is_kept)
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
                self._close(box, words, is_kept=box.has_fault or not run.is_ended_at_wish)
        self._holder.end()

    # Inner

    def _open_boxes(self) -> list[_Box]:
        return [box for box in self._boxes.values() if not box.closed_at]

    def _keep(self, box: _Box) -> None:
        """Have the last seconds before a standstill written, while the run goes on."""
        explained, box.unkept = box.unkept, None
        if explained is None or len(box.faults) == MOST_FAULTS:
            return
        box.faults.append(explained)
        self._look_now(box)
        path = fault_path(box.path, len(box.faults))
        self._holder.keep(KeepBlackBox(box.number, str(path), standing(explained)))

    def _learn(self, run: ApplicationRun, box: _Box, word: BlackBoxWritten) -> None:
        """A file of it is written, or why not."""
        if word.path == str(box.path):
            box.why_not = word.reason
        elif word.reason:
            self._warn(run, box, word.reason)
        else:
            for number, explained in enumerate(box.faults, 1):
                path = fault_path(box.path, number)
                if word.path == str(path):
                    run.name_black_box(explained, path)

    def _warn(self, run: ApplicationRun, box: _Box, why: Reason) -> None:
        run.warn(Reason.of("host.no_black_box", why=why), (self._driver.now - box.began) * 1e-9)

    def _look_now(self, box: _Box) -> None:
        self._meet(box)
        if self._driver.is_virtual:
            self._holder.look(self._driver.now)

    def _close(self, box: _Box, words: dict[str, str], *, is_kept: bool) -> None:
        self._look_now(box)
        box.closed_at = monotonic_ns()
        self._holder.close(CloseBlackBox(box.number, is_kept, words))

    def _note(self, box: _Box, topic: str, body: bytes, standing: str = "") -> None:
        at = max(self._driver.now - box.began, 0)
        self._holder.take(TracedEvent(topic, at, body, standing), box.number)

    def _meet(self, box: _Box) -> None:
        """Variables that have come."""
        for name in box.names:
            table, before = self._subsystems.tables.get(name), box.met.get(name, 0)
            if table is not None and len(table.entries) > before:
                new = places_of(table, before, box.units.get(name, {}))
                box.met[name] = before + len(new)
                self._holder.take(TracedVariables(name, new), box.number, table.segment)

    def _look(self) -> None:
        """In virtual time: at the end of an instant."""
        now = self._driver.now
        if now >= self._look_at and self._boxes:
            self._look_at = now + LOOKED_EVERY_NS
            for box in self._open_boxes():
                self._meet(box)
            self._holder.look(now)

    def _lose(self) -> None:
        """Whoever held the last seconds is gone, and they with it; those who run are told once."""
        why = Reason.of("host.black_box_gone")
        for run, box in list(self._boxes.items()):
            if not box.closed_at:
                self._warn(run, box, why)
            del self._boxes[run]


def _is_fault(message: event.Event) -> bool:
    """Whether a run that has known this ends badly whoever ends it."""
    match message:
        case event.Failed() | event.Lost():
            return True
        case event.Stopped():
            return message.is_stopped
        case event.Explained():
            return message.kind not in _HARMLESS
        case event.Drive():
            return message.state in _TRIPPED
    return False


def _standing(message: event.Event) -> str:
    """What an event says something about that holds until another one says otherwise; empty: it passes."""
    match message:
        case event.TaskState():
            return f"task {message.subsystem}/{message.task}"
        case event.Moved():
            return f"flow {message.subsystem}"
        case event.Began() | event.Done():
            return f"action {message.flow}"
        case event.Drive():
            return f"drive {message.device}"
        case event.Failed():
            return f"failure {message.subsystem}/{message.task}"
        case event.Lost():
            return f"loss {message.name}"
    return ""

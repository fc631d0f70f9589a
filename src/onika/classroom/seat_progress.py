"""How the learner at a seat gets on, as its environment sees it: what was done last, what was refused, what runs (X25).

No I/O; the time is handed in, in seconds that never go back.
"""

import re
from collections.abc import Callable

from onika.classroom.messages import SeatStanding
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.model import Model
from onika.web.access.act_rights import WATCHING
from onika.wire import act
from onika.words.reason import NOTHING, Reason

LESSON = "pass_lesson"
"""What a page notes of a course: the course, and how many of its lessons are done, of how many."""
_COURSE = re.compile(r"[a-z]{1,20}")
_NUMBER = re.compile(r"[0-9]{1,3}")
_NO_STEP: frozenset[type] = frozenset((*WATCHING, act.Note, act.Open, act.Peek, act.Close, act.Preflight, act.WhatIf))
"""Acts that bring no program further."""


class SeatProgress:
    """Follows what is done at a seat."""

    def __init__(self, model: Callable[[], Model], clock: Callable[[], float]) -> None:
        self._model = model
        self._clock = clock
        self._doc = ""
        self._steps = 0
        self._forward_s = clock()
        self._refusal: Reason = NOTHING
        self._refused_s = 0.0
        self._course = ("", 0, 0)

    def begun(self, command: act.AnyAct, _by: str) -> Callable[[ActAnswer], None]:
        """An act has begun; who is told how it ended."""
        return lambda given: self.acted(command, given)

    def acted(self, command: act.AnyAct, given: ActAnswer) -> None:
        """An act has ended."""
        if isinstance(command, act.Note):
            self._noted(command)
            return
        if type(command) in WATCHING:
            return
        doc = getattr(command, "doc", "")
        if doc in self._model().applications:
            self._doc = doc
        if given.no is not None:
            self.refused(given.no.reason)
        elif type(command) not in _NO_STEP:
            self._steps += 1
            self._forward_s = self._clock()

    def _noted(self, note: act.Note) -> None:
        """A lesson that is done is a step forward; a page that says anything else is not believed."""
        numbers = (note.associated, note.associated_id)
        if note.event != LESSON or not _COURSE.fullmatch(note.object) or not all(map(_NUMBER.fullmatch, numbers)):
            return
        before, (lessons, of) = self._course, map(int, numbers)
        self._course = (note.object, min(lessons, of), of)
        if before[0] == note.object and before[1] < lessons:
            self._forward_s = self._clock()

    def refused(self, reason: Reason) -> None:
        """Something was not done."""
        self._refusal, self._refused_s = reason, self._clock()

    def changed(self, before: Model, after: Model) -> None:
        """Whatever has changed: an action that was done is a step forward."""
        if before.run is not after.run and after.run is not None and _done(before.run) < _done(after.run):
            self._forward_s = self._clock()

    def came(self) -> None:
        """Somebody has opened the page after it was closed: nobody was stuck meanwhile."""
        self._forward_s = self._clock()

    def standing(self, pages: int, teachers: int) -> SeatStanding:
        """How it stands."""
        model, now_s = self._model(), self._clock()
        opened = model.applications.get(self._doc) or next(reversed(tuple(model.applications.values())), None)
        run = model.run
        course, lessons, lessons_of = self._course
        return SeatStanding(
            pages=pages,
            teachers=teachers,
            program="" if opened is None else opened.name,
            icons=0 if opened is None else sum(len(flow.steps) for flow in opened.application.flows),
            steps=self._steps,
            idle_s=now_s - self._forward_s,
            run="" if run is None else _state(run),
            done=0 if run is None else _done(run),
            of=0 if run is None else _of(run),
            why=NOTHING if run is None else _why(run),
            refusal=self._refusal,
            refusal_s=now_s - self._refused_s if self._refusal else 0.0,
            course=course,
            lessons=lessons,
            lessons_of=lessons_of,
        )


def _state(run: Run) -> str:
    if run.is_over:
        return "completed" if run.view.is_completed else "aborted"
    if run.view.state == "beginning":
        return "starting"
    return "stopped" if any(flow.state == "stopped" for flow in run.view.flows.values()) else "running"


def _done(run: Run | None) -> int:
    if run is None:
        return 0
    return max(run.view.done, sum(flow.done for flow in run.view.flows.values()))


def _of(run: Run) -> int:
    return max(run.view.of, sum(flow.of for flow in run.view.flows.values()))


def _why(run: Run) -> Reason:
    """Why it stands or has ended."""
    stop = next(iter(run.view.stops.values()), None)
    return run.view.cause if stop is None else stop.short or stop.text

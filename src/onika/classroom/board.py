"""What the teacher's board shows: one row for each seat, with what its learner does and what it costs (X25)."""

from typing import Any

from onika.classroom.attended_seat import AttendedSeat
from onika.classroom.room import ClassRoom
from onika.classroom.roster import Learner
from onika.wire.class_board import ClassBoard, ExpectationRow, SeatRow
from onika.words.reason import NOTHING

STUCK_S = 120.0
"""Without a step for so long while his page is open, a learner is said to be stuck."""


def board(room: ClassRoom, address: str) -> ClassBoard:
    """The board of a room."""
    rows = tuple(_row(learner, room.seat_of(learner)) for learner in room.roster.learners)
    return ClassBoard(room.roster.code, address, room.roster.seats, rows, room.trouble)


def _row(learner: Learner, seat: AttendedSeat) -> SeatRow:
    grade, at = learner.grade, seat.standing
    is_there: bool = seat.state == "there"
    state: Any = seat.state
    return SeatRow(
        seat=learner.seat,
        learner=learner.name,
        state=learner.state,
        process=state,
        pages=at.pages if is_there else 0,
        program=at.program,
        icons=at.icons,
        steps=at.steps,
        idle_s=at.idle_s,
        is_stuck=is_there and at.pages > 0 and at.idle_s > STUCK_S and not _has_excuse(learner, at.run),
        run=at.run,
        done=at.done,
        of=at.of,
        why=at.why,
        refusal=at.refusal,
        refusal_s=at.refusal_s,
        ended=seat.ended,
        note=learner.note,
        handed_in=learner.handed_in,
        expectations=() if grade is None else tuple(ExpectationRow(e.text, e.holds, e.why) for e in grade.expectations),
        grade_why=NOTHING if grade is None else grade.why,
        may_return=learner.may_return,
        bytes=seat.footprint.bytes,
        processes=len(seat.footprint.processes),
        course=at.course,
        lessons=at.lessons,
        lessons_of=at.lessons_of,
    )


def _has_excuse(learner: Learner, run: str) -> bool:
    """Whether he has done it all, may not do anything, or waits for a runtime that starts: twenty take their time."""
    return learner.is_done or learner.state != "works" or run == "starting"

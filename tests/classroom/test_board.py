import pytest

from onika.classroom import messages
from onika.classroom.board import STUCK_S, board
from onika.classroom.footprint import Footprint
from onika.classroom.roster import Grade, GradedExpectation, Learner, Roster
from onika.words.reason import NOTHING, Reason


class Seat:
    def __init__(self, state="there", **standing):
        self.state, self.ended, self.footprint = state, NOTHING, Footprint(5, 0.0, (1, 2))
        self.standing = messages.SeatStanding(**standing)


class Room:
    trouble = NOTHING

    def __init__(self, learner, seat):
        self.roster = Roster("ABCDEF", 4, (learner,))
        self.seat_of = lambda _learner: seat


def row(learner=None, state="there", **standing):
    (only,) = board(Room(learner or Learner("Ana", 2, "t"), Seat(state, **standing)), "http://h:1/").rows
    return only


def test_a_row_says_who_does_what_and_what_it_costs():  # R-X25
    said = Reason.of("class.act_closed")
    only = row(pages=1, program="go_home", icons=3, run="running", done=2, of=5, refusal=said, refusal_s=4.0)
    assert (only.seat, only.learner, only.program, only.icons) == (2, "Ana", "go_home", 3)
    assert (only.run, only.done, only.of, only.refusal, only.refusal_s) == ("running", 2, 5, said, 4.0)
    assert (only.bytes, only.processes) == (5, 2)
    of_course = row(course="loops", lessons=2, lessons_of=5)
    assert (of_course.course, of_course.lessons, of_course.lessons_of) == ("loops", 2, 5)


@pytest.mark.parametrize(
    ("pages", "idle_s", "state", "is_stuck"),
    [
        (1, STUCK_S + 1, "works", True),
        (1, 5.0, "works", False),
        (0, 999.0, "works", False),
        (1, 999.0, "frozen", False),
    ],
)
def test_stuck_is_who_has_his_page_open_may_work_and_makes_no_step(pages, idle_s, state, is_stuck):  # R-X25
    learner = Learner("Ana", 2, "t", state)
    assert row(learner, pages=pages, idle_s=idle_s).is_stuck is is_stuck


@pytest.mark.parametrize(("number", "holds", "is_stuck"), [(2, True, False), (2, False, True), (1, True, True)])
def test_nobody_is_stuck_whose_newest_hand_in_holds_what_is_expected(number, holds, is_stuck):  # R-X25
    grade = Grade(number, (GradedExpectation("LAMP == 1", holds=holds),))
    learner = Learner("Ana", 2, "t", handed_in=2, grade=grade)
    assert row(learner, pages=1, idle_s=STUCK_S + 1).is_stuck is is_stuck


def test_nobody_is_stuck_while_his_runtime_starts():  # R-X25
    assert not row(pages=1, idle_s=STUCK_S + 1, run="starting").is_stuck
    assert row(pages=1, idle_s=STUCK_S + 1, run="running").is_stuck


def test_of_a_seat_that_is_not_there_nobody_looks_at_a_page():
    assert row(state="silent", pages=3).pages == 0


def test_a_grade_is_shown_with_what_it_is_made_of():
    why = Reason.of("class.nothing_to_run")
    grade = Grade(1, (GradedExpectation("LAMP == 1", holds=False, why=why),))
    only = row(Learner("Ana", 2, "t", handed_in=1, grade=grade))
    assert [(one.text, one.holds, one.why) for one in only.expectations] == [("LAMP == 1", False, why)]

import pytest

from onika.classroom.seat_rights import SeatRights
from onika.link.caller import Role
from onika.web.access.act_rights import LEAST
from onika.web.access.entrance import Visitor
from onika.wire import act

ANA = Visitor("Ana", Role.OWNER, "learner")
TEACHER = Visitor("teacher", Role.OWNER, "teacher")
EDIT, STOP = act.RemoveIcons("a1", ()), act.Stop()


@pytest.fixture
def rights():
    return SeatRights(may_write_code=False)


def test_a_learner_works_and_the_teacher_watches(rights):  # R-X25
    assert not rights.refusal(ANA, EDIT)
    assert rights.refusal(TEACHER, EDIT).key == "class.teacher_watches"


@pytest.mark.parametrize(("state", "who"), [("frozen", ()), ("taken", (TEACHER,))])
def test_a_seat_that_is_frozen_or_taken_is_not_its_learners(rights, state, who):  # R-X25
    rights.state = state
    assert rights.refusal(ANA, EDIT).key == f"class.learner_{state}"
    assert [visitor for visitor in (ANA, TEACHER) if not rights.refusal(visitor, EDIT)] == list(who)


@pytest.mark.parametrize("state", ["works", "frozen", "taken"])
def test_stop_is_everybodys_always(rights, state):  # R-X25
    rights.state = state
    assert not rights.refusal(ANA, STOP)
    assert not rights.refusal(TEACHER, STOP)


CLOSED = [
    act.Connect("c1", "wss://robot:1"),
    act.AddStation("wss://robot:1", "", "cmu"),
    act.SetButton("b", "rm -rf ~", 0),
    act.Press("b"),
    act.TrustSite("s", ""),
]


@pytest.mark.parametrize("command", CLOSED, ids=lambda command: type(command).__name__)
def test_what_reaches_beyond_the_seat_is_closed_to_all(command):  # R-X25
    for is_open in (False, True):
        rights = SeatRights(may_write_code=is_open)
        assert rights.refusal(ANA, command).key == "class.act_closed"


def test_code_is_written_where_the_teacher_allows_it():
    command = act.NewModule("twice")
    assert SeatRights(may_write_code=False).refusal(ANA, command).key == "class.code_closed"
    assert not SeatRights(may_write_code=True).refusal(ANA, command)


def test_an_act_that_stands_in_no_row_is_nobodys(rights):
    class Unheard(act.Act, frozen=True):
        pass

    assert Unheard not in LEAST
    assert rights.refusal(ANA, Unheard()).key == "class.act_closed"

"""Stories of flows that meet those of other runtimes: what is agreed there is told to the engine as news."""

import pytest

from kit.plans import build
from onika.engine.news import (
    Abort,
    Agreed,
    BegunAlone,
    Cleared,
    Closed,
    Failed,
    Finished,
    Killed,
    Run,
    Settled,
    Spawned,
    TurnedOn,
)
from onika.engine.orders import (
    Began,
    Clear,
    Convene,
    Disperse,
    Done,
    Kill,
    Launch,
    Moved,
    Off,
    RunNote,
    Switch,
    Together,
)
from onika.wire.plan import Do, Halt, Meet
from onika.wire.steer import Pass, Pause, Recover, Resume, Skip
from onika.words.reason import Reason

REACH = build.job("arm", "reach", trigger="reach")
GRIP = build.job("arm", "grip", trigger="grip")
MEETS = [Do(0), Meet("x"), Do(1), Halt()]
GRIP_ON, ARM_ON = Launch("grip", "", 100.0), Launch("arm", "", 100.0)
ALONE = BegunAlone("x", Reason.plain("B did not begin"))


def engine(*flows, **given):
    """Flows of two actions that meet others at the tag x in between; everybody is spawned and begun."""
    made = build.engine(*flows or [build.flow([REACH, GRIP], MEETS)], shared=["x"], **given)
    orders = made.feed(Run())
    for order in orders:
        made.feed(Spawned(order.flow, order.task))
    return made


def be_on(made, flow, *tasks):
    for task in tasks:
        made.feed(TurnedOn(flow, task))


def come(made, flow=0):
    """The first action of a flow ends, and it comes to the tag."""
    be_on(made, flow, "arm", "reach")
    return made.feed(Finished(flow, "reach"))


def without_notes(orders):
    return [order for order in orders if not isinstance(order, Moved | Began | Done)]


@pytest.fixture
def made():
    return engine()


def test_flows_wait_at_a_shared_tag_until_others_agree():  # R-E04, R-F02
    made = engine()
    orders = come(made)
    switch = Switch(0, (), (GRIP_ON,))
    assert orders[-1] == Convene("x", (0,), (switch,))
    assert made.positions()[0].state == "waiting"
    assert str(orders[-2].text) == "waits for flows of other runtimes"
    assert without_notes(made.feed(Agreed("x", 4))) == [Switch(0, (), (GRIP_ON,), (), 4)]
    assert made.positions()[0].state == "running"


@pytest.mark.parametrize("is_ended", [False, True])
def test_what_was_agreed_and_is_told_when_the_application_ends_begins_nothing(is_ended):  # R-E12, law 25
    made = engine()
    come(made)
    killed = [order for order in made.feed(Abort(Reason.plain("enough"))) if isinstance(order, Kill)]
    for order in killed if is_ended else ():
        made.feed(Killed(order.flow, order.task))
    assert made.positions()[0].state == ("ended" if is_ended else "killing")
    assert not any(isinstance(order, Switch | Began) for order in made.feed(Agreed("x", 4)))
    assert made.positions()[0].state == ("ended" if is_ended else "killing")


def test_all_flows_of_this_runtime_are_convened_when_the_last_of_them_is_there():
    made = engine(build.flow([REACH, GRIP], MEETS), build.flow([REACH, GRIP], MEETS))
    assert not any(isinstance(order, Convene) for order in come(made, 1))
    assert come(made, 0)[-1].flows == (0, 1)
    orders = without_notes(made.feed(Agreed("x")))
    assert [type(order) for order in orders] == [Together, Switch, Switch]
    assert orders[0] == Together("x", (0, 1))


def test_no_action_ends_before_all_others_have_begun(made):  # R-F02, decision 56
    come(made)
    made.feed(Agreed("x"))
    be_on(made, 0, "grip")
    assert made.feed(Finished(0, "grip")) == []
    assert made.cases(0) == []
    orders = made.feed(Closed("x"))
    assert orders[0] == Done(0, 1)
    assert made.feed(Settled())


def test_once_all_have_begun_actions_end_as_ever_and_the_next_switch_is_prepared():
    made = engine(build.flow([REACH, GRIP, REACH], [*MEETS[:-1], Do(2), Halt()]))
    come(made)
    made.feed(Agreed("x"))
    be_on(made, 0, "grip")
    revision = made.revision(0)
    assert (made.cases(0), made.feed(Closed("x"))) == ([], [])
    assert made.revision(0) != revision
    assert len(made.cases(0)) == 1
    assert made.feed(Finished(0, "grip"))[0] == Done(0, 1)


def test_who_has_begun_alone_stops_and_meets_anew_when_he_recovers():  # R-E08, R-F02
    made = engine(stands_still=True)
    come(made)
    made.feed(Agreed("x"))
    be_on(made, 0, "grip")
    assert made.feed(Failed(0, "arm", Reason.plain("held")))[0] == Off(0, "grip")
    assert made.feed(ALONE)[-1].text == ALONE.cause
    assert made.positions()[0].state == "stopped"
    assert Clear(0, "arm") in made.feed(Recover("0"))
    orders = made.feed(Cleared(0, "arm"))
    assert without_notes(orders)[0] == Switch(0, (), (ARM_ON,))
    assert orders[-1].anew
    assert made.positions()[0].state == "waiting"
    be_on(made, 0, "arm")
    assert without_notes(made.feed(Agreed("x"))) == [Switch(0, (), (GRIP_ON,))]


def test_without_a_user_who_decides_who_has_begun_alone_ends_the_run(made):
    come(made)
    made.feed(Agreed("x"))
    assert {type(order) for order in made.feed(ALONE)} == {Kill}


HARMLESS = BegunAlone("x", Reason.plain("B did not begin"), drives=False)


@pytest.mark.parametrize("stands_still", [False, True])
def test_who_has_begun_alone_and_moves_nothing_waits_at_the_tag_again(stands_still):  # R-F02, decision 56
    made = engine(stands_still=stands_still)
    come(made)
    made.feed(Agreed("x"))
    be_on(made, 0, "grip")
    orders = made.feed(HARMLESS)
    assert orders[0] == RunNote(0, HARMLESS.cause)
    assert without_notes(orders[1:]) == [Off(0, "grip"), Convene("x", (0,), (Switch(0, (), (GRIP_ON,)),), anew=True)]
    assert made.positions()[0].state == "waiting"
    assert without_notes(made.feed(Agreed("x", 9))) == [Switch(0, (), (GRIP_ON,), (), 9)]


def test_flows_that_meet_again_are_convened_when_the_last_of_them_is_there():
    made = engine(build.flow([REACH, GRIP], MEETS), build.flow([REACH, GRIP], MEETS))
    come(made, 0)
    come(made, 1)
    made.feed(Agreed("x"))
    convened = [order.flows for order in made.feed(HARMLESS) if isinstance(order, Convene)]
    assert convened == [(0, 1)]


def test_a_flow_that_has_stopped_at_an_error_of_its_own_waits_for_its_user_all_the_same():  # R-E08
    made = engine(stands_still=True)
    come(made)
    made.feed(Agreed("x"))
    be_on(made, 0, "grip")
    made.feed(Failed(0, "arm", Reason.plain("broken")))
    made.feed(HARMLESS)
    assert made.positions()[0].state == "stopped"


def test_what_a_trigger_said_while_it_was_alone_ends_nothing():
    made = engine(stands_still=True)
    come(made)
    made.feed(Agreed("x"))
    be_on(made, 0, "grip")
    made.feed(Finished(0, "grip"))
    made.feed(ALONE)
    assert made.feed(Closed("x")) == []
    assert made.positions()[0].state == "stopped"


ELSEWHERE = [(Pause("0"), False), (Skip("0", 0), False), (Pass("0"), True)]


@pytest.mark.parametrize(("wanted", "was_there"), ELSEWHERE)
def test_who_is_sent_elsewhere_does_not_wait_for_others_any_more(made, wanted, was_there):  # R-E07, R-E13
    come(made)
    assert made.feed(wanted)[0] == Disperse("x", was_there)


def test_who_paused_at_the_tag_comes_to_it_again(made):
    come(made)
    made.feed(Pause("0"))
    assert made.feed(Resume("0"))[-1] == Convene("x", (0,), (Switch(0, (), (GRIP_ON,)),))


def test_while_a_flow_of_this_runtime_waits_on_those_that_are_let_pass_have_been_there():
    made = engine(build.flow([REACH, GRIP], MEETS), build.flow([REACH, GRIP], MEETS))
    come(made, 0)
    come(made, 1)
    assert not any(isinstance(order, Disperse) for order in made.feed(Pass("0")))
    assert made.feed(Pass("1"))[0] == Disperse("x", was_there=True)


def test_who_is_sent_elsewhere_after_he_has_begun_alone_has_been_there():
    made = engine(stands_still=True)
    come(made)
    made.feed(Agreed("x"))
    made.feed(ALONE)
    assert made.feed(Skip("0", 0))[0] == Disperse("x", was_there=True)


def test_a_switch_that_is_not_clear_beforehand_is_not_prepared():
    made = engine(build.flow([REACH, GRIP], [Do(0), Meet("x"), Meet("y"), Do(1), Halt()]))
    assert come(made)[-1] == Convene("x", (0,))
    made = engine()
    be_on(made, 0, "reach")  # the arm has not said yet that it is ON
    assert made.feed(Finished(0, "reach"))[-1] == Convene("x", (0,))

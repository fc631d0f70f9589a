import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.ring.displacement import Displacement
from onika.wire import act, live, request
from onika.words.reason import Reason

HOLDS = Reason.of(
    "workcell.hand_holds", hand=Reason.of("workcell.the_hand"), box=Reason.plain("the box with the triangle")
)

AWAY = Reason.of("workcell.arm_away", arm=Reason.of("workcell.the_arm"))


@pytest.fixture
def play(tmp_path):
    """Its task `a` drives a device of the world `cell`, in which the hand holds a box after a run."""
    play = RunFixture(tmp_path)
    play.files.plain_task("a", writes="A", local="DEVICE cell:arm\n")
    play.runtime.worlds = {"cell": True}
    play.doc = play.open([job("aC")])
    play.run(play.doc)
    play.runtime.displaced = {"cell": (Displacement(HOLDS), Displacement(AWAY, is_harmless=True))}
    play.end()
    play.pump()
    return play


def shown(play):
    return play.environment.tree.runtime.displaced


def test_what_is_not_at_its_place_is_shown_when_a_run_is_over_until_it_is_put_back(play):  # law 18
    assert shown(play) == {"cell": (HOLDS,)}
    play.do(act.PutBack())
    assert shown(play) == {}
    assert play.carried(live.PutBack) == [live.PutBack()]
    assert any(say.text.key == "run.workcell_is_back" for say in play.says)
    assert not any(order.reach is not None and order.reach.is_anew for order in play.orders)


def test_an_arm_that_ended_elsewhere_is_not_among_what_is_to_be_put_back(play):  # law 18, R-E16
    assert play.environment.tree.runtime.moved == {"cell": (AWAY,)}
    play.runtime.displaced = {"cell": (Displacement(AWAY, is_harmless=True),)}
    play.run(play.doc)
    play.end()
    play.pump()
    assert shown(play) == {}
    assert play.environment.tree.runtime.moved == {"cell": (AWAY,)}


def test_a_run_puts_back_what_it_needs_and_begins_at_one_press(play):  # law 18, R-E12
    play.runtime.worlds = {"cell": True, "shed": True}
    play.do(act.Run(play.doc, puts_back=True))
    assert play.carried(live.PutBack) == [live.PutBack(("cell",))]
    assert play.view.state == "running"
    order = [type(message) for message in play.carried_out]
    assert order.index(live.PutBack) < len(order) - 1 - order[::-1].index(request.Prepare)


def test_a_run_as_it_stands_puts_nothing_back(play):  # law 18
    play.do(act.Run(play.doc))
    assert play.carried(live.PutBack) == []


def test_of_a_real_workcell_it_is_told_what_a_person_has_to_do_and_nothing_begins(play):  # law 18
    play.runtime.worlds = {"cell": False}
    assert "put cell back by hand" in str(play.no(act.PutBack()).reason)
    no = play.answer(act.Run(play.doc, puts_back=True)).no
    assert "put cell back by hand" in str(no.reason)
    assert [remedy.act for remedy in no.remedies] == [act.Run(play.doc)]
    assert play.view.state == "over"


def test_beside_a_real_one_simulated_ones_are_put_back_and_the_rest_is_told(play):  # law 18, R-E09
    play.runtime.worlds = {"cell": True, "plant": False}
    play.do(act.PutBack())
    assert any("put plant back by hand" in str(say.text) and say.level == "warning" for say in play.says)


def test_what_is_driven_is_not_put_back_and_the_runtime_may_be_started_anew(play):  # law 18
    play.runtime.refusals = {"PutBack": Reason.plain("arm is ON")}
    no = play.no(act.PutBack())
    assert "arm is ON" in str(no.reason) and [remedy.act for remedy in no.remedies] == [act.StartAnew()]
    assert "arm is ON" in str(play.answer(act.Run(play.doc, puts_back=True)).no.reason)


def test_where_the_runtime_is_lost_another_is_started_and_where_none_is_nothing_moves(play, tmp_path):  # R-E10
    play.lose("killed")
    play.do(act.PutBack())
    assert any(order.reach is not None and order.reach.is_anew for order in play.orders)
    fresh = RunFixture(tmp_path / "other")
    assert fresh.no(act.PutBack()).reason.key == "run.nothing_to_put_back"

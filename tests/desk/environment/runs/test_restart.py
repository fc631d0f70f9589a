import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, live, request
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_what_ends_with_it_is_told_before(play):  # R-X01
    play.connected("c")
    play.run(play.open([job("aC")]))
    no = play.no(act.StartAnew())
    assert "play, Untitled-1 with it" in str(no.reason) and no.remedies[0].act == act.StartAnew(confirmed=True)


def test_the_run_is_over_and_documents_are_connected_no_more(play):  # R-E10
    doc = play.connected("c")
    play.run(play.open([job("aC")]))
    play.do(act.StartAnew(confirmed=True))
    assert play.view.state == "over" and "anew" in str(play.view.cause)
    assert play.document(doc).live is None and play.environment.tree.runtime.state == "linked"
    order = next(order for order in play.orders if order.reach is not None and order.reach.is_anew)
    assert isinstance(order.asked, live.Survey)
    assert any("Untitled-1 is no longer connected" in str(say.text) for say in play.says)


def test_where_nothing_lives_nothing_is_asked(play):
    play.do(act.StartAnew())
    assert play.environment.tree.runtime.state == "linked"


def test_a_runtime_elsewhere_is_not_ours_to_start(play):
    doc = play.new("c")
    play.do(act.Connect(doc, url="ws://there"))
    assert "ws://there" in str(play.no(act.StartAnew(confirmed=True)).reason)


def test_where_none_comes_the_reason_is_the_answer(play):
    play.rebuffs = {live.Survey: request.Refused(Reason.plain("no program"))}
    assert "no program" in str(play.answer(act.StartAnew()).no.reason)
    assert play.environment.tree.runtime.state == "lost"

import pytest

from onika.host.sessions.request_backlog import Backlog
from onika.host.sessions.request_server import SessionRequest
from onika.link.caller import Role
from onika.wire import holding, live, request
from onika.wire.plan import Code
from onika.words.reason import NOTHING


def call(message, session="me"):
    return SessionRequest(1, session, Role.OWNER, message)


def answered(_response):
    pass


@pytest.fixture
def backlog():
    kept = Backlog()
    kept.keep(call(live.Clear("arm", "pd")), answered)
    return kept


def test_a_session_is_answered_in_the_order_it_asked(backlog):  # law 21
    assert backlog.is_before(call(live.Clear("arm", "grav")))
    assert not Backlog().is_before(call(live.Clear("arm", "grav")))


def test_nobody_waits_behind_another_session(backlog):  # law 21
    assert not backlog.is_before(call(live.Clear("arm", "grav"), "other"))


@pytest.mark.parametrize("wish", [request.Stop(NOTHING), live.Reset(), live.Survey(), holding.Sessions()])
def test_what_is_urgent_waits_behind_nothing(backlog, wish):  # law 27
    assert not backlog.is_before(call(wish))


@pytest.mark.parametrize("wish", [live.Describe(()), live.Solve(Code("d", "m", "m.py", ""), (), ())])
def test_what_code_says_of_itself_holds_up_nobody(wish):  # law 21
    backlog = Backlog()
    backlog.keep(call(wish), answered)
    assert not backlog.is_before(call(live.Clear("arm", "pd")))


def test_what_waits_is_taken_once_in_order(backlog):
    later = call(live.Clear("arm", "grav"))
    backlog.keep(later, answered)
    assert [call.asked.task for call, _ in backlog.take()] == ["pd", "grav"]
    assert backlog.take() == []

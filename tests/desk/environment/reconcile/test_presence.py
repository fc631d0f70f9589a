import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.reconcile.presence import you
from onika.model.task import Task
from onika.wire import act, event, holding
from onika.words.reason import Reason


@pytest.fixture
def duet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))
    duet.runtime.sessions = (
        holding.SessionStanding("you", "owner"),
        holding.SessionStanding("anna#2", "operator", is_here=False),
    )
    return duet


def test_who_is_there_is_shown_as_soon_as_it_is_connected(duet):  # R-X12
    duet.connected("a")
    sessions = duet.environment.tree.runtime.sessions
    assert {name: (session.role, session.is_here, session.is_you) for name, session in sessions.items()} == {
        "you": ("owner", True, True),
        "anna#2": ("operator", False, False),
    }
    assert you(duet.environment.model) == "you"


def test_who_comes_and_goes_is_shown(duet):  # R-X12
    duet.connected("a")
    duet.tell(event.Company((holding.SessionStanding("you", "owner"), holding.SessionStanding("bob#3", "viewer"))))
    assert list(duet.environment.tree.runtime.sessions) == ["you", "bob#3"]
    assert you(duet.environment.model) == "you"
    duet.do(act.Release(next(iter(duet.environment.tree.documents))))
    assert list(duet.environment.tree.runtime.sessions) == ["you", "bob#3"]


def test_what_is_offered_here_is_shown_and_said_and_gone_with_its_end(duet):  # R-X12
    doc = duet.connected("a")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    duet.tell(event.Offered("Untitled-1", "anna#2", "you"))
    shown = duet.environment.tree.documents[doc]
    assert (shown.offered_by, shown.offered_to, shown.is_offered_here) == ("anna#2", "you", True)
    assert "anna#2 offers Untitled-1: take it, or decline" in [str(say.text) for say in duet.says]
    duet.tell(event.Offered("Untitled-1", "anna#2", "you", Reason.plain("withdrawn")))
    assert duet.environment.tree.documents[doc].offered_by == ""


def test_what_is_offered_to_others_is_shown_and_not_said(duet):  # R-X12
    doc = duet.connected("a")
    before = len(duet.says)
    duet.tell(event.Held("Untitled-1", "anna#2"))
    duet.tell(event.Offered("Untitled-1", "anna#2", "bob#3"))
    shown = duet.environment.tree.documents[doc]
    assert (shown.offered_to, shown.is_offered_here) == ("bob#3", False)
    duet.tell(event.Held("Untitled-1", "bob#3"))
    assert duet.environment.tree.documents[doc].offered_to == ""
    assert len(duet.says) == before


def test_who_offered_it_is_told_that_it_was_declined_and_is_offered_no_longer(duet):  # R-X12
    duet.connected("a")
    duet.tell(event.Offered("Untitled-1", "you", "bob#3"))
    duet.tell(event.Offered("Untitled-1", "you", "bob#3", Reason.plain("bob#3 declines")))
    assert str(duet.says[-1].text) == "Untitled-1 is no longer offered to bob#3: bob#3 declines"


def test_who_takes_what_was_offered_is_told_and_so_is_who_offered_it(duet):  # R-X12
    duet.connected("a")
    accepted = Reason.of("host.offer_accepted")
    duet.tell(event.Offered("Untitled-1", "anna#2", "you", accepted))
    assert str(duet.says[-1].text) == "Untitled-1 is held here now: anna#2 has handed it over"
    duet.tell(event.Offered("Untitled-1", "you", "bob#3", accepted))
    assert str(duet.says[-1].text) == "bob#3 has taken Untitled-1"

from dataclasses import replace

import msgspec
import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.outcome.outcome import Done
from onika.model.task import Task
from onika.wire import act, event, holding, live, request
from onika.words.reason import Reason


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))


def promised(duet):
    """It only watches a runtime elsewhere."""
    doc = duet.connected("a")
    duet.do(act.Release(doc))
    runtime = msgspec.structs.replace(duet.environment.model.runtime, address="ws://far:1")
    duet.environment.become(lambda model: Done(replace(model, runtime=runtime)))
    duet.runtime.sessions = (holding.SessionStanding("you", "owner", only_watches=True),)
    duet.do(act.OnlyWatch())
    return doc


def test_who_only_wants_to_watch_releases_first(duet):  # R-X12
    doc = duet.connected("a")
    assert duet.no(act.OnlyWatch()).remedies[0].act == act.Release(doc)
    duet.do(act.Release(doc))
    assert str(duet.do(act.OnlyWatch())) == "this environment only watches from now on"
    assert holding.OnlyWatch() in duet.carried_out


def test_a_run_that_was_taken_is_something_that_is_held(duet):  # R-X12
    doc = duet.connected("a")
    duet.do(act.Release(doc))
    duet.tell(event.Held("far", "you"))
    no = duet.no(act.OnlyWatch())
    assert str(no.reason) == "far is held here; release it first" and no.remedies[0].act == act.Release(subsystem="far")


def test_the_promise_ends_by_coming_anew_and_nothing_is_held_then(duet):  # R-X12
    doc = promised(duet)
    assert duet.environment.tree.runtime.sessions["you"].only_watches
    duet.runtime.sessions = (holding.SessionStanding("you", "owner"),)
    assert str(duet.do(act.WatchNoMore())) == "this environment may change something again"
    anew = [order for order in duet.orders if order.reach is not None and order.reach.is_anew]
    assert [(order.asked, order.reach.url) for order in anew] == [(live.Survey(), "ws://far:1")]
    assert not duet.environment.tree.runtime.sessions["you"].only_watches
    assert duet.document(doc).live.me == ""


def test_who_cannot_come_anew_has_lost_the_runtime(duet):  # R-E10
    promised(duet)
    duet.rebuffs = {live.Survey: request.Refused(Reason.plain("it does not answer"))}
    assert "it does not answer" in str(duet.answer(act.WatchNoMore()).no.reason)
    assert duet.environment.tree.runtime.state == "lost"


def test_without_a_promise_there_is_nothing_to_end(duet):
    assert str(duet.no(act.WatchNoMore()).reason) == "this environment has not promised that it only watches"
    doc = duet.connected("a")
    duet.do(act.Release(doc))
    duet.runtime.sessions = (holding.SessionStanding("you", "owner", only_watches=True),)
    duet.do(act.OnlyWatch())
    assert duet.no(act.WatchNoMore()).remedies[0].act == act.StartAnew()

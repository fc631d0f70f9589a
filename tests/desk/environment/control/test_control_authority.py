import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, event, holding, live, request
from onika.words.reason import Reason


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))


def test_everybody_stops_everything_whoever_holds_it(duet):  # law 27
    duet.connected("a")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    assert duet.do(act.Stop()) is None
    assert duet.runtime.is_stopped and duet.environment.tree.runtime.is_stopped


def test_a_stop_without_a_runtime_says_that_there_is_none(duet):  # law 27
    duet.rebuffs = {request.Stop: request.Refused(Reason.plain("no runtime is connected"))}
    assert str(duet.do(act.Stop())) == "there is nothing to stop: no runtime is connected"


def test_a_reset_allows_motion_again_and_nothing_more(duet):  # law 27
    doc = duet.connected("a")
    duet.do(act.Stop())
    duet.do(act.Reset())
    assert not duet.environment.tree.runtime.is_stopped and duet.state(doc, "a") == "OFF"
    duet.rebuffs = {live.Reset: request.Refused(Reason.plain("only a holder leaves a stop"))}
    assert str(duet.answer(act.Reset()).no.reason) == "only a holder leaves a stop"


def test_a_unit_is_added_or_the_runtimes_refusal_is_told(duet):  # R-A06
    duet.connected("a")
    duet.do(act.AddUnit("rt2"))
    assert duet.carried_out[-1] == live.AddUnit("rt2")
    duet.rebuffs = {live.AddUnit: request.Refused(Reason.of("host.units_many", most=8))}
    assert duet.answer(act.AddUnit("rt9")).no.reason == Reason.of("host.units_many", most=8)


def test_a_subsystem_is_released_and_taken_again(duet):  # R-X12
    doc = duet.connected("a")
    duet.do(act.Release(doc))
    assert not duet.environment.tree.documents[doc].is_held_here
    duet.do(act.Take(doc))
    assert duet.environment.tree.documents[doc].is_held_here


def test_what_another_holds_can_be_neither_taken_nor_released(duet):  # R-X12
    doc = duet.connected("a")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    assert str(duet.no(act.Release(doc)).reason) == "Untitled-1 is held by anna#2"
    duet.rebuffs = {live.Take: request.Refused(Reason.plain("subsystem Untitled-1 is held by anna#2"))}
    assert str(duet.answer(act.Take(doc)).no.reason) == "subsystem Untitled-1 is held by anna#2"


def test_what_is_not_connected_is_held_by_nobody(duet):
    doc = duet.new("a")
    assert duet.no(act.Take(doc)).remedies[0].act == act.Connect(doc)
    assert str(duet.no(act.Release("c9")).reason) == "this configuration is no longer open"


def test_a_subsystem_is_offered_to_another_and_no_more(duet):  # R-X12
    doc = duet.connected("a")
    duet.do(act.Hand(doc, "anna#2"))
    assert holding.Hand("Untitled-1", "anna#2") in duet.carried_out
    assert duet.environment.tree.documents[doc].offered_to == "anna#2"
    duet.do(act.Hand(doc))
    assert duet.environment.tree.documents[doc].offered_to == ""
    duet.rebuffs = {holding.Hand: request.Refused(Reason.plain("bob#3 only watches and can take nothing"))}
    assert str(duet.answer(act.Hand(doc, "bob#3")).no.reason) == "bob#3 only watches and can take nothing"


def test_what_is_handed_over_can_only_be_watched_from_then_on(duet):  # R-X12
    doc = duet.connected("a")
    duet.do(act.Hand(doc, "anna#2"))
    duet.tell(event.Held("Untitled-1", "anna#2", Reason.plain("you has handed it over")))
    assert not duet.environment.tree.documents[doc].is_held_here
    assert str(duet.no(act.Hand(doc, "anna#2")).reason) == "Untitled-1 is not held here, so it cannot be handed over"
    assert "held by anna#2" in str(duet.no(act.Toggle(doc, "a")).reason)


def test_what_is_offered_here_is_taken_or_declined(duet):  # R-X12
    doc = duet.connected("a")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    assert str(duet.no(act.Decline(doc)).reason) == "nobody offers Untitled-1 to this environment"
    duet.tell(event.Offered("Untitled-1", "anna#2", "you"))
    duet.do(act.Decline(doc))
    assert holding.Decline("Untitled-1") in duet.carried_out
    duet.tell(event.Offered("Untitled-1", "anna#2", "you"))
    duet.do(act.Take(doc))
    shown = duet.environment.tree.documents[doc]
    assert (shown.is_held_here, shown.offered_by) == (True, "")


def test_who_only_wants_to_watch_releases_first(duet):  # R-X12
    doc = duet.connected("a")
    assert duet.no(act.OnlyWatch()).remedies[0].act == act.Release(doc)
    duet.do(act.Release(doc))
    assert str(duet.do(act.OnlyWatch())) == "this environment only watches from now on"
    assert holding.OnlyWatch() in duet.carried_out


def test_of_a_document_that_is_closed_nothing_is_handed_over(duet):
    for wish in (act.Hand("c9", "anna#2"), act.Decline("c9")):
        assert str(duet.no(wish).reason) == "this configuration is no longer open"

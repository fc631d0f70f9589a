import pytest

from onika.model.task import Task
from onika.testing.duet import Duet
from onika.wire import act, event, live, request


@pytest.fixture
def duet(tmp_path):
    return Duet(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))


def test_everybody_stops_everything_whoever_holds_it(duet):  # law 27
    duet.connected("a")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    assert duet.do(act.Stop()) is None
    assert duet.runtime.is_stopped and duet.environment.tree.runtime.is_stopped


def test_a_stop_without_a_runtime_says_that_there_is_none(duet):  # law 27
    duet.rebuffs = {request.Stop: request.Refused("no runtime is connected")}
    assert duet.do(act.Stop()) == "there is nothing to stop: no runtime is connected"


def test_a_reset_allows_motion_again_and_nothing_more(duet):  # law 27
    doc = duet.connected("a")
    duet.do(act.Stop())
    duet.do(act.Reset())
    assert not duet.environment.tree.runtime.is_stopped and duet.state(doc, "a") == "OFF"
    duet.rebuffs = {live.Reset: request.Refused("only a holder leaves a stop")}
    assert duet.answer(act.Reset()).no.reason == "only a holder leaves a stop"


def test_a_subsystem_is_released_and_taken_again(duet):  # R-X12
    doc = duet.connected("a")
    duet.do(act.Release(doc))
    assert not duet.environment.tree.documents[doc].is_held_here
    duet.do(act.Take(doc))
    assert duet.environment.tree.documents[doc].is_held_here


def test_what_another_holds_can_be_neither_taken_nor_released(duet):  # R-X12
    doc = duet.connected("a")
    duet.tell(event.Held("Untitled-1", "anna#2"))
    assert duet.no(act.Release(doc)).reason == "Untitled-1 is held by anna#2"
    duet.rebuffs = {live.Take: request.Refused("subsystem Untitled-1 is held by anna#2")}
    assert duet.answer(act.Take(doc)).no.reason == "subsystem Untitled-1 is held by anna#2"


def test_what_is_not_connected_is_held_by_nobody(duet):
    doc = duet.new("a")
    assert duet.no(act.Take(doc)).remedies[0].act == act.Connect(doc)
    assert duet.no(act.Release("c9")).reason == "this configuration is no longer open"

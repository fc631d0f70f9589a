from dataclasses import replace

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.outcome.outcome import Done
from onika.wire import act, event, live, request
from onika.wire.sheet import ModuleSheet
from onika.words.reason import Reason


def sheet(*, trigger=False):
    return ModuleSheet((), (), (), trigger, False, False, 0, "")


@pytest.fixture
def play(tmp_path):
    fixture = RunFixture(tmp_path)
    sheets = {"a": sheet(), "b": sheet(trigger=True), "c": sheet()}

    def described(model):
        return Done(replace(model, libraries=replace(model.libraries, sheets=sheets)))

    fixture.environment.become(described)
    return fixture


def taken(play, *on):
    """A configuration with a, b and c alive, some of them ON, taken over by a run; its id."""
    lower = play.connected("a", "b", "c")
    if on:
        play.do(act.Turn(lower, on, True))
    play.do(act.Run(play.open([job("aC")]), confirmed=True))
    return lower


def states(play, doc):
    return {name: play.state(doc, name) for name in ("a", "b", "c")}


def last(play):
    return str(play.says[-1].text)


def test_after_a_whole_run_what_was_on_is_on_again(play):  # R-C18
    lower = taken(play, "a")
    assert play.document(lower).live is None and play.environment.tree.documents[lower].taken_by == "play"
    play.end()
    assert states(play, lower) == {"a": "ON", "b": "OFF", "c": "OFF"}
    assert play.environment.tree.documents[lower].taken_by == "" and play.document(lower).live.is_held_here
    assert last(play) == "Untitled-1 is put back: its tasks live again, a ON"


def test_a_trigger_that_was_on_does_not_move_again(play):  # R-C18, law 27
    lower = taken(play, "a", "b")
    play.end()
    assert states(play, lower) == {"a": "ON", "b": "OFF", "c": "OFF"}


def test_after_a_run_that_ended_early_everything_is_off(play):  # R-C18, law 27
    lower = taken(play, "a")
    play.end("it broke")
    assert states(play, lower) == {"a": "OFF", "b": "OFF", "c": "OFF"}
    assert last(play) == "Untitled-1 is put back: its tasks live again, OFF"


def test_while_all_is_stopped_nothing_lives_and_afterwards_nothing_is_on(play):  # R-C18, law 27
    lower = taken(play, "a")
    play.do(act.Stop())
    play.end("stopped")
    assert play.document(lower).live is None
    play.do(act.Reset())
    assert states(play, lower) == {"a": "OFF", "b": "OFF", "c": "OFF"}


def test_a_stop_that_is_left_before_the_run_is_over_is_not_forgotten(play):  # law 27
    lower = taken(play, "a")
    play.tell(event.Stopped(True, Reason.plain("a hand")))
    play.tell(event.Stopped(False, Reason.plain("")))
    assert play.document(lower).live is None  # the run goes on
    play.end()
    assert states(play, lower)["a"] == "OFF"


def test_where_the_run_never_begins_all_is_as_it_was(play):  # R-C18, R-E12
    lower = play.connected("a", "b", "c")
    play.do(act.Turn(lower, ("a",), True))
    play.rebuffs = {request.Begin: request.Refused(Reason.plain("no room"))}
    assert "no room" in str(play.answer(act.Run(play.open([job("aC")]), confirmed=True)).no.reason)
    assert states(play, lower) == {"a": "ON", "b": "OFF", "c": "OFF"}


def test_who_does_not_want_it_back_says_so(play):  # R-C18
    lower = taken(play)
    play.do(act.Disconnect(lower))
    play.end()
    assert play.document(lower).live is None and "Untitled-1" not in play.runtime.lives


def test_what_is_connected_with_something_else_meanwhile_is_left_there(play):  # R-C18
    lower = taken(play)
    play.do(act.Remove(lower, ("a",)))
    play.do(act.Connect(lower, subsystem="elsewhere"))
    play.end()
    assert play.document(lower).live.subsystem == "elsewhere" and "Untitled-1" not in play.runtime.lives


def test_its_place_is_kept_from_other_runs_and_documents(play):  # R-C18
    lower = taken(play)
    other = play.new("c")
    play.do(act.Connect(other, subsystem="Untitled-1"))
    play.end()
    assert play.document(lower).live is None
    assert last(play).startswith("Untitled-1 is not put back: ")


def test_a_closed_one_is_not_put_back(play):  # R-C18
    lower = taken(play)
    play.do(act.Close(lower, discards=True))
    before = len(play.carried(live.Take))
    play.end()
    assert len(play.carried(live.Take)) == before and "Untitled-1" not in play.runtime.lives


def test_one_that_is_closed_while_its_place_is_taken_again_holds_nothing(play):  # R-C18, R-X12
    lower = taken(play)
    play.is_held_back = True
    play.end()
    play.do(act.Close(lower, discards=True))
    play.is_held_back = False
    play.pump()
    assert play.carried(live.Release)[-1] == live.Release("Untitled-1")


def test_with_the_runtime_goes_what_was_to_be_put_back(play):  # R-E10
    lower = taken(play)
    play.lose("it died")
    assert play.document(lower).taken is None
    assert "is not put back: the runtime is gone" in last(play)


def test_who_holds_the_place_by_then_keeps_it_and_is_watched(play):  # R-X12
    lower = taken(play, "a")
    play.runtime._holders["Untitled-1"] = "anna#2"
    play.runtime.lives["Untitled-1"] = {}
    play.rebuffs = {**play.rebuffs, live.Take: request.Refused(Reason.plain("held by anna#2"))}
    play.end()
    view = play.environment.tree.documents[lower]
    assert (view.holder, view.is_held_here) == ("anna#2", False) and play.runtime.lives["Untitled-1"] == {}


def alive(play, doc):
    return {name: facts.state for name, facts in play.document(doc).live.tasks.items()}


def test_what_was_kept_alive_beside_it_lives_again_too_and_rests(play):  # R-C18, R-C32
    play.files.configuration("restC", "c 10")
    lower = play.connected("a")
    play.do(act.KeepAlive(lower, str(play.base.configuration_file("restC"))))
    play.do(act.Turn(lower, ("a",), True))
    assert alive(play, lower) == {"a": "ON", "c": "OFF"}
    play.do(act.Run(play.open([job("aC")]), confirmed=True))
    play.end()
    assert alive(play, lower) == {"a": "ON", "c": "OFF"}
    play.do(act.SwitchTo(lower, "restC"))
    assert alive(play, lower) == {"a": "OFF", "c": "ON"}

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.control import held_subsystems
from onika.model.task import Task
from onika.wire import act, event, holding, live, request, steer
from onika.wire.view import HoldView
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def duet(tmp_path):
    """Connected; in `flow0` and `flow1` an application runs that anna#2 began."""
    duet = FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))
    duet.connected("a")
    duet.runtime.positions = (steer.Position("flow0", "running", 0), steer.Position("flow1", "paused", 3))
    assert duet.do(act.Company()) is None
    return duet


SILENT = Reason.plain("its holder anna#2 has been silent for 1.0 s")


def lose_holder(duet, holder="", cause=SILENT):
    for name in ("flow0", "flow1"):
        duet.tell(event.Held(name, "anna#2"))
        duet.tell(event.Held(name, holder, cause))


def holds(duet):
    return duet.environment.tree.runtime.holds


def test_what_runs_and_where_is_asked_anew(duet):  # R-X12
    assert (holds(duet)["flow1"].application, holds(duet)["flow1"].state) == ("played", "paused")
    duet.rebuffs = {live.Survey: request.Refused(Reason.plain("busy"))}
    assert str(duet.answer(act.Company()).no.reason) == "busy"


def test_a_run_that_is_nobodys_is_taken_only_when_that_is_meant(duet):  # R-X12
    lose_holder(duet)
    refusal = duet.no(act.Take(subsystem="flow0"))
    assert "anna#2 began it and is gone" in str(refusal.reason) and "starts nothing" in str(refusal.reason)
    assert refusal.remedies[0].act == act.Take(subsystem="flow0", confirmed=True)
    assert live.Take("flow0") not in duet.carried_out
    duet.do(act.Take(subsystem="flow0", confirmed=True))
    assert duet.carried_out.count(live.Take("flow0")) == 1
    moving = (steer.Resume, steer.Recover, request.Begin, live.Change)
    assert not [message for message in duet.carried_out[-4:] if isinstance(message, moving)]


def test_what_is_lost_is_said_whoever_held_it(duet):  # R-X12
    lose_holder(duet)
    assert "flow0: its holder anna#2 has been silent for 1.0 s" in [str(say.text) for say in duet.says]
    assert holds(duet)["flow0"].former == "anna#2" and not holds(duet)["flow0"].was_here


def test_a_run_is_steered_only_by_who_has_taken_it(duet):  # R-X12
    lose_holder(duet)
    no = duet.no(act.SteerTaken("flow0", "pause"))
    assert "nobody" in str(no.reason) and no.remedies[0].act == act.Take(subsystem="flow0")
    lose_holder(duet, "bob#3")
    no = duet.no(act.SteerTaken("flow0", "pause"))
    assert "held by bob#3" in str(no.reason) and not no.remedies
    assert str(duet.no(act.SteerTaken("far", "pause")).reason) == "no application runs in far any more"


@pytest.mark.parametrize(
    ("wish", "action"),
    [
        ("resume", steer.Resume()),
        ("clear", steer.Recover()),
        ("abort", request.Abort(Reason.of("run.ended_by_taker"), "flow0")),
    ],
)
def test_what_moves_or_ends_a_run_that_was_taken_is_asked_back_first(duet, wish, action):  # R-X12
    lose_holder(duet, "you")
    no = duet.no(act.SteerTaken("flow0", wish))
    assert no.remedies[0].act == act.SteerTaken("flow0", wish, confirmed=True) and action not in duet.carried_out
    duet.do(act.SteerTaken("flow0", wish, confirmed=True))
    assert action in duet.carried_out


def test_a_pause_needs_no_word_and_a_refusal_is_shown(duet):  # R-X12
    lose_holder(duet, "you")
    duet.do(act.SteerTaken("flow0", "pause"))
    assert steer.Pause() in duet.carried_out
    duet.rebuffs = {steer.Pause: request.Refused(Reason.plain("nothing runs"))}
    assert str(duet.answer(act.SteerTaken("flow0", "pause")).no.reason) == "nothing runs"


def test_one_run_is_held_here_at_a_time(duet):  # R-X12
    lose_holder(duet, "you")
    assert held_subsystems.run_here(duet.environment.model) == "flow0"
    duet.tell(event.Held("flow1", "", Reason.plain("gone")))
    assert "the run of another is taken over where nothing runs" in str(duet.no(act.Take(subsystem="flow1")).reason)


def test_what_is_offered_here_is_taken_without_a_word_and_declined_by_its_name(duet):  # R-X12
    lose_holder(duet, "anna#2")
    assert str(duet.no(act.Decline(subsystem="flow0")).reason) == "nobody offers flow0 to this environment"
    duet.tell(event.Offered("flow0", "anna#2", "you"))
    duet.do(act.Decline(subsystem="flow0"))
    assert holding.Decline("flow0") in duet.carried_out
    duet.tell(event.Offered("flow0", "anna#2", "you"))
    duet.do(act.Take(subsystem="flow0"))
    assert live.Take("flow0") in duet.carried_out


def test_what_is_held_is_handed_over_and_released_by_its_name(duet):  # R-X12
    lose_holder(duet, "you")
    duet.do(act.Hand(subsystem="flow0", to="anna#2"))
    assert holding.Hand("flow0", "anna#2") in duet.carried_out
    assert holds(duet)["flow0"].offered_to == "anna#2"
    lose_holder(duet, "bob#3")
    assert str(duet.no(act.Release(subsystem="flow0")).reason) == "flow0 is held by bob#3"
    assert "not held here" in str(duet.no(act.Hand(subsystem="flow0", to="anna#2")).reason)


def test_of_what_is_gone_nothing_is_taken(duet):
    assert str(duet.no(act.Take(subsystem="far")).reason) == "there is no subsystem far any more"
    assert not held_subsystems.is_held_here(duet.environment.model, "far")
    assert held_subsystems.holder(duet.environment.model, "far") == HoldView().holder


def test_what_a_run_asks_is_answered_by_who_has_taken_it(duet):  # R-X12, R-C13
    lose_holder(duet)
    answer = act.Answer("", "flow0/servo", "1.5")
    duet.rebuffs = {request.Reply: request.Done()}
    duet.tell(event.Asked("flow0", "servo", NOTHING, (), 1.0))
    no = duet.no(answer)
    assert "nobody" in str(no.reason) and no.remedies[0].act == act.Take(subsystem="flow0")
    lose_holder(duet, "bob#3")
    assert "only its holder answers it" in str(duet.no(answer).reason)
    lose_holder(duet, "you")
    duet.do(answer)
    assert request.Reply("flow0", "servo", "1.5") in duet.carried_out
    duet.tell(event.TaskState("flow0", "servo", "ON", 1.0))
    assert str(duet.no(answer).reason) == "servo asks for nothing any more"
    assert str(duet.no(act.Answer("", "far/servo", "1")).reason) == "no application runs in far any more"


def test_what_another_page_has_just_taken_is_taken_and_what_another_session_took_is_refused(duet):  # R-X12
    duet.rebuffs = {live.Take: request.Refused(Reason.of("host.held_by", subsystem="flow0", holder="you"))}
    lose_holder(duet, "you")
    assert duet.answer(act.Take(subsystem="flow0", confirmed=True)).no is None
    lose_holder(duet, "bob#3")
    assert duet.answer(act.Take(subsystem="flow0", confirmed=True)).no.reason.key == "host.held_by"

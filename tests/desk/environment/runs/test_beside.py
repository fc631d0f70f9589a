import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import Laboratory, job
from onika.model.lifecycle import State
from onika.wire import act, event, request, steer
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def play(tmp_path):
    files = Laboratory(tmp_path)
    files.module("rival", "# rival\n")
    files.plain_task("rival", writes="D", local="DEVICE arm\n")
    files.configuration("rivalC", "rival 100")
    return RunFixture(tmp_path)


@pytest.fixture
def two(play):
    """Two applications side by side: `play` in flow0, then `other` in flow0-1."""
    play.first = play.open([job("aC"), job("bC")])
    play.other = play.open([job("cC")], name="other")
    play.run(play.first)
    play.run(play.other)
    return play


def beside(play):
    (view,) = play.environment.tree.beside.values()
    return view


def began(play, index, run, of=2, action="aC"):
    play.tell(event.Began(0, index, of, action, 1.0, run=run))


def ended(play, run, cause=""):
    play.tell(event.Result(not cause, Reason.plain(cause), 1, 2, 9.0, 0.0, {}, (), "", run=run))


def test_two_applications_run_side_by_side_each_in_subsystems_of_its_own(two):  # R-C18, R-E12
    assert (two.view.name, list(two.view.flows)) == ("other", ["flow0-1"])
    assert (beside(two).name, list(beside(two).flows)) == ("play", ["flow0"])
    applications = two.environment.tree.applications
    assert applications[two.first].is_running and applications[two.other].is_running


def test_what_happens_belongs_to_the_run_that_it_is_told_of(two):  # R-C18, R-E11
    began(two, 0, "flow0")
    began(two, 0, "flow0-1", of=1, action="cC")
    two.tell(event.Moved("flow0", "paused", 0, 2.0))
    two.tell(event.Warned("flow0", "a", Reason.plain("odd"), 2.0))
    assert beside(two).flows["flow0"].state == "paused" and two.view.flows["flow0-1"].state == "running"
    assert [str(note) for note in beside(two).notes] == ["a: odd"] and two.view.notes == ()
    two.tell(event.Done(0, 0, 3.0, run="flow0"))
    assert (beside(two).done, two.view.done) == (1, 0)


def test_each_ends_with_its_own_result(two):  # R-C18, R-E14
    ended(two, "flow0", "it broke")
    assert (beside(two).state, two.view.state) == ("over", "running")
    assert not two.environment.tree.applications[two.first].is_running
    two.do(act.Dismiss(two.first))
    assert two.environment.tree.beside == {}
    ended(two, "flow0-1")
    assert two.view.is_completed


def test_a_pause_is_for_the_flows_of_one_alone(two):  # R-C18, R-E07
    two.do(act.Steer("pause", two.first))
    two.do(act.Steer("pause", two.other))
    assert two.carried(steer.Pause) == [steer.Pause("flow0"), steer.Pause("flow0-1")]


def test_of_several_flows_each_is_asked(play):  # R-C18, R-E07
    both = play.open([job("aC")], [job("bC")], parallel=True)
    play.run(both)
    play.run(play.open([job("cC")], name="other"))
    play.do(act.Steer("pause", both))
    play.do(act.Steer("continue", both))
    assert play.carried(steer.Pause) == [steer.Pause("flow0"), steer.Pause("flow1")]
    assert play.carried(steer.Resume) == [steer.Resume("flow0"), steer.Resume("flow1")]


def test_what_no_flow_of_it_does_is_refused_with_the_first_reason(two):  # R-X01
    two.rebuffs = {**two.rebuffs, steer.Recover: request.Refused(Reason.plain("flow0 has not stopped"))}
    assert str(two.answer(act.Steer("clear", two.first)).no.reason) == "flow0 has not stopped"


def test_an_abort_ends_one_and_no_other(two):  # R-C18, R-E07
    two.do(act.Steer("abort", two.first))
    assert [message.subsystem for message in two.carried(request.Abort)] == ["flow0"]
    assert (beside(two).state, two.view.state) == ("over", "running")
    two.do(act.Steer("abort", two.other))
    assert two.view.state == "over"


def test_a_skip_goes_to_the_flow_of_the_application_that_is_seen(two):  # R-E13
    two.do(act.SkipTo(2, two.first))
    assert two.carried(steer.Skip) == [steer.Skip("flow0", 1)]


def test_what_a_task_asks_is_answered_in_its_run(two):  # R-E15
    item = event.Item("speed", "double", 1, "m/s", "how fast", None, None, None)
    two.tell(event.Asked("flow0", "a", NOTHING, (item,), 1.0))
    assert list(beside(two).asks) == ["flow0/a"] and two.view.asks == {}
    two.rebuffs = {**two.rebuffs, request.Reply: request.Done()}
    two.do(act.Answer(two.first, "flow0/a", "1.0"))
    assert two.carried(request.Reply) == [request.Reply("flow0", "a", "1.0")]


def test_who_needs_the_device_of_another_does_not_run_beside_it(play):  # R-C18, R-X01
    first, rival = play.open([job("aC")]), play.open([job("rivalC")], name="rival")
    play.run(first)
    play.alive()
    no = play.answer(act.Run(rival)).no
    assert str(no.reason) == "rival cannot run beside what runs: play has arm"
    assert [(str(remedy.label), remedy.act) for remedy in no.remedies] == [("Abort play", act.Steer("abort", first))]
    assert (play.view.name, play.view.state) == ("play", "running") and play.environment.tree.beside == {}


def test_one_that_cannot_begin_leaves_the_other_as_it_is(play):  # R-C18
    first, other = play.open([job("aC"), job("bC")]), play.open([job("cC")], name="other")
    play.run(first)
    given = []
    play.is_held_back = True
    play.rebuffs = {request.Begin: request.Refused(Reason.plain("no room"))}
    play.environment.do(act.Run(other), "me", given.append)
    began(play, 0, "flow0")
    play.is_held_back = False
    play.pump()
    assert "no room" in str(given[0].no.reason)
    assert (play.view.name, play.view.flows["flow0"].step) == ("play", 1) and play.environment.tree.beside == {}


def test_with_the_runtime_both_end(two):  # R-E10
    two.lose("it died")
    assert two.view.state == beside(two).state == "over"
    assert [run.view.is_completed for run in two.environment.model.every_run] == [False, False]


def test_nothing_is_changed_in_any_application_that_runs(two):  # R-D18
    for doc in (two.first, two.other):
        assert "is running" in str(two.no(act.RemoveIcons(doc, (1,))).reason)


def test_a_breakpoint_is_set_in_the_run_of_its_application(two):  # R-E07
    two.do(act.SetBreakpoint(two.first, (1,)))
    assert [(mark.subsystem, mark.action) for mark in two.carried(steer.Mark)] == [("flow0", 0)]


def test_what_one_took_over_is_put_back_when_that_one_is_over(play):  # R-C18
    lower = play.connected("a")
    play.do(act.Run(play.open([job("aC")]), confirmed=True))
    play.run(play.open([job("cC")], name="other"))
    ended(play, "flow0-1")
    assert play.document(lower).live is None
    ended(play, "flow0")
    assert play.state(lower, "a") == State.OFF.value

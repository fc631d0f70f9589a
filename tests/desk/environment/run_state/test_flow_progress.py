import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job, joints
from onika.wire import event
from onika.words.reason import NOTHING, Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def steps(play):
    return {int(key): (step.state, step.times) for key, step in play.view.steps.items()}


def test_steps_are_under_way_and_then_done_with_their_times(play):  # R-E11
    play.run(play.open([job("aC"), job("bC")]))
    play.began(0, at_s=1.0)
    flow = play.view.flows["flow0"]
    assert (flow.step, flow.action, flow.index, flow.of) == (1, "a job", 0, 2)
    assert steps(play) == {1: ("running", 0)} and flow.state == "running"
    play.done(0, at_s=3.5)
    play.began(1, at_s=3.5)
    assert steps(play) == {1: ("done", 1), 2: ("running", 0)} and play.view.steps["1"].took_s == 2.5
    assert (play.view.done, play.view.flows["flow0"].done) == (1, 1)


def test_what_is_skipped_is_left(play):  # R-E13
    play.run(play.open([job("aC"), job("bC")]))
    play.began(0)
    play.began(1)
    assert steps(play) == {1: ("left", 0), 2: ("running", 0)}


def test_rounds_are_counted(play):  # R-E05
    play.run(play.open([job("aC"), job("bC")]))
    for _ in range(3):
        for index in (0, 1):
            play.began(index)
            play.done(index)
    assert steps(play) == {1: ("done", 3), 2: ("done", 3)}


def test_an_application_in_it_is_one_step(play):  # R-E06
    play.files.application("inner", [job("aC"), job("bC")])
    play.run(play.open([job("inner", "Complete application"), job("cC")]))
    play.began(0, at_s=1.0)
    assert play.view.flows["flow0"].within == ("a job",)
    play.done(0, at_s=2.0)
    play.began(1, at_s=2.0)
    play.done(1, at_s=4.0)
    assert steps(play) == {1: ("running", 0)}
    play.began(2, at_s=4.0)
    assert steps(play) == {1: ("done", 1), 2: ("running", 0)} and play.view.steps["1"].took_s == 3.0


def test_an_application_in_a_loop_of_its_own_is_counted(play):  # R-E05, R-E06
    play.files.application("inner", [job("aC"), job("bC")])
    play.run(play.open([job("inner", "Complete application")]))
    for _ in range(2):
        for index in (0, 1):
            play.began(index)
            play.done(index)
    play.moved("done", action=1)
    assert steps(play) == {1: ("done", 2)}


def test_flows_begun_by_others_belong_to_the_step_that_begins_them(play):  # R-D13
    play.files.application("both", [job("aC")], [job("bC")], parallel=True)
    play.run(play.open([job("both", "Complete application"), job("cC")]))
    assert play.view.flows["flow0.1"].is_nested
    play.began(0)
    play.began(0, flow=1)
    play.done(0, flow=1)
    assert steps(play) == {1: ("running", 0)}
    play.done(0)
    play.began(1)
    assert steps(play) == {1: ("done", 1), 2: ("running", 0)}


def test_who_waits_for_whom_and_since_when(play):  # R-E04, R-X03
    tag = "SYNCHTAG    meet"
    play.run(play.open([job("aC", "Complete job", tag)], [job("bC", "Complete job", tag)], parallel=True))
    play.moved("waiting", flow="flow1", at_s=2.0, tag="play meet")
    play.moved("waiting", flow="flow1", at_s=3.0, tag="play meet")
    flow = play.view.flows["flow1"]
    assert (flow.tag, flow.waits_for, flow.waits_since_s) == ("meet", ("flow0",), 2.0)
    play.tell(event.Met("play meet", ("flow0", "flow1"), 120.0, 4.0))
    play.moved("running", flow="flow1", at_s=4.0)
    assert play.view.meets[0].skew_us == 120.0 and play.view.flows["flow1"].waits_since_s == 0.0


def test_the_end_leaves_what_was_under_way(play):  # R-E14
    play.run(play.open([job("aC"), job("bC")]))
    play.began(0)
    play.tell(event.Asked("flow0", "a", NOTHING, (), 1.0))
    play.end("aborted by the user", 5.0)
    assert (play.view.state, str(play.view.cause), play.view.took_s) == ("over", "aborted by the user", 5.0)
    assert steps(play) == {1: ("left", 0)} and play.view.asks == {}


def test_what_is_remarked_at_the_end_stands_among_the_notes(play):  # R-E14, R-X05
    play.run(play.open([job("aC")]))
    play.environment.receive(event.Result(True, NOTHING, 1, 1, 1.0, 1.0, {}, (), "", remarks=(Reason.plain("cut"),)))
    assert str(play.view.notes[-1]) == "cut"


def test_words_of_another_run_change_nothing(play):
    play.run(play.open([job("aC")]))
    before = play.view
    play.tell(event.Began(0, 0, 1, "something else", 1.0))
    play.tell(event.Moved("elsewhere", "running", 0, 1.0))
    play.tell(event.Done(3, 7, 1.0))
    assert play.view is before


def test_that_a_flow_waits_for_ever_is_forgotten_when_the_other_goes_on(play):  # R-X06
    play.run(play.open([job("aC")], [job("bC")], parallel=True))
    play.moved("stopped", flow="flow0")
    play.moved("waiting", flow="flow1", tag="play meet")
    why = ("", "", "", 0, "", Reason.plain("waits"), "", 0, (), (), (("abort", Reason.plain("ends")),), 2.0)
    play.tell(event.Explained("flow1", *why[1:], "deserted"))
    assert set(play.view.stops) == {"flow1"}
    play.moved("clearing", flow="flow0")
    assert play.view.stops == {}


def test_a_run_that_is_ended_where_it_stood_keeps_why_it_stood(play):  # R-X06, R-E14
    play.run(play.open([job("aC")]))
    play.began(0)
    play.moved("stopped")
    raised = Reason.of("runtime.raised", kind="ModuleError", why="out of reach")
    failed = Reason.of("host.entry_failed", entry="cycle", why=raised)
    why = ("a", "", 0, "", failed, "", 0, (), (), (("clear", Reason.plain("again")),), 2.0, "error")
    play.tell(event.Explained("flow0", *why))
    play.moved("killing")
    assert "flow0" not in play.view.stops
    play.end(Reason.of("desk.aborted_by_user"))
    assert str(play.view.cause) == "ended by you, after: out of reach"


def test_a_standstill_and_an_end_name_the_last_seconds_before_them(play):  # R-X05
    play.run(play.open([job("aC")]))
    play.began(0)
    play.moved("stopped")
    why = ("a", "", 0, "", Reason.plain("broken"), "", 0, (), (), (("clear", Reason.plain("again")),), 2.0, "error")
    play.tell(event.Explained("flow0", *why))
    play.tell(event.LastSecondsKept("flow0", 1.5, "/box/of-another.mcap"))
    assert play.view.stops["flow0"].black_box == ""
    play.tell(event.LastSecondsKept("flow0", 2.0, "/box/of-this.mcap"))
    assert play.view.stops["flow0"].black_box == "/box/of-this.mcap"
    play.tell(event.Result(False, Reason.plain("broken"), 0, 1, 2.0, 2.0, {}, (), "", black_box="/box/end.mcap"))
    assert play.view.black_box == "/box/end.mcap"


def test_what_the_task_of_an_action_warns_of_is_told_of_the_action_and_of_others_of_the_task(play):  # R-E14
    rows = "DESC x\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR none\nTASKTYPE periodic\nFREQ 10"
    play.files.module("d", '"""The code of d."""\n')
    play.files.task("d", f"MODULE d\n{rows}\nONIKA\nOBJECT Joint job")
    play.files.configuration("dC", "b 100", "d 100")
    play.run(play.open([job("dC", "Joint job"), joints("there", *range(6))]))
    play.began(0)
    for task in ("d", "b"):
        play.tell(event.Warned("flow0", task, Reason.plain("too fast"), 1.0))
    assert [str(note) for note in play.view.notes] == ["a job a target: too fast", "b: too fast"]

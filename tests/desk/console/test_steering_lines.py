import pytest

from onika.desk.console.steering_lines import flow_index_of
from onika.wire import event, live, request, steer
from onika.words.reason import Reason

HERE = steer.Position("flow0", "paused", 1)
THERE = steer.Position("flow1", "waiting", 0, "t a", ("flow0",))


@pytest.fixture
def steered(sit):
    """A sitting at a runtime where an application runs that somebody else began."""
    sitting = sit()
    sitting.runtime.positions = (HERE,)
    return sitting


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("pause", steer.Pause("flow0")),
        ("continue flow0", steer.Resume("flow0")),
        ("step 0", steer.Step("flow0")),
        ("next", steer.Skip("flow0")),
        ("skip 7", steer.Skip("flow0", 6)),
        ("pass", steer.Pass("flow0")),
        ("leave", steer.Leave("flow0")),
        ("break 3 if LAMP == 1", steer.Mark("flow0", 2, True, "LAMP == 1")),
        ("unbreak 3", steer.Mark("flow0", 2, False)),
    ],
)
def test_the_words_of_steering_are_those_of_scripts(steered, line, message):  # R-E07, R-E13
    steered.does(line)
    assert steered.runtime.asked[-1] == message


def test_where_no_application_runs_there_is_nothing_to_steer(sit):  # R-E07
    sitting = sit()
    for line in ("pause", "skip 3"):
        assert sitting.fails(line).reason == Reason.of("console.no_application_runs")
    assert sitting.does("who", "runs")[-2:] == ["no application runs", "no application runs"]


def test_what_is_written_wrongly_or_refused_is_a_fault(steered):  # R-E07
    assert steered.fails("pause flow7").reason == Reason.of("desk.flow_or_number", names=("flow0",), word="flow7")
    steered.runtime.refusals["Pass"] = Reason.plain("expected flow 0 to be waiting, found it paused")
    assert str(steered.fails("pass").reason) == "expected flow 0 to be waiting, found it paused"


def test_who_says_where_every_flow_is_and_whom_it_waits_for(steered):  # R-X03
    steered.runtime.positions = (HERE, THERE)
    assert steered.does("who") == [
        "flow   state    action",
        "flow0  paused        2",
        "flow1  waiting       1  waits at a for flow0",
    ]


def test_runs_lists_the_applications_with_their_flows(steered):  # R-E11
    assert steered.does("runs") == ["played in flow0", "  flow   state   action", "  flow0  paused       2"]


def test_actions_of_an_own_run_go_by_their_names_too(steered):  # R-E13
    steered.console.carry_out("run go_home")
    name = steered.session.flow_index.parts[0].actions[0]
    steered.does(f"skip {name}")
    assert steered.runtime.asked[-1] == steer.Skip("flow0", 0)
    assert flow_index_of(steered.session, (HERE, THERE)).name("flow0", 0) == ""


def test_to_clear_a_flow_is_to_clear_and_continue(steered):  # R-E08
    steered.does("clear flow0")
    assert steered.requests_of(steer.Recover) == [steer.Recover("flow0")]
    steered.runtime.positions = (steer.Position("flow0", "stopped", 1, failed=("pd",)),)
    steered.does("clear")
    assert steered.requests_of(steer.Recover) == [steer.Recover("flow0")] * 2


def test_tasks_held_by_hand_are_cleared_as_ever(steered):  # R-A05
    steered.runtime.positions = (steer.Position("flow0", "stopped", 1, failed=("pd",)),)
    steered.does("spawn puma", "clear")
    assert steered.requests_of(steer.Recover) == []
    steered.console.carry_out("clear puma")
    assert steered.requests_of(live.Clear) == [live.Clear("main", "puma")]


def test_a_run_that_somebody_left_alone_is_aborted(steered):  # R-E07
    steered.does("abort it is nobody's")
    assert steered.requests_of(request.Abort) == [request.Abort(Reason.plain("it is nobody's"))]


def test_a_script_begins_an_application_and_goes_on(sit):  # R-E07
    sitting = sit()
    sitting.session.in_script = True
    sitting.console.carry_out("begin go_home")
    assert sitting.session.running == "go_home"
    assert sitting.requests_of(request.Begin)[0].on_error == "abort"
    sitting.does("wait run")


def test_a_person_is_waited_for_at_an_error(sit):  # R-E08
    sitting = sit()
    sitting.console.carry_out("run go_home")
    assert sitting.requests_of(request.Begin)[0].on_error == "wait"


def test_a_script_waits_for_the_state_of_a_flow(steered):  # R-E07
    steered.does("wait flow0 paused")
    assert steered.fails("wait flow0 done within 0.1").reason == Reason.of(
        "console.not_within", expected="flow0 done", limit=0.1, reality="paused"
    )
    assert steered.fails("wait flow7 paused").reason == Reason.of("console.no_flow", name="flow7")


def test_what_flows_do_is_told(steered):  # R-E11, R-X03, R-X06
    for message in (
        event.Moved("flow1", "waiting", 0, 1.0, "t a", ("flow0",)),
        event.Moved("flow0", "paused", 1, 2.0),
        event.Moved("flow0", "paused", -1, 2.0),
        event.Moved("flow0", "running", 1, 2.0, text=Reason.plain("does not pause")),
        event.Moved("flow0", "running", 1, 2.0),
        event.Met("t a", ("flow0", "flow1"), 12.0, 3.0),
    ):
        steered.runtime.tell(message)
    steered.session.hear()
    assert [line.partition(" s  ")[2] for line in steered.lines[-5:]] == [
        "flow1 waits at a for flow0",
        "flow0 is paused after 2",
        "flow0 is paused before its first action",
        "flow0 does not pause",
        "flow0 and flow1 go on together at a, 12 us apart",
    ]


def test_why_a_flow_stands_still_is_told_with_what_can_be_done(steered):  # R-X06
    choices = (("clear", Reason.plain("clear the error and repeat")),)
    explained = event.Explained(
        "flow0", "pd", "move", 1, "a.appl:3", Reason.plain("it broke"), "", 0, (), (), choices, 4.0
    )
    steered.runtime.tell(explained)
    steered.session.hear()
    assert any("it broke" in line for line in steered.lines)
    assert any("clear the error and repeat" in line for line in steered.lines)

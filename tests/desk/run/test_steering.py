import pytest

from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.steering import VERBS, Expectation, PositionQuery, SteeringOrder, SteeringWait, act
from onika.desk.run.wait_condition import WaitCondition
from onika.wire import live, request, steer
from onika.words.reason import Reason

ONE = FlowIndex((IndexedFlow("flow0", ("lift", "turn home"), frozenset({"LAMP"})),))
TWO = FlowIndex((*ONE.parts, IndexedFlow("flow1", ("wait", "lift"), frozenset({"X"}))))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("pause", steer.Pause("flow0")),
        ("continue", steer.Resume("flow0")),
        ("step 0", steer.Step("flow0")),
        ("next", steer.Skip("flow0")),
        ("skip 2", steer.Skip("flow0", 1)),
        ("skip turn home", steer.Skip("flow0", 1)),
        ("skip flow0 turn home", steer.Skip("flow0", 1)),
        ("pass", steer.Pass("flow0")),
        ("leave", steer.Leave("flow0")),
        ("break 2", steer.Mark("flow0", 1)),
        ("break 2 if LAMP == 1", steer.Mark("flow0", 1, True, "LAMP == 1")),
        ("break turn home IF flow0/LAMP == 1", steer.Mark("flow0", 1, True, "flow0/LAMP == 1")),
        ("unbreak 1", steer.Mark("flow0", 0, False)),
        ("clear", steer.Recover("flow0")),
        ("abort", request.Abort(Reason.of("desk.aborted_by_user"))),
        ("abort too slow", request.Abort(Reason.plain("too slow"))),
        ("touch boxes panic_left 1", live.Touch("boxes", "panic_left", 1.0)),
    ],
)
def test_a_line_becomes_a_request_for_the_only_flow(line, message):  # R-E07, R-E08, R-E13
    order = act(line, ONE)
    assert isinstance(order, SteeringOrder)
    assert order.message == message


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("pause", steer.Pause("")),
        ("continue", steer.Resume("")),
        ("clear", steer.Recover("")),
        ("pause flow1", steer.Pause("flow1")),
        ("skip 1 2", steer.Skip("flow1", 1)),
        ("skip flow1 lift", steer.Skip("flow1", 1)),
        ("break 1 lift if X > 2", steer.Mark("flow1", 1, True, "X > 2")),
    ],
)
def test_where_there_are_several_some_words_mean_all_and_others_one(line, message):  # R-E07
    assert act(line, TWO).message == message


@pytest.mark.parametrize("line", ["next", "skip 2", "pass", "leave", "break 1", "unbreak 1", "wait began 2"])
def test_where_there_are_several_the_others_want_to_know_which(line):  # R-E07
    with pytest.raises(ValueError, match=r"expected which flow \(flow0, flow1\), found none"):
        act(line, TWO)


@pytest.mark.parametrize(
    ("line", "condition", "within_s"),
    [
        ("wait 2.5", WaitCondition("seconds", seconds=2.5), 60.0),
        ("wait began 2", WaitCondition("began", "flow0", 1), 60.0),
        ("wait done turn home within 5", WaitCondition("done", "flow0", 1), 5.0),
        ("wait done", WaitCondition("done", "flow0"), 60.0),
        ("wait done flow0", WaitCondition("done", "flow0"), 60.0),
        ("wait paused within 0.5", WaitCondition("paused", "flow0"), 0.5),
        ("wait stopped", WaitCondition("stopped", "flow0"), 60.0),
    ],
)
def test_a_script_waits_for_times_actions_and_states(line, condition, within_s):  # R-E07
    assert act(line, ONE) == SteeringWait(condition, within_s)


@pytest.mark.parametrize(
    ("line", "condition"),
    [
        ("wait done 1", WaitCondition("done", "flow1")),
        ("wait done 1 2", WaitCondition("done", "flow1", 1)),
        ("wait waiting", WaitCondition("waiting", "")),
        ("wait began flow1 lift", WaitCondition("began", "flow1", 1)),
    ],
)
def test_where_there_are_several_a_lone_number_is_a_flow(line, condition):  # R-E07
    assert act(line, TWO) == SteeringWait(condition)


def test_an_expectation_knows_where_its_variable_is():  # R-X07
    order = act("expect X < 3", TWO)
    assert isinstance(order, Expectation)
    assert (order.subsystem, order.name, order.condition.text) == ("flow1", "X", "X < 3")


def test_who_asks_where_the_flows_are():  # R-X03
    assert act("who", TWO) == PositionQuery()


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("", "expected one of pause, .* found ''"),
        ("dance", "expected one of pause, .* found 'dance'"),
        ("pause here", r"expected a flow \(flow0\) or its number, found 'here'"),
        ("pause 0 1", r"expected `pause \[FLOW\]`, found `pause 0 1`"),
        ("skip", r"expected `skip \[FLOW\] N`"),
        ("skip 3", "from 1 to 2, found 3"),
        ("break 1 if", "an address, a comparison and a number"),
        ("break 1 if NOBODY == 1", "found NOBODY"),
        ("touch boxes panic_left hard", "expected a number as the value, found 'hard'"),
        ("touch boxes", "expected `touch WORLD PART VALUE`"),
        ("who there", "expected `who`"),
        ("wait", r"expected `wait \(SECONDS"),
        ("wait long", r"expected `wait \(SECONDS"),
        ("wait -1", "seconds from 0"),
        ("wait nan", "seconds from 0"),
        ("wait 1 2", r"expected `wait \(SECONDS"),
        ("wait began", r"expected `wait \(SECONDS"),
        ("wait paused within soon", r"expected `wait \(SECONDS"),
        ("expect LAMP", "an address, a comparison and a number"),
    ],
)
def test_what_is_not_written_as_it_should_be_is_named(line, sentence):  # R-E07
    with pytest.raises(ValueError, match=sentence):
        act(line, ONE)


def test_every_word_says_how_it_is_written_and_what_it_does():
    for name, verb in VERBS.items():
        assert verb.usage.split()[0] == name
        assert verb.purpose

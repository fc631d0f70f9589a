import pytest
from hypothesis import given, strategies as st

from onika.engine.flow import FlowState
from onika.host.diagnosis.stall import causes, last_of, tag_of, waiting_for
from onika.host.diagnosis.stop_cause import CauseKind
from onika.wire.steer import Position


def at(subsystem, state="running", tag="", *waits_for):
    return Position(subsystem, state, 0, tag, waits_for)


def waits(subsystem, tag, *others):
    return at(subsystem, "waiting", tag, *others)


CIRCLE = (waits("flow0", "a", "flow1"), waits("flow1", "b", "flow0"))


def test_a_circle_of_flows_is_a_deadlock_named_once():  # R-X03, R-X06
    (cause,) = causes(CIRCLE)
    assert (cause.kind, cause.subsystem, cause.task, cause.ends) == (CauseKind.DEADLOCK, "flow0", "", False)
    assert str(cause.text) == "flow0 waits at a for flow1, flow1 waits at b for flow0: none of them can go on"


def test_whoever_waits_for_a_flow_of_a_circle_is_no_cause_and_does_not_turn_it():  # R-X06
    early = waits("early", "c", "flow1")
    assert causes((early, *CIRCLE)) == causes(CIRCLE)
    assert causes((*CIRCLE, early)) == causes(CIRCLE)


@pytest.mark.parametrize("state", ["ready", "spawning", "running", "paused", "clearing"])
def test_whoever_waits_for_a_flow_that_can_go_on_waits_rightly(state):  # R-X06
    assert causes((waits("flow0", "a", "flow1"), at("flow1", state))) == ()


@pytest.mark.parametrize(
    ("state", "words"), [("done", "which has ended"), ("stopped", "which stands still at an error")]
)
def test_whoever_waits_for_one_that_comes_no_more_is_deserted(state, words):  # R-X06
    (cause,) = causes((waits("flow0", "assemble a", "flow1"), at("flow1", state)))
    assert (cause.kind, cause.subsystem) == (CauseKind.DESERTED, "flow0")
    assert str(cause.text) == f"flow0 waits at a for flow1, {words}"


def test_a_flow_is_deserted_through_others_too():  # R-X06
    flows = (at("flow0", "done"), waits("flow1", "a", "flow0"), at("flow2", "joining", "", "flow1"))
    near, far = causes(flows)
    assert near.subsystem == "flow1"
    assert str(far.text) == "flow2 waits for flow1, which waits at a for flow0, which has ended"
    assert last_of("flow2", flows) == "flow0"


def test_of_several_awaited_flows_the_one_that_stands_is_named():  # R-X06
    (cause,) = causes((waits("flow0", "a", "flow1", "flow2"), at("flow1"), at("flow2", "stopped")))
    assert "for flow2" in str(cause.text)


@pytest.mark.parametrize("state", ["killing", "ended"])
def test_a_run_that_is_over_stands_still_by_no_cause(state):  # R-X06
    assert causes((*CIRCLE, at("flow2", state))) == ()


def test_who_waits_is_told_with_tags_nearest_first():  # R-X06
    flows = (
        at("flow0", "stopped"),
        waits("flow3", "later", "flow2"),
        waits("flow2", "assemble lift", "flow0", "flow1"),
        at("flow1"),
    )
    assert waiting_for("flow0", flows) == (("flow2", "lift"), ("flow3", "later"))
    assert waiting_for("flow3", flows) == ()
    assert waiting_for("flow0", CIRCLE) == (("flow1", "b"),)


def test_a_flow_that_waits_for_nested_flows_has_no_tag():
    assert tag_of(at("flow0", "joining", "", "flow0.1")) == ""


@st.composite
def situations(draw):
    names = [f"flow{number}" for number in range(draw(st.integers(1, 5)))]
    states = [state.value for state in FlowState if state not in (FlowState.KILLING, FlowState.ENDED)]
    flows = []
    for name in names:
        state = draw(st.sampled_from(states))
        others = [other for other in names if other != name]
        wanted = draw(st.lists(st.sampled_from(others), unique=True)) if others and state == "waiting" else []
        flows.append(at(name, state, "t", *wanted))
    return flows


@given(situations())
def test_what_is_called_stuck_stays_stuck_and_nothing_else_does(flows):  # R-X03, R-X06
    """An oracle that plays: flows that are not waiting come to every tag; those that stand never do."""
    come = {flow.subsystem for flow in flows if flow.state not in ("waiting", "joining", "done", "stopped")}
    for _ in flows:
        come |= {
            flow.subsystem for flow in flows if flow.state in ("waiting", "joining") and come >= set(flow.waits_for)
        }
    stuck = {flow.subsystem for flow in flows if flow.state in ("waiting", "joining")} - come
    objections = causes(flows)
    named = {objection.subsystem for objection in objections if objection.kind is CauseKind.DESERTED}
    for objection in objections:
        if objection.kind is CauseKind.DEADLOCK:
            hanging = {name for name, _ in waiting_for(objection.subsystem, flows)} | {objection.subsystem}
            named |= hanging & stuck
    assert named >= stuck
    assert {objection.subsystem for objection in objections} <= stuck

import pytest

from onika.engine.flow import TABLE, FlowEvent, FlowState, after, diagram

ON_ITS_WAY = {
    "begin": "running",
    "hold": "waiting",
    "join": "joining",
    "rest": "paused",
    "complete": "done",
    "kill": "killing",
}
FAILS = {"fail": "stopped"}
STATES = {
    "ready": {"spawn": "spawning", "kill": "killing"},
    "spawning": ON_ITS_WAY,
    "running": ON_ITS_WAY | FAILS,
    "waiting": ON_ITS_WAY | FAILS,
    "joining": ON_ITS_WAY | FAILS,
    "paused": ON_ITS_WAY | FAILS,
    "stopped": {"fail": "stopped", "recover": "clearing", "kill": "killing"},
    "clearing": ON_ITS_WAY | FAILS,
    "done": ON_ITS_WAY | FAILS,
    "killing": {"gone": "ended"},
    "ended": {},
}
EXPECTED = {(state, event): following for state, events in STATES.items() for event, following in events.items()}


@pytest.mark.parametrize("state", FlowState)
@pytest.mark.parametrize("event", FlowEvent)
def test_every_state_answers_every_event_with_a_state_or_a_refusal(state, event):
    following = EXPECTED.get((state.value, event.value))
    if following is None:
        with pytest.raises(ValueError, match=f"is {state.value} expects .* found {event.value}"):
            after(state, event)
    else:
        assert after(state, event) is FlowState(following)


def test_every_state_can_be_reached_and_all_but_the_last_can_be_left():
    reached = {FlowState.READY} | {following for events in TABLE.values() for following in events.values()}
    assert reached == set(FlowState)
    assert [state for state in FlowState if not TABLE[state]] == [FlowState.ENDED]


def test_a_flow_can_be_aborted_wherever_it_is():  # R-E07
    safe = {FlowState.KILLING, FlowState.ENDED}
    assert all(FlowEvent.KILL in TABLE[state] for state in FlowState if state not in safe)


def test_the_diagram_has_one_arrow_for_every_line_of_the_table():
    arrows = [line.strip() for line in diagram().splitlines() if "-->" in line and "[*]" not in line]
    expected = [f"{state} --> {following}: {event}" for (state, event), following in EXPECTED.items()]
    assert sorted(arrows) == sorted(expected)


def test_a_flow_in_error_does_nothing_before_its_error_is_cleared():  # R-E08
    assert FlowEvent.BEGIN not in TABLE[FlowState.STOPPED]
    assert {state for state, events in TABLE.items() if FlowState.CLEARING in events.values()} == {FlowState.STOPPED}

"""The life of a task."""

import pytest

from onika.model.lifecycle import TABLE, IllegalTransition, LifecycleInput, State, after, diagram, refusal
from onika.words.reason import NOTHING


def test_a_task_is_spawned_initialised_turned_on_and_off_and_killed():  # R-A05
    state = State.WAITING
    for step in (
        LifecycleInput.INITIALISED,
        LifecycleInput.ON,
        LifecycleInput.OFF,
        LifecycleInput.ON,
        LifecycleInput.FINISH,
        LifecycleInput.KILL,
    ):
        state = after(state, step)
    assert state is State.KILLED


def test_a_task_that_asks_goes_on_with_an_answer_or_asks_again():  # R-A10
    asking = after(State.OFF, LifecycleInput.ASK)
    assert asking is State.ASKING
    assert after(asking, LifecycleInput.ASK) is State.ASKING
    assert after(asking, LifecycleInput.ANSWERED) is State.ON
    assert after(asking, LifecycleInput.OFF) is State.OFF


def test_an_error_is_left_by_clear_or_kill_only():  # R-A05, R-C28
    assert {step: state for step, state in TABLE[State.ERROR].items() if state is not State.ERROR} == {
        LifecycleInput.CLEAR: State.OFF,
        LifecycleInput.KILL: State.KILLED,
    }


def test_a_change_of_ports_or_code_leaves_a_task_where_it_is():  # laws 12, 21
    for step in (LifecycleInput.REBIND, LifecycleInput.SWAP, LifecycleInput.REINIT):
        assert all(steps[step] is state for state, steps in TABLE.items() if step in steps)
    assert [state for state, steps in TABLE.items() if LifecycleInput.REINIT in steps] == [State.OFF]
    assert [state for state, steps in TABLE.items() if LifecycleInput.REBIND in steps] == [
        State.WAITING,
        State.OFF,
        State.ERROR,
    ]
    assert [state for state, steps in TABLE.items() if LifecycleInput.SWAP in steps] == [
        State.OFF,
        State.ON,
        State.ERROR,
    ]


def test_a_task_can_fail_and_be_killed_as_long_as_it_lives():
    for state in State:
        if state is not State.KILLED:
            assert after(state, LifecycleInput.FAIL) is State.ERROR
        assert after(state, LifecycleInput.KILL) is State.KILLED


def test_nothing_brings_a_killed_task_back():
    assert set(TABLE[State.KILLED].values()) == {State.KILLED}


def test_to_be_turned_off_is_refused_by_no_task_that_is_initialised_and_undoes_no_error():  # R-A05, law 27
    assert {state: steps.get(LifecycleInput.OFF) for state, steps in TABLE.items()} == {
        State.WAITING: None,
        State.OFF: State.OFF,
        State.ASKING: State.OFF,
        State.ON: State.OFF,
        State.ERROR: State.ERROR,
        State.KILLED: State.KILLED,
    }


def test_a_task_that_has_finished_does_not_go_on():  # law 28
    assert after(State.ON, LifecycleInput.FINISH) is State.OFF


def test_states_and_steps_bear_the_words_that_recordings_and_people_read():  # R-A05
    assert [state.value for state in State] == ["WAITING", "OFF", "ASKING", "ON", "ERROR", "KILLED"]
    steps = "initialised on ask answered off finish fail clear reinit rebind swap kill"
    assert [step.value for step in LifecycleInput] == steps.split()


def test_only_what_is_off_or_asking_comes_on():
    changes = [(state, step, end) for state, steps in TABLE.items() for step, end in steps.items()]
    comes_on = {(state, step) for state, step, end in changes if end is State.ON and state is not end}
    assert comes_on == {(State.OFF, LifecycleInput.ON), (State.ASKING, LifecycleInput.ANSWERED)}


@pytest.mark.parametrize("state", State)
@pytest.mark.parametrize("step", LifecycleInput)
def test_a_step_that_the_table_lacks_is_refused_with_what_would_be_allowed(state, step):
    if step in TABLE[state]:
        assert after(state, step) is TABLE[state][step]
        assert refusal(state, step) == NOTHING
        return
    with pytest.raises(IllegalTransition, match=f"while {state.value}, found {step.value}") as refused:
        after(state, step)
    assert all(existing.value in str(refused.value) for existing in TABLE[state])
    assert str(refusal(state, step)) == str(refused.value)


def test_the_diagram_shows_every_change():
    drawn = diagram().splitlines()
    for state, steps in TABLE.items():
        for step, end in steps.items():
            assert (f"    {state.value} --> {end.value} : {step.value}" in drawn) == (end is not state)
    assert drawn[:2] == ["stateDiagram-v2", "    [*] --> WAITING : spawn"]
    assert drawn[-1] == "    KILLED --> [*]"

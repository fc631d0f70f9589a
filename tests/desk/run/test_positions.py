import pytest

from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.positions import lines, remark, state, state_word, waits
from onika.engine.flow import FlowState
from onika.wire.steer import Position
from onika.words.reason import Reason, in_language

CAST = FlowIndex((IndexedFlow("flow0", ("lift", "turn"), frozenset()), IndexedFlow("flow1", ("wait",), frozenset())))


def test_each_flow_is_a_row_with_what_it_does_and_whom_it_waits_for():  # R-E11, R-X03
    rows = lines([Position("flow0", "running", 1), Position("flow1", "waiting", -1, "t a", ("flow0",))], CAST)
    assert rows == [
        "flow   state    action",
        "flow0  running  2/2 turn",
        "flow1  waiting  -         waits at a for flow0",
    ]


def test_where_names_are_not_known_numbers_stand_alone():  # R-E11
    assert lines([Position("main", "paused", 4)], FlowIndex.seen([]))[1] == "main  paused       5"


@pytest.mark.parametrize(
    ("position", "sentence"),
    [
        (Position("flow0", "running", 0, loops=("outer", "inner")), "in loop inner in outer"),
        (Position("flow0", "stopped", 0, failed=("pd", "puma")), "failed: pd, puma"),
        (Position("flow0", "running", 0, breakpoints=(0, 3)), "pauses after 1, 4"),
        (Position("flow0", "joining", 0, waits_for=("flow0.1",)), "waits for flow0.1"),
        (Position("flow0", "running", 0), ""),
    ],
)
def test_what_there_is_to_say_besides(position, sentence):  # R-E11
    assert str(remark(position)) == sentence


def test_a_pause_that_is_still_to_come_is_said():  # R-E07
    assert str(state(Position("flow0", "running", 0, is_pausing=True))) == "running, will pause"
    assert state(Position("flow0", "paused", 0, is_pausing=True)) == Reason.of("desk.state_paused")


def test_of_a_tag_the_word_of_the_file_is_shown():  # R-X03
    assert str(waits("assemble a", ("flow0", "flow2"))) == "waits at a for flow0 and flow2"
    assert str(waits("", ())) == "waits"


def test_every_state_of_a_flow_has_a_word_in_both_languages():  # R-E11, R-G03
    words = {state.value: state_word(state.value) for state in FlowState}
    assert {name: str(word) for name, word in words.items()} == {name: name for name in words}
    assert all(in_language(word, "es") != word.text for word in words.values())
    assert state_word("of a later release") == Reason.plain("of a later release")

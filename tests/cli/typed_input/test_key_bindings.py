import pytest
from prompt_toolkit.keys import Keys

from onika.cli.typed_input.key_bindings import KEYS, KeyBindings
from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.steering import VERBS, PositionQuery, SteeringOrder, act

TWO = ("flow0", "flow1")


def press(bindings, keys):
    for key in keys:
        bindings.press(key)
    return bindings.take()


@pytest.mark.parametrize("key", sorted(KEYS))
def test_every_key_says_a_line_that_steering_knows(key):  # R-E07
    (line,) = press(KeyBindings(("flow0",)), [key])
    assert line.split()[0] in VERBS
    assert isinstance(act(line, FlowIndex((IndexedFlow("flow0", ("a",), frozenset()),))), SteeringOrder | PositionQuery)


def test_a_flow_is_chosen_by_its_number_and_let_go_by_the_same():  # R-E07
    bindings = KeyBindings(TWO)
    assert press(bindings, "p1p") == ["pause", "pause flow1"]
    assert press(bindings, "1c9s") == ["continue", "step"]


def test_the_end_of_the_run_and_who_waits_are_about_all():  # R-E07
    assert press(KeyBindings(TWO), "1aw") == ["abort", "who"]


def test_with_one_flow_there_is_nothing_to_choose():  # R-E07
    assert press(KeyBindings(("flow0",)), "0n") == ["next"]


def test_a_line_is_typed_to_its_end():  # R-E13
    bindings = KeyBindings(TWO)
    assert press(bindings, [":", *"skip 1 5"]) == []
    assert bindings.typed == "skip 1 5"
    assert press(bindings, [Keys.Backspace, "4", Keys.Up, Keys.ControlM]) == ["skip 1 4"]
    assert bindings.typed is None


def test_a_breakpoint_begins_with_its_word_and_the_chosen_flow():  # R-E07
    bindings = KeyBindings(TWO)
    assert press(bindings, ["b", *"0 3", Keys.ControlM]) == ["break 0 3"]
    assert press(bindings, ["1", "b", *"3 if LAMP == 1", Keys.ControlM]) == ["break flow1 3 if LAMP == 1"]


def test_what_is_typed_can_be_let_be():  # R-E07
    bindings = KeyBindings(TWO)
    assert press(bindings, [":", "a", "b", Keys.ControlU, Keys.Backspace, "p"]) == ["pause"]
    assert press(bindings, [":", Keys.ControlM, "p"]) == ["pause"]


def test_help_comes_and_goes():
    bindings = KeyBindings(TWO)
    press(bindings, "?")
    assert bindings.has_help
    press(bindings, "?z")
    assert not bindings.has_help

import pytest

from onika.cli.key_bindings import KEYS, Wheel
from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.steering import VERBS, PositionQuery, SteeringOrder, act

TWO = ("flow0", "flow1")


def press(wheel, keys):
    for key in keys:
        wheel.press(key)
    return wheel.take()


@pytest.mark.parametrize("key", sorted(KEYS))
def test_every_key_says_a_line_that_steering_knows(key):  # R-E07
    (line,) = press(Wheel(("flow0",)), [key])
    assert line.split()[0] in VERBS
    assert isinstance(act(line, FlowIndex((IndexedFlow("flow0", ("a",), frozenset()),))), SteeringOrder | PositionQuery)


def test_a_flow_is_chosen_by_its_number_and_let_go_by_the_same():  # R-E07
    wheel = Wheel(TWO)
    assert press(wheel, "p1p") == ["pause", "pause flow1"]
    assert press(wheel, "1c9s") == ["continue", "step"]


def test_the_end_of_the_run_and_who_waits_are_about_all():  # R-E07
    assert press(Wheel(TWO), "1aw") == ["abort", "who"]


def test_with_one_flow_there_is_nothing_to_choose():  # R-E07
    assert press(Wheel(("flow0",)), "0n") == ["next"]


def test_a_line_is_typed_to_its_end():  # R-E13
    wheel = Wheel(TWO)
    assert press(wheel, [":", *"skip 1 5"]) == []
    assert wheel.typed == "skip 1 5"
    assert press(wheel, ["backspace", "4", "up", "enter"]) == ["skip 1 4"]
    assert wheel.typed is None


def test_a_breakpoint_begins_with_its_word_and_the_chosen_flow():  # R-E07
    wheel = Wheel(TWO)
    assert press(wheel, ["b", *"0 3", "enter"]) == ["break 0 3"]
    assert press(wheel, ["1", "b", *"3 if LAMP == 1", "enter"]) == ["break flow1 3 if LAMP == 1"]


def test_what_is_typed_can_be_let_be():  # R-E07
    wheel = Wheel(TWO)
    assert press(wheel, [":", "a", "b", "cut to start", "backspace", "p"]) == ["pause"]
    assert press(wheel, [":", "enter", "p"]) == ["pause"]


def test_help_comes_and_goes():
    wheel = Wheel(TWO)
    press(wheel, "?")
    assert wheel.has_help
    press(wheel, "?z")
    assert not wheel.has_help

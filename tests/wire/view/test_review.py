import msgspec

from onika.wire import view


def test_an_action_that_no_step_is_has_step_0():
    assert msgspec.to_builtins(view.PassageView(2, "go", 1.0)) == {"action": 2, "name": "go", "begin_s": 1.0}


def test_no_difference_is_one_without_a_text():
    assert msgspec.to_builtins(view.DifferenceView()) == {}

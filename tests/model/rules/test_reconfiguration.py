from hypothesis import given, settings
from hypothesis import strategies as st

from onika.model.rules.reconfiguration import Change, difference

names = st.lists(st.sampled_from("abcdefgh"), unique=True)


def test_a_task_that_is_not_wanted_goes_off():  # R-A13
    assert difference(["move", "puma"], ["puma"]) == Change(off=("move",), keep=("puma",), on=())


def test_a_task_that_is_not_yet_on_comes_on():  # R-A13
    assert difference(["puma"], ["move", "puma"]) == Change(off=(), keep=("puma",), on=("move",))


def test_a_common_task_is_not_touched():  # R-A13
    assert difference(["puma"], ["puma"]) == Change(off=(), keep=("puma",), on=())


def test_from_nothing_everything_comes_on():
    assert difference([], ["move", "puma"]) == Change(off=(), keep=(), on=("move", "puma"))


def test_to_nothing_everything_goes_off():
    assert difference(["move", "puma"], []) == Change(off=("move", "puma"), keep=(), on=())


def test_off_keeps_the_order_of_what_is_on_and_the_others_that_of_what_is_wanted():
    assert difference(["d", "b", "c", "a"], ["e", "a", "d", "f"]) == Change(("b", "c"), ("a", "d"), ("e", "f"))


def test_a_task_named_twice_is_switched_once():
    assert difference(["a", "a"], ["b", "b"]) == Change(off=("a",), keep=(), on=("b",))


@settings(max_examples=100, deadline=None)
@given(names, names)
def test_carrying_a_change_out_gives_what_is_wanted(on_now, wanted):
    change = difference(on_now, wanted)
    assert (set(on_now) - set(change.off)) | set(change.on) == set(wanted)
    assert set(change.off).isdisjoint(change.keep)
    assert set(change.keep).isdisjoint(change.on)
    assert set(change.keep) == set(on_now) & set(wanted)

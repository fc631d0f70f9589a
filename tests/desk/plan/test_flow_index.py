import pytest

from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.wire.steer import Position

CAST = FlowIndex(
    (
        IndexedFlow("left", ("lift", "turn", "lift"), frozenset({"LAMP", "Q"})),
        IndexedFlow("right", ("wait",), frozenset({"Q", "X"})),
        IndexedFlow("left.1", ("help",), frozenset(), is_nested=True),
    )
)


@pytest.mark.parametrize(
    ("word", "flow"), [("left", "left"), ("1", "right"), ("left.1", "left.1"), ("3", ""), ("middle", ""), ("-1", "")]
)
def test_a_flow_goes_by_its_subsystem_or_its_number(word, flow):  # R-E07
    assert CAST.flow(word) == flow


def test_a_flow_need_not_be_said_where_there_is_one_besides_nested_ones():  # R-E07
    assert CAST.lone == ""
    assert FlowIndex((CAST.parts[0], CAST.parts[2])).lone == "left"


@pytest.mark.parametrize(("word", "index"), [("1", 0), ("3", 2), ("turn", 1)])
def test_an_action_goes_by_its_number_from_one_or_by_its_name(word, index):  # R-E13
    assert CAST.action("left", word) == index


@pytest.mark.parametrize(
    ("word", "sentence"),
    [
        ("0", "from 1 to 3, found 0"),
        ("4", "from 1 to 3, found 4"),
        ("lift", "expected one action, found 'lift' as 1, 3 of left"),
        ("drop", r"number or name \(lift, turn\), found 'drop'"),
    ],
)
def test_an_action_that_is_none_is_refused_with_those_that_are(word, sentence):  # R-E13
    with pytest.raises(ValueError, match=sentence):
        CAST.action("left", word)


def test_of_a_run_that_somebody_else_began_numbers_alone_are_known():  # R-E13
    seen = FlowIndex.seen([Position("left", "running", 2)])
    assert (seen.lone, seen.action("left", "9"), seen.count("left"), seen.name("left", 2)) == ("left", 8, 0, "")
    with pytest.raises(ValueError, match="by its number"):
        seen.action("left", "lift")
    assert seen.home("Q") == ("left", "Q")


def test_a_variable_is_that_of_the_first_flow_that_has_it():  # R-X07
    assert CAST.home("Q") == ("left", "Q")
    assert CAST.home("right/Q") == ("right", "Q")
    assert CAST.home("X") == ("right", "X")


@pytest.mark.parametrize("address", ["NOBODY", "left/X", "nowhere/Q"])
def test_a_variable_that_nobody_has_is_refused(address):  # R-X07
    with pytest.raises(ValueError, match=f"found {address}"):
        CAST.home(address)


def test_names_and_counts_are_those_of_the_plan():  # R-E11
    assert (CAST.name("left", 1), CAST.name("left", -1), CAST.name("left", 9)) == ("turn", "", "")
    assert (CAST.count("left"), CAST.count("nowhere")) == (3, 0)

import pytest

from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import DataItem, IconType, Syntax
from onika.words.value import ValueType

ITEMS = (
    DataItem("endpoint", ValueType.DOUBLE, 2),
    DataItem("count", ValueType.INT, 1),
    DataItem("say", ValueType.LINE, 1),
)
SYNTAX = Syntax((IconType("Joint object", 1, 0, ITEMS), IconType("Complete job", 0, 0)), ())


def test_the_argument_line_joins_the_values_in_the_order_of_the_definition() -> None:
    onikon = Onikon("home", "joint object", "", ((0.5, -1.0), (3,), ("go home",)), blank())
    assert onikon.argument_line(SYNTAX) == '0.5 -1.0 3 "go home"'  # reading 40


def test_an_action_has_an_empty_argument_line() -> None:
    assert Onikon("stop", "Complete job", "", (), blank()).argument_line(SYNTAX) == ""


@pytest.mark.parametrize(
    ("kind", "values"),
    [("Joint object", ((0.5,), (3,), ("x",))), ("Joint object", ()), ("Other object", ()), ("Complete job", ((1,),))],
)
def test_values_that_are_not_those_of_the_type_are_a_fault_of_the_program(kind: str, values: tuple) -> None:
    with pytest.raises(ValueError, match=r"expected .* found"):
        Onikon("x", kind, "", values, blank()).argument_line(SYNTAX)


def test_what_an_icon_says_in_other_languages_stays_in_the_dictionary_when_it_is_placed():  # R-X11
    spoken = Onikon("grip", "Complete job", "close the hand", (), blank(), (), (("es", "cierra la mano"),))
    placed = spoken.as_placed()
    assert (placed.words, placed.description) == ((), "close the hand")
    assert placed.as_placed() is placed


def test_the_arm_that_a_target_was_made_for_stays_in_the_dictionary_when_it_is_placed():  # R-D08
    made = Onikon("high", "Joint object", "", ((0.5, -1.0), (3,), ("x",)), blank(), arm="puma_right")
    assert made.as_placed() == Onikon("high", "Joint object", "", ((0.5, -1.0), (3,), ("x",)), blank())

import pytest

from onika.model.application import AppFlow, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.loop import faults
from onika.model.syntax import IconType, Syntax
from onika.words.fault import Place

SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in ("Complete job", "Joint job", "Joint object")), ())


def icon(mark: str, kind: str = "Complete job") -> Icon:
    """`a` is the anchor of loop a, `a?` its test, `-` no loop."""
    tag = None if mark == "-" else mark.rstrip("?")
    return Icon(Onikon("x", kind, "", (), blank()), while_tag=tag, while_test=mark.endswith("?"))


def found(marks: str) -> list[str]:
    flow = AppFlow(tuple(map(icon, marks.split())))
    return [f"{fault.expected}: {fault.found}" for fault in faults(flow, SYNTAX, "flow 0", Place("a.appl"))]


@pytest.mark.parametrize("marks", ["", "- -", "a a?", "a? a", "a - b b? - a?", "a a? b b?", "a b c? c b? a?"])
def test_loops_apart_or_within_each_other_are_well_formed(marks: str) -> None:
    assert found(marks) == []  # decision 23, R-E01


@pytest.mark.parametrize(
    ("marks", "expected"),
    [
        ("a -", ["the loop tag a twice in flow 0: 1 times", "exactly one test icon of the loop a in flow 0: 0"]),
        ("a a? a", ["the loop tag a twice in flow 0: 3 times"]),
        ("a a", ["exactly one test icon of the loop a in flow 0: 0"]),
        ("a? a?", ["exactly one test icon of the loop a in flow 0: 2"]),
        ("a b a? b?", ["loops that do not cross in flow 0: a (steps 0 to 2) and b (1 to 3)"]),
    ],
)
def test_every_malformed_loop_is_named(marks: str, expected: list[str]) -> None:
    assert found(marks) == expected  # decision 23, R-E01


def test_both_tags_on_one_action_are_no_loop() -> None:
    flow = AppFlow((icon("a", "Joint job"), icon("a?", "Joint object")))  # decision 24
    assert [fault.found for fault in faults(flow, SYNTAX, "flow 0", Place("a.appl"))] == ["it twice at one"]


def test_a_tag_on_a_target_counts_for_its_job() -> None:
    flow = AppFlow((icon("-", "Joint job"), icon("a", "Joint object"), icon("a?")))  # decision 24
    assert faults(flow, SYNTAX, "flow 0", Place("a.appl")) == ()

from dataclasses import replace

import pytest

from onika.model.application import AppFlow, Icon, actions
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.loop import Loop, faults, loops
from onika.model.syntax import IconType, Syntax
from onika.words.fault import Place
from onika.words.reason import Reason

SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in ("Complete job", "Joint job", "Joint object")), ())


X = "`x`, step"
ONE = "expected exactly one test icon of the loop a in flow 0"

FLOW = Reason.of("rules.flow", number=0)


def icon(mark: str, kind: str = "Complete job") -> Icon:
    """`a` is the anchor of loop a, `a?` its test, `-` no loop."""
    tag = None if mark == "-" else mark.rstrip("?")
    return Icon(Onikon("x", kind, "", (), blank()), while_tag=tag, while_test=mark.endswith("?"))


def result(marks: str) -> list[str]:
    flow = AppFlow(tuple(map(icon, marks.split())))
    return [f"{fault.reason}" for fault in faults(flow, SYNTAX, FLOW, Place("a.appl"))]


@pytest.mark.parametrize("marks", ["", "- -", "a a?", "a? a", "a - b b? - a?", "a a? b b?", "a b c? c b? a?"])
def test_loops_apart_or_within_each_other_are_well_formed(marks: str) -> None:
    assert result(marks) == []  # reading 23, R-E01


@pytest.mark.parametrize(
    ("marks", "expected"),
    [
        (
            "a -",
            [
                f"expected the loop tag a twice in flow 0, found 1 times, last at {X} 0",
                f"{ONE}, found 0, the last icon being {X} 0",
            ],
        ),
        ("a a? a", [f"expected the loop tag a twice in flow 0, found 3 times, last at {X} 2"]),
        ("a a", [f"{ONE}, found 0, the last icon being {X} 1"]),
        ("a? a?", [f"{ONE}, found 2, the last icon being {X} 1"]),
        ("a b a? b?", ["expected loops that do not cross in flow 0, found a (steps 0 to 2) and b (steps 1 to 3)"]),
        (
            "a b c a? b? c?",
            [
                f"expected loops that do not cross in flow 0, found {item}"
                for item in (
                    "a (steps 0 to 3) and b (steps 1 to 4)",
                    "a (steps 0 to 3) and c (steps 2 to 5)",
                    "b (steps 1 to 4) and c (steps 2 to 5)",
                )
            ],
        ),
    ],
)
def test_every_malformed_loop_is_named(marks: str, expected: list[str]) -> None:
    assert result(marks) == expected  # reading 23, R-E01


def test_both_tags_on_one_action_are_no_loop() -> None:
    flow = AppFlow((icon("a", "Joint job"), icon("a?", "Joint object")))  # decision 24
    assert [str(fault.reason) for fault in faults(flow, SYNTAX, FLOW, Place("a.appl"))] == [
        "expected the loop tag a at two actions of flow 0, found it twice at one, `x`, step 0"
    ]


def test_a_tag_on_a_target_counts_for_its_job() -> None:
    flow = AppFlow((icon("-", "Joint job"), icon("a", "Joint object"), icon("a?")))  # decision 24
    assert faults(flow, SYNTAX, FLOW, Place("a.appl")) == ()


def test_the_condition_of_a_loop_stands_at_its_test() -> None:
    wrong, right = (replace(icon(mark), while_if="LAMP == 1") for mark in ("a", "a?"))  # R-D13
    sentences = faults(AppFlow((wrong, right)), SYNTAX, FLOW, Place("a.appl"))
    assert [str(fault.reason) for fault in sentences] == [
        "expected the condition of the loop a at its test in flow 0, found it at `x`, step 0"
    ]
    assert faults(AppFlow((icon("a"), right)), SYNTAX, FLOW, Place("a.appl")) == ()


def test_a_fault_stands_at_the_line_of_its_icon() -> None:
    flow = AppFlow((replace(icon("-"), line=3), replace(icon("a?"), line=7)))  # R-E01
    assert [fault.place for fault in faults(flow, SYNTAX, FLOW, Place("a.appl"))] == [Place("a.appl", 7)]


@pytest.mark.parametrize(
    ("marks", "expected"),
    [
        ("- a b? b a?", [Loop("a", 1, 4, 4), Loop("b", 2, 3, 2)]),
        ("a b a? b?", []),
        ("a a? b c? c c d d", [Loop("a", 0, 1, 1)]),
    ],
)
def test_loops_that_are_well_formed_are_known_by_their_ends_and_their_test(marks: str, expected: list[Loop]) -> None:
    flow = AppFlow(tuple(map(icon, marks.split())))  # reading 23, R-E05
    result = loops(flow, actions(flow, SYNTAX))
    assert list(result) == expected
    assert [loop.is_top for loop in result] == [loop.test == loop.start for loop in expected]

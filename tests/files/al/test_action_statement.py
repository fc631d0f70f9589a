import pytest
from tests.files.models import TYPES

from onika.files.al import action_statement
from onika.files.al.logical_line import sentences
from onika.files.al.where_section import WhereSection
from onika.files.text_reading import TextReading
from onika.model.application import Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.words.reason import NOTHING

GO = Onikon("go", "Joint job", "", (), blank())
GRIP = Onikon("opengrip", "Complete job", "", (), blank())
HOME = Onikon("home", "Joint object", "", ((1.0, 2.0), ("x",)), blank())
KNOWN = {item.name: item for item in (GO, GRIP, HOME)}


def read(text: str) -> list[Icon | Hole]:
    (sentence,), _ = sentences(text, TextReading("f", NOTHING))
    return action_statement.read(sentence, WhereSection(KNOWN.get, holes={1: "ROUTINE x\n"}), TYPES)


def home(*values: object) -> Icon:
    return Icon(Onikon("home", "Joint object", "", values, blank()))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("DRIVE go TO home", [Icon(GO), Icon(HOME)]),
        ("DO go", [Icon(GO)]),
        ("OPEN HAND opengrip", [Icon(GRIP)]),
        ("OPEN opengrip", [Icon(GRIP)]),
        ("DRIVE go TO home (3 -4.5e1; here) WITH home", [Icon(GO), home((3.0, -45.0), ("here",)), Icon(HOME)]),
        ('USING home (3 4; who = "a b")', [home((3.0, 4.0), ("a b",))]),
        ("DRIVE go TO HOLE WITH HOLE #1", [Icon(GO), Hole(), Hole(kept="ROUTINE x\n")]),
        ("HOLE", [Hole()]),
    ],
)
def test_a_statement_is_its_steps(text: str, steps: list[Icon | Hole]) -> None:
    assert read(text) == steps  # R-D14


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("DRIVE", "expected the name of a job or application, found the end of the line"),
        ("DRIVE walk", "expected an icon `walk` in the dictionary or under WHERE, found none"),
        ("DRIVE go #2", "expected an icon `go #2` under WHERE, found none"),
        ("MOVE go", "expected DRIVE before `go`, a Joint job, found MOVE"),
        ("DO home", "expected an action after DO, found `home`, a Joint object"),
        ("DRIVE go TO go", "expected a target, found `go`, a Joint job"),
        ("HOLE #2", "expected HOLE #2 under WHERE, found none for '#2'"),
        ("DRIVE go TO home (1 2)", "expected ; and 1 element of type line for who, found ')'"),
        ("DRIVE go TO home (1; x)", "expected 2 elements of type double for endpoint, found 1 in '1'"),
        ("DRIVE go TO home (1 2; )", "expected 1 element of type line for who, found none before ')'"),
        ("DRIVE go TO home (1 2; at=x)", "expected who= or no name, found 'at='"),
        ("DRIVE go TO home (1 b; x)", "expected a number (double), found 'b'"),
        ("DRIVE go TO home (1 2; x; 3)", "expected ) behind the values of Joint object, found '; 3)'"),
        ("DRIVE go home", "expected the end of the line, found 'home'"),
        ("HOLE TO home", "expected the end of the line, found 'TO home'"),
    ],
)
def test_what_is_no_statement_is_told_as_expected_and_found(text: str, complaint: str) -> None:
    with pytest.raises(ValueError) as wrong:
        read(text)
    assert str(wrong.value) == complaint

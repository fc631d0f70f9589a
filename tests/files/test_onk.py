from onika.files.onk import read, write
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import DataItem, IconType, Syntax
from onika.words.value import ValueType

ITEMS = (DataItem("endpoint", ValueType.DOUBLE, 2), DataItem("duration", ValueType.DOUBLE, 1))
SYNTAX = Syntax((IconType("Joint object", 1, 0, ITEMS), IconType("Application start", 0, 0)), ())
ONIKON = Onikon("home", "Joint object", "where it rests", ((0.5, -1.0), (2.0,)), blank())
TEXT = write(ONIKON)


def test_an_onikon_is_read_and_written() -> None:
    head = "VERSION     1.3\n\nONIKON      Joint object\nDESC        where it rests\n"
    assert TEXT.startswith(
        head + "UI          0.5 -1.0\nUI          2.0\nPICT        88888888888888888888888888888888\n"
    )  # R-B03
    assert read(TEXT, "home", "home.onk", SYNTAX) == (ONIKON, ())


def test_comments_of_the_former_text_are_kept() -> None:
    assert write(ONIKON, "# mine\n" + TEXT) == "# mine\n" + TEXT


def test_an_unknown_target_is_left_out_and_reported() -> None:
    onikon, (fault,) = read(TEXT.replace("Joint", "Force"), "home", "home.onk", SYNTAX)  # R-D16
    assert onikon is None
    assert (fault.place.line, fault.instead) == (3, "the icon is left out")


def test_a_start_icon_belongs_into_no_dictionary() -> None:
    text = TEXT.replace("Joint object", "Application start").replace("0.5 -1.0\nUI          2.0", "none")
    onikon, (fault,) = read(text, "home", "home.onk", SYNTAX)
    assert onikon is None
    assert fault.expected == "an action or a target"


def test_an_older_file_may_lack_its_description() -> None:
    text = TEXT.replace("VERSION     1.3\n", "").replace("DESC        where it rests\n", "")  # R-B06
    onikon, faults = read(text, "home", "home.onk", SYNTAX)
    assert faults == ()
    assert onikon
    assert onikon.description == ""
    assert "VERSION     1.3" in write(onikon)

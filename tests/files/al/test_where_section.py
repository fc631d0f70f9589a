from dataclasses import replace

import pytest
from tests.files.models import TYPES

from onika.files.al.where_section import WhereSection, read
from onika.files.text_reading import TextReading
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.words.reason import NOTHING, Reason

HOME = Onikon("home", "Joint object", "up", ((1.0, 2.0), ("x",)), blank())
OTHER = replace(HOME, values=((3.0, 4.0), ("y",)))
DOWN = replace(HOME, description="down")
KEPT = "ROUTINE     push\nMARKER      no\nONIKON      Force object\n"


def again(text: str, onikons: dict[str, Onikon] | None = None) -> tuple[WhereSection, list[str]]:
    """The glossary of a section alone, and its faults."""
    reading = TextReading("f", Reason.plain("nothing"))
    result = read("WHERE\n" + text, len("WHERE\n"), TYPES, (onikons or {}).get, reading)
    return result, [f"{fault.place.line}: {fault.reason}" for fault in reading.faults]


def test_an_icon_the_dictionary_holds_alike_is_named_only() -> None:
    glossary = WhereSection({"home": OTHER}.get)  # R-D14
    assert glossary.refer(HOME) == "home"
    assert glossary.write() == ""
    assert glossary.find("home", 1) == OTHER


def test_icons_of_one_name_that_differ_are_numbered() -> None:
    glossary = WhereSection({"home": HOME}.get)
    assert glossary.refer(DOWN) == "home #2"
    assert glossary.refer(HOME) == "home"
    assert glossary.refer(replace(DOWN, values=OTHER.values)) == "home #2"
    assert glossary.write().startswith("WHERE\n\nICON        home #2\nONIKON      Joint object\nDESC        down\n")
    alone = WhereSection(lambda _: None)
    assert [alone.refer(item) for item in (HOME, DOWN, OTHER)] == ["home", "home #2", "home"]


def test_a_name_that_is_a_word_of_the_language_is_quoted_in_the_program_only() -> None:
    glossary = WhereSection(lambda _: None)
    assert glossary.refer(replace(HOME, name="END")) == '"END"'
    assert "ICON        END\n" in glossary.write()


def test_what_is_written_is_read_again() -> None:
    glossary = WhereSection(lambda _: None)
    timed = Onikon("go", "Joint job", "{ }", (), blank(), ("Any object",))
    for item in (HOME, DOWN, timed):
        glossary.refer(item)
    assert [glossary.refer_hole(item) for item in (KEPT, KEPT + "UI 1\n", KEPT, "")] == [" #1", " #2", " #1", ""]
    result, faults = again(glossary.write().removeprefix("WHERE\n"))
    assert faults == []
    assert result.icons == {("home", 1): HOME, ("home", 2): DOWN, ("go", 1): timed}
    assert result.holes[1] == KEPT
    assert result.find("home", 2) == DOWN
    assert result.find("home", 3) is None


def test_without_the_line_where_there_is_nothing_in_it() -> None:
    assert read("END", -1, TYPES, {"home": HOME}.get, TextReading("f", NOTHING)).find("home", 1) == HOME


ICON = WhereSection(lambda _: None)
ICON.refer(HOME)
LINES = ICON.write().removeprefix("WHERE\n").removesuffix("END WHERE\n")


@pytest.mark.parametrize(
    ("text", "sentences"),
    [
        ("", "1: expected END WHERE, found the end of the text"),
        ("x\nEND WHERE\n", "2: expected ICON or HOLE, found 'x'"),
        ("END WHERE\nx\n", "3: expected nothing after END WHERE, found 'x'"),
        (LINES, "39: expected END WHERE, found the end of the text"),
        (LINES + LINES + "END WHERE\n", "42: expected every icon once, found 'ICON home' again"),
        ("HOLE #1\nEND WHERE\n", "2: expected ROUTINE and the lines of a target behind it, found none"),
        (
            "HOLE #1\nROUTINE x\nENDFLOW\nEND WHERE\n",
            "2: expected ROUTINE and the lines of a target behind it, found ROUTINE ENDFLOW",
        ),
        ("HOLE x\nUI 1\nEND WHERE\n", "2: expected a number such as #1 after HOLE, found 'HOLE x'"),
        ("HOLE #1\nROUTINE x\nHOLE #1\nROUTINE x\nEND WHERE\n", ("4: expected every hole once, found 'HOLE #1' again")),
        (
            LINES.replace("ICON        home", "ICON 2") + "END WHERE\n",
            "3: expected the name of an icon after ICON, found 'ICON 2'",
        ),
        (
            LINES.replace("Joint object", "Application end") + "END WHERE\n",
            "4: expected an action or a target, found 'ONIKON Application end'",
        ),
    ],
)
def test_what_is_wrong_is_told_with_its_line(text: str, sentences: str) -> None:
    assert sentences in again(text)[1]


def test_a_placed_icon_is_named_though_its_dictionary_says_it_in_other_languages_too() -> None:
    spoken = replace(HOME, words=(("es", "casa"),))  # R-D14, R-X11
    glossary = WhereSection({HOME.name: spoken}.get)
    assert glossary.refer(HOME) == HOME.name
    assert glossary.write() == ""
    assert glossary.find(HOME.name, 1) == HOME

from dataclasses import replace

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
    assert (fault.place.line, str(fault.instead)) == (3, "the icon is left out")


def test_a_start_icon_belongs_into_no_dictionary() -> None:
    text = TEXT.replace("Joint object", "Application start").replace("0.5 -1.0\nUI          2.0", "none")
    onikon, (fault,) = read(text, "home", "home.onk", SYNTAX)
    assert onikon is None
    assert str(fault.reason) == "expected an action or a target, found 'ONIKON Application start'"


def test_an_older_file_may_lack_its_description() -> None:
    text = TEXT.replace("VERSION     1.3\n", "").replace("DESC        where it rests\n", "")  # R-B06
    onikon, faults = read(text, "home", "home.onk", SYNTAX)
    assert faults == ()
    assert onikon
    assert onikon.description == ""
    assert "VERSION     1.3" in write(onikon)


def test_a_larger_picture_makes_an_icon_one_of_version_2_0_and_a_smaller_one_again_of_1_3() -> None:
    larger = replace(ONIKON, picture=blank(48))  # R-B09, R-B06
    text = write(larger)
    assert text.startswith("VERSION     2.0\n") and text.count("PICT ") == 48
    assert read(text, "home", "f", SYNTAX) == (larger, ())
    assert write(replace(larger, picture=blank()), text) == TEXT
    for older in ("VERSION     1.3", "VERSION     1.0", ""):
        onikon, (fault,) = read(text.replace("VERSION     2.0", older), "home", "f", SYNTAX)
        assert onikon is None
        assert str(fault.reason) == "expected VERSION 2.0 for a picture of 48 rows, found an older one"
        assert fault.place.line == 7


MORE = Syntax((IconType("Joint object", 1, 0, ITEMS), IconType("Joint job", 0, 1), IconType("Complete job", 0, 0)), ())
VIA = Onikon("via", "Joint job", "", (), blank(), ("Joint object", "Joint object"))


def test_an_icon_with_further_targets_is_of_version_2_0() -> None:
    text = write(VIA)  # R-D13, R-B06
    assert text.startswith(
        "VERSION     2.0\n\nONIKON      Joint job\nTARGET      Joint object\nTARGET      Joint object\n"
    )
    assert read(text, "via", "f", MORE) == (VIA, ())
    assert read(text.replace("TARGET      Joint object", "TARGET joint OBJECT"), "via", "f", MORE) == (VIA, ())
    commented = text.replace("TARGET", "# the second\nTARGET", 1)
    assert write(VIA, commented) == commented


def test_what_is_wrong_with_further_targets_is_named() -> None:
    def keys(text: str) -> set[str]:
        return {fault.reason.key for fault in read(text, "via", "f", MORE)[1] if not fault.is_note}

    text = write(VIA)
    assert keys(text.replace("2.0", "1.3", 1)) == {"files.version_for_line"}
    assert keys(text.replace("Joint job", "Complete job")) == {"files.no_line_target"}
    assert keys(text.replace("Joint object", "Force object")) == {"files.target_type_unknown"}
    assert keys(text.replace("Joint object", "Joint job")) == {"files.target_type_unknown"}
    assert keys(text.replace("Joint job", "Force job")) == set()
    assert keys(text.replace("Joint job", "Force job").replace("Joint object", "Odd object")) == set()


SPOKEN = Onikon(
    "hold", "Complete job", "close the hand", (), blank(), (), (("es", "cierra la mano"), ("pt-BR", "feche"))
)


def test_an_icon_says_what_it_is_in_several_languages_under_version_2_0() -> None:
    text = write(SPOKEN)  # R-X11, R-B06, R-B09
    assert text.startswith(
        "VERSION     2.0\n\nONIKON      Complete job\nDESC        close the hand\n"
        "DESCIN      es cierra la mano\nDESCIN      pt-BR feche\nUI          none\n"
    )
    assert read(text, "hold", "f", MORE) == (SPOKEN, ())
    assert write(replace(SPOKEN, words=())).startswith("VERSION     1.3\n")


def test_what_is_wrong_with_a_description_in_another_language_is_named() -> None:
    def keys(text: str) -> set[str]:
        return {fault.reason.key for fault in read(text, "hold", "f", MORE)[1]}

    text = write(SPOKEN)  # R-B07
    assert keys(text.replace("2.0", "1.3", 1)) == {"files.version_for_line"}
    assert keys(text.replace("pt-BR", "es")) == {"files.descin_once"}
    assert keys(text.replace("pt-BR feche", "pt-BR")) == {"files.descin_line"}
    assert keys(text.replace("es cierra", "Spanish cierra")) == {"files.descin_line"}


OF_RIGHT_ARM = replace(ONIKON, arm="puma_right")


def test_a_target_says_under_version_2_0_for_which_arm_it_was_made() -> None:
    text = write(OF_RIGHT_ARM)  # R-D08, R-B06, R-B09
    assert text.startswith("VERSION     2.0\n") and "\nDESC        where it rests\nARM         puma_right\nUI " in text
    assert read(text, "home", "f", SYNTAX) == (OF_RIGHT_ARM, ())
    assert write(replace(OF_RIGHT_ARM, arm=""), text) == TEXT


def test_what_is_wrong_with_the_arm_of_an_icon_is_named() -> None:
    def keys(text: str) -> set[str]:
        return {fault.reason.key for fault in read(text, "hold", "f", MORE)[1]}

    text = write(OF_RIGHT_ARM)  # R-B07
    assert keys(text.replace("2.0", "1.3", 1)) == {"files.version_for_line"}
    assert keys(text.replace("puma_right", "two words")) == {"files.arm_line"}
    assert keys(write(SPOKEN).replace("UI ", "ARM puma\nUI ")) == {"files.arm_of_target"}

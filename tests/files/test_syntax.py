import pytest

from onika.files.syntax import read, write
from onika.model.syntax import SPECIAL_TYPES, DataItem, Edge, IconType, Syntax
from onika.words.value import ValueType

SYNTAX = Syntax(
    (
        *(IconType(name, 0, 0) for name in SPECIAL_TYPES),
        IconType("Joint job", 0, 7),
        IconType(
            "Joint object", 7, 0, (DataItem("end point", ValueType.DOUBLE, 6), DataItem("duration", ValueType.FLOAT, 1))
        ),
    ),
    (Edge(0, (255, 0, 10), ((-5, 5), (5, 5))), Edge(7, (0, 0, 0), ())),
)
TEXT = write(SYNTAX)


def result(text: str) -> list[str]:
    syntax, faults = read(text, "the syntax", "OnikaUpperSetUp.dta")
    assert (syntax is None) == bool(faults)
    return [f"{fault.reason}" for fault in faults]


def test_a_syntax_is_read_and_written() -> None:
    assert read(TEXT, "s", "f") == (SYNTAX, ())  # R-B05, R-D02
    joint = "ONIKON      Joint object\nLEFTEDGE    7\nRIGHTEDGE   0\n"
    assert joint + "VARNAME     end point\nDATATYPE    double\nNELEMS      6\n" in TEXT
    assert "EDGENUM     0\nRGB         255 0 10\nNUMVERTS    2\nVERTICES    -5 5 5 5\n" in TEXT


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("Joint job", "joint OBJECT", "expected every type once, found 'Joint object' again"),
        ("RIGHTEDGE   7", "RIGHTEDGE   9", ("expected edges that are defined by EDGENUM, found edge 9 of 'Joint job'")),
        ("Complete NOP", "Other NOP", "expected the type Complete NOP, found none"),
        ("EDGENUM     7", "EDGENUM     0", "expected every edge once, found edge 0 again"),
        ("255 0 10", "256 0 10", "expected three numbers from 0 to 255 after RGB, found 'RGB 256 0 10'"),
        ("-5 5 5 5", "-5 5 5", "expected 2 pairs of numbers after VERTICES, found 'VERTICES -5 5 5'"),
        ("Joint object", "Joint thing", "expected VARNAME only for a type of object, found 'VARNAME end point'"),
        ("DATATYPE    double", "DATATYPE    real", "'DATATYPE real'"),
        ("NELEMS      6", "NELEMS      0", "expected a whole number of at least 1 after NELEMS, found 'NELEMS 0'"),
        ("NELEMS      6\n", "", "expected a line NELEMS, found none"),
        ("VARNAME     end point", "VARNAME", "expected the name of a data item after VARNAME, found 'VARNAME'"),
    ],
)
def test_what_is_wrong_is_named(old: str, new: str, expected: str) -> None:
    assert any(fault.endswith(expected) for fault in result(TEXT.replace(old, new, 1)))  # R-B07


def test_types_stand_before_edges() -> None:
    text = TEXT.replace("EOF", "ONIKON x\nLEFTEDGE 0\nRIGHTEDGE 0\nEOF")
    assert result(text) == ["expected every ONIKON before the first EDGENUM, found 'ONIKON x'"]


def test_comments_of_the_former_text_are_kept() -> None:
    former = TEXT.replace("EDGENUM     7", "# red\nEDGENUM     7")
    assert write(SYNTAX, former) == former


def test_a_constant_may_say_how_many_values_there_are_and_a_1_3_file_stays_as_it_is():  # R-D13, R-B09
    kinds = tuple(IconType(name, 0, 0) for name in SPECIAL_TYPES)
    joint = IconType("Joint object", 0, 0, (DataItem("endpoint", ValueType.DOUBLE, 6, "NDOF"),))
    text = write(Syntax((*kinds, joint), (Edge(0, (1, 2, 3), ()),)))
    assert text.startswith("VERSION     2.0\n")
    existing, faults = read(text, "s", "f")
    assert faults == ()
    assert [existing.find("Joint object").items[0].takes(count) for count in (6, 4, 1, 0)] == [True, True, True, False]
    refused, faults = read(text.replace("2.0", "1.3"), "s", "f")
    assert (refused, [fault.reason.key for fault in faults]) == (None, ["files.version_for_line"])
    plain = DataItem("endpoint", ValueType.DOUBLE, 6)
    assert [plain.takes(count) for count in (6, 4)] == [True, False]


def test_there_may_be_several_for_each_that_a_constant_counts():  # R-D13, R-K08
    kinds = tuple(IconType(name, 0, 0) for name in SPECIAL_TYPES)
    path = IconType("Path object", 0, 0, (DataItem("coefficients", ValueType.DOUBLE, 36, "NDOF", 6),))
    text = write(Syntax((*kinds, path), (Edge(0, (1, 2, 3), ()),)))
    assert "DIMENSION   NDOF 6\n" in text
    item = read(text, "s", "f")[0].find("Path object").items[0]
    assert item.each == 6 and [item.takes(count) for count in (36, 42, 30, 35, 0)] == [True, True, True, False, False]
    for wrong in ("NDOF 0", "NDOF six", "NDOF 6 6", "6"):
        _, (fault,) = read(text.replace("NDOF 6", wrong), "s", "f")
        assert fault.reason.key == "files.meaning_after"

from dataclasses import replace

import pytest

from onika.files.conf import read, write
from onika.model.configuration import Configuration, Group, Locus, Placed

TEXT = """\
VERSION     1.3

RMODFILE    jmove
COORDS      10 -20
INLEFT      no
FREQ        250
RTPU        rtpu0

RMODFILE    logger
COORDS      0 0
INLEFT      yes
FREQ        0
RTPU        unknown

LOCUS       Q^_REF
COORDS      3 4
CONNS       2
NUMINCONST  1
NUMOUTCONST 2
NUMINVAR    3
NUMOUTVAR   4
NUMDOUBLEIN 5
SHOW        no

EOF
"""
CONFIGURATION = Configuration(
    "move",
    (Placed("jmove", 10, -20, False, 250.0, "rtpu0"), Placed("logger")),
    (Locus("Q^_REF", 3, 4, 2, 1, 2, 3, 4, 5, False),),
)


def result(text: str) -> list[str]:
    _, faults = read(text, "move", "move.conf")
    return [f"{fault.place.line}: {fault.reason}" for fault in faults]


def test_a_configuration_is_read_and_written() -> None:
    assert read(TEXT, "move", "move.conf") == (CONFIGURATION, ())  # R-B02
    assert write(CONFIGURATION) == TEXT


def test_comments_of_the_former_text_are_kept() -> None:
    former = TEXT.replace("RMODFILE    logger", "# writes the log\nRMODFILE    logger")
    moved = Configuration("move", (Placed("jmove", 1, 2, False, 250.0, "rtpu0"), Placed("logger")), CONFIGURATION.loci)
    assert write(moved, former) == former.replace("10 -20", "1 2")


def test_an_older_file_has_defaults_for_what_it_lacks() -> None:
    configuration, faults = read("RMODFILE a\nCOORDS 1 2\nLOCUS X\nCOORDS 3 4\nEOF", "c", "f")  # R-B06
    assert configuration == Configuration("c", (Placed("a", 1, 2),), (Locus("X", 3, 4),))
    assert faults == ()


def test_a_configuration_may_be_empty() -> None:
    assert read("EOF", "c", "f") == (Configuration("c"), ())
    assert read(write(Configuration("c")), "c", "f") == (Configuration("c"), ())


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("RTPU        rtpu0\n", "", "6: expected a line RTPU, found none"),
        ("10 -20", "10", "4: expected 2 whole numbers after COORDS, found 'COORDS 10'"),
        ("FREQ        250", "FREQ nan", "6: expected a number of at least 0 (Hz) after FREQ, found 'FREQ nan'"),
        ("FREQ        250", "PERIOD 3", "6: expected FREQ, found 'PERIOD 3'"),
        (
            "RMODFILE    jmove",
            "RMODFILE ../jmove",
            "3: expected the name of a task after RMODFILE, found 'RMODFILE ../jmove'",
        ),
        ("RMODFILE    jmove", "RMODFILE    logger", "9: expected RMODFILE logger once, found it again after line 3"),
        ("LOCUS       Q^", "LOCUS q^", ("15: expected the name of a state variable after LOCUS, found 'LOCUS q^_REF'")),
        ("CONNS       2", "CONNS -2", "17: expected a whole number of at least 0 after CONNS, found 'CONNS -2'"),
        ("EOF", "RMODFILE b\nCOORDS 1 2\nEOF", "25: expected every task before the first LOCUS, found 'RMODFILE b'"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(old: str, new: str, expected: str) -> None:
    assert expected in result(TEXT.replace(old, new, 1))  # R-B07
    assert read(TEXT.replace(old, new, 1), "move", "f")[0] is None


GROUPED = TEXT.replace("1.3", "2.0", 1).replace("EOF", "GROUP       arm logger jmove\n\nEOF")


def test_supermodules_stand_behind_the_loci_under_the_newer_version() -> None:
    grouped = replace(CONFIGURATION, groups=(Group("arm", ("logger", "jmove")),))  # R-C17, R-B09
    assert write(grouped) == GROUPED
    assert read(GROUPED, "move", "move.conf") == (grouped, ())
    assert write(replace(grouped, groups=()), GROUPED) == TEXT  # without any it is a file of 1.3 again


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("GROUP", "25: expected the name of a group and those of its tasks after GROUP, found 'GROUP'"),
        ("GROUP arm", "25: expected the name of a group and those of its tasks after GROUP, found 'GROUP arm'"),
        (
            "GROUP arm ../b",
            "25: expected the name of a group and those of its tasks after GROUP, found 'GROUP arm ../b'",
        ),
        ("GROUP arm jmove ghost", "25: expected tasks of this configuration after GROUP arm, found ghost"),
        ("GROUP arm jmove jmove", "25: expected every task in one GROUP, and once, found jmove again after line 25"),
        (
            "GROUP a jmove\nGROUP b jmove",
            "26: expected every task in one GROUP, and once, found jmove again after line 25",
        ),
        ("GROUP a jmove\nGROUP a logger", "26: expected GROUP a once, found it again after line 25"),
        (
            "GROUP a jmove\nLOCUS X\nCOORDS 1 2",
            "26: expected every task and locus before the first GROUP, found 'LOCUS X'",
        ),
        ("GROUP a jmove\nRULE a b", "26: expected no more lines here, found 'RULE a b'"),
    ],
)
def test_what_is_wrong_with_a_supermodule_is_named_with_its_line(line: str, expected: str) -> None:
    text = TEXT.replace("1.3", "2.0", 1).replace("EOF", f"{line}\nEOF")
    assert expected in result(text)  # R-C17, R-B07
    assert read(text, "move", "f")[0] is None


def test_a_supermodule_in_a_file_of_the_thesis_is_told_with_the_version_it_needs() -> None:
    (fault,) = result(GROUPED.replace("2.0", "1.3", 1))  # R-B09
    assert fault == "25: expected VERSION 2.0 for a line GROUP, found 'GROUP arm logger jmove'"

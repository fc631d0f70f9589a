"""Texts that repeat, nest or run on for ever are left out after a bounded look (R-B07); see `files.text_reading`."""

import pytest
from tests.files.models import FORMATS, Format
from tests.files.test_appl import SYNTAX

from onika.files import appl
from onika.files.al import reader as al
from onika.files.text_reading import LONGEST_LINE, MOST_FAULTS, MOST_LINES
from onika.words.fault import Fault

_OF_LINES = [form for form in FORMATS if form.name != "picture"]
"""A picture has rows without keywords, and never more than a few."""
_MANY = MOST_FAULTS + 100
_REPEATED = (
    *(
        "FLOW",
        "ENDFLOW",
        "BRANCH",
        "BRANCH\nFLOW",
        "ENDBRANCH",
        "ROUTINE a",
        "PICT 8",
        "ONIKON a",
        "EOF",
        "VERSION 2.0",
    ),
    *("RMODFILE a", "LOCUS A", "GROUP a", "BUTTON", "EDGENUM 1", "ACTION a", "MEET a", "LINELEN x", "SVARALIAS A = A"),
    *("APPLTYPE x", "INVAR a", "junk", "\x01", '"', "{", "(", "BEGIN", "COBEGIN", "IF A == 1 THEN", "MOVE a;"),
)


def keys(faults: tuple[Fault, ...]) -> list[str]:
    return [fault.reason.key for fault in faults]


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_a_line_that_is_repeated_gives_few_faults(form: Format) -> None:
    for line in _REPEATED:
        _, faults = form.read("VERSION 2.0\n" + f"{line}\n" * _MANY)
        assert faults
        assert len(faults) <= MOST_FAULTS


@pytest.mark.parametrize("form", _OF_LINES, ids=lambda form: form.name)
def test_a_text_of_far_too_many_lines_is_left_out(form: Format) -> None:
    assert "files.lines_many" in keys(form.read("\n" * (5 * MOST_LINES + 1))[1])


@pytest.mark.parametrize("form", _OF_LINES, ids=lambda form: form.name)
def test_a_line_that_does_not_end_is_told_by_its_length(form: Format) -> None:
    _, faults = form.read("X " + "x " * LONGEST_LINE + "\nEOF\n")
    assert "files.line_long" in keys(faults)
    assert all(len(str(fault)) < 500 for fault in faults)


def test_more_faults_than_anybody_reads_end_the_reading() -> None:
    application, faults = appl.salvage("VERSION 2.0\n" + "FLOW\nROUTINE a\n" * _MANY, "a", "a.appl", SYNTAX)
    assert application is None
    assert "files.faults_many" in keys(faults)


def test_branches_without_end_are_left_at_the_first_that_is_too_deep() -> None:
    _, faults = appl.read(
        "VERSION 2.0\nAPPLTYPE conditional\nFLOW\n" + "BRANCH\nFLOW\n" * 200_000 + "EOF\n", "a", "a.appl", SYNTAX
    )
    assert keys(faults) == ["files.branches_too_deep"]


@pytest.mark.parametrize("line", _REPEATED)
def test_a_program_in_words_that_repeats_one_line_gives_few_faults(line: str) -> None:
    application, faults = al.read(f"{line}\n" * _MANY, "a", "a.al", SYNTAX)
    assert application is None
    assert 0 < len(faults) <= MOST_FAULTS


@pytest.mark.parametrize(
    ("text", "key"), [("x" * 1_000_001, "files.text_long"), ("(" * 20_000, "files.statement_long")]
)
def test_a_program_in_words_without_end_is_left_out(text: str, key: str) -> None:
    _, faults = al.read(text, "a", "a.al", SYNTAX)
    assert key in keys(faults)

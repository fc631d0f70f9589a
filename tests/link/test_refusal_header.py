import pytest
from hypothesis import given, strategies as st

from onika.link.refusal_header import LONGEST, read, written
from onika.words.reason import Reason

WRONG_PATH = Reason.of("host.no_such_path", paths=("/", "/señal"))


def test_a_reason_comes_back_as_it_was():
    assert read(written(WRONG_PATH)) == WRONG_PATH
    assert written(WRONG_PATH).isascii()


@pytest.mark.parametrize(
    "header", ["", "no", "[]", "{}", '{"key": 1, "text": ""}', "[" * LONGEST, '{"key": "k", "text": "\ud800"}', "é"]
)
def test_what_is_no_reason_says_none(header):  # R-F01
    assert read(header) is None


def test_a_reason_without_end_is_not_believed():
    long = Reason.plain("x" * LONGEST)
    assert read(written(long)) is None


@given(st.text())
def test_no_header_ends_the_program(header):
    assert read(header) is None or isinstance(read(header), Reason)

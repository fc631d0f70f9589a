import pytest

from onika.files.version import EXTENDED, VERSION, is_extended, is_known, is_older, is_version


@pytest.mark.parametrize(("text", "expected"), [("1.3", True), ("2", True), ("x", False), ("", False), ("1.", False)])
def test_a_version_is_numbers_with_points_between(text: str, expected: bool) -> None:
    assert is_version(text) == expected


def test_what_is_written_can_be_read() -> None:
    assert is_known(VERSION, extended=False)
    assert not is_older(VERSION)
    assert is_known(EXTENDED, extended=True)
    assert is_extended(EXTENDED)


@pytest.mark.parametrize(
    ("text", "plain", "extended"),
    [("0.9", True, True), ("1.3.0", True, True), ("1.3.1", False, False), ("1.9", False, False), ("2", False, True),
     ("02.0.0", False, True), ("2.0.1", False, False), ("3", False, False)],
)  # fmt: skip
def test_older_versions_are_known_and_of_the_newer_ones_two_where_there_are_lines_of_it(
    text: str, plain: bool, extended: bool
) -> None:
    assert is_known(text, extended=False) == plain  # R-B06
    assert is_known(text, extended=True) == extended
    assert is_extended(text) == (extended and not plain)

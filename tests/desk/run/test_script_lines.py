import pytest
from hypothesis import given, strategies as st

from onika.desk.run import script_lines
from onika.words.fault import Place


@pytest.mark.parametrize(
    ("line", "content"),
    [
        ("spawn puma  # the arm", "spawn puma"),
        ("# all of it", ""),
        ("   ", ""),
        ('echo "a # b" # c', 'echo "a # b"'),
        ("echo a#b", "echo a#b"),
        (r'echo "a \" # b"', r'echo "a \" # b"'),
    ],
)
def test_a_comment_begins_with_a_free_standing_sign(line, content):  # R-A16
    assert script_lines.bare(line) == content


@given(st.text(alphabet='ab #"\\', max_size=12))
def test_what_is_left_is_left_as_it_is(line):
    assert script_lines.bare(script_lines.bare(line)) == script_lines.bare(line)


def test_lines_keep_their_places():
    lines = list(script_lines.lines("# head\nspawn puma\r\n\non puma # go\n", "a.txt"))
    assert lines == [(Place("a.txt", 2), "spawn puma"), (Place("a.txt", 4), "on puma")]


def test_a_script_that_cannot_be_read_is_a_fault(tmp_path):
    lines, (fault,) = script_lines.load(tmp_path / "none")
    assert (lines, fault.place.file) == (None, str(tmp_path / "none"))

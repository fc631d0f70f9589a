from pathlib import Path

import pytest

from onika.files.site.launch_list import read, write
from onika.model.launch import Launch

WHOLE = Launch(
    "arm",
    worlds=("boxes", "table"),
    robot="arm_left",
    units=("left", "right"),
    port=7996,
    is_virtual=True,
    needs_booking=True,
    takes_code=True,
    stays=True,
    lease_s=0.5,
)
TEXT = write([WHOLE, Launch("spare")])


def faults_of(text):
    launches, faults = read(text, "list", "list")
    assert launches is None
    return [str(fault.sentence) for fault in faults]


def test_a_list_is_read_as_it_was_written():  # R-A15
    assert read(TEXT, "list", "list") == ((WHOLE, Launch("spare")), ())
    assert write([WHOLE, Launch("spare")], TEXT) == TEXT


def test_comments_stay_where_a_list_is_written_again():
    noted = TEXT.replace("LAUNCH      spare", "# what is left over\nLAUNCH      spare")
    assert write([WHOLE, Launch("spare")], noted) == noted


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("PORT 70000", "a port up to 65535"),
        ("LEASE 9 s", "LEASE of 0.2 to 3 s"),
        ("LEASE much", "LEASE of 0.2 to 3 s"),
        ("BOOKING needed", "expected ROBOT NAME"),
        ("TIME fast", "wall or virtual"),
        ("CODE perhaps", "yes or no"),
        ("WORLD /etc", "a name"),
        ("UNIT --listen", "a name"),
        ("COMMAND reboot", "COMMAND"),
    ],
)
def test_what_a_launch_cannot_be_is_told_with_its_line(line, words):  # R-A15
    told = faults_of(f"VERSION 2.0\nLAUNCH arm\n{line}\nEOF\n")
    assert words in " ".join(told)
    assert "list:3" in " ".join(told)


def test_two_of_one_name_and_two_at_one_port_are_told():
    told = faults_of("VERSION 2.0\nLAUNCH a\nPORT 7996\nLAUNCH a\nLAUNCH b\nPORT 7996\nEOF\n")
    assert "every name once" in told[0] and "7996 is that of another" in told[1]


def test_a_list_of_nothing_is_none():
    assert "expected LAUNCH" in faults_of("VERSION 2.0\nEOF\n")[0]


def test_the_list_of_the_guide_is_read_as_it_stands_there():  # R-A15
    guide = Path(__file__).parents[3] / "docs" / "guide" / "38-a-site-that-launches.md"
    text = guide.read_text().partition("```text file=launches\n")[2].partition("```")[0]
    launches, faults = read(text, "launches", "launches")
    assert faults == ()
    assert [launch.name for launch in launches] == ["arm", "sandbox"]

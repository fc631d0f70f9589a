import os

import pytest

from onika.host.runtime_options import followed, options


def test_what_is_not_given_is_as_usual():  # R-A15
    given = options(["--link-fd", "5", "--parent", "7", "--virtual"])
    assert (given.link_fd, given.parent, given.virtual, given.forecast, given.rtpu) == (5, 7, True, False, [])


@pytest.mark.parametrize("words", [[], ["--parent", "7"], ["--link-fd", "5", "--listen", "127.0.0.1:0"]])
def test_a_runtime_that_nobody_could_speak_to_is_not_started(words, capsys):  # R-A15
    with pytest.raises(SystemExit):
        options(words)
    assert capsys.readouterr().err


def told(text):
    """A descriptor on which it was told, by one who has ended."""
    read, write = os.pipe()
    os.write(write, text)
    os.close(write)
    return read


def test_options_may_follow_when_the_libraries_are_loaded():  # R-A15
    first = ["--link-fd", "5", "--parent", "7", "--virtual"]
    given = followed(first, told(b'["--rtpu", "left", "--scale", "2"]'))
    assert (given.link_fd, given.virtual, given.rtpu, given.scale) == (5, True, ["left"], 2.0)


def test_a_runtime_that_is_not_wanted_any_more_ends_quietly(capsys):  # R-A15
    with pytest.raises(SystemExit) as end:
        followed(["--link-fd", "5", "--parent", "7"], told(b""))
    assert (end.value.code, capsys.readouterr().err) == (0, "")

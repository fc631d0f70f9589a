import pytest

from onika.host.runtime_options import options


def test_what_is_not_given_is_as_usual():  # R-A15
    given = options(["--link-fd", "5", "--parent", "7", "--virtual"])
    assert (given.link_fd, given.parent, given.virtual, given.forecast, given.rtpu) == (5, 7, True, False, [])


@pytest.mark.parametrize("words", [[], ["--parent", "7"], ["--link-fd", "5", "--listen", "127.0.0.1:0"]])
def test_a_runtime_that_nobody_could_speak_to_is_not_started(words, capsys):  # R-A15
    with pytest.raises(SystemExit):
        options(words)
    assert capsys.readouterr().err

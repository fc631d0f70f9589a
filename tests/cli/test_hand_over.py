import pytest

from onika.cli import hand_over as room, main
from onika.files.state.staying_runtime import StayingFile, StayingRuntime, staying_path
from onika.link.token import own_token, token_path
from onika.wire.hand_over import HandOver, hand_over_in


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return tmp_path


def test_a_runtime_that_stays_is_handed_over_as_it_is(home, monkeypatch, capsys):  # R-A15
    token, file = own_token(token_path()), StayingFile(staying_path())
    file.say(StayingRuntime(4711, 12))
    monkeypatch.setattr(room.os, "read", lambda _number, _size: b"")
    assert main(["runtime", "--hand-over", "--stay"]) == 0
    assert hand_over_in(capsys.readouterr().out) == HandOver(4711, token, 12, is_new=False)
    file.close()


def test_one_that_does_not_come_to_stay_says_what_it_said(home, monkeypatch, capsys):  # R-A15
    monkeypatch.setattr(room, "RUNTIME", ("sh", "-c", "echo it is broken; exit 3"))
    assert main(["runtime", "--hand-over", "--stay"]) == 1
    assert "it is broken" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["--stay"], ["--hand-over", "--listen", "127.0.0.1:0"]])
def test_words_that_do_not_go_together_are_refused(words, capsys):  # R-A15
    with pytest.raises(SystemExit):
        main(["runtime", *words])
    assert "hand-over" in capsys.readouterr().err

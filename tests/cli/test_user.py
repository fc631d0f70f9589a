import io
import sys

import pytest

from onika.cli import commands, user
from onika.link.token import digest

GOOD = "correct horse battery"


@pytest.fixture
def state(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return tmp_path / "onika" / "page-users"


@pytest.fixture
def typed(monkeypatch):
    def type_in(text):
        monkeypatch.setattr(sys, "stdin", io.StringIO(text))

    return type_in


def test_users_are_added_listed_and_removed(state, typed, capsys):  # R-F10
    typed(f"{GOOD}\n")
    assert commands.carry_out(["user", "add", "ann", "owner"]) == 0
    assert "ann may come in, as owner" in capsys.readouterr().out
    assert state.stat().st_mode & 0o077 == 0
    assert GOOD not in state.read_text()
    typed(f"{GOOD}\n")
    assert commands.carry_out(["user", "add", "ann", "viewer"]) == 0
    assert "ann is viewer from now on" in capsys.readouterr().out
    assert commands.carry_out(["user", "list"]) == 0
    assert capsys.readouterr().out == "ann  viewer\n"
    assert commands.carry_out(["user", "remove", "ann"]) == 0
    assert commands.carry_out(["user", "list"]) == 0
    assert "nobody is in" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "password", "words"),
    [("ann", "short", "10 to 256"), ("a/b", GOOD, "a name of letters"), ("horse", GOOD, "not easily guessed")],
)
def test_what_will_not_do_is_told_and_nobody_is_added(state, typed, capsys, name, password, words):  # R-F10, R-X01
    typed(f"{password}\n")
    assert commands.carry_out(["user", "add", name, "viewer"]) == 1
    assert words in capsys.readouterr().err
    assert not state.exists()


def test_a_password_is_typed_twice_at_a_terminal(state, monkeypatch, capsys):  # R-F10
    monkeypatch.setattr(sys.stdin, "isatty", lambda: True, raising=False)
    answers = [GOOD, f"{GOOD}!", GOOD, GOOD]
    monkeypatch.setattr(user.getpass, "getpass", lambda _prompt: answers.pop(0))
    assert commands.carry_out(["user", "add", "ann", "viewer"]) == 1
    assert "twice" in capsys.readouterr().err
    assert commands.carry_out(["user", "add", "ann", "viewer"]) == 0


def test_whoever_is_not_there_cannot_be_removed(state, capsys):  # R-X01
    assert commands.carry_out(["user", "remove", "bob"]) == 1
    assert "'bob'" in capsys.readouterr().err


def test_lines_that_are_none_are_not_lost_by_writing(state, typed, capsys, tmp_path):  # R-X01
    file = tmp_path / "users"
    file.write_text("bob viewer something\n")
    typed(f"{GOOD}\n")
    assert commands.carry_out(["user", "add", "ann", "viewer", "--users", str(file)]) == 1
    assert f"{file}:1" in capsys.readouterr().err
    assert file.read_text() == "bob viewer something\n"


def test_a_token_of_a_runtime_or_site_goes_alone_into_a_file(state, capsys, tmp_path):  # R-F02
    file = tmp_path / "users"
    assert commands.carry_out(["user", "token", "ann", "programmer", "--users", str(file)]) == 0
    told = capsys.readouterr()
    token = told.out.strip()
    assert file.read_text() == f"ann programmer {digest(token)}\n" and token not in told.err
    assert commands.carry_out(["user", "token", "ann", "viewer", "--users", str(file)]) == 1
    assert "one role for ann" in capsys.readouterr().err

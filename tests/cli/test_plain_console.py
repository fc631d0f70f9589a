import os

import pytest

from onika.cli.plain_console import PlainConsole
from onika.desk.console.display import Tone
from onika.words.reason import Reason


@pytest.fixture
def pipe(monkeypatch):
    read, write = os.pipe()
    with os.fdopen(read) as stdin:
        monkeypatch.setattr("sys.stdin", stdin)
        yield write


def test_lines_come_one_by_one_and_then_the_end(pipe):  # R-A16
    with PlainConsole() as desk:
        os.write(pipe, "spawn puma\r\non pé\nhalf".encode())
        assert desk.line("", 0.0) == "spawn puma"
        assert desk.line("", 0.0) == "on pé"
        assert desk.line("", 0.0) is None
        os.close(pipe)
        assert desk.line("", 0.0) == "half"
        with pytest.raises(EOFError):
            desk.line("", 0.0)


def test_nothing_is_waited_for_longer_than_said(pipe):
    assert PlainConsole().line("", 0.0) is None
    os.close(pipe)


def test_lines_are_plain_and_no_prompt_goes_to_a_file(pipe, capsys):
    desk = PlainConsole()
    desk.say(Reason.plain("\x1b[2Jred"), Tone.FAULT)
    desk.line("main> ", 0.0)
    desk.drop()
    assert capsys.readouterr().out == "�[2Jred\n"
    os.close(pipe)


def test_a_person_at_a_plain_terminal_gets_a_prompt_once(pipe, monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    desk = PlainConsole()
    for _ in range(3):
        desk.line("main> ", 0.0)
    os.write(pipe, b"tasks\n")
    assert desk.line("main> ", 0.0) == "tasks"
    desk.line("main> ", 0.0)
    assert capsys.readouterr().out == "main> main> "
    os.close(pipe)


def test_a_closed_input_is_an_end(monkeypatch):
    monkeypatch.setattr("sys.stdin", None)
    with pytest.raises(EOFError):
        PlainConsole().line("", 0.0)

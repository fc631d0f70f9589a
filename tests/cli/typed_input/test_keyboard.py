import os
import pty
import select
import termios
from types import SimpleNamespace

import pytest
from prompt_toolkit.keys import Keys

from onika.cli.typed_input import keyboard as room, terminal_input
from onika.cli.typed_input.keyboard import Keyboard


@pytest.fixture
def terminal(monkeypatch):
    """A terminal that is ours: the other end of it, and its settings."""
    far, near = pty.openpty()
    monkeypatch.setattr(terminal_input.os, "tcgetpgrp", lambda _: os.getpgrp())
    with os.fdopen(near) as stdin:
        monkeypatch.setattr(room, "sys", SimpleNamespace(stdin=stdin))
        yield SimpleNamespace(
            type=lambda text: os.write(far, text.encode()),
            is_typed=lambda: select.select([near], [], [], 10.0)[0] == [near],
            mode=lambda: termios.tcgetattr(near),
        )
    os.close(far)


def is_raw(terminal):
    return not terminal.mode()[3] & (termios.ICANON | termios.ECHO)


def pressed(keyboard, count):
    keys = []
    for _ in range(10_000):  # the kernel hands them on when it likes
        keys += keyboard.pressed()
        if len(keys) >= count:
            return keys
    raise AssertionError(keys)


def test_keys_are_heard_at_once_and_the_terminal_is_as_it_was(terminal):  # R-E07
    usual = terminal.mode()
    with Keyboard() as keyboard:
        assert keyboard.is_there
        assert is_raw(terminal)
        assert terminal.mode()[3] & termios.ISIG
        assert keyboard.pressed() == []
        terminal.type("p1\r")
        assert pressed(keyboard, 3) == ["p", "1", Keys.ControlM]
    assert terminal.mode() == usual


def test_the_terminal_is_restored_whatever_happens(terminal):  # R-E07
    usual = terminal.mode()
    with pytest.raises(RuntimeError), Keyboard():
        raise RuntimeError("something")
    assert terminal.mode() == usual


def test_a_key_with_alt_is_another_key(terminal):  # R-E07
    with Keyboard() as keyboard:
        terminal.type("\x1bcp")
        assert pressed(keyboard, 1) == ["p"]


def test_after_escape_alone_the_next_key_counts(terminal):  # R-E07
    with Keyboard() as keyboard:
        terminal.type("\x1b")
        assert terminal.is_typed()
        assert keyboard.pressed() == keyboard.pressed() == []
        terminal.type("a")
        assert pressed(keyboard, 1) == ["a"]


def test_the_end_of_the_input_takes_the_keyboard_away():
    far, near = pty.openpty()
    with os.fdopen(near) as stdin, pytest.MonkeyPatch.context() as patch:
        patch.setattr(room, "sys", SimpleNamespace(stdin=stdin))
        with Keyboard() as keyboard:
            os.close(far)
            assert select.select([near], [], [], 10.0)[0]
            assert keyboard.pressed() == []
            assert not keyboard.is_there
            assert keyboard.pressed() == []


def test_in_the_background_the_terminal_is_not_touched(terminal, monkeypatch):  # R-E07
    usual = terminal.mode()
    monkeypatch.setattr(terminal_input.os, "tcgetpgrp", lambda _: os.getpgrp() + 1)
    with Keyboard() as keyboard:
        terminal.type("p")
        assert keyboard.pressed() == []
        assert terminal.mode() == usual
        assert keyboard.is_in_background
        monkeypatch.setattr(terminal_input.os, "tcgetpgrp", lambda _: os.getpgrp())
        keyboard.pressed()
        assert is_raw(terminal)
    assert terminal.mode() == usual


def test_without_a_terminal_there_are_no_keys(monkeypatch):  # R-E07
    read, write = os.pipe()
    os.close(write)
    with os.fdopen(read) as stdin:
        monkeypatch.setattr(room, "sys", SimpleNamespace(stdin=stdin))
        with Keyboard() as keyboard:
            assert not keyboard.is_there
            assert keyboard.pressed() == []
    monkeypatch.setattr(room, "sys", SimpleNamespace(stdin=None))
    assert not Keyboard().is_there

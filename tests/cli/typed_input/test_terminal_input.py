import os
import pty
import termios
from types import SimpleNamespace

import pytest
from hypothesis import given, strategies as st
from prompt_toolkit.keys import Keys

from onika.cli.typed_input import terminal_input as room
from onika.cli.typed_input.terminal_input import TerminalInput


@pytest.fixture(scope="module")
def terminal():
    """A terminal: its near end as standard input, and what is typed at its far end."""
    far, near = pty.openpty()
    with os.fdopen(near) as stdin:
        yield SimpleNamespace(stdin=stdin, far=far, type=lambda data: os.write(far, data))
    os.close(far)


def keys_of(*pieces):
    """The names of the keys of these bytes, which come one piece after the other."""
    read, write = os.pipe()
    with os.fdopen(read) as stdin:
        stdin.isatty = lambda: True
        keys = TerminalInput(stdin)
        presses = []
        for piece in pieces:
            os.write(write, piece)
            presses += keys.read_keys()
        os.close(write)
    return [press.key for press in presses if press.key != Keys.Ignore]


def test_keys_come_at_once_unechoed_and_ctrl_c_stays_a_signal(terminal):  # R-E07, decision 11
    usual = termios.tcgetattr(terminal.stdin)
    with TerminalInput(terminal.stdin).single_keys():
        mode = termios.tcgetattr(terminal.stdin)
        assert not mode[3] & (termios.ICANON | termios.ECHO)
        assert mode[3] & termios.ISIG
        assert mode[6][termios.VSUSP] == b"\0"
    assert termios.tcgetattr(terminal.stdin) == usual


def test_the_terminal_is_restored_whatever_happens(terminal):  # R-E07
    usual = termios.tcgetattr(terminal.stdin)
    with pytest.raises(RuntimeError), TerminalInput(terminal.stdin).single_keys():
        raise RuntimeError("something")
    assert termios.tcgetattr(terminal.stdin) == usual


def test_a_terminal_that_has_hung_up_needs_no_restoring():
    far, near = pty.openpty()
    with os.fdopen(near) as stdin, TerminalInput(stdin).single_keys():
        os.close(far)


def test_the_library_changes_the_mode_neither_way(terminal):
    keys = TerminalInput(terminal.stdin)
    usual = termios.tcgetattr(terminal.stdin)
    with keys.raw_mode():
        assert termios.tcgetattr(terminal.stdin) == usual
    with keys.single_keys(), keys.cooked_mode():
        assert not termios.tcgetattr(terminal.stdin)[3] & termios.ECHO


def test_it_knows_whether_another_program_has_the_terminal(terminal, monkeypatch):  # R-E07
    keys = TerminalInput(terminal.stdin)
    assert not keys.is_in_background  # it is not the terminal of this session
    monkeypatch.setattr(room.os, "tcgetpgrp", lambda _: os.getpgrp() + 1)
    assert keys.is_in_background
    monkeypatch.setattr(room.os, "tcgetpgrp", lambda _: os.getpgrp())
    assert not keys.is_in_background


@pytest.mark.parametrize(
    ("data", "keys"),
    [
        ("é漢".encode(), ["é", "漢"]),
        (b"a\xffb", ["a", "�", "b"]),
        (b"\x1b[A\x1bOB\x1b[3~", [Keys.Up, Keys.Down, Keys.Delete]),
        (b"\x1b[1;5Cx", [Keys.ControlRight, "x"]),
        (b"\x1bb", [Keys.Escape, "b"]),
        (b"a\x1b[999zc", ["a", Keys.Escape, "c"]),
        (b"\x1b[?62;c", [Keys.Escape]),
        (b"\x1bOpp", [Keys.Escape, "p"]),
        (b"\x1b[?6\x1b[A", [Keys.Escape, Keys.Up]),
    ],
)
def test_a_control_sequence_is_one_key_or_nothing_but_never_its_letters(data, keys):  # R-E07
    assert keys_of(data) == keys


PIECES = [
    b"a",
    "漢".encode(),
    b"\x1b[A",
    b"\x1b[1;5D",
    b"\x1bOC",
    b"\x1bf",
    b"\x7f",
    b"\x1b[999z",
    b"\x1b[?62;c",
    b"\x1bOp",
]


@given(st.lists(st.sampled_from(PIECES)), st.data())
def test_it_does_not_matter_where_they_are_cut(pieces, data):
    whole = b"".join(pieces)
    place = data.draw(st.integers(0, len(whole)))
    assert keys_of(whole[:place], whole[place:]) == keys_of(whole)


def test_escape_alone_is_held_back_until_it_is_sure(terminal):
    keys = TerminalInput(terminal.stdin)
    with keys.single_keys():
        terminal.type(b"\x1b")
        assert keys.read_keys() == []
        assert [press.key for press in keys.flush_keys()] == [Keys.Escape]

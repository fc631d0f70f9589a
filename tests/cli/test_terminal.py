import fcntl
import os
import pty
import select
import struct
import termios
from types import SimpleNamespace

import pytest

from onika.cli import terminal as room
from onika.cli.terminal import Terminal
from onika.desk.console.display import Tone


@pytest.fixture
def screen(monkeypatch):
    """The other end of a terminal of 40 columns; `shown` reads what was written so far."""
    far, near = pty.openpty()
    fcntl.ioctl(near, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 40, 0, 0))
    monkeypatch.setenv("COLUMNS", "40")
    monkeypatch.delenv("NO_COLOR", raising=False)

    class Screen:
        descriptor = near

        def type(self, text):
            os.write(far, text.encode())

        def shown(self, end):
            """What was written up to these words; the kernel hands it on when it likes."""
            text = ""
            while not text.endswith(end):
                assert select.select([far], [], [], 10.0)[0], f"expected {end!r}, found {text!r}"
                text += os.read(far, 1).decode("latin-1")
            return text.replace("\r\n", "\n")

    with os.fdopen(os.dup(near)) as stdin, os.fdopen(os.dup(near), "w") as stdout:
        # not those of sys itself, which the test's own capture exchanges
        monkeypatch.setattr(room, "sys", SimpleNamespace(stdin=stdin, stdout=stdout))
        yield Screen()
    os.close(near)
    os.close(far)


def next_line(terminal):
    """The next whole line; the keys are there already, the turns only pass them on."""
    for _ in range(50):
        line = terminal.line("main> ", 0.05)
        if line is not None:
            return line
    raise AssertionError("no line")


def test_a_line_is_typed_at_the_prompt_and_stays_above(screen):  # R-A16
    with Terminal(lambda before: []) as terminal:
        terminal.line("main> ", 0.0)
        assert screen.shown("\x1b[6C") == "\r\x1b[Kmain> \r\x1b[6C"
        screen.type("spawn\r")
        assert next_line(terminal) == "spawn"
        terminal.say("there")
    assert screen.shown("there\r\n").endswith("\r\x1b[Kmain> spawn\nthere\n")


def test_what_happens_goes_by_above_the_line_that_is_typed(screen):  # R-A16
    with Terminal(lambda before: []) as terminal:
        screen.type("spaw")
        terminal.line("main> ", 1.0)
        terminal.say("main/puma ON", Tone.GOOD)
        assert "\x1b[32mmain/puma ON\x1b[0m" in screen.shown("\r\n\r\x1b[Kmain> spaw\r\x1b[10C")
        screen.type("n\r")
        assert next_line(terminal) == "spawn"


def test_colour_is_left_out_where_none_is_wanted_and_no_escape_gets_through(screen, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    with Terminal(lambda before: []) as terminal:
        terminal.say("\x1b[2Jred", Tone.FAULT)
    assert "\x1b" not in screen.shown("[2Jred\r\n")


def test_completions_are_offered_side_by_side(screen):  # R-A16
    with Terminal(lambda before: [f"task{n:02}" for n in range(9)]) as terminal:
        screen.type("task0\t")
        terminal.line("main> ", 1.0)
    assert screen.shown("task00  task01  task02  task03  task04\x1b[0m\r\n")


def test_a_long_line_is_shown_around_its_cursor(screen):
    with Terminal(lambda before: []) as terminal:
        screen.type("ab" + "x" * 60 + "end")
        terminal.line("main> ", 1.0)
        last = screen.shown("xend\r\x1b[39C").rpartition("\x1b[K")[2]
        assert last.startswith("main> xxx")
        screen.type("\x01")
        terminal.line("main> ", 1.0)
        assert screen.shown("x\r\x1b[6C").rpartition("\x1b[K")[2].startswith("main> abx")


def test_ctrl_d_ends_the_input(screen):
    with Terminal(lambda before: []) as terminal, pytest.raises(EOFError):
        screen.type("\x04")
        terminal.line("main> ", 1.0)


def test_what_was_typed_can_be_dropped(screen):
    with Terminal(lambda before: []) as terminal:
        screen.type("spawn")
        terminal.line("main> ", 1.0)
        terminal.drop()
        screen.type("off\r")
        assert next_line(terminal) == "off"


def test_the_screen_is_cleared_on_wish(screen):
    with Terminal(lambda before: []) as terminal:
        screen.type("\x0c")
        terminal.line("main> ", 1.0)
    assert screen.shown("\x1b[H\x1b[2J")


def test_lines_are_remembered_for_the_next_console(screen, tmp_path):  # R-A16
    path = tmp_path / "state" / "history"
    for typed, expected in (("status\r", "status"), ("\x1b[A\r", "status")):
        with Terminal(lambda before: [], path) as terminal:
            screen.type(typed)
            assert next_line(terminal) == expected
    assert path.read_text() == "status\n"
    assert path.stat().st_mode & 0o077 == 0
    with Terminal(lambda before: [], tmp_path):  # a folder: no history, and no complaint
        pass


def test_the_terminal_is_left_as_it_was(screen):
    usual = termios.tcgetattr(screen.descriptor)
    with Terminal(lambda before: []):
        assert not termios.tcgetattr(screen.descriptor)[3] & termios.ECHO
    assert termios.tcgetattr(screen.descriptor) == usual

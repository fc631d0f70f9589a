import fcntl
import os
import pty
import re
import select
import signal
import struct
import termios
from contextlib import contextmanager
from types import SimpleNamespace

import pytest

from onika.cli import terminal as room
from onika.cli.terminal import Terminal
from onika.desk.console.display import Tone
from onika.words.reason import Reason

ESCAPES = re.compile(r"\x1b\[[?0-9;]*[A-Za-z]")
DRAWN = "\x1b[?7h\x1b[0m\x1b[?12l\x1b[?25h"
"""How a drawing of the line ends."""


def lines(text):
    return ESCAPES.sub("", text).split("\n")


@pytest.fixture
def screen(monkeypatch):
    """The other end of a terminal of 40 columns; `shown` reads what was written so far."""
    far, near = pty.openpty()
    fcntl.ioctl(near, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 40, 0, 0))
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.delenv("NO_COLOR", raising=False)

    class Screen:
        descriptor = near

        def type(self, text):
            os.write(far, text.encode())
            assert select.select([near], [], [], 10.0)[0], "the kernel hands it on when it likes"

        def shown(self, end):
            """What was written up to these words; the kernel hands it on when it likes."""
            text = b""
            while not text.decode(errors="replace").endswith(end):
                assert select.select([far], [], [], 10.0)[0], f"expected {end!r}, found {text!r}"
                text += os.read(far, 1)
            return text.decode().replace("\r\n", "\n")

        def rest(self):
            """What else was written."""
            text = b""
            while select.select([far], [], [], 0.05)[0]:
                text += os.read(far, 65536)
            return text.decode()

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


@contextmanager
def typed(screen, text, complete=lambda before: []):
    """A terminal after these keys."""
    with Terminal(complete) as terminal:
        screen.type(text)
        assert terminal.line("main> ", 1.0) is None
        yield terminal


def test_a_line_is_typed_at_the_prompt_and_stays_above(screen):  # R-A16
    with Terminal(lambda before: []) as terminal:
        assert terminal.line("main> ", 0.05) is None
        screen.shown("main>")
        screen.type("spawn\r")
        assert next_line(terminal) == "spawn"
        terminal.say(Reason.plain("there"))
    assert re.search(r"main> spawn\s+there\n$", ESCAPES.sub("", screen.shown("there\r\n")))


def test_what_happens_goes_by_above_the_line_that_is_typed(screen):  # R-A16
    with typed(screen, "spaw") as terminal:
        screen.shown("spaw")
        terminal.say(Reason.plain("main/puma ON"), Tone.GOOD)
        terminal.say(Reason.plain("main/diff ON"))
        terminal.line("main> ", 0.05)
        text = screen.shown("main> spaw")
        assert "\x1b[32mmain/puma ON\x1b[0m" in text
        assert lines(text) == ["main/puma ON", "main/diff ON", "main> spaw"]
        screen.type("n\r")
        assert next_line(terminal) == "spawn"


def test_the_line_goes_and_comes_back_in_one_piece(screen):  # R-A16
    with typed(screen, "spaw") as terminal:
        screen.shown("spaw" + DRAWN)
        screen.rest()
        terminal.say(Reason.plain("main/puma ON"))
        assert screen.rest() == ""
        terminal.line("main> ", 0.05)
        assert lines(screen.shown(DRAWN)) == ["main/puma ON", "main> spaw"]


def test_what_is_said_after_a_stop_does_not_wait_for_the_line(screen):  # decision 11
    with typed(screen, "spaw") as terminal:
        screen.shown("spaw" + DRAWN)
        screen.rest()
        terminal.say(Reason.plain("main/puma ON"))
        terminal.drop()
        terminal.say(Reason.plain("STOPPED"))
        assert lines(screen.shown("STOPPED\r\n")) == ["main/puma ON", "STOPPED", ""]


def test_another_prompt_leaves_what_is_typed(screen):
    with typed(screen, "0.5") as terminal:
        terminal.say(Reason.plain("diff asks"))
        terminal.line("diff? ", 0.05)
        screen.shown("diff? 0.5")


def test_colour_is_left_out_where_none_is_wanted_and_no_escape_gets_through(screen, monkeypatch):
    monkeypatch.setenv("NO_COLOR", "1")
    with Terminal(lambda before: []) as terminal:
        terminal.say(Reason.plain("\x1b[2Jred"), Tone.FAULT)
    text = screen.shown("�[2Jred\r\n")
    assert not re.search(r"\x1b\[[0-9;]*[mJ]", text)


def test_completions_are_offered_side_by_side(screen):  # R-A16
    with typed(screen, "task0\t", lambda before: [f"task{n:02}" for n in range(9)]):
        screen.shown("task00  task01  task02  task03  task04\x1b[0m\r\n")
        screen.shown("main> task0")


@pytest.mark.parametrize(
    ("text", "words", "line"),
    [
        ("sp", ["spawn"], "spawn "),
        ("s", ["spawn", "spare"], "spa"),
        ("source scr", ["scripts/"], "source scripts/"),
        ("on ", ["puma"], "on puma "),
        ("x", [], "x"),
    ],
)
def test_tab_completes_as_far_as_it_can(screen, text, words, line):  # R-A16
    with Terminal(lambda before: words if before == text else pytest.fail(before)) as terminal:
        screen.type(f"{text}\t\r")
        assert next_line(terminal) == line


def test_only_what_stands_before_the_cursor_is_completed(screen):
    with Terminal(lambda before: ["spawn"] if before == "sp" else []) as terminal:
        screen.type("spx\x1b[D\t\r")
        assert next_line(terminal) == "spawn x"


def test_what_is_said_while_a_word_is_completed_goes_by_above(screen):  # R-A16
    with Terminal(lambda before: terminal.say(Reason.plain("the link is slow")) or ["spawn"]) as terminal:
        screen.type("sp\t")
        terminal.line("main> ", 1.0)
        screen.shown("the link is slow\r\n")
        screen.shown("main> spawn")


def test_a_fault_while_a_word_is_completed_is_not_hidden(screen):
    def lose(before):
        raise ConnectionError("the runtime is gone")

    with Terminal(lose) as terminal, pytest.raises(ConnectionError, match="the runtime is gone"):
        screen.type("\t")
        terminal.line("main> ", 1.0)


def test_a_long_line_goes_on_in_the_next_row(screen):
    with typed(screen, "ab" + "x" * 60 + "end"):
        assert screen.shown("xend").count("x") == 60


@pytest.mark.parametrize(
    ("keys", "line"),
    [
        ("\x1b[A", "off"),
        ("on\x1b[A", "on puma"),
        ("on\x1b[A\x1b[A", "on diff"),
        ("on\x1b[A\x1b[B", "on"),
        ("x\x1b[A", "x"),
    ],
)
def test_earlier_lines_that_begin_so_are_found(screen, tmp_path, keys, line):  # R-A16
    path = tmp_path / "history"
    path.write_text("on diff\non puma\noff\n")
    with Terminal(lambda before: [], path) as terminal:
        terminal.line("main> ", 0.05)
        screen.type(f"{keys}\r")
        assert next_line(terminal) == line


def test_lines_are_remembered_for_the_next_console(screen, tmp_path):  # R-A16
    path = tmp_path / "state" / "history"
    for keys, line in (("status\r", "status"), ("\x1b[A\r", "status")):
        with Terminal(lambda before: [], path) as terminal:
            screen.type(keys)
            assert next_line(terminal) == line
    assert path.read_text() == "status\n"


def test_several_lines_that_are_pasted_wait_for_enter_and_come_one_by_one(screen):  # R-A16
    with typed(screen, "\x1b[200~spawn puma\non puma\n\x1b[201~") as terminal:
        screen.type("\r")
        assert next_line(terminal) == "spawn puma"
        assert terminal.line("main> ", 0.0) == "on puma"
        assert terminal.line("main> ", 0.0) is None


def test_keys_that_are_typed_ahead_are_the_next_lines(screen):
    with Terminal(lambda before: []) as terminal:
        screen.type("spawn puma\ron puma\r\r")
        assert [next_line(terminal) for _ in range(3)] == ["spawn puma", "on puma", ""]


@pytest.mark.parametrize("keys", ["\x1a", "\x1b[999z", "\x1b[?62;c"])
def test_what_is_no_key_of_the_console_is_nothing(screen, keys):
    with Terminal(lambda before: []) as terminal:
        screen.type(f"o{keys}n\r")
        assert next_line(terminal) == "on"


def test_ctrl_c_is_a_signal_also_where_the_terminal_has_another_key_for_it(screen):  # decision 11
    mode = termios.tcgetattr(screen.descriptor)
    mode[6][termios.VINTR] = b"\x18"
    termios.tcsetattr(screen.descriptor, termios.TCSANOW, mode)
    pressed = []
    former = signal.signal(signal.SIGINT, lambda *_: pressed.append("Ctrl-C"))
    try:
        with Terminal(lambda before: []) as terminal:
            screen.type("\x03")
            terminal.line("main> ", 1.0)
    finally:
        signal.signal(signal.SIGINT, former)
    assert pressed == ["Ctrl-C"]


def test_a_signal_that_ends_the_program_ends_the_line_at_once(screen):
    def end(*_):
        raise SystemExit(143)

    usual = termios.tcgetattr(screen.descriptor)
    former = signal.signal(signal.SIGTERM, end)
    try:
        with pytest.raises(SystemExit), Terminal(lambda before: signal.raise_signal(signal.SIGTERM)) as terminal:
            screen.type("spa\t")
            terminal.line("main> ", 60.0)
    finally:
        signal.signal(signal.SIGTERM, former)
    assert termios.tcgetattr(screen.descriptor) == usual


def test_ctrl_d_ends_the_input(screen):
    with Terminal(lambda before: []) as terminal, pytest.raises(EOFError):
        screen.type("\x04")
        terminal.line("main> ", 1.0)


def test_what_was_typed_can_be_dropped(screen):
    with typed(screen, "spawn") as terminal:
        terminal.drop()
        screen.type("off\r")
        assert next_line(terminal) == "off"


def test_lines_that_were_typed_ahead_are_dropped_too(screen):
    with Terminal(lambda before: []) as terminal:
        screen.type("spawn puma\r\x1b[200~on puma\noff\x1b[201~\rkill\r")
        assert next_line(terminal) == "spawn puma"
        assert terminal.line("main> ", 0.5) == "on puma"
        terminal.drop()
        screen.type("status\r")
        assert next_line(terminal) == "status"


def test_the_screen_is_cleared_on_wish(screen):
    with typed(screen, "\x0c"):
        screen.shown("\x1b[2J")


def test_the_terminal_is_left_as_it_was(screen):
    usual = termios.tcgetattr(screen.descriptor)
    with typed(screen, "spawn"):
        assert not termios.tcgetattr(screen.descriptor)[3] & termios.ECHO
    assert termios.tcgetattr(screen.descriptor) == usual
    assert screen.shown("\x1b[?2004h")
    assert screen.shown("\x1b[?2004l")

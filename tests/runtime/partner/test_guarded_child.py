"""A program that a task has started."""

import select
import socket
import sys
from pathlib import Path

import pytest

from onika.runtime.partner.guarded_child import GuardedChild

PATIENCE_S = 60.0


@pytest.fixture
def start():
    made = []

    def begin(*command, **given):
        made.append(GuardedChild(command, **given))
        return made[-1]

    yield begin
    for child in made:
        child.close()


def wait(started):
    assert select.select([started], [], [], PATIENCE_S)[0]
    started.look()
    return started.how_ended


def test_a_conversation_is_its_standard_input_and_output(start):  # R-F04
    ours, theirs = socket.socketpair()
    with ours, theirs:
        ours.settimeout(PATIENCE_S)
        start("cat", conversation=theirs.fileno())
        ours.sendall(b"hello\n")
        assert ours.recv(100) == b"hello\n"


def test_as_long_as_it_runs_there_is_nothing_to_see(start):
    started = start("sleep", "1000")
    started.look()
    assert not started.how_ended


@pytest.mark.parametrize(("command", "how"), [(["false"], "ended with exit code 1"), (["/no"], "cannot be started")])
def test_it_is_told_how_it_ended(start, command, how):  # R-F04
    assert str(wait(start(*command))).startswith(how)


def test_without_a_conversation_it_finds_the_address_and_an_empty_input(start):
    script = "import os, sys; sys.exit(7 if os.environ['ONIKA_PARTNER'] == 'unix:/x' and not sys.stdin.read() else 1)"
    assert str(wait(start(sys.executable, "-c", script, address="unix:/x"))) == "ended with exit code 7"


def test_when_it_is_closed_the_program_hears_the_end_of_its_input_and_has_time_to_end(start, tmp_path):  # R-F04
    ours, theirs = socket.socketpair()
    started = start("sh", "-c", f"cat > /dev/null; echo done > {tmp_path / 'last'}", conversation=theirs.fileno())
    theirs.close()
    ours.settimeout(PATIENCE_S)
    ours.shutdown(socket.SHUT_WR)
    started.close()
    assert ours.recv(1) == b""  # the program is gone with its end
    assert (tmp_path / "last").read_text() == "done\n"
    ours.close()


def test_programs_beside_its_own_interpreter_come_first(start):  # R-A20
    ours, theirs = socket.socketpair()
    with ours, theirs:
        ours.settimeout(PATIENCE_S)
        start("sh", "-c", "echo $PATH", conversation=theirs.fileno())
        assert ours.makefile().readline().split(":")[0] == str(Path(sys.executable).parent)

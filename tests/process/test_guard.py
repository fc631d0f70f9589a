"""The guard of a started program, run as the script it is."""

import os
import select
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from onika.process import guard

PATIENCE_S = 60.0


class Kept:
    """A keeper with its lifeline; the program it keeps has a pipe as its output."""

    def __init__(self, *command, manner="partner"):
        self.lifeline, theirs = socket.socketpair()
        self.lifeline.settimeout(PATIENCE_S)
        self.output, child_output = os.pipe()

        def third():
            os.dup2(theirs.fileno(), guard.LIFELINE)

        subprocess.run(
            [sys.executable, "-I", "-S", guard.__file__, manner, *command],
            stdin=subprocess.DEVNULL,
            stdout=child_output,
            preexec_fn=third,
            close_fds=False,
            timeout=PATIENCE_S,
            check=True,
        )
        theirs.close()
        os.close(child_output)

    def words(self):
        """The last words on the lifeline."""
        return self.lifeline.recv(1000).decode()

    def first_line(self):
        line = b""
        while not line.endswith(b"\n"):
            line += os.read(self.output, 1)
        return line.decode()

    def output_ends(self):
        """Whether nobody holds the program's output any more, in the end."""
        while select.select([self.output], [], [], PATIENCE_S)[0]:
            if not os.read(self.output, 1000):
                return True
        return False

    def close(self):
        self.lifeline.close()
        os.close(self.output)


@pytest.fixture
def keep():
    made = []

    def start(*command, manner="partner"):
        made.append(Kept(*command, manner=manner))
        return made[-1]

    yield start
    for child in made:
        child.close()


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (("sh", "-c", "exit 3"), "exit 3"),
        (("sh", "-c", "kill -9 $$"), "signal 9"),
        (("/nowhere/at/all",), "unstartable No such file or directory"),
    ],
)
def test_it_says_how_the_program_ended(keep, command, words):  # R-F04
    assert keep(*command).words() == words


def test_the_program_ends_with_the_lifeline(keep):  # R-F04
    kept = keep("sh", "-c", "echo up; exec sleep 1000")
    assert kept.first_line() == "up\n"
    kept.lifeline.close()
    assert kept.output_ends()


def test_a_program_that_does_not_want_to_end_is_ended_with_all_it_started(keep):  # R-F04
    script = "import signal, subprocess, time; signal.signal(signal.SIGTERM, signal.SIG_IGN);"
    script += "subprocess.Popen(['sleep', '1000']); print('up', flush=True); time.sleep(1000)"
    kept = keep(sys.executable, "-c", script)
    assert kept.first_line() == "up\n"
    kept.lifeline.close()
    assert kept.output_ends()


LEAVES = "import os, time; os.fork() and ({}); os.setsid(); print('up', flush=True); time.sleep(1000)"
"""A program that leaves a child behind in a session of its own; what else it does."""


@pytest.mark.parametrize("manner", ["partner", "listener"])
def test_a_program_that_does_not_end_by_itself_is_asked_to(keep, manner):  # R-F04, R-A20
    kept = keep("sh", "-c", "trap 'echo asked; exit' TERM; echo up; while :; do sleep 0.01; done", manner=manner)
    assert kept.first_line() == "up\n"
    kept.lifeline.close()
    assert kept.first_line() == "asked\n"
    assert kept.output_ends()


def test_nothing_is_left_of_a_program_that_ends_at_once_when_it_shall(keep):  # R-F04
    kept = keep(sys.executable, "-c", LEAVES.format("time.sleep(1000)"))
    assert kept.first_line() == "up\n"
    kept.lifeline.close()
    assert kept.output_ends()


def test_what_a_program_leaves_behind_lives_as_long_as_the_task_and_no_longer(keep):  # R-F04
    kept = keep(sys.executable, "-c", LEAVES.format("os._exit(0)"))
    assert kept.words() == "exit 0"
    assert kept.first_line() == "up\n"
    assert not select.select([kept.output], [], [], 0.05)[0]
    kept.lifeline.close()
    assert kept.output_ends()


def test_the_program_is_in_a_session_of_its_own_and_may_use_all_processors(keep):
    script = "import os; print(f'{os.getsid(0) == os.getpid()} {len(os.sched_getaffinity(0))}')"
    kept = keep(sys.executable, "-c", script)
    assert kept.first_line() == f"True {len(os.sched_getaffinity(0))}\n"


LINGERS = """
import os, sys, time
if os.fork():
    os._exit(0)
end = time.monotonic() + 0.9
while time.monotonic() < end:
    {}
open(sys.argv[1], "w").close()
"""
"""A runtime that leaves a child behind, which writes a file later than whoever waits may live."""


@pytest.mark.site  # its moment is one of the machine's clock
@pytest.mark.parametrize(("how", "is_done"), [("pass", True), ("time.sleep(0.01)", False)])
def test_who_is_at_work_when_a_runtime_ends_has_a_moment_longer(tmp_path, how, is_done):  # R-X05
    ours, theirs = socket.socketpair()
    words = [sys.executable, "-I", "-S", guard.__file__, "runtime", str(theirs.fileno())]
    with ours, subprocess.Popen(words, pass_fds=[theirs.fileno()]) as keeper:
        theirs.close()
        command = [sys.executable, "-c", LINGERS.format(how), str(tmp_path / "written")]
        ours.send("\0".join(["own group", "", *command]).encode())
        assert keeper.wait(PATIENCE_S) == 0
    assert (tmp_path / "written").exists() == is_done


@pytest.fixture
def signals(monkeypatch):
    """Who was sent which signal, while time goes by and nobody is really there."""
    sent, clock = [], iter(range(1000))
    monkeypatch.setattr(guard.os, "kill", lambda pid, signum: sent.append((pid, signum)))
    monkeypatch.setattr(guard, "monotonic", lambda: next(clock) * 0.1)
    monkeypatch.setattr(guard.select, "select", lambda *_: None)
    return sent


def looks(monkeypatch, *families):
    """What is found at each look; the last one stays."""
    found = [dict(each) for each in families]
    monkeypatch.setattr(guard, "family", lambda: found.pop(0) if len(found) > 1 else found[0])


def test_the_child_of_one_that_died_while_it_was_looked_for_is_ended_too(monkeypatch, signals):  # R-X12
    dead = {10: b"Z"}
    looks(monkeypatch, {10: b"R"}, dead, *[{**dead, 11: b"S"}] * 12, {**dead, 11: b"Z"})
    guard.end_family(0.3, 0.0)
    assert [signum for pid, signum in signals if pid == 11] == [0, signal.SIGTERM, signal.SIGKILL]


def test_where_all_are_dead_nobody_is_waited_for(monkeypatch, signals):  # R-X12
    looks(monkeypatch, {10: b"Z"})
    guard.end_family(0.3, 0.0)
    assert signals == []


def test_who_is_born_while_all_are_ended_is_ended_as_well(monkeypatch, signals):  # R-X12
    looks(monkeypatch, *[{10: b"S"}] * 7, {10: b"Z", 11: b"R"}, {10: b"Z", 11: b"Z"})
    guard.end_family(0.3, 0.0)
    assert (11, signal.SIGKILL) in signals


def test_it_knows_nothing_of_onika():
    assert "import onika" not in Path(guard.__file__).read_text()
    assert "from onika" not in Path(guard.__file__).read_text()

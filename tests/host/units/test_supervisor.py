import os
import signal

import pytest

from onika.host.units import supervisor as room
from onika.host.units.supervisor import HELD_NS, MOST_UNSENT, SILENT_NS, SLOW_NS, UNLOOKED_NS, Supervisor
from onika.words.reason import NOTHING, Reason

PUPPET = """
import argparse, select, socket
parser = argparse.ArgumentParser()
for option in ("--fd", "--beat-fd", "--zero", "--parent"):
    parser.add_argument(option, type=int)
parser.add_argument("--fifo", action="store_true")
parser.add_argument("--name", default="")
given = parser.parse_args()
post = socket.socket(fileno=given.fd)
post.send(f"{given.zero} {given.fifo} {given.name}".encode())
while post.recv(10):
    pass
"""


@pytest.fixture
def supervisor(tmp_path, monkeypatch):
    (tmp_path / "puppet.py").write_text(PUPPET)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path), prepend=os.pathsep)
    supervisor = Supervisor(zero_ns=123, with_fifo=True)
    yield supervisor
    supervisor.end()


@pytest.fixture
def clock(monkeypatch):
    """Time as a list with one number."""
    now = [10 * SLOW_NS]
    monkeypatch.setattr(room, "monotonic_ns", lambda: now[0])
    return now


def up(supervisor, *arguments):
    process = supervisor.launch("rt0", "rt0", "puppet", arguments)
    process.is_up = True
    return process


def first_word(process):
    while (received := process.post.receive()) is None:
        assert process.process.poll() is None
    return received[0].decode()


def beat(process, now):
    process.heartbeat._words[0] = now[0]


def test_a_process_is_started_with_what_it_needs(supervisor):  # law 30
    process = supervisor.launch("rt0", "rt0", "puppet", ("--name", "rt0"))
    assert first_word(process) == "123 True rt0"
    assert supervisor.processes == {"rt0": process}
    assert (process.is_up, process.is_lost) == (False, False)


def test_a_process_that_is_well_makes_no_trouble(supervisor, clock):  # law 30
    process = up(supervisor)
    beat(process, clock)
    clock[0] += SILENT_NS
    assert supervisor.troubles() == []


def test_a_process_that_is_not_up_yet_may_be_silent(supervisor, clock):  # law 30
    supervisor.launch("rt0", "rt0", "puppet")
    assert supervisor.troubles() == []


def test_a_process_that_is_held_while_it_starts_is_ended_and_told(supervisor, clock):  # law 30
    process = supervisor.launch("rt0", "rt0", "puppet")
    os.kill(process.process.pid, signal.SIGSTOP)
    os.waitid(os.P_PID, process.process.pid, os.WSTOPPED | os.WNOWAIT)
    assert supervisor.trouble() == NOTHING
    clock[0] += HELD_NS
    assert str(supervisor.trouble()) == "rt0 has not answered for 0.4 s: stopped"
    assert [lost.name for lost, _ in supervisor.troubles()] == ["rt0"]
    assert process.process.returncode == -signal.SIGKILL


def test_a_silent_process_is_ended_and_told_once(supervisor, clock):  # law 30
    process = up(supervisor)
    beat(process, clock)
    clock[0] += SILENT_NS + 1
    ((lost, reason),) = supervisor.troubles()
    assert lost is process
    assert str(reason) == "rt0 has not answered for 1.0 s: stopped"
    assert process.is_lost
    assert process.process.returncode == -signal.SIGKILL
    assert supervisor.troubles() == []


def test_the_task_whose_code_never_returned_is_named(supervisor, clock):  # law 15
    process = up(supervisor)
    beat(process, clock)
    process.heartbeat.watch("flow0/sick")
    clock[0] += SILENT_NS + 1
    assert str(supervisor.troubles()[0][1]).endswith("a call of task flow0/sick has not returned")


def test_no_task_is_blamed_for_a_process_that_somebody_stopped(supervisor, clock):  # R-X06
    process = up(supervisor)
    first_word(process)
    beat(process, clock)
    process.heartbeat.watch("flow0/innocent")
    os.kill(process.process.pid, signal.SIGSTOP)
    os.waitid(os.P_PID, process.process.pid, os.WSTOPPED | os.WNOWAIT)
    clock[0] += SILENT_NS + 1
    assert str(supervisor.troubles()[0][1]).endswith(" s: stopped")


def test_announced_work_may_take_longer(supervisor, clock):  # law 30
    process = up(supervisor)
    beat(process, clock)
    process.heartbeat.is_slow(True)
    clock[0] += SLOW_NS
    assert supervisor.troubles() == []
    clock[0] += 1
    assert len(supervisor.troubles()) == 1


def test_a_process_that_leaves_its_commands_unread_does_not_fill_the_memory(supervisor, clock):  # law 30
    process = up(supervisor)
    beat(process, clock)
    process.post.unsent = MOST_UNSENT
    assert supervisor.troubles() == []
    process.post.unsent += 1
    expected = Reason.of("host.commands_unread", name="rt0", megabytes=64)
    assert supervisor.troubles() == [(process, expected)]
    assert process.process.poll() == -signal.SIGKILL


def test_a_process_that_does_not_look_at_its_code_any_more_is_ended(supervisor, clock):  # law 14
    process = up(supervisor)
    process.heartbeat._words[2] = clock[0]
    clock[0] += UNLOOKED_NS
    beat(process, clock)
    assert supervisor.troubles() == []
    clock[0] += 1
    process.heartbeat.is_slow(True)
    assert supervisor.troubles() == []
    process.heartbeat.is_slow(False)
    ((_, reason),) = supervisor.troubles()
    assert str(reason) == "rt0 has not looked at its own code for 5.0 s: module code keeps it from that"


def test_why_a_process_ended_itself_is_told_in_its_own_words(supervisor, clock):  # law 14
    process = up(supervisor)
    first_word(process)
    process.heartbeat.leave(Reason.plain("it had enough"))
    process.post.close()  # then the puppet goes
    os.waitid(os.P_PID, process.process.pid, os.WEXITED | os.WNOWAIT)
    assert str(supervisor.troubles()[0][1]) == "rt0 ended itself: it had enough"


@pytest.mark.parametrize(("blow", "sentence"), [(signal.SIGKILL, "signal 9"), (signal.SIGTERM, "signal 15")])
def test_a_killed_process_is_told_with_its_signal(supervisor, clock, blow, sentence):  # R-E10
    process = up(supervisor)
    os.kill(process.process.pid, blow)
    os.waitid(os.P_PID, process.process.pid, os.WEXITED | os.WNOWAIT)
    assert str(supervisor.troubles()[0][1]) == f"rt0 was killed by {sentence}"


def test_a_process_that_ends_is_told_with_its_code(supervisor, clock):  # R-E10
    process = up(supervisor)
    first_word(process)
    process.post.close()  # then the puppet goes
    os.waitid(os.P_PID, process.process.pid, os.WEXITED | os.WNOWAIT)
    assert str(supervisor.troubles()[0][1]) == "rt0 ended with code 0"


def test_the_end_leaves_no_process_and_no_zombie(supervisor):  # R-E10
    process = up(supervisor)
    supervisor.end()
    supervisor.end()
    assert process.process.returncode == -signal.SIGKILL
    assert process.post.is_closed

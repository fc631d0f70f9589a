"""The supervisor without processes: what it makes of what it sees of them, and what it starts them with."""

import os
import signal
import socket
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from onika.host.units import supervisor as room
from onika.host.units.heartbeat import Heartbeat
from onika.host.units.supervisor import HELD_NS, Supervisor
from onika.ring.segment import Segment
from onika.words.reason import NOTHING, Reason

S = 1_000_000_000
TITLE = Reason.of("host.processing_unit", name="rt0")


@dataclass
class Process:
    """What the supervisor sees of a process."""

    pid: int
    code: int | None = None
    is_held: bool = False
    blows: list[str] = field(default_factory=list)

    def poll(self):
        return self.code

    def kill(self):
        self.blows.append("kill")
        self.code = -signal.SIGKILL

    def wait(self):
        self.blows.append("wait")


@dataclass
class Start:
    """With what a process was started."""

    module: str
    end: socket.socket
    arguments: tuple
    heartbeat: Segment
    memory: str
    own_group: bool


class Machine:
    """The operating system: its clock, the processes that were started, which of them it holds."""

    def __init__(self):
        self.now = 100 * S
        self.starts = []
        self.processes = {}

    def start(self, module, end, arguments=(), descriptors=(), *, own_group=False):
        (beat_fd,) = descriptors
        memory = str(Path(f"/proc/self/fd/{beat_fd}").readlink())
        words = tuple("BEAT-FD" if word == str(beat_fd) else word for word in arguments)
        self.starts.append(Start(module, end, words, Segment.attach(os.dup(beat_fd)), memory, own_group))
        process = Process(len(self.starts))
        self.processes[process.pid] = process
        return process

    def holds(self, pid):
        return self.processes[pid].is_held

    def close(self):
        for start in self.starts:
            start.end.close()


@pytest.fixture
def machine(monkeypatch):
    machine = Machine()
    monkeypatch.setattr(room, "monotonic_ns", lambda: machine.now)
    monkeypatch.setattr(room, "start", machine.start)
    monkeypatch.setattr(room, "is_stopped", machine.holds)
    yield machine
    machine.close()


@pytest.fixture
def supervisor(machine):
    supervisor = Supervisor(zero_ns=123, with_fifo=False)
    yield supervisor
    supervisor.end()


def up(supervisor, name="rt0", title=TITLE):
    process = supervisor.launch(name, title, "puppet")
    process.is_up = True
    return process


def beat(process, at):
    process.heartbeat._words[0] = at


def test_a_process_that_is_up_may_be_silent_for_a_second(supervisor, machine):  # law 30
    process = up(supervisor)
    beat(process, machine.now - S)
    assert process.trouble(machine.now) == NOTHING
    beat(process, machine.now - S - 1)
    assert process.trouble(machine.now).key == "host.process_silent"


def test_how_long_a_process_was_silent_is_told_in_seconds(supervisor, machine):  # law 30
    process = up(supervisor)
    beat(process, machine.now - 4 * S)
    assert process.trouble(machine.now) == Reason.of("host.process_silent", name=TITLE, seconds=4.0)
    process.heartbeat.watch("flow0/sick")
    assert process.trouble(machine.now) == Reason.of("host.call_silent", name=TITLE, seconds=4.0, task="flow0/sick")
    machine.processes[1].is_held = True
    assert process.trouble(machine.now) == Reason.of("host.process_silent", name=TITLE, seconds=4.0)


@pytest.mark.parametrize("is_slow", [False, True])
def test_one_that_the_system_holds_may_be_silent_for_four_tenths_of_a_second(supervisor, machine, is_slow):  # R-X24
    process = up(supervisor)
    process.heartbeat.watch("flow0/innocent")
    process.heartbeat.is_slow(is_slow)
    machine.processes[1].is_held = True
    beat(process, machine.now - HELD_NS)
    assert process.trouble(machine.now) == NOTHING
    beat(process, machine.now - HELD_NS - 1)
    assert process.trouble(machine.now).key == "host.process_silent"


def test_work_that_was_announced_may_take_fifteen_seconds(supervisor, machine):  # law 30
    process = up(supervisor)
    process.heartbeat.is_slow(True)
    beat(process, machine.now - 15 * S)
    assert process.trouble(machine.now) == NOTHING
    beat(process, machine.now - 15 * S - 1)
    assert process.trouble(machine.now).key == "host.process_silent"


def test_a_process_that_reads_no_commands_is_given_up_beyond_64_megabytes_and_not_before(supervisor, machine):  # law 30
    process = up(supervisor)
    beat(process, machine.now)
    order = bytes(1 << 16)
    while process.post.unsent < 64 << 20:
        process.post.send(order)
    assert process.post.unsent == 64 << 20
    assert process.trouble(machine.now) == NOTHING
    process.post.send(b"!")
    assert process.trouble(machine.now) == Reason.of("host.commands_unread", name=TITLE, megabytes=64)


def test_a_process_may_leave_its_code_unlooked_at_for_five_seconds(supervisor, machine):  # law 14
    process = up(supervisor)
    beat(process, machine.now)
    assert process.trouble(machine.now) == NOTHING, "one that never looks is none that was kept from it"
    process.heartbeat._words[2] = machine.now - 5 * S
    assert process.trouble(machine.now) == NOTHING
    process.heartbeat._words[2] = machine.now - 8 * S
    assert process.trouble(machine.now) == Reason.of("host.code_unlooked", name=TITLE, seconds=8.0)
    process.heartbeat.is_slow(True)
    assert process.trouble(machine.now) == NOTHING
    process.heartbeat.is_slow(False)
    process.heartbeat._words[2] = machine.now - 5 * S - 1
    assert process.trouble(machine.now).key == "host.code_unlooked"


def test_a_process_that_starts_may_take_its_time_as_long_as_it_is_not_held(supervisor, machine):  # law 30
    process = supervisor.launch("rt0", TITLE, "puppet")
    assert process.trouble(machine.now) == NOTHING
    assert process.trouble(machine.now + 1000 * S) == NOTHING


def test_one_that_is_held_while_it_starts_is_given_up_after_four_tenths_of_a_second(supervisor, machine):  # law 30
    process = supervisor.launch("rt0", TITLE, "puppet")
    machine.processes[1].is_held = True
    assert process.trouble(machine.now) == NOTHING
    assert process.trouble(machine.now + 399_999_999) == NOTHING
    assert process.trouble(machine.now + 400_000_000) == Reason.of("host.process_silent", name=TITLE, seconds=0.4)


def test_one_that_was_held_for_a_while_and_let_go_is_held_anew_the_next_time(supervisor, machine):  # law 30
    process = supervisor.launch("rt0", TITLE, "puppet")
    machine.processes[1].is_held = True
    assert process.trouble(machine.now) == NOTHING
    machine.processes[1].is_held = False
    assert process.trouble(machine.now + S) == NOTHING
    machine.processes[1].is_held = True
    assert process.trouble(machine.now + 2 * S) == NOTHING
    assert process.trouble(machine.now + 2 * S + 399_999_999) == NOTHING
    assert process.trouble(machine.now + 4 * S) == Reason.of("host.process_silent", name=TITLE, seconds=2.0)


@pytest.mark.parametrize("is_up", [False, True])
def test_a_process_that_is_gone_is_told_with_its_signal_or_its_code(supervisor, machine, is_up):  # R-E10
    process = supervisor.launch("rt0", TITLE, "puppet")
    process.is_up = is_up
    for number in (1, 9):
        machine.processes[1].code = -number
        killed = Reason.of("host.process_killed", name=TITLE, signal=number, during=NOTHING)
        assert process.trouble(machine.now) == killed
    for code in (0, 3):
        machine.processes[1].code = code
        ended = Reason.of("host.process_ended", name=TITLE, code=code, during=NOTHING)
        assert process.trouble(machine.now) == ended


def test_the_task_in_whose_code_a_process_ended_is_named(supervisor, machine):  # R-E10
    process = up(supervisor)
    process.heartbeat.watch("flow0/sick")
    machine.processes[1].code = -11
    during = Reason.of("host.in_call", task="flow0/sick")
    assert process.trouble(machine.now) == Reason.of("host.process_killed", name=TITLE, signal=11, during=during)
    machine.processes[1].code = 1
    assert process.trouble(machine.now) == Reason.of("host.process_ended", name=TITLE, code=1, during=during)


def test_what_a_process_said_before_it_ended_itself_comes_before_all_else(supervisor, machine):  # law 14
    process = up(supervisor)
    process.heartbeat.watch("flow0/sick")
    process.heartbeat.leave(Reason.plain("it had enough"))
    machine.processes[1].code = -9
    assert process.trouble(machine.now) == Reason.of("host.gave_up", name=TITLE, why=Reason.plain("it had enough"))


def test_a_process_is_started_with_its_post_its_heartbeat_and_the_zero_of_time(supervisor, machine):  # law 30
    process = supervisor.launch("rt0", TITLE, "puppet", ("--name", "rt0"))
    (start,) = machine.starts
    assert (start.module, start.own_group) == ("puppet", False)
    assert start.arguments == ("--name", "rt0", "--beat-fd", "BEAT-FD", "--zero", "123")
    assert start.memory.startswith("/memfd:onika-beat-rt0")
    Heartbeat(start.heartbeat).watch("it")
    assert process.heartbeat.task == "it"
    process.post.send(b"welcome")
    assert start.end.recv(20) == b"welcome"
    assert (process.name, process.title, process.is_up, process.is_lost) == ("rt0", TITLE, False, False)
    assert supervisor.processes == {"rt0": process}


def test_a_process_that_has_modules_is_a_group_of_its_own(supervisor, machine):  # law 14
    supervisor.launch("rt0", TITLE, "puppet", has_modules=True)
    assert machine.starts[0].own_group is True


def test_processes_are_real_time_where_the_machine_grants_it(machine):  # law 30
    eager = Supervisor(zero_ns=0, with_fifo=True)
    eager.launch("rt0", TITLE, "puppet")
    assert machine.starts[0].arguments[-1] == "--fifo"
    eager.end()


def test_of_several_processes_each_that_failed_is_ended_and_told_once(supervisor, machine):  # law 30
    processes = [up(supervisor, name, Reason.plain(name)) for name in ("well", "silent", "dead")]
    for process in processes:
        beat(process, machine.now)
    beat(processes[1], machine.now - 2 * S)
    machine.processes[3].code = -9
    silent = Reason.of("host.process_silent", name=Reason.plain("silent"), seconds=2.0)
    killed = Reason.of("host.process_killed", name=Reason.plain("dead"), signal=9, during=NOTHING)
    assert supervisor.trouble() == silent, "the first that has failed, not the first of all"
    assert supervisor.troubles() == [(processes[1], silent), (processes[2], killed)]
    assert [process.is_lost for process in processes] == [False, True, True]
    assert [machine.processes[pid].blows for pid in (1, 2, 3)] == [[], ["kill", "wait"], ["kill", "wait"]]
    assert [process.post.is_closed for process in processes] == [False, True, True]
    assert (supervisor.trouble(), supervisor.troubles()) == (NOTHING, [])


def test_the_trouble_of_those_that_are_named_is_not_looked_at(supervisor, machine):  # law 30
    for name in ("rt0", "rt1", "rt2"):
        beat(up(supervisor, name, Reason.plain(name)), machine.now)
    machine.processes[1].code = -9
    machine.processes[3].code = 1
    ended = Reason.of("host.process_ended", name=Reason.plain("rt2"), code=1, during=NOTHING)
    assert supervisor.trouble(("rt0",)) == ended
    assert supervisor.trouble(("rt0", "rt2")) == NOTHING


def test_the_end_ends_every_process_once_also_those_that_were_lost(supervisor, machine):  # R-E10
    up(supervisor, "rt0")
    up(supervisor, "rt1")
    machine.processes[1].code = -9
    beat(supervisor.processes["rt1"], machine.now)
    assert len(supervisor.troubles()) == 1
    supervisor.end()
    supervisor.end()
    assert [process.is_lost for process in supervisor.processes.values()] == [True, True]
    assert [machine.processes[pid].blows for pid in (1, 2)] == [["kill", "wait"]] * 2
    assert [process.post.is_closed for process in supervisor.processes.values()] == [True, True]

"""What fails in wall time, in real processes: the drive holds in time, the cause is named, nothing is left behind.

Time is judged by the world's own log of its drives and by the runtime's own times, never by the test's clock.
"""

import os
import signal
import time

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.process.cli_process import CliProcess
from kit.process.failed_run import aborted, assert_held_in_time, failures

pytestmark = pytest.mark.site

SICK = """
import os, signal, sys, threading, time
from pathlib import Path

from onika.module import Module, OutVar


def sibling(name):
    for path in Path("/proc").glob("[0-9]*"):
        if name in (path / "cmdline").read_text() and path.joinpath("stat").read_text().split()[3] == str(os.getppid()):
            return int(path.name)


class Sick(Module):
    SEEN = OutVar("double", "-", "how many cycles")

    def init(self):
        self._count = 0
        {init}

    def cycle(self):
        self._count += 1
        self.SEEN = self._count
        if self._count == 10:
            self.warn("it begins")
            {act}

    def kill(self):
        {kill}
"""
ARM = ("puma 500", "diff 500", "gravcomp 250", "pd 500", "torque_sum 500", "led_monitor 50")


def program(tmp_path, act="pass", init="pass", kill="pass", seconds=20.0):
    """One long motion of the arm, beside which a task falls sick after 10 of its cycles."""
    laboratory = Laboratory(tmp_path)
    laboratory.module("sick", SICK.format(act=act, init=init, kill=kill))
    laboratory.plain_task("sick", writes="SEEN")
    laboratory.configuration("sickC", *ARM, "sick 100", "jtraj 250")
    turn = 0.05 * seconds
    there = joints("there", turn, -1.57, 1.57, 0.0, 0.0, 0.0, duration=seconds)
    return str(laboratory.application("sick", [job("sickC", "Joint job"), there]))


def sick(tmp_path, act, *options, **settings):
    return CliProcess("run", program(tmp_path, act, **settings), "--json", *options)


def test_control_c_stops_the_run(tmp_path):  # R-E07, law 27
    with CliProcess("run", program(tmp_path), "--json") as console:
        console.until(event="warned", text="it begins")
        console.interrupt()
        assert aborted(console)["cause"] == "stopped by the user (Ctrl-C)"
    assert_held_in_time(console)


def test_a_killed_processing_unit_ends_the_run(tmp_path):  # R-A16, R-E10, law 17
    with CliProcess("run", program(tmp_path), "--json") as console:
        console.until(event="warned", text="it begins")
        os.kill(console.process("onika.host.units.rtpu"), signal.SIGKILL)
        assert aborted(console)["cause"].startswith("processing unit rt0 was killed by signal 9")
    assert_held_in_time(console)


def test_a_stopped_processing_unit_ends_the_run(tmp_path):  # R-A16, law 17
    with CliProcess("run", program(tmp_path), "--json") as console:
        console.until(event="warned", text="it begins")
        os.kill(console.process("onika.host.units.rtpu"), signal.SIGSTOP)
        cause = aborted(console)["cause"]
        assert cause.startswith("processing unit rt0 has not answered for ")
        assert cause.endswith(" s: stopped")
    assert_held_in_time(console)
    assert [event["state"] for event in console.events if event["event"] == "drive"] == ["DRIVEN", "HELD", "TRIPPED"]


def test_a_module_that_raises_is_named_with_its_line(tmp_path):  # R-A09, R-E08
    with sick(tmp_path, 'raise ValueError("bang")') as console:
        cause = aborted(console)["cause"]
    line = 1 + SICK.format(act="BANG", init="pass", kill="pass").splitlines().index(" " * 12 + "BANG")
    assert f"sick is in error: cycle: ValueError: bang ({tmp_path}/module/sick.py:{line})" in cause
    assert "sick.appl:7 (sickC there)" in cause
    assert_held_in_time(console)


def test_a_module_that_never_returns_is_named(tmp_path):  # law 15, law 17
    with sick(tmp_path, "while True: pass") as console:
        assert aborted(console)["cause"].endswith("a call of task flow0/sick has not returned")
    assert_held_in_time(console)


TAKEN = {
    "Executive.handle": "import onika.runtime.execution.executive as e; e.Executive.handle = lambda *given: []",
    "Executive._run_due": "import onika.runtime.execution.executive as e; e.Executive._run_due = lambda *given: None",
    "RunningTask.cycle": "import onika.runtime.execution.running_task as e; e.RunningTask.cycle = lambda *given: None",
    "Rtpu._tell": "sys.modules['onika.host.units.rtpu'].Rtpu._tell = lambda *given: None",
    "ProcessSocket.send": "import onika.host.processes.process_socket as e; e.ProcessSocket.send = lambda *given: None",
}


@pytest.mark.parametrize(
    "taken", [pytest.param(name, marks=[pytest.mark.slow] * bool(at)) for at, name in enumerate(TAKEN)]
)
def test_a_module_that_replaces_code_of_the_runtime_is_named(tmp_path, taken):  # law 14
    with sick(tmp_path, TAKEN[taken]) as console:
        cause = aborted(console)["cause"]
    assert cause.startswith("processing unit rt0 ended itself: module sick has replaced ")
    assert cause.endswith(f".{taken}, on which the runtime relies")
    assert_held_in_time(console)


UNINTERRUPTED = "signal.signal(signal.SIGALRM, signal.SIG_IGN); [one for one in iter(int, 1) if one]"
ENDS = {
    TAKEN["Executive.handle"]: "it ended itself: module sick has replaced onika.runtime.execution.executive.",
    "os._exit(0)": "it ended with code 0 in a call of task flow0/sick",
    "import ctypes; ctypes.string_at(0)": "it was killed by signal 11 in a call of task flow0/sick",
    "os.closerange(3, 300)": "it ended itself: task flow0/sick has closed descriptors of its process",
    UNINTERRUPTED: "it ended itself: a call of task flow0/sick has not returned for 20 s, and could not be interrupted",
}


@pytest.mark.parametrize("act", [pytest.param(act, marks=[pytest.mark.slow] * (at > 1)) for at, act in enumerate(ENDS)])
def test_in_virtual_time_whoever_ends_the_runtime_is_named(tmp_path, act):  # law 15, R-E10
    with sick(tmp_path, act, "--virtual") as console:
        cause = aborted(console)["cause"]
    assert cause.startswith("the runtime is gone: ")
    assert ENDS[act] in cause


def test_in_virtual_time_control_c_ends_a_call_that_nothing_interrupts(tmp_path):  # R-E07, law 15
    hangs = tmp_path / "hangs"
    with sick(tmp_path, f"Path({str(hangs)!r}).touch(); {UNINTERRUPTED}", "--virtual") as console:
        until = time.monotonic() + 60
        while not hangs.exists():
            assert time.monotonic() < until
            time.sleep(0.05)
        console.interrupt()
        assert "a call of task flow0/sick had not returned" in aborted(console)["cause"]


def test_a_module_that_ends_its_process_ends_the_run(tmp_path):  # law 30
    with sick(tmp_path, "os._exit(3)") as console:
        assert aborted(console)["cause"] == "processing unit rt0 ended with code 3 in a call of task flow0/sick"
    assert_held_in_time(console)


def test_a_module_that_closes_everything_ends_the_run(tmp_path):  # law 30
    with sick(tmp_path, "os.closerange(3, 300)") as console:
        expected = "processing unit rt0 ended itself: task flow0/sick has closed descriptors of its process"
        assert aborted(console)["cause"] == expected
    assert_held_in_time(console)


@pytest.mark.parametrize("blow", ["SIGKILL", "SIGSTOP"])
def test_without_the_device_server_hardware_tasks_fail_within_a_tenth_of_a_second(tmp_path, blow):  # law 17
    with sick(tmp_path, f"os.kill(sibling('device_server'), signal.{blow})") as console:
        cause = aborted(console)["cause"]
    begins = next(event["at_s"] for event in console.events if event.get("text") == "it begins")
    failed = failures(console)
    assert "puma" in failed
    assert all(event["at_s"] - begins < 0.1 for event in failed.values())
    assert ("was killed by signal 9" if blow == "SIGKILL" else "puma is in error") in cause


@pytest.mark.parametrize("time", [(), ("--virtual", "--scale", "1")], ids=["wall", "scaled"])
def test_a_frozen_runtime_is_told_and_ended_by_the_first_control_c(tmp_path, time):  # R-E07, R-E10, law 27
    with CliProcess("run", program(tmp_path), "--json", *time) as console:
        console.until(event="warned", text="it begins")
        os.kill(console.process("onika.host --link-fd"), signal.SIGSTOP)
        console.interrupt()
        assert "it was frozen, and has been ended" in aborted(console)["cause"]


def test_a_killed_runtime_is_told_and_takes_its_processes_with_it(tmp_path):  # R-E10, R-A15
    with CliProcess("run", program(tmp_path), "--json") as console:
        console.until(event="warned", text="it begins")
        os.kill(console.process("onika.host --link-fd"), signal.SIGKILL)
        result = aborted(console)
    assert "the runtime is gone" in result["cause"]
    assert "killed by signal 9" in result["cause"]
    assert (result["actions_done"], result["actions"]) == (0, 1)


@pytest.mark.parametrize("mode", [(), ("--virtual",)])
def test_a_killed_command_line_takes_everything_with_it(tmp_path, mode):  # R-A15, R-E10
    with CliProcess("run", program(tmp_path, "self._count = 9; time.sleep(0.02)"), "--json", *mode) as console:
        console.until(event="warned", text="it begins")
        assert len(console.processes()) >= 3
        os.kill(console.pid, signal.SIGKILL)
        assert console.code() == -signal.SIGKILL
        assert console.left_over() == []


def test_a_module_that_prints_megabytes_disturbs_nobody(tmp_path):  # law 30
    flood = "sys.stdout.write('x' * 4_000_000); sys.stderr.write('y' * 4_000_000)"
    with sick(tmp_path, flood, seconds=0.3) as console:
        result = console.result()
    assert (result["state"], result["exit"]) == ("completed", 0)
    assert console.left_over() == []


def test_a_module_may_take_seconds_to_be_initialised(tmp_path):  # law 10, law 30
    with sick(tmp_path, "pass", init="time.sleep(5)", seconds=0.3) as console:
        assert console.result()["state"] == "completed"
    moved = next(event for event in console.events if event["event"] == "drive")
    assert moved["at_ns"] >= 5_000_000_000  # nothing moved before every task had come to life


def test_a_module_that_ends_its_process_as_it_is_killed_is_named_at_the_end_of_the_run(tmp_path):  # R-E14
    with sick(tmp_path, "pass", kill="os._exit(3)", seconds=0.3) as console:
        result = console.result()
    assert (result["state"], result["exit"]) == ("completed", 0)
    (remark,) = result["remarks"]
    assert remark["text"].endswith("processing unit rt0 ended with code 3 in a call of task flow0/sick")


def test_a_module_with_a_thread_that_spins_hangs_nobody(tmp_path):  # law 30
    spin = "threading.Thread(target=lambda: [one for one in iter(int, 1)], daemon=True).start()"
    with sick(tmp_path, spin, seconds=0.3) as console:
        assert console.result()["state"] in ("completed", "aborted")
        assert console.left_over() == []


def test_in_virtual_time_a_thread_that_spins_and_a_flood_of_words_hang_nobody(tmp_path):  # law 30
    spin = "threading.Thread(target=lambda: [one for one in iter(int, 1)], daemon=True).start()"
    with sick(tmp_path, f"{spin}; sys.stdout.write('x' * 4_000_000)", "--virtual", seconds=0.3) as console:
        assert console.result()["state"] == "completed"
        assert console.left_over() == []


def test_in_virtual_time_a_module_that_raises_is_named_too(tmp_path):  # R-A09, R-X08
    with CliProcess("run", program(tmp_path, 'raise ValueError("bang")'), "--virtual", "--json") as console:
        assert "sick is in error: cycle: ValueError: bang" in aborted(console)["cause"]
    assert_held_in_time(console)


@pytest.mark.parametrize(
    ("act", "how"),
    [
        ("os._exit(3)", "it ended with code 3"),
        ("os.closerange(3, 300)", "task flow0/sick has closed descriptors of its process"),
    ],
)
def test_in_virtual_time_a_module_that_ends_the_runtime_is_survived(tmp_path, act, how):  # law 15
    with CliProcess("run", program(tmp_path, act), "--virtual", "--json") as console:
        cause = aborted(console)["cause"]
    assert "the runtime is gone" in cause
    assert how in cause


CHANGED = (
    "import locale; locale.setlocale(locale.LC_ALL, 'C'); os.chdir('/'); os.environ.clear(); "
    "[signal.signal(each, signal.SIG_IGN) for each in (signal.SIGTERM, signal.SIGINT, signal.SIGPIPE)]; "
    "os.fork() or os._exit(0); endless = lambda: endless(); globals().update(endless=endless); endless()"
)
"""Everything of a process that all of its tasks share; then it calls itself without end."""


@pytest.mark.parametrize("mode", [(), ("--virtual",)], ids=["wall", "virtual"])
def test_changed_signals_locale_directory_and_environment_keep_no_end_from_coming(tmp_path, mode):  # R-E10, law 30
    with sick(tmp_path, CHANGED, *mode) as console:
        assert "sick is in error: cycle: RecursionError" in aborted(console)["cause"]
    assert_held_in_time(console)


def test_in_virtual_time_control_c_stops_the_run(tmp_path):  # R-E07
    with CliProcess("run", program(tmp_path, "self._count = 9; time.sleep(0.01)"), "--virtual", "--json") as console:
        console.until(event="warned", text="it begins")
        console.interrupt()
        assert aborted(console)["cause"] == "stopped by the user (Ctrl-C)"
    assert_held_in_time(console)

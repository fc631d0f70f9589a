"""A run is steered: by a script, by keys at a terminal, from a program, from a console (E07, E08, E11, E13, X03)."""

import os
import pty
import re
import select
import signal
import subprocess
import termios
from time import monotonic

import pytest

from kit.process.cli_process import ONIKA, CliProcess
from onika.desk.run.run import start
from onika.desk.run.running_application import Running
from onika.desk.run.settings import RunSettings
from onika.store.site import open_site
from onika.wire import event

pytestmark = pytest.mark.site

SITE = open_site([], {}, None)
PANIC = """
wait began 2                  # the arm moves
wait 1
touch boxes panic_left 1      # §4.5.2
wait stopped
expect LAMP == 0
touch boxes panic_left 0
wait 0.5
clear
wait done 2
"""


def steered(tmp_path, text, *words):
    """The result of a run that this script steers, and all that was said."""
    path = tmp_path / "script"
    path.write_text(text)
    with CliProcess("run", *words, "--json", "--script", str(path), patience_s=120.0) as console:
        return console.result(), console.events


BRIEFLY = """
wait began flow0 1
wait 0.5
touch boxes panic_left 1
wait stopped flow0
touch boxes panic_left 0
wait 0.5
clear flow0
wait done flow0 1
"""


ASSEMBLY = ("assemble24", "--expect", "LAMP == 1", "--virtual")


@pytest.fixture(scope="module")
def panicked(tmp_path_factory):
    """The result and the events of an assembly that the panic button interrupts."""
    return steered(tmp_path_factory.mktemp("panic"), PANIC, *ASSEMBLY)


def test_the_panic_button_is_pressed_let_go_and_cleared_and_the_work_is_completed(panicked):  # R-E08
    result, events = panicked
    assert (result["state"], result["exit"], result["failed"]) == ("completed", 0, []), result
    explained = next(entry for entry in events if entry["event"] == "explained")
    assert (explained["task"], explained["index"]) == ("puma", 1)
    assert [entry["line"] for entry in events if entry["event"] == "steered"][-1] == "wait done 2"
    begun = [entry["index"] for entry in events if entry["event"] == "began"]
    assert begun[:4] == [0, 1, 1, 2]


def test_in_wall_time_the_same_words_do_the_same(tmp_path):  # R-E08
    result, events = steered(tmp_path, BRIEFLY, "two_arms")
    assert (result["state"], result["failed"]) == ("completed", []), result
    assert [entry["index"] for entry in events if entry["event"] == "began" and entry["flow"] == 0] == [0, 0, 1]


def test_a_steered_run_in_virtual_time_is_the_same_bit_for_bit(panicked, tmp_path):  # R-E07, law 14
    results = [panicked, steered(tmp_path, PANIC, *ASSEMBLY)]
    assert results[0][0]["hash"] == results[1][0]["hash"] != ""
    kinds = ("began", "done", "moved", "explained", "steered")
    first, second = ([entry for entry in events if entry["event"] in kinds] for _, events in results)
    assert first == second
    touched = next(entry for entry in first if entry["event"] == "explained")
    assert touched["at_s"] == pytest.approx(
        next(entry["at_s"] for entry in first if entry.get("index") == 1) + 1.0, abs=0.05
    )


def test_a_script_that_steers_nothing_changes_nothing(tmp_path):  # law 14
    result, _ = steered(tmp_path, "wait done 1\n", "two_arms", "--virtual")
    with CliProcess("run", "two_arms", "--virtual", "--json") as plain:
        assert plain.result()["hash"] == result["hash"]


def test_an_endless_loop_is_left(tmp_path):  # R-E05, R-E07
    result, events = steered(tmp_path, "wait began 1\nwait done 2\nwait began 1\nleave\n", "wave_on", "--virtual")
    assert result["state"] == "completed", result
    assert [entry["index"] for entry in events if entry["event"] == "began"].count(0) == 2


def test_flows_are_steered_each_on_its_own(tmp_path):  # R-E07, R-E13
    text = "break flow1 1\nwait paused flow1\nwho\nskip 1 2\nwait done flow0\nwait done flow1\n"
    result, events = steered(tmp_path, text, "two_arms", "--virtual")
    assert result["state"] == "completed", result
    who = next(entry for entry in events if entry["event"] == "steered" and entry["line"] == "who")
    assert {flow["subsystem"]: flow["state"] for flow in who["flows"]}["flow1"] == "paused"


@pytest.mark.parametrize("line", ["next", "skip 3"])
def test_an_action_is_left_for_one_of_another_job_while_it_moves(tmp_path, line):  # R-E13, law 9
    script = f"wait began 2\nwait 2\n{line}\nwait began 3\nwait done 3\n"
    result, _ = steered(tmp_path, script, "assemble", "--virtual", "--expect", "LAMP == 1")
    assert (result["state"], result["actions_done"]) == ("completed", 24), result


def test_a_script_with_faults_is_refused_before_anything_moves(tmp_path):  # R-E07
    result, events = steered(tmp_path, "dance\nskip 99\nwait began 2\n", "assemble24", "--virtual")
    assert (result["state"], result["exit"]) == ("refused", 2)
    assert [fault["line"] for fault in result["faults"]] == [1, 2]
    assert not any(entry["event"] == "began" for entry in events)


def test_a_pause_that_nobody_ends_aborts_the_run(tmp_path):  # R-X03
    result, _ = steered(tmp_path, "pause\n", "go_home", "--virtual")
    assert result["state"] == "aborted"
    assert result["cause"].startswith("nobody is there to go on: flow0 is paused")


def story(running: Running) -> tuple[str, float]:
    """Steer it in some way; the run's hash, and when it was paused."""
    for message in running.events():
        if isinstance(message, event.Began) and message.index == 1:
            assert running.steer("pause") == ()
        if isinstance(message, event.Moved) and message.state == "paused":
            break
    paused_s = running.now_s
    assert running.wait("0.5") == ()
    assert running.now_s == pytest.approx(paused_s + 0.5)
    assert running.steer("skip 25") == ()
    assert running.wait("began 25") == ()
    assert running.steer("continue") != ()
    return running.result().hash, paused_s


def test_a_program_steers_a_run_and_gets_the_same_run_each_time():  # R-E07, law 14
    stories = []
    for _ in range(2):
        with start(RunSettings("assemble", is_virtual=True), SITE) as running:
            stories.append(story(running))
        assert running.outcome.exit_code == 0
    assert stories[0] == stories[1]


def test_a_program_that_leaves_its_run_ends_it():  # R-E10
    with start(RunSettings("assemble", is_virtual=True), SITE) as running:
        assert running.wait("began 2") == ()
    assert running.outcome.state == "aborted"
    assert str(running.outcome.result.cause) == "the program that began it has left it"


class Terminal:
    """`onika WORDS` at a terminal of 100 columns."""

    def __init__(self, *words, patience_s=60.0):
        self._until = monotonic() + patience_s
        self._far, self.near = pty.openpty()
        self.usual = termios.tcgetattr(self.near)
        # setsid and the controlling terminal, as a login gives it: keys are for the foreground only
        take = "import fcntl, os, sys, termios; os.setsid(); fcntl.ioctl(0, termios.TIOCSCTTY, 0); "
        words = [ONIKA[0], "-c", take + "from onika.cli import main; sys.exit(main())", *words]
        environment = os.environ | {"TERM": "xterm", "COLUMNS": "100", "LINES": "30"}
        self.process = subprocess.Popen(words, stdin=self.near, stdout=self.near, stderr=self.near, env=environment)
        self.said = ""

    def until(self, text):
        """Read on until this was said."""
        start = len(self.said)
        while text not in self.said[start:]:
            assert select.select([self._far], [], [], max(self._until - monotonic(), 0.0))[0], self.said[-3000:]
            self.said += os.read(self._far, 65536).decode("utf-8", "replace")

    def press(self, keys):
        os.write(self._far, keys.encode())

    def end(self):
        """Read to the end; the exit code."""
        while self.process.poll() is None and monotonic() < self._until:
            if select.select([self._far], [], [], 0.05)[0]:
                self.said += os.read(self._far, 65536).decode("utf-8", "replace")
        return self.process.wait(1.0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self._far)
        os.close(self.near)


def test_keys_steer_a_run_at_a_terminal(tmp_path):  # R-E07, R-E11
    with Terminal("run", "assemble") as terminal:
        terminal.until("2/25  jmoveC")
        terminal.press("p")
        terminal.until("flow0 is paused after 2")
        terminal.until("‖ paused")
        terminal.press(":skip 25\r")
        terminal.until("> skip 25")
        terminal.until("25/25  jmoveC")
        terminal.press("?")
        terminal.until("r release who waits")
        assert terminal.end() == 0
        assert "assemble: completed" in terminal.said
        assert termios.tcgetattr(terminal.near) == terminal.usual


@pytest.fixture
def open_to_hangups():
    """Programs that begin meanwhile hear SIGHUP, also where `nohup` hides it from the tests themselves."""
    former = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGHUP, former)


@pytest.mark.usefixtures("open_to_hangups")
@pytest.mark.parametrize(
    "stop_signal", [pytest.param(signal.SIGTERM, marks=pytest.mark.slow), signal.SIGINT, signal.SIGHUP]
)
def test_the_terminal_is_restored_whatever_ends_the_run(stop_signal):  # R-E07
    with Terminal("run", "assemble") as terminal:
        terminal.until("2/25  jmoveC")
        assert not termios.tcgetattr(terminal.near)[3] & termios.ECHO
        terminal.process.send_signal(stop_signal)
        assert terminal.end() == (1 if stop_signal is signal.SIGINT else 128 + stop_signal)
        assert termios.tcgetattr(terminal.near) == terminal.usual


def test_a_run_that_was_left_alone_is_steered_from_a_console(tmp_path):  # R-E07, R-E10
    environment = {"XDG_STATE_HOME": str(tmp_path)}
    served = ["runtime", "--no-console", "--listen", "127.0.0.1:0"]
    with CliProcess(*served, environment=environment, patience_s=120.0) as runtime:
        url = re.search(r"ws://\S+", runtime.until_line("others reach it at"))[0]
        with CliProcess(
            "run", "assemble", "--json", "--on-loss", "finish", "--runtime", url, environment=environment
        ) as run:
            run.until(event="began", index=1)
            os.kill(run.pid, signal.SIGKILL)
        path = tmp_path / "script"
        path.write_text(
            "wait flow0 paused within 60\nruns\nwho\nstep\nwait flow0 running\nwait flow0 paused within 20\nabort\n"
        )
        with CliProcess("console", url, "--script", str(path), "--no-console", environment=environment) as console:
            output = console.text()
            assert console.code() == 0, output
        assert "assemble in flow0" in output
        assert re.search(r"flow0\s+paused\s+\d+\n", output), output
        assert re.search(r"> step\n .*\d+/25 ", output), output

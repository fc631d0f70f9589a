"""A runtime operated by hand: by scripts in virtual and wall time, by a pipe, at a terminal, from a second console."""

import os
import pty
import re
import select
import signal
import subprocess
import time

import pytest

from kit.process.cli_process import ONIKA, CliProcess
from kit.process.process_tree import runtime_of

pytestmark = pytest.mark.site

BY_HAND = """
spawn all of jmoveC           # tasks from the shipped laboratories
tasks
on puma
on diff
on gravcomp
on pd
on torque_sum
on jtraj 0.0 -1.2 1.2 0.0 0.0 0.0 1.0
wait jtraj off within 20
read Q_MEZ
wait Q_REF[1] >= -1.2001 within 1
log readings
status
check
rate diff 250
off
swap diff
kill all
tasks
quit
echo never
"""


def script(tmp_path, text):
    path = tmp_path / "script"
    path.write_text(text)
    return str(path)


def batch(tmp_path, text, *words):
    """The exit code and everything that was said."""
    with CliProcess("runtime", "--no-fifo", "--script", script(tmp_path, text), *words) as console:
        output = console.text()
        return console.code(), output


@pytest.mark.parametrize("kind", [["--virtual"], []], ids=["virtual", "wall"])
def test_tasks_of_the_puma_are_spawned_moved_read_and_killed_by_a_script(tmp_path, monkeypatch, kind):  # R-A16
    monkeypatch.chdir(tmp_path)
    code, output = batch(tmp_path, BY_HAND, "--no-console", *kind)
    assert code == 0, output
    angles = re.search(r"^Q_MEZ = (.*)$", output, re.MULTILINE)[1].split()
    assert [float(angle) for angle in angles] == pytest.approx([0, -1.2, 1.2, 0, 0, 0], abs=0.02)
    assert re.search(r"^puma +arm +rt0 +ON +[1-9]\d* ", output, re.MULTILINE)
    assert "main: the memory of variables is sound" in output
    assert re.search(r"^[0-9.]+ main Q_MEZ double\[6\] ", (tmp_path / "readings").read_text(), re.MULTILINE)
    assert "no task lives here" in output
    assert "never" not in output.replace("echo never", "")


def test_a_script_ends_at_its_first_bad_line_with_its_place(tmp_path):  # R-A16
    code, output = batch(tmp_path, "spawn puma\non pumma\nspawn diff\n", "--virtual")
    assert code == 1
    assert f"{tmp_path}/script:2: expected a living task of main (puma), found 'pumma'" in output
    assert "diff" not in output


def test_after_a_script_lines_are_taken_from_a_pipe_and_applications_run(tmp_path):  # R-A16
    path = script(tmp_path, "home\n")
    ran = subprocess.run(
        [*ONIKA, "runtime", "--virtual", "--script", path],
        input="config jmoveC\nanswer jtraj @aside\nwait jtraj off\nread Q_MEZ\n",
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "run completed, 1 of 1 actions" in ran.stdout
    assert "main/jtraj asks for endpoint double[6] in rad" in ran.stdout
    assert "Q_MEZ = " in ran.stdout
    assert "\x1b" not in ran.stdout


def test_a_module_that_fails_shows_where_and_its_new_file_mends_it(tmp_path):  # R-A18, R-X15
    lab = tmp_path / "lab" / "module"
    lab.mkdir(parents=True)
    (lab / "wave.py").write_text(WAVE.format("1 / 0"))
    (lab / "better.py").write_text(WAVE.format("0.5"))
    (lab / "wave.rmod").write_text(WAVE_TASK)
    lines = (
        "spawn wave",
        "on wave",
        "wait wave error",
        "clear wave",
        f"swap wave {lab}/better.py",
        "on wave",
        "advance 0.1",
        "read WAVE",
    )
    text = "".join(f"{line}\n" for line in lines)
    code, output = batch(tmp_path, text, "--virtual", "--no-console", "--base", str(lab.parent))
    assert code == 0, output
    assert re.search(r"ERROR main/wave: cycle: ZeroDivisionError.*wave\.py:\d+\)", output)
    assert "self.WAVE = 1 / 0" in output
    assert "WAVE = 0.5000" in output


def test_a_second_console_takes_part_in_the_same_runtime(tmp_path, monkeypatch):  # R-A16, R-A15
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    with CliProcess("runtime", "--virtual", "--no-console", "--listen", "127.0.0.1:0") as first:
        address = first.until_line("others reach it at ").split()[-1]
        path = script(tmp_path, "spawn puma\non puma\ntasks\nsubsystems\n")
        with CliProcess("console", address, "--script", path, "--no-console") as second:
            output = second.text()
            assert second.code() == 0, output
        assert re.search(r"^main/puma +ON ", output, re.MULTILINE)
        first.until_line("main/puma ON")
        os.kill(first.pid, signal.SIGINT)
        assert first.code() == 0


def test_a_runtime_that_dies_is_told_and_ends_its_console():  # R-E10
    with subprocess.Popen(
        [*ONIKA, "runtime", "--no-fifo"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as console:
        console.stdin.write(b"config jmoveC @home\n")
        console.stdin.flush()
        while b"main/jtraj ON" not in console.stdout.readline():
            pass
        os.kill(runtime_of(console.pid), signal.SIGKILL)
        output = console.stdout.read().decode()  # its end, with the input still open
        assert console.wait(30) == 1
    assert "the runtime is gone" in output
    assert "killed by signal 9" in output


class Screen:
    """`onika runtime` at a terminal of its own."""

    def __init__(self, *words):
        self.pid, self._terminal = pty.fork()
        if self.pid == 0:
            os.execv(ONIKA[0], [*ONIKA, "runtime", *words])
        self.shown = ""

    def until(self, text, since=None):
        start = len(self.shown) if since is None else since
        until = time.monotonic() + 60
        while text not in self.shown[start:] and time.monotonic() < until:
            if select.select([self._terminal], [], [], 0.1)[0]:
                try:
                    self.shown += os.read(self._terminal, 65536).decode()
                except OSError:
                    break
        assert text in self.shown[start:], self.shown

    def type(self, text):
        os.write(self._terminal, text.encode())

    def close(self):
        os.kill(self.pid, signal.SIGKILL)
        os.close(self._terminal)
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def test_at_a_terminal_a_question_is_answered_at_the_prompt_and_ctrl_c_stops(tmp_path, monkeypatch):  # decision 11
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    screen = Screen("--no-fifo")
    try:
        screen.until("main>")
        screen.type("config jmo\t")
        screen.until("jmove")
        screen.type("C\r")
        screen.until("jtraj?")
        screen.type("0 -1 1 0 0 0 600\r")
        screen.until("main/jtraj ON")
        screen.type("\x03")
        screen.until("drive boxes:arm_left HELD")
        screen.until("main (stopped)>", since=0)  # some of what stops may be told after the prompt
    finally:
        screen.close()


def test_a_saved_file_is_new_code_while_the_others_keep_cycling(tmp_path, monkeypatch):  # R-X15, R-A14
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    module = tmp_path / "module"
    module.mkdir()
    (module / "wave.py").write_text(WAVE.format("0.25"))
    (module / "wave.rmod").write_text(WAVE_TASK)
    (module / "other.py").write_text(WAVE.format("1.0").replace("WAVE", "OTHER"))
    (module / "other.rmod").write_text(WAVE_TASK.replace("WAVE", "OTHER").replace("wave", "other"))
    screen = Screen("--no-fifo", "--base", str(tmp_path))
    try:
        screen.until("main>")
        screen.type("spawn wave other\ron all\rfollow wave\r")
        screen.until("follows")
        screen.type("wait WAVE == 0.25\rread WAVE\r")
        screen.until("WAVE = 0.2500")
        (module / "wave.py").write_text(WAVE.format("0.75"))
        screen.until("runs the new code")
        screen.type("wait WAVE == 0.75\rread WAVE\r")
        screen.until("WAVE = 0.7500")
        screen.type("status\r")
        screen.until("load:")
    finally:
        screen.close()
    assert screen.shown.count("main/other ON") == screen.shown.count("main/other OFF") == 1
    assert re.search(r"other +other +rt0 +ON +[1-9]", screen.shown)
    assert "ERROR" not in screen.shown


WAVE = """
from onika.module import Module, OutVar


class Wave(Module):
    WAVE = OutVar("double", "-", "goes up and down")

    def cycle(self):
        self.WAVE = {}
"""

WAVE_TASK = """
MODULE      wave
DESC        goes up and down
INCONST     none
OUTCONST    none
INVAR       none
OUTVAR      WAVE
TASKTYPE    periodic
FREQ        20

EOF
"""

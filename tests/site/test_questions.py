"""A task that needs input which no target gives: answered on the command line, asked for on a terminal, or refused."""

import json
import os
import pty
import select
import subprocess

import pytest

from kit.labs.laboratory import Laboratory, job
from kit.process.cli_process import ONIKA
from onika.cli import main

pytestmark = [pytest.mark.site, pytest.mark.usefixtures("warm_runtimes")]

GAUGE = """
from onika.module import AskAgain, Input, Module, OutVar, finish


class Gauge(Module):
    trigger = True

    LEVEL = OutVar("double[2]", "m", "what was said")

    level = Input("double[2]", "m", "how high on both sides", low=0.0, high=1.0)

    def on(self, inputs):
        if inputs.level[0] > inputs.level[1]:
            raise AskAgain("expected the left side below the right one")
        self.LEVEL = inputs.level

    def cycle(self):
        return finish()
"""


@pytest.fixture
def path(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.module("gauge", GAUGE)
    laboratory.plain_task("gauge", writes="LEVEL")
    laboratory.configuration("gaugeC", "gauge 50")
    return str(laboratory.application("measure", [job("gaugeC")]))


def result_of(capsys, path, *words):
    code = main(["run", path, "--virtual", "--json", "--expect", "LEVEL[1] == 0.75", *words])
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert result["exit"] == code
    return result


@pytest.mark.parametrize("answer", ["gauge.level=0.5 0.75", "gauge.level=0.5,0.75"])
def test_an_answer_on_the_command_line_is_taken(capsys, path, answer):  # R-A10, law 25
    result = result_of(capsys, path, "--answer", answer)
    assert (result["exit"], result["values"]) == (0, {"LEVEL": [0.5, 0.75]})


def test_several_answers_for_one_task_are_joined_in_their_order(capsys, path):  # law 25
    result = result_of(capsys, path, "--answer", "gauge.level=0.5", "--answer", "gauge.level=0.75")
    assert result["exit"] == 0


def test_without_an_answer_the_run_ends_and_names_what_is_asked_for(capsys, path):  # law 25
    result = result_of(capsys, path)
    assert (result["exit"], result["state"]) == (1, "aborted")
    assert "gauge.level" in result["cause"]["text"]


@pytest.mark.parametrize(
    ("answer", "reason"),
    [
        ("0.5 high", "level[1]: expected a number (double), found 'high'"),
        ("0.5 7", "level[1]: expected 0..1 m, found 7"),
        ("0.5", "expected 2 values (level[2]), found 1"),
        ("0.5 nan", "expected a finite number"),
        ("0.75 0.5", "expected the left side below the right one"),
        ('0.5 "0.7', "in double quotes"),
    ],
)
def test_an_answer_that_cannot_be_used_ends_the_run_with_the_reason(capsys, path, answer, reason):  # R-A10, R-E03
    result = result_of(capsys, path, "--answer", f"gauge.level={answer}")
    assert (result["exit"], result["state"]) == (1, "aborted")
    assert reason in result["cause"]["text"]
    assert "gauge.level" in result["cause"]["text"]


class Terminal:
    """The command line on a terminal of its own; what is shown is read as it comes."""

    def __init__(self, *words, kind):
        self._ours, theirs = pty.openpty()
        environment = os.environ | {"TERM": kind, "COLUMNS": "120", "LINES": "40"}
        command = [*ONIKA, *words]
        self.process = subprocess.Popen(
            command, stdin=theirs, stdout=theirs, stderr=theirs, env=environment, start_new_session=True
        )
        os.close(theirs)
        self.shown = ""

    def read_until(self, text):
        while text not in self.shown:
            ready, _, _ = select.select([self._ours], [], [], 30.0)
            assert ready, self.shown
            try:
                self.shown += os.read(self._ours, 4096).decode()
            except OSError:  # the other side has hung up
                break
        assert text in self.shown, self.shown

    def type(self, line, end="\n"):
        self.shown = ""
        os.write(self._ours, (line + end).encode())

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self._ours)


@pytest.fixture(params=["xterm", "dumb"])
def terminal(path, request):
    terminal = Terminal("run", path, "--virtual", "--expect", "LEVEL[1] == 0.75", kind=request.param)
    yield terminal
    terminal.close()


def test_on_a_terminal_the_user_is_asked_until_the_answer_can_be_used(terminal):  # R-A10, R-E15, law 25
    terminal.read_until("gauge asks for level")
    terminal.type("0.5 9")
    terminal.read_until("expected 0..1 m, found 9")
    terminal.type("0.5 0.75")
    terminal.read_until("expect LEVEL[1] == 0.75: yes")
    assert terminal.process.wait(30) == 0


def test_control_c_at_a_question_ends_the_run(terminal):  # R-E07
    terminal.read_until("gauge asks for level")
    terminal.process.send_signal(2)
    terminal.read_until("stopped by the user (Ctrl-C)")
    assert terminal.process.wait(30) == 1


def test_the_end_of_the_input_at_a_question_ends_the_run(terminal):  # law 25
    terminal.read_until("gauge asks for level")
    terminal.type("\x04", end="")
    terminal.read_until("asks for input and nobody answers")
    assert terminal.process.wait(30) == 1

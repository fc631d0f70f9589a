import os
import time
from queue import Queue

import pytest

from onika.desk.environment.outcome.button_commands import KEPT, Commands
from onika.desk.environment.state.model import Model
from onika.model.button import Button
from onika.wire.view import ButtonView
from onika.words.reason import NOTHING


class Shown:
    """Commands, and a model in which they are shown."""

    def __init__(self, environment=None):
        self.changes = Queue()
        self.commands = Commands(self.changes.put, os.environ if environment is None else environment)
        self.model = Model(runs={"b": ButtonView("", 0, is_running=True)})

    def start(self, command, **more):
        return self.commands.start(Button("b", command, **more))

    def until(self, is_so):
        """The run as soon as it is as it is waited for."""
        while not is_so(self.model.runs["b"]):
            self.model = self.changes.get(timeout=30)(self.model).model
        return self.model.runs["b"]

    def end(self):
        return self.until(lambda run: run.code is not None)


@pytest.fixture
def shown():
    shown = Shown()
    yield shown
    shown.commands.close()


def test_output_is_shown_while_the_command_runs(shown):  # R-G02
    assert shown.start("echo one; read x < /dev/stdin; sleep 1000") == NOTHING
    run = shown.until(lambda run: run.output)
    assert (run.output, run.is_running, run.code) == ("one\n", True, None)
    assert shown.commands.halt("b")
    assert shown.end().code == -15


def test_both_outputs_are_shown_and_the_end_of_much_of_it(shown):  # R-G02
    shown.start("echo wrong >&2; seq 100000; printf end")
    run = shown.end()
    assert run.code == 0
    assert run.output.endswith("99999\n100000\nend")
    assert len(run.output) == KEPT


def test_a_sign_that_is_cut_in_two_is_left_out(shown):  # R-G02
    shown.start(f"for i in $(seq {KEPT}); do printf é; done; printf x")
    run = shown.end()
    assert set(run.output) == {"é", "x"}
    assert len(run.output.encode()) == KEPT - 1


def test_whatever_a_command_has_begun_ends_with_it(shown):  # R-G02
    shown.start("sleep 1000 & echo $!; sleep 1000 & wait")
    child = int(shown.until(lambda run: run.output).output)
    shown.commands.halt("b")
    shown.end()  # it comes once nobody holds the output any more: a process lets go of that a moment before it is over
    deadline = time.monotonic() + 60
    while is_alive(child):
        assert time.monotonic() < deadline


def test_a_command_that_will_not_end_is_ended(shown, monkeypatch):  # R-G02
    monkeypatch.setattr("onika.desk.environment.outcome.button_commands._GRACE_S", 0.05)
    shown.start("trap '' TERM; echo deaf; while :; do sleep 1; done")
    shown.until(lambda run: run.output)
    assert shown.commands.halt("b")
    assert shown.commands.halt("b"), "asked twice"
    assert shown.end().code == -9


def test_nothing_is_halted_that_has_ended(shown):  # R-G02
    shown.start("true")
    shown.end()
    assert not shown.commands.halt("b")
    assert not shown.commands.halt("other")


@pytest.mark.parametrize("command", ["echo a; exit 4 &", "echo a; exit 4 & ", "echo a; true && exit 4"])
def test_the_ampersand_at_the_end_says_what_happens_anyway(shown, command):  # §A.6
    shown.start(command)
    run = shown.end()
    assert (run.output, run.code) == ("a\n", 4)


def test_a_command_gets_no_keyboard_and_the_variables_of_the_environment():  # R-G02
    shown = Shown({"PATH": os.environ["PATH"], "HERE": "yes"})
    shown.start("cat; echo $HERE")
    assert shown.end().output == "yes\n"


def test_a_command_that_wants_a_terminal_gets_one_that_is_found(tmp_path):  # §A.6
    terminal = tmp_path / "myterm"
    terminal.write_text('#!/bin/sh\necho "in a terminal: $1"; shift; exec "$@"\n')
    terminal.chmod(0o755)
    shown = Shown({"PATH": f"{tmp_path}:{os.environ['PATH']}", "DISPLAY": ":0", "TERMINAL": "myterm"})
    assert shown.start("echo hello", spawns_terminal=True) == NOTHING
    assert shown.end().output == "in a terminal: -e\nhello\n"


def test_without_a_terminal_it_runs_here_and_says_so():  # §A.6
    shown = Shown({"PATH": "/bin:/usr/bin"})
    assert str(shown.start("echo hello", spawns_terminal=True)) == "no terminal was found: b runs here"
    assert shown.end().output == "hello\n"


def test_a_command_that_cannot_begin_is_refused(shown):  # R-G02
    assert "null" in str(shown.start("echo \0").reason)


def test_what_nobody_shows_is_not_shown(shown):  # R-G02
    shown.model = Model()
    shown.start("true")
    assert shown.changes.get(timeout=30)(shown.model).model is shown.model


def test_at_the_end_all_are_asked_to_end_and_nobody_is_told_any_more(shown, tmp_path):  # R-G02
    shown.start(f"trap 'echo bye > {tmp_path}/bye; exit 7' TERM; echo on; while :; do sleep 0.05; done")
    shown.until(lambda run: run.output)
    shown.commands.close()
    shown.commands._running["b"].thread.join(30)
    assert (tmp_path / "bye").exists()
    assert shown.changes.empty()


def is_alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    with open(f"/proc/{pid}/stat") as file:  # noqa: PTH123 - it may be gone between two calls
        return file.read().split()[2] != "Z"

import os
import signal

import pytest

from kit.desk.live_runtime import LiveRuntime
from onika.cli.conversation import converse, next_line, run_batch, serve
from onika.desk.console.console import Console
from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession
from onika.store.site import open_site
from onika.wire import event

ITEM = event.Item("level", "double", 1, "m", "how high", None, None, None)


class Played:
    """A desk whose lines are given; a line that can be called is carried out in place of being typed."""

    def __init__(self, *lines, is_person=True):
        self.is_person = is_person
        self.said = []
        self.prompts = []
        self.dropped = 0
        self._lines = list(lines)

    def say(self, line, tone=Tone.PLAIN):
        self.said.append(str(line))

    def line(self, prompt, timeout_s):
        self.prompts.append(prompt)
        if not self._lines:
            raise EOFError
        line = self._lines.pop(0)
        return line() if callable(line) else line

    def drop(self):
        self.dropped += 1


def seat(desk, **given):
    runtime = LiveRuntime(**given)
    ticks = iter(range(10**9))
    session = ConsoleSession(runtime, open_site([], {}, None), desk, lambda: next(ticks) * 0.01)
    session.begin()
    return runtime, Console(session)


def ctrl_c():
    os.kill(os.getpid(), signal.SIGINT)


def test_a_line_is_waited_for_in_turns_so_that_a_ctrl_c_before_one_is_not_missed():  # R-A10, R-E07
    desk = Played(None, None, "0.5 0.75", "")
    assert next_line(desk, "gauge? ") == "0.5 0.75"
    assert next_line(desk, "gauge? ") == ""
    assert next_line(desk, "gauge? ") is None
    assert desk.prompts == ["gauge? "] * 5


def test_lines_are_carried_out_until_the_end_of_the_input(tmp_path):  # R-A16
    desk = Played("spawn puma", None, "on puma")
    runtime, console = seat(desk)
    assert converse(console, desk, None) == 0
    assert runtime.lives["main"]["puma"].state.value == "ON"


def test_a_person_goes_on_after_a_line_that_failed():
    desk = Played("dance", "spawn puma", "quit", "spawn diff")
    runtime, console = seat(desk)
    assert converse(console, desk, None) == 0
    assert list(runtime.lives["main"]) == ["puma"]
    assert "expected one command; `help` names them, found 'dance'; instead: nothing is changed" in desk.said


def test_lines_of_a_pipe_end_with_the_first_that_failed():
    desk = Played("spawn puma", "dance", "spawn diff", is_person=False)
    runtime, console = seat(desk)
    assert converse(console, desk, None) == 1
    assert list(runtime.lives["main"]) == ["puma"]
    assert any(line.startswith("stdin:2: expected one command") for line in desk.said)


@pytest.mark.parametrize(("is_person", "code", "living"), [(True, 0, ["diff"]), (False, 1, [])])
def test_after_a_script_that_failed_only_a_person_goes_on(tmp_path, is_person, code, living):  # R-A16
    path = tmp_path / "start"
    path.write_text("dance\n")
    desk = Played("spawn diff", is_person=is_person)
    runtime, console = seat(desk)
    assert converse(console, desk, path) == code
    assert list(runtime.lives.get("main", {})) == living
    assert any(line.startswith(f"{path}:1: expected one command") for line in desk.said)


def test_a_script_alone_gives_the_exit_code(tmp_path):
    path = tmp_path / "start"
    path.write_text("spawn puma\n")
    desk = Played()
    _, console = seat(desk)
    assert run_batch(console, desk, path) == 0
    path.write_text("on diff\n")
    assert run_batch(console, desk, path) == 1
    assert desk.prompts == []


def test_the_prompt_names_the_subsystem_a_stop_and_a_question():  # R-A10
    desk = Played("subsystem left", "spawn gauge as x", "spawn diff", "on diff", "0.5", "stop")
    _, console = seat(desk, asks={"diff": (ITEM,)})
    converse(console, desk, None)
    assert desk.prompts == ["main> ", "left> ", "left> ", "left> ", "diff? ", "left> ", "left (stopped)> "]


def test_ctrl_c_at_the_prompt_stops_what_moves():  # decision 11
    desk = Played("spawn puma", "on puma", ctrl_c, "status", ctrl_c)
    runtime, console = seat(desk)
    assert converse(console, desk, None) == 0
    assert runtime.is_stopped
    assert desk.dropped == 2


def test_ctrl_c_where_nothing_moves_only_forgets_what_was_typed():
    desk = Played(ctrl_c, "spawn puma")
    runtime, console = seat(desk)
    assert converse(console, desk, None) == 0
    assert not runtime.is_stopped
    assert any("nothing moves" in line for line in desk.said)
    assert list(runtime.lives["main"]) == ["puma"]


def test_ctrl_c_while_a_line_is_carried_out_stops_everything():  # decision 11
    desk = Played("spawn puma", "advance 100")
    runtime, console = seat(desk, as_time_passes=lambda runtime: ctrl_c() if runtime.now_s == 1.0 else None)
    converse(console, desk, None)
    assert runtime.is_stopped
    assert runtime.now_s == 1.0


def test_serving_goes_on_until_ctrl_c_and_ends_with_a_stop():
    desk = Played()
    keys = iter([None] * 6 + [ctrl_c])

    def press(_runtime):
        key = next(keys, None)
        if key is not None:
            key()

    runtime, console = seat(desk, is_virtual=False, as_time_passes=press)
    assert serve(console) == 0
    assert runtime.is_stopped
    assert runtime.now_s > 2.0

"""A guest as a program: what it answers, and that it sees when nobody waits any more."""

import io
import json
import os
import signal
import socket
import subprocess
import sys
import threading
from types import SimpleNamespace

import pytest

from onika import guest
from onika.guest import ActionResult, Errand, GuestError, GuestProgram, action

TIMEOUT_S = 20.0


class Oracle(GuestProgram):
    name = "oracle"

    def __init__(self):
        self.begun = threading.Event()
        self.stopped = threading.Event()

    @action
    def add(self, errand: Errand) -> ActionResult:
        return ActionResult(values={"SUM": sum(errand.target["terms"]) + errand.values["MORE"]}, says="added")

    @action
    def second(self, _errand: Errand) -> int:
        return 1

    @action
    def nothing(self, _errand: Errand) -> None:
        pass

    @action
    def refuse(self, _errand: Errand) -> None:
        raise GuestError("the moon is in the wrong house " * 20)

    @action
    def fail(self, _errand: Errand) -> None:
        raise KeyError("rune")

    @action
    def divide(self, _errand: Errand) -> ActionResult:
        return ActionResult(values={"SHARE": float("nan")})

    @action
    def ponder(self, errand: Errand) -> None:
        self.begun.set()
        if errand.wait(TIMEOUT_S) and errand.is_stopped:
            self.stopped.set()

    def no_action(self):
        return 7


class Line:
    """A task's end of a connection."""

    def __init__(self, path):
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.settimeout(TIMEOUT_S)
        try:
            self._socket.connect(path)
        except OSError:
            self._socket.close()
            raise
        self._lines = self._socket.makefile("rb")

    def ask(self, number, **fields):
        self.say(json.dumps({"onika": 1, "id": number, "task": "flow0/asks", **fields}).encode() + b"\n")
        return self

    def say(self, words):
        self._socket.sendall(words)

    def answer(self):
        return json.loads(self._lines.readline())

    def has_ended(self):
        return self._lines.readline() == b""

    def close(self):
        self._lines.close()
        self._socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


@pytest.fixture
def oracle():
    return Oracle()


@pytest.fixture
def path(oracle, tmp_path):
    """Where it listens; its thread ends with the tests."""
    at = tmp_path / "oracle"
    threading.Thread(target=oracle.serve, args=(f"unix:{at}",), daemon=True).start()
    for _ in range(1000):
        if at.exists():
            break
        threading.Event().wait(0.01)
    while True:
        try:
            Line(str(at)).close()
        except ConnectionRefusedError:  # bound, and does not listen yet
            continue
        return str(at)


def done(path, name, target=None, values=None):
    with Line(path) as line:
        return line.ask(3, ask="do", action=name, target=target or {}, values=values or {}).answer()


def test_it_says_who_it_is_and_what_it_can_do(path):  # R-A20
    with Line(path) as line:
        answer = line.ask(1, ask="hello").answer()
    assert answer["guest"] == "oracle"
    assert answer["actions"] == ["add", "divide", "fail", "nothing", "ponder", "refuse", "second"]


def test_an_action_is_told_its_target_and_values_and_answers_an_outcome(path):  # R-A20
    answer = done(path, "add", {"terms": [1, 2]}, {"MORE": 4})
    assert answer == {"id": 3, "flow": 0, "loop": False, "values": {"SUM": 7}, "says": "added"}


@pytest.mark.parametrize(("name", "flow"), [("second", 1), ("nothing", 0)])
def test_a_number_is_the_flow_and_nothing_is_flow_0(path, name, flow):  # R-A20
    assert done(path, name) == {"id": 3, "flow": flow, "loop": False, "values": {}}


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("refuse", "the moon is in the wrong house"),
        ("fail", "KeyError: 'rune'"),
        ("divide", "ValueError"),
        ("no_action", "expected an action of add, divide"),
        ("__init__", "expected an action of add, divide"),
    ],
)
def test_what_goes_wrong_is_an_error_of_that_action_alone(path, name, words, capfd):  # R-A20
    answer = done(path, name)
    assert answer["error"].startswith(words)
    assert len(answer["error"]) <= 200
    assert done(path, "second")["flow"] == 1
    assert ("Traceback" in capfd.readouterr().err) == (name in ("fail", "divide"))


def test_it_says_who_it_is_while_an_action_is_under_way(oracle, path):  # R-A20
    with Line(path) as busy, Line(path) as other:
        busy.ask(1, ask="do", action="ponder")
        assert oracle.begun.wait(TIMEOUT_S)
        assert other.ask(1, ask="hello").answer()["guest"] == "oracle"


def test_who_hangs_up_stops_the_action(oracle, path):  # R-A20, R-E13
    with Line(path) as line:
        line.ask(1, ask="do", action="ponder")
        assert oracle.begun.wait(TIMEOUT_S)
        assert not oracle.stopped.is_set()
    assert oracle.stopped.wait(TIMEOUT_S)


@pytest.mark.parametrize(
    "words", [b"hello\n", b"[]\n", b'{"id": "x"}\n', b"[" * 60_000 + b"\n", b"x" * 70_000, b"{}\n"]
)
def test_who_says_what_is_no_question_is_hung_up_on_and_others_are_not(path, words):  # R-A20
    with Line(path) as line:
        line.say(words)
        assert line.has_ended()
    assert done(path, "second")["flow"] == 1


def test_what_it_does_not_know_is_an_error(path):  # R-A20
    with Line(path) as line:
        assert line.ask(1, ask="path").answer() == {"id": 1, "error": "expected to be asked do or hello, not path"}


def test_it_takes_the_place_of_one_that_was_killed_and_not_of_one_that_listens(path, tmp_path, monkeypatch):  # R-A20
    monkeypatch.setattr(guest, "_MOMENT_S", 0.0)
    with pytest.raises(OSError, match="somebody listens at"):
        Oracle().serve(f"unix:{path}")
    left = socket.socket(socket.AF_UNIX)
    left.bind(str(tmp_path / "left"))
    left.close()
    threading.Thread(target=Oracle().serve, args=(f"unix:{tmp_path / 'left'}",), daemon=True).start()
    for _ in range(1000):
        try:
            assert done(str(tmp_path / "left"), "second")["flow"] == 1
        except (ConnectionRefusedError, FileNotFoundError):
            threading.Event().wait(0.01)
            continue
        return
    raise AssertionError("It never listened.")


def test_who_is_just_ending_there_has_a_moment(tmp_path, monkeypatch):  # R-A20
    place, ending = str(tmp_path / "ending"), socket.socket(socket.AF_UNIX)
    ending.bind(place)
    ending.listen()

    def moment(_seconds):
        ending.close()

    monkeypatch.setattr(guest.time, "sleep", moment)
    with guest._listening(f"unix:{place}") as server:
        assert server.getsockname() == place


@pytest.mark.parametrize("address", ["unix:", "tcp:here", "http://here", "tcp::1"])
def test_what_is_no_address_is_refused(address):
    with pytest.raises(ValueError, match="expected unix:PATH or tcp:HOST:PORT"):
        Oracle().serve(address)


def test_without_an_address_its_standard_input_and_output_are_the_conversation(monkeypatch):  # R-A20
    monkeypatch.delenv("ONIKA_PARTNER", raising=False)
    answers = io.BytesIO()
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(b'{"id": 1, "ask": "hello"}\n')))
    monkeypatch.setattr(sys, "stdout", SimpleNamespace(buffer=answers))
    Oracle().serve()
    assert json.loads(answers.getvalue())["guest"] == "oracle"


PONDERS = """
import sys
from pathlib import Path
from onika.guest import GuestProgram, action

class Oracle(GuestProgram):
    name = "oracle"

    @action
    def ponder(self, errand):
        print("begun", flush=True)
        errand.wait(3600)
        {more}
        print("in order", flush=True)

Oracle().serve({at!r})
"""


@pytest.fixture
def program(tmp_path):
    """Starts a guest as a program, whose action is under way: it, and the line on which it was asked."""
    begun = []

    def start(more="", at=f"unix:{tmp_path / 'apart'}"):
        words = [sys.executable, "-c", PONDERS.format(more=more, at=at)]
        begun.append(
            subprocess.Popen(
                words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=os.environ | {"ONIKA_PARTNER": ""}
            )
        )
        asked = b'{"onika": 1, "id": 1, "ask": "do", "task": "a/b", "action": "ponder"}\n'
        if at:
            line = connected(at.removeprefix("unix:"))
            line.say(asked)
        else:
            line = None
            begun[-1].stdin.write(asked)
            begun[-1].stdin.flush()
        while begun[-1].stdout.readline() != b"begun\n":
            pass
        return begun[-1], line

    yield start
    for process in begun:
        process.kill()
        process.communicate()


def connected(path):
    for _ in range(3000):
        try:
            return Line(path)
        except (ConnectionRefusedError, FileNotFoundError):
            threading.Event().wait(0.01)
    raise AssertionError("It never listened.")


def test_who_is_asked_to_end_leaves_in_order_what_is_under_way(program):  # R-A20, R-E13
    process, line = program()
    process.send_signal(signal.SIGTERM)
    assert process.communicate(timeout=TIMEOUT_S)[0] == b"in order\n"
    assert process.returncode == 128 + signal.SIGTERM
    line.close()


def test_whose_input_ends_leaves_in_order_what_is_under_way(program):  # R-A20, R-E13
    process, _ = program(at="")
    assert process.communicate(timeout=TIMEOUT_S)[0] == b"in order\n"
    assert process.returncode == 0


def test_what_does_not_want_to_end_holds_up_nobody_for_long(program):  # R-A20
    process, line = program(more="import time; time.sleep(3600)")
    process.send_signal(signal.SIGTERM)
    assert process.communicate(timeout=TIMEOUT_S)[0] == b""
    line.close()

"""Whatever several people do at one environment whose runtime answers late, each act is answered once.

All pages hold one tree at the end, and so does one that comes then; see `message_fuzz`.
"""

from collections import Counter
from pathlib import Path
from queue import Empty
from typing import Any, get_args

import msgspec
import pytest

from kit.desk.app_fixture import ONIKONS
from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.wire.message_fuzz import MessageFuzz
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.outcome.outcome import Order
from onika.desk.environment.state.model import Model
from onika.model.task import Task
from onika.wire import act, event, page

_TASKS = (
    Task("cubic", "cubic", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", invar=("Q_REF", "Q_MEZ"), outvar=("TAU",), frequency=100.0),
    Task("robot", "robot", invar=("TAU",), outvar=("Q_MEZ",), frequency=100.0),
    Task("spare", "spare", invar=("TAU",), frequency=50.0),
)
_NAMES = tuple(task.name for task in _TASKS)
_PEOPLE = ("browser 1", "browser 2", "browser 3")
_LIFE = 300
"""Acts on one environment, before a new one is opened."""
_AWAY = (act.Watch, act.Press, act.Halt, act.OpenRecording, act.Recordings)
"""What the web server carries out, what begins programs of the user's, and what reads files aside."""


class _Late(FakeRuntimeEnv):
    """A runtime that is asked in order, but answers when the test lets it; other sessions do things meanwhile."""

    def send(self, order: Order) -> None:
        super().send(order)
        self.is_held_back = True

    @property
    def has_orders(self) -> bool:
        """Whether the runtime has still to answer."""
        return bool(self._waiting)

    def deliver(self, count: int) -> None:
        """So many of the next answers, each with what is told before it."""
        for _ in range(count):
            if not self._waiting:
                return
            order = self._waiting.popleft()
            response = self.runtime_at(order.station or "").ask(order.asked)
            self.environment.replied(order, response)
            self.hear()


class Editors:
    """Several people at one environment, who do whatever comes to their minds."""

    def __init__(self, folder: Path, seed: int) -> None:
        self.folder = folder
        self.fuzz = MessageFuzz(get_args(act.AnyAct), msgspec.json.encode, seed, {})
        self.random = self.fuzz.random
        self.lives = self.carried_out = self.refused = 0
        self._open()

    def _open(self) -> None:
        self.lives += 1
        self.env = _Late(self.folder / str(self.lives), _TASKS)
        for onikon in ONIKONS:
            self.env.base.save_onikon(onikon)
        self.acts: dict[int, str] = {}
        self.answers: Counter[int] = Counter()
        self.doc = self.env.do(act.New())
        self._do(act.Connect(self.doc), "browser 1")
        self.env.deliver(100)

    def step(self, number: int) -> None:
        """One act of somebody, and now and then something that comes from the runtime."""
        if number % _LIFE == _LIFE - 1:
            self.end()
            self._open()
        self._rename()
        honest = self._honest(self.env.environment.model)
        body = self.fuzz.body(honest) if self.random.random() < 0.3 else None
        try:
            command = self.random.choice(honest) if body is None else page.decode(b'{"cid":1,"act":' + body + b"}").act
        except ValueError:
            self.refused += 1
            return
        if not isinstance(command, _AWAY):
            self._do(command, self.random.choice(_PEOPLE))
        self._something_comes()

    def end(self) -> None:
        """Everything that is under way comes to its end."""
        for _ in range(1000):
            self.env.deliver(1000)
            self.env.hear()
            try:
                while True:
                    self.env.environment.become(self.env.changes.get_nowait())
            except Empty:
                pass
            if len(self.answers) == len(self.acts) and not self.env.has_orders:
                break
            if not self.env.has_orders:
                self._wait_aside()
        unanswered = {name for number, name in self.acts.items() if self.answers[number] != 1}
        assert not unanswered, unanswered
        assert _filled(self.env.copy) == _filled(msgspec.to_builtins(self.env.environment.tree))

    def _wait_aside(self) -> None:
        """Something is done in a thread."""
        try:
            self.env.environment.become(self.env.changes.get(timeout=5))
        except Empty:
            return

    def _something_comes(self) -> None:
        draw = self.random.random()
        if draw < 0.5:
            self.env.deliver(self.random.choice((1, 1, 2, 5)))
        if draw < 0.1:
            lives = [(home, name) for home, tasks in self.env.runtime.lives.items() for name in tasks]
            if lives:
                home, name = self.random.choice(lives)
                state = self.random.choice(("ON", "OFF", "ERROR"))
                self.env.runtime.tell(event.TaskState(home, name, state, 0.0))
        while draw < 0.3 and not self.env.changes.empty():
            self.env.environment.become(self.env.changes.get())

    def _do(self, command: act.AnyAct, by: str) -> None:
        number = len(self.acts)
        self.acts[number] = str(command)[:200]
        self.env.environment.do(command, by, lambda answer: self._answered(number, answer))
        self.carried_out += 1

    def _answered(self, number: int, answer: ActAnswer) -> None:
        self.answers[number] += 1
        assert self.answers[number] == 1, self.acts[number]
        if answer.no is None:
            page.encode(page.Ok(1, 1, answer.value))
        else:
            page.encode(page.Refused(1, answer.no.reason, answer.no.remedies, dict(answer.no.fields)))

    def _rename(self) -> None:
        model = self.env.environment.model
        self.fuzz.names |= {
            "doc": (*model.documents, *model.applications) or ("nowhere",),
            "task": _NAMES,
            "tasks": _NAMES,
            "name": (*_NAMES, "group"),
            "onikon": tuple(onikon.name for onikon in ONIKONS),
            "base": (str(self.folder / "away"),),
        }

    def _honest(self, model: Model) -> list[Any]:
        """What people do who mean it, often at cross purposes."""
        acts: list[Any] = [
            act.New(),
            act.Stop(),
            act.Reset(),
            act.NewApplication(2, True),
            act.OnlyWatch(),
            act.Take("main"),
        ]
        for doc in (*model.documents, "gone"):
            task, other = self.random.sample(_NAMES, 2)
            acts += [act.Undo(doc), act.Redo(doc), act.Connect(doc), act.Disconnect(doc), act.Close(doc, True)]
            acts += [act.Place(doc, name, 0, 90 * row) for row, name in enumerate(_NAMES)] * 2
            acts += [
                act.Toggle(doc, task),
                act.Remove(doc, (task,)),
                act.Rate(doc, task, 50.0),
                act.Unit(doc, task, "rt1"),
            ]
            acts += [
                act.Toggle(doc, other),
                act.Exchange(doc, task, other),
                act.Renew(doc, task),
                act.Reinit(doc, task),
            ]
            acts += [act.Group(doc, "group", (task, other)), act.Ungroup(doc, "group"), act.Cut(doc, (task,))]
            acts += [act.Paste(doc, 5, 5), act.Clear(doc, task), act.Release(doc), act.Flip(doc, (task,))]
        return acts


def _filled(tree: Any) -> Any:
    """Without what is as good as absent: empty maps."""
    if not isinstance(tree, dict):
        return tree
    filled = {key: _filled(value) for key, value in tree.items()}
    return {key: value for key, value in filled.items() if value is not None and value != {}}


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    """What a relative path names is in a folder of the test."""
    (tmp_path / "cwd").mkdir()
    monkeypatch.chdir(tmp_path / "cwd")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))


@pytest.mark.parametrize("seed", [1])
def test_several_people_are_answered_once_each_and_see_one_tree(tmp_path, seed):  # R-C12, R-F01, R-C06
    editors = Editors(tmp_path, seed)
    for number in range(600):
        editors.step(number)
    editors.end()
    assert editors.carried_out > 400
    assert list((tmp_path / "cwd").iterdir()) == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2, 22))
def test_several_people_are_answered_once_each_in_a_long_time(tmp_path, seed):  # R-C12, R-F01
    editors = Editors(tmp_path, seed)
    for number in range(6_000):
        editors.step(number)
    editors.end()

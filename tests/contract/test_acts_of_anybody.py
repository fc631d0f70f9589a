"""Whatever a page sends, an environment lives, answers, and shows all pages one tree; see `message_fuzz`."""

from typing import get_args

import msgspec
import pytest
from msgspec import inspect

from kit.desk.app_fixture import ONIKONS
from kit.desk.environment_fixture import EnvironmentFixture
from kit.wire.message_fuzz import TEXTS, MessageFuzz
from onika.desk.environment.initial_model import opened
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.wire import act, page

_LIFE = 200
"""Acts on one environment, before a new one is opened: what was done to it does not hide what comes."""
_TASKS = (
    Task("cubic", "cubic", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", invar=("Q_REF", "Q_MEZ"), outvar=("TAU",), frequency=100.0),
    Task("robot", "robot", invar=("TAU",), outvar=("Q_MEZ",), frequency=100.0),
)
_NAMES = {
    "path": ("0", "1", "0.1.0"),
    "flow": ("0", "1"),
    "onikon": tuple(one.name for one in ONIKONS),
    "task": tuple(task.name for task in _TASKS),
    "name": ("cubic", "pd", "move", "there", "play"),
    "kind": ("Joint job", "Joint object", "Complete job"),
    "type": ("Joint object", "Complete NOP"),
    "language": ("en", "es"),
}
_WATCH = act.Watch
"""What the web server itself carries out."""


class Pages:
    """An environment with tasks and icons, and a page whose copy of its tree is compared after every change."""

    def __init__(self, folder, seed):
        self._folder, self._count = folder, 0
        self.fuzz = MessageFuzz(get_args(act.AnyAct), msgspec.json.encode, seed, dict(_NAMES))
        self.refused = self.carried_out = 0
        self._open()

    def _open(self):
        self._count += 1
        folder = self._folder / str(self._count)
        base = BaseDirectory(folder)
        for onikon in ONIKONS:
            base.save_onikon(onikon)
        for task in _TASKS:
            base.save_task(RmodText(task))
        site = Site((base,), shipped() / "prefs", folder / "home")
        model, _ = opened(site, None, {})
        self.environment = EnvironmentFixture(folder, (), model, site)
        self._revised()

    def _revised(self):
        model = self.environment.environment.model
        documents = (*model.documents, *model.applications)
        self.fuzz.names["doc"] = documents or ("nowhere",)
        self.fuzz.names["base"] = (str(self._folder / str(self._count)),)

    def honest(self):
        documents = self.fuzz.names["doc"]
        acts = [act.New(), act.NewApplication(2, True)]
        acts += [act.Place(doc, task, 0, 100 * row) for doc in documents[:3] for row, task in enumerate(_NAMES["task"])]
        acts += [act.InsertIcon(doc, name, "0", 0) for doc in documents[-3:] for name in ("move", "there", "grip")]
        return acts

    def send(self, number):
        """One message."""
        if number % _LIFE == _LIFE - 1:
            self._open()
        self._revised()
        honest = self.honest()
        body = self.fuzz.body(honest) if number % 5 else msgspec.json.encode(self.fuzz.random.choice(honest))
        self.take(b'{"cid":1,"act":' + body + b"}")

    def take(self, body):
        """As the web server does."""
        try:
            ordered = page.decode(body)
        except ValueError:
            self.refused += 1
            return
        if isinstance(ordered.act, _WATCH):
            return
        self.environment.environment.do(ordered.act, "me", self._answer)
        self.carried_out += 1

    def _answer(self, answer):
        """It has to travel."""
        if answer.no is None:
            page.encode(page.Ok(1, 1, answer.value))
        else:
            page.encode(page.Refused(1, answer.no.reason, answer.no.remedies, dict(answer.no.fields)))


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    """What a relative path names is in a folder of the test."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))


@pytest.mark.parametrize("seed", [1, 2])
def test_no_act_ends_an_environment_and_all_pages_hold_one_tree(tmp_path, seed):  # R-C12, R-F01
    pages = Pages(tmp_path, seed)
    for number in range(2_500):
        pages.send(number)
    assert min(pages.refused, pages.carried_out) > 500


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3, 13))
def test_no_act_ends_an_environment_in_a_long_time(tmp_path, seed):  # R-C12, R-F01
    pages = Pages(tmp_path, seed)
    for number in range(25_000):
        pages.send(number)


@pytest.mark.parametrize("kind", get_args(act.AnyAct), ids=lambda kind: kind.__name__)
def test_every_text_of_an_act_may_be_any_text(tmp_path, kind):  # R-B07, R-F01
    pages = Pages(tmp_path, 1)
    struct = inspect.type_info(kind)
    confirmed = {field.name: True for field in struct.fields if field.name == "confirmed"}
    for number, field in enumerate(struct.fields):
        for text in TEXTS:
            with_text = pages.fuzz.with_text(struct, field.name, text)
            if with_text is not None:
                pages.take(msgspec.json.encode({"cid": number, "act": with_text | confirmed}))

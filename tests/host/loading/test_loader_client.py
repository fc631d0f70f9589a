import pytest

from onika.host.loading import loader_client as room
from onika.host.loading.loader_client import LoaderClient, NotYet
from onika.host.loading.loader_messages import AskDevices, AskSheet, Devices, Sheet, UnusableModule
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.wire.plan import Code
from onika.wire.request import FaultText
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault
from onika.words.reason import Reason


class FakeLoader:
    """Is asked, and answers when the test says so."""

    def __init__(self):
        self.asked = []
        self.answers = []
        self.is_lost = False
        self.given_up = []

    def send(self, question):
        self.asked.append(question)

    def take(self):
        return self.answers.pop(0) if self.answers else None

    def give_up(self, code):
        self.given_up.append(code.module)
        self.is_lost = False
        return UnusableModule(
            FaultText(
                code.path, 0, Reason.plain("expected a module, found the loader died of it"), Reason.plain("not used")
            )
        )


def code(name):
    return Code(f"digest of {name}", name, f"{name}.py", f"# {name}")


@pytest.fixture
def loader():
    return FakeLoader()


@pytest.fixture
def client(loader):
    return LoaderClient(loader)


@pytest.fixture
def sheet():
    return sheet_of(load("from onika.module import Module\nclass One(Module):\n    pass\n", "one.py", "one"))


def test_what_is_not_known_is_asked_once_and_told_when_the_answer_is_there(client, loader, sheet):  # law 21
    for _ in range(3):
        with pytest.raises(NotYet):
            client.sheet(code("a"))
    assert loader.asked == [AskSheet(code("a"))]
    assert client.take() is False
    loader.answers.append(Sheet(sheet, 700))
    assert client.take() is True
    assert isinstance(client.sheet(code("a")), ModuleSheet)
    assert client.cost_ns(code("a")) == 700
    assert client.cost_ns(code("b")) == 0


def test_questions_are_asked_one_after_the_other(client, loader, sheet):
    client.expect((code("a"), code("b")))
    assert loader.asked == [AskSheet(code("a"))]
    loader.answers.append(Sheet(sheet))
    client.take()
    assert loader.asked == [AskSheet(code("a")), AskSheet(code("b"))]


def test_code_of_which_the_loader_dies_is_a_fault_and_the_next_question_goes_on(client, loader):  # law 21
    client.expect((code("a"), code("b")))
    loader.is_lost = True
    assert client.take() is True
    fault = client.sheet(code("a"))
    assert isinstance(fault, Fault)
    assert str(fault.reason) == "expected a module, found the loader died of it"
    assert loader.asked[-1] == AskSheet(code("b"))


def test_code_that_never_answers_is_given_up(client, loader, monkeypatch):  # law 21
    now = [0]
    monkeypatch.setattr(room, "monotonic_ns", lambda: now[0])
    client.expect((code("a"),))
    now[0] = 9_000_000_000
    assert client.take() is False
    now[0] = 11_000_000_000
    assert client.take() is True
    assert loader.given_up == ["a"]


def test_a_changed_source_is_another_question(client, loader, sheet):
    client.expect((code("a"),))
    loader.answers.append(Sheet(sheet))
    client.take()
    with pytest.raises(NotYet):
        client.sheet(Code("other", "a", "a.py", "# changed"))


def test_only_the_newest_answers_are_kept(client, loader, monkeypatch):
    monkeypatch.setattr(room, "_KEPT", 2)
    for world in ("x", "y", "z"):
        with pytest.raises(NotYet):
            client.devices(world)
        loader.answers.append(Devices((world,)))
        client.take()
    assert client.devices("z") == ("z",)
    with pytest.raises(NotYet):
        client.devices("x")
    assert loader.asked[-1] == AskDevices("x")

import select

import pytest

from onika.host.loading import loader as room, loader_client as client_room
from onika.host.loading.loader import Loader
from onika.host.loading.loader_client import LoaderClient, NotYet
from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.words.reason import Reason

pytestmark = pytest.mark.site

GOOD = """
from onika.module import Module

class Good(Module):
    @classmethod
    def constants(cls, local, identity):
        return {"N": 3}

    @classmethod
    def resolve(cls, constants, targets):
        return ["too far"] * len(targets)
"""


def code(source):
    return Code("digest", "thing", "/lab/module/thing.py", source)


class Patient:
    """Asks a loader process through its client, and waits for each answer."""

    def __init__(self, loader):
        self._client = LoaderClient(loader)

    def __getattr__(self, name):
        def ask(*arguments):
            while True:
                try:
                    return getattr(self._client, name)(*arguments)
                except NotYet:
                    select.select([self._client.post], [], [], 0.05)
                    self._client.take()

        return ask


@pytest.fixture
def loader():
    process = Loader()
    yield Patient(process)
    process.close()


def test_a_process_of_its_own_answers_as_direct_loading_does(loader):  # law 21
    assert isinstance(loader.sheet(code(GOOD)), ModuleSheet)
    assert loader.constants(code(GOOD), ()) == {"N": 3}
    (far,) = loader.resolve(code(GOOD), {}, [("joint object", [1.0])])
    assert str(far) == "too far"
    assert loader.sheet(code("class (")).place.line == 1
    assert "ZeroDivisionError" in str(loader.constants(code(GOOD.replace('{"N": 3}', "1 / 0")), ()).reason)
    assert "ZeroDivisionError" in str(loader.resolve(code(GOOD.replace('["too far"]', "1 / 0 and [0]")), {}, []).reason)


def test_code_that_ends_the_process_is_named_and_the_next_is_looked_at_all_the_same(loader):  # law 21
    fault = loader.sheet(code("import os\nos._exit(1)\n"))
    assert (fault.place.file, fault.reason.key) == ("/lab/module/thing.py", "host.loader_died")
    assert isinstance(loader.sheet(code(GOOD)), ModuleSheet)


def test_code_that_never_returns_is_named_and_the_next_is_looked_at_all_the_same(loader, monkeypatch):  # law 21
    loader.sheet(code(GOOD))  # it is up
    for module in (room, client_room):
        monkeypatch.setattr(module, "PATIENCE_S", 0.2)
    fault = loader.sheet(code("while True: pass\n"))
    assert fault.reason == Reason.of("host.loader_silent", seconds=0.2)
    monkeypatch.undo()
    assert isinstance(loader.sheet(code(GOOD)), ModuleSheet)


def test_code_that_closes_everything_is_named(loader):  # law 21
    assert loader.sheet(code("import os\nos.closerange(3, 65536)\n")).reason.key == "host.loader_died"


def test_code_that_prints_megabytes_is_looked_at(loader, capfd):  # law 30
    assert isinstance(loader.sheet(code("print('x' * 3_000_000)\n" + GOOD)), ModuleSheet)


def test_code_that_does_not_return_is_interrupted_and_named_with_its_line(loader):  # law 21, R-X12
    loader.sheet(code(GOOD))  # it is up
    fault = loader.sheet(code("x = 1\nwhile True: pass\n"))
    assert fault.place.line == 2
    assert fault.reason.args["given"].args["why"] == Reason.of("host.loading_takes_long", seconds=2.0)


def test_a_module_that_declares_too_much_is_refused_and_the_next_is_looked_at(loader):  # R-X12, R-B07
    ports = "".join(f"    P{number} = OutVar('double', '-', 'one of many')\n" for number in range(20_000))
    fault = loader.sheet(code(f"from onika.module import Module, OutVar\nclass Many(Module):\n{ports}"))
    assert fault.reason.key == "host.answer_too_long"
    assert isinstance(loader.sheet(code(GOOD)), ModuleSheet)

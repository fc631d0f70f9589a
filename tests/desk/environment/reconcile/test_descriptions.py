from dataclasses import replace
from functools import partial

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.reconcile.descriptions import describe, forgotten
from onika.desk.environment.refresh import refreshed
from onika.model.task import Task
from onika.wire import act, live, request
from onika.wire.sheet import ModuleSheet, PortSheet
from onika.wire.view import ShowSource
from onika.words.reason import Reason

TASKS = tuple(Task(f"t{number}", f"m{number}", outvar=(f"X{number}",), frequency=1.0) for number in range(20))


class Reader(LiveRuntime):
    """Reads every module but one; the sheets say nothing but a port."""

    def __init__(self, unread="m3"):
        super().__init__()
        self.unread = unread
        self.described = []

    def ask(self, wish):
        if not isinstance(wish, live.Describe):
            return super().ask(wish)
        (code,) = wish.code
        self.described.append(code.module)
        if code.module == self.unread:
            return live.Described({}, {code.digest: Reason.plain("it raises")})
        port = PortSheet("OUTVAR", f"X{code.module[1:]}", "double[6]", "rad", "where it is")
        return live.Described({code.digest: ModuleSheet((port,), (), (), False, False, False, 0, "")})


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS, Reader())


def test_after_connecting_every_pin_learns_what_it_is(duet):  # R-C02, R-C23
    duet.connected()
    tasks = duet.environment.tree.tasks
    pin = tasks["t0"].pins[0]
    assert (pin.shape, pin.unit, pin.meaning) == ("double[6]", "rad", "where it is")
    assert tasks["t3"].pins[0].shape == ""
    assert sorted(duet.runtime.described) == sorted(f"m{number}" for number in range(20))


def test_a_module_that_cannot_be_read_is_an_objection_with_the_way_to_its_source(duet):  # R-X01
    doc = duet.connected()
    (reason,) = duet.environment.tree.documents[doc].objections["t3"]
    assert str(reason.text) == "its module m3 cannot be used: it raises" and reason.remedies[0].show == ShowSource("t3")


def test_one_module_is_asked_for_at_a_time(duet):  # law 21
    duet.connected()
    assert all(len(message.code) == 1 for message in duet.carried_out if isinstance(message, live.Describe))


def test_what_is_known_is_not_asked_again_and_what_has_changed_is(duet):
    duet.connected()
    duet.runtime.described.clear()
    other = duet.new()
    duet.do(act.Connect(other))
    assert duet.runtime.described == []
    duet.environment.become(lambda model: Done(forgotten(model, "m5")))
    duet.pump()
    assert duet.runtime.described == ["m5"]
    model = duet.environment.model
    assert forgotten(model, "m99") is model


def test_a_module_without_a_file_is_not_asked_for(duet, tmp_path):
    (tmp_path / "module" / "m7.py").unlink()
    duet.connected()
    assert (
        duet.environment.model.libraries.unread["m7"].key == "run.code_missing" and "m7" not in duet.runtime.described
    )


def test_a_runtime_that_does_not_say_it_is_not_asked_further(duet):  # law 23
    duet.rebuffs = {live.Describe: request.Refused(Reason.plain("code from another machine is not accepted"))}
    duet.connected()
    assert len([message for message in duet.carried_out if isinstance(message, live.Describe)]) == 1
    assert duet.environment.model.libraries.sheets == {}


def test_where_everything_is_described_nothing_is_asked(duet):
    duet.connected()
    model = duet.environment.model
    assert describe(model) == Done(model)
    empty = replace(model, libraries=replace(model.libraries, libraries=()))
    assert describe(empty).orders == ()


def test_code_that_was_written_is_asked_about_anew(duet):  # R-C05
    duet.connected()
    count = len(duet.runtime.described)
    code = duet.base.code_file("m5")
    code.write_text(code.read_text() + "\n# another\n")
    duet.environment.become(partial(refreshed, changed={code}))
    duet.pump()
    assert duet.runtime.described[count:] == ["m5"]

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task
from onika.wire import act, live, request
from onika.wire.sheet import ModuleSheet, PortSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

GAIN = Task("gain", "gain", invar=("Y",), outvar=("U",), frequency=10.0)
CODE = '"""The code of gain."""\n\nclass Gain:\n    U = OutVar("double")\n    V: object = OutVar("double")\n'


def sheet(*ports):
    return ModuleSheet(
        tuple(PortSheet(kind, name, "double", "m", "") for kind, name in ports), (), (), *[False] * 3, 0, ""
    )


class Reader(LiveRuntime):
    """Says of all code the same: a sheet, or a fault."""

    answer: object = sheet(("INVAR", "Y"), ("OUTVAR", "U"))

    def ask(self, wish):
        if isinstance(wish, live.Describe):
            digests = [code.digest for code in wish.code]
            if isinstance(self.answer, ModuleSheet):
                return live.Described(dict.fromkeys(digests, self.answer))
            return live.Described({}, dict.fromkeys(digests, self.answer))
        return super().ask(wish)


@pytest.fixture
def desk(tmp_path):
    desk = FakeRuntimeEnv(tmp_path, (GAIN,), Reader())
    (tmp_path / "module" / "gain.py").write_text(CODE)
    return desk


def test_a_sound_module_is_loaded_and_what_its_class_declares_counts_at_once(desk):  # R-C31
    assert desk.environment.tree.runtime.state == "none"
    assert desk.do(act.LoadModule("gain")).faults == ()
    assert desk.environment.tree.runtime.state == "linked"
    assert {pin.name: pin.unit for pin in desk.environment.tree.tasks["gain"].pins} == {"Y": "m", "U": "m"}


def test_what_its_code_does_wrong_stands_beside_its_line(desk):  # R-C31, R-C05
    why = Reason.of("run.unreadable")
    desk.runtime.answer = Fault(Place("/somewhere/gain.py", 4), why, Reason.of("words.nothing_changed")).sentence
    assert desk.do(act.LoadModule("gain")).faults == ((4, why),)
    desk.runtime.answer = why
    assert desk.do(act.LoadModule("gain")).faults == ((0, why),)


def test_ports_that_the_rmod_does_not_have_stand_beside_their_lines(desk):  # R-C31
    desk.runtime.answer = sheet(("OUTVAR", "U"), ("OUTVAR", "V"))
    faults = desk.do(act.LoadModule("gain")).faults
    assert [(line, str(reason)) for line, reason in faults] == [
        (5, "OUTVAR V is not so in the .rmod of gain"),
        (0, "expected only ports that module gain declares, found INVAR Y"),
    ]


def test_where_no_runtime_comes_or_no_code_is_there_it_is_said(desk, tmp_path):  # R-C31, R-X01
    desk.rebuffs = {live.Survey: request.Refused(Reason.plain("no room"))}
    before = desk.answer(act.LoadModule("gain"))
    assert before.no is not None and "no room" in str(before.no.reason)
    assert "no open library has a task" in str(desk.no(act.LoadModule("nobody")).reason)
    (tmp_path / "module" / "gain.py").unlink()
    assert desk.no(act.LoadModule("gain")).reason.key == "run.code_missing"

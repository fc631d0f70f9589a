import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task, TaskType
from onika.wire import act, event, live, request
from onika.wire.sheet import InputSheet, ModuleSheet, PortSheet
from onika.words.reason import Reason

MOVE = Task("move", "move", aliases=(("Q", "Q_MEZ"),), invar=("Q", "S"), type=TaskType.APERIODIC)
ARM = Task("arm", "arm", outvar=("Q_MEZ",), frequency=100.0)
ITEM = event.Item("endpoint", "double", 2, "rad", "where to go", None, None, None)
SHEET = ModuleSheet(
    (
        PortSheet("INVAR", "S", "double", "s", "a time"),
        PortSheet("INVAR", "Q", "double[NDOF]", "rad", "measured position"),
        PortSheet("INVAR", "R", "double[NDOF]", "rad", "another"),
    ),
    (
        InputSheet("endpoint", "double[NDOF]", "rad", "where to go", None, None, None),
        InputSheet("duration", "double", "s", "how long", None, None, None),
        InputSheet("pose", "double[9]", "-", "where", None, None, None),
    ),
    (), True, False, False, 0, "",
)  # fmt: skip


class Reader(LiveRuntime):
    def ask(self, wish):
        if isinstance(wish, live.Describe):
            return live.Described({wish.code[0].digest: SHEET})
        return super().ask(wish)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (MOVE, ARM), Reader(asks={"move": (ITEM,)}))


def test_what_nobody_writes_is_no_present_position(duet):  # R-C13
    doc = duet.connected("move", "arm")
    duet.runtime.variables["Untitled-1"] = {"Q_MEZ": [0.0, 0.0], "S": 3.0}
    duet.do(act.Toggle(doc, "move"))
    assert duet.environment.tree.documents[doc].tasks["move"].ask.present == {}


def test_a_question_comes_with_what_is_measured_of_its_kind(duet):  # R-C13
    doc = duet.connected("move", "arm")
    duet.do(act.Toggle(doc, "arm"))
    duet.runtime.variables["Untitled-1"] = {"Q_MEZ": [0.5, -1.0], "S": 3.0}
    duet.do(act.Toggle(doc, "move"))
    assert live.Read("Untitled-1", ("Q_MEZ",)) in duet.carried_out
    assert duet.environment.tree.documents[doc].tasks["move"].ask.present == {"endpoint": (0.5, -1.0)}
    duet.do(act.Toggle(doc, "move"))
    assert duet.document(doc).live.tasks["move"].present == {}


def test_a_runtime_that_does_not_say_it_is_no_harm(duet):
    doc = duet.connected("move")
    duet.rebuffs = {live.Read: request.Refused(Reason.plain("there is no such variable"))}
    duet.do(act.Toggle(doc, "move"))
    ask = duet.environment.tree.documents[doc].tasks["move"].ask
    assert ask.items[0].name == "endpoint" and ask.present == {}

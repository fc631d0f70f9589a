import contextlib
import os
import queue
import signal
import time

import pytest

from kit.labs.laboratory import Laboratory
from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.runtime_thread import RuntimeThread
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.world_channel import WorldChannel
from onika.store.library import open_libraries
from onika.store.site import open_site
from onika.wire import act, event

pytestmark = pytest.mark.site

PATIENCE_S = 60.0
HOLDING = ("puma", "diff", "gravcomp", "pd", "torque_sum")
MOODY = '''
from onika.module import InVar, Module, ModuleError, OutVar

class Moody(Module):
    """Fails as long as joint 1 stands at 0."""

    Q_MEZ = InVar("double[NDOF]", "rad", "measured position")
    MOOD = OutVar("double", "-", "how it feels")

    def cycle(self):
        if abs(self.Q_MEZ[0]) < 0.01:
            raise ModuleError("nothing has moved")
        self.MOOD = 1.0
'''
TANGLED = "from onika.module import Module\n\n\nclass Tangled(Module):\n    def cycle(self):\n        pass\n"


class Lab:
    """The environment and a runtime of its own, in scaled time."""

    def __init__(self, folder):
        files = Laboratory(folder)
        files.module("moody", MOODY)
        files.plain_task("moody", reads="Q_MEZ", writes="MOOD", hz=50)
        files.module("tangled", TANGLED)
        files.plain_task("tangled", writes="KNOT")
        site = open_site([folder], {}, None)
        self.things = queue.Queue()
        self.says = []
        self.station = RuntimeThread(
            RuntimeLauncher(("rt0", "rt1"), is_virtual=True, options=("--scale", "4")), self.things.put
        )
        model = Model(OpenLibraries(open_libraries(site.directories)))
        self.environment = Environment(
            model, HANDLERS, Services(site, time.monotonic), WorldChannel(self.station, site)
        )
        self.environment.listeners.append(self)
        self.station.begin(self.environment)
        self.values = {}

    def patch(self, patch):
        pass

    def say(self, say):
        self.says.append(say)

    def answer(self, wish):
        given = []
        self.environment.do(wish, "me", given.append)
        self.until(lambda: given)
        return given[0]

    def do(self, wish):
        answer = self.answer(wish)
        assert answer.no is None, answer.no
        return answer.value

    def until(self, reached):
        end = time.monotonic() + PATIENCE_S
        while not reached():
            assert time.monotonic() < end, f"it did not come; said was {[say.text for say in self.says[-5:]]}"
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()
            frame = self.station.frame()
            if frame is not None:
                self.values |= frame.values | {f"world:{name}": rows for name, rows in frame.poses.items()}

    def task(self, name):
        return self.environment.tree.documents["c1"].tasks[name]

    def told_states(self):
        """The states of tasks in the order in which the runtime tells them from now on."""
        states, receive = [], self.environment.receive

        def hear(message, station=""):
            if isinstance(message, event.TaskState):
                states.append((message.task, message.state))
            receive(message, station)

        self.environment.receive = hear
        return states

    def stands(self, name, state):
        self.until(lambda: self.task(name).state == state)


@pytest.fixture
def lab(tmp_path):
    lab = Lab(tmp_path)
    yield lab
    lab.station.end()


def test_an_arm_is_made_to_move_by_acts_alone(lab):  # R-C11, R-C12, R-C13, R-C14, R-C25
    doc = lab.do(act.New())
    lab.do(act.Connect(doc))
    for number, name in enumerate((*HOLDING, "jtraj")):
        lab.do(act.Place(doc, name, 200 * number, 100))
        lab.stands(name, "OFF")
    names = frozenset((f"{doc}/Q_MEZ",))
    lab.station.watch(names, frozenset(("boxes",)), True, 30.0)
    lab.do(act.Turn(doc, HOLDING, is_on=True))
    for name in HOLDING:
        lab.stands(name, "ON")
    lab.do(act.Toggle(doc, "jtraj"))
    lab.until(lambda: lab.task("jtraj").ask is not None)
    lab.do(act.Answer(doc, "jtraj", "0.5 -1.5 1.5 0 0 far 2"))
    lab.until(lambda: lab.task("jtraj").ask.reason)
    lab.do(act.Answer(doc, "jtraj", "0.5 -1.5 1.5 0 0 0 2"))
    lab.stands("jtraj", "ON")
    lab.stands("jtraj", "OFF")
    assert "jtraj has finished" in [str(say.text) for say in lab.says]
    lab.until(lambda: abs(lab.values.get(f"{doc}/Q_MEZ", [0.0])[0] - 0.5) < 0.01)
    assert len(lab.values["world:boxes"]["rows"]) > 6


def test_an_error_is_shown_and_cleared_and_an_undo_kills(lab):  # R-C11, R-C28, R-X10
    doc = lab.do(act.New())
    lab.do(act.Connect(doc))
    for name in ("puma", "moody"):
        lab.do(act.Place(doc, name, 0, 0))
        lab.stands(name, "OFF")
    lab.do(act.Toggle(doc, "moody"))
    lab.stands("moody", "ERROR")
    error = lab.task("moody").error
    assert "nothing has moved" in str(error.text) and error.entry == "cycle" and error.line > 0
    lab.do(act.Clear(doc, "moody"))
    lab.stands("moody", "OFF")
    lab.do(act.Undo(doc))  # it was ON before it failed
    lab.do(act.Undo(doc))
    lab.until(lambda: "moody" not in lab.environment.model.documents[doc].live.tasks)
    assert set(lab.environment.tree.documents[doc].tasks) == {"puma"}


def test_what_the_runtime_finds_wrong_is_refused_and_nothing_is_changed(lab):  # R-X01, R-X10
    doc = lab.do(act.New())
    lab.do(act.Connect(doc))
    lab.do(act.Place(doc, "puma", 0, 0))
    refused = lab.answer(act.Place(doc, "tangled", 300, 0)).no
    assert refused is not None and "tangled.rmod" in str(refused.reason) and "KNOT" in str(refused.reason)
    assert set(lab.environment.tree.documents[doc].tasks) == {"puma"}
    lab.stands("puma", "OFF")
    lab.do(act.Unit(doc, "puma", "rt1"))
    lab.stands("puma", "OFF")
    assert lab.task("puma").rtpu == "rt1"


def test_a_runtime_that_is_killed_is_shown_lost_and_another_takes_over(lab):  # R-E10, R-C18
    doc = lab.do(act.New())
    lab.do(act.Connect(doc))
    lab.do(act.Place(doc, "puma", 0, 0))
    os.kill(lab.station.pid, signal.SIGKILL)
    lab.until(lambda: lab.environment.tree.runtime.state == "lost")
    assert "killed by signal 9" in str(lab.environment.tree.runtime.text)
    assert lab.task("puma").state == "" and lab.environment.tree.documents[doc].connection == "lost"
    lab.do(act.Connect(doc))
    lab.stands("puma", "OFF")


def test_a_recalled_supermodule_is_born_and_comes_on_in_its_order(lab, tmp_path):  # R-C17, law 10
    doc = lab.do(act.New())
    for number, name in enumerate(HOLDING):
        lab.do(act.Place(doc, name, 200 * number, 100))
    order = HOLDING[::-1]
    lab.do(act.Group(doc, "arm", order))
    lab.do(act.SaveGroup(doc, "arm", str(tmp_path)))
    lab.do(act.Remove(doc, HOLDING))
    lab.do(act.Connect(doc))
    states = lab.told_states()
    lab.do(act.Insert(doc, "arm", 50, 50))
    for name in HOLDING:
        lab.stands(name, "OFF")
    supplier, *others = HOLDING
    assert states == [(name, "OFF") for name in (supplier, *reversed(others))]  # all others need its constants
    states.clear()
    lab.do(act.TurnGroup(doc, "arm", is_on=True))
    lab.until(lambda: len(states) == len(order))
    assert states == [(name, "ON") for name in order]
    states.clear()
    lab.do(act.TurnGroup(doc, "arm", is_on=False))
    lab.until(lambda: len(states) == len(order))
    assert states == [(name, "OFF") for name in HOLDING]

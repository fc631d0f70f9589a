import contextlib
import queue
import threading
import time

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.runtime_line import RuntimeLine
from onika.desk.environment.environment import Environment
from onika.desk.environment.outcome.outcome import Order, RequiredRuntime, Simulator
from onika.desk.environment.runtime_thread import RuntimeThread
from onika.link.lost import LinkLost, LossCause
from onika.model.lifecycle import State
from onika.model.task import Task
from onika.wire import act, event, live, reading
from onika.words.reason import Reason

PATIENCE_S = 60.0


class Lab(EnvironmentFixture):
    """An environment with a station, and the lines that it was given."""

    def __init__(self, folder):
        super().__init__(folder, (Task("a", "a", outvar=("A",), frequency=10.0),))
        (folder / "module" / "a.py").write_text("# a\n")
        self.things = queue.Queue()
        self.lines = []
        self.refusal = None
        self.station = RuntimeThread(self.open, self.things.put)
        model, handlers = self.environment.model, self.environment._handlers
        self.environment = Environment(model, handlers, self.surroundings, self.station)
        self.environment.listeners.append(self)
        self.station.begin(self.environment)

    def open(self, url, token, simulator=None):
        if self.refusal:
            raise self.refusal
        self.lines.append(RuntimeLine())
        self.simulator = simulator
        self.reached = (url, token, threading.current_thread().name)
        return self.lines[-1]

    def answer(self, request, by="me"):
        given = []
        self.environment.do(request, by, given.append)
        self.until(lambda: given)
        return given[0]

    def until(self, reached):
        end = time.monotonic() + PATIENCE_S
        while not reached():
            assert time.monotonic() < end, "it did not come"
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()


@pytest.fixture
def lab(tmp_path):
    lab = Lab(tmp_path)
    yield lab
    lab.station.end()


def test_the_first_connect_gets_a_runtime_in_the_stations_own_thread(lab):  # R-A15, R-C18
    doc = lab.new("a")
    assert lab.lines == []
    lab.do(act.Connect(doc, url="ws://there", token="secret"))
    assert lab.reached == ("ws://there", "secret", "station")
    lab.until(lambda: lab.environment.tree.documents[doc].tasks["a"].state == "OFF")
    assert live.Attend(("*",), hz=0.1) in lab.lines[0].asked


def test_a_simulator_takes_the_place_of_the_runtime_as_it_was_asked_for(lab):  # R-X05
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    assert lab.simulator is None
    wanted = Simulator(("left",), ("--shake", "3"))
    lab.station.send(Order(live.Survey(), reach=RequiredRuntime(is_anew=True, simulator=wanted)))
    lab.until(lambda: len(lab.lines) == 2)
    assert lab.simulator == wanted and lab.lines[0].is_left


def test_a_token_is_known_for_the_next_time(lab):  # R-C18
    doc = lab.new()
    lab.do(act.Connect(doc, url="ws://there", token="secret"))
    lab.lines[0].say(LinkLost(LossCause.CLOSED, Reason.plain("the cable")))
    lab.until(lambda: lab.environment.tree.runtime.state == "lost")
    lab.do(act.Connect(doc))
    assert lab.reached[:2] == ("ws://there", "secret")


def test_where_no_runtime_is_to_be_had_the_reason_is_the_answer(lab):  # R-C18
    doc = lab.new("a")
    for lab.refusal in (
        LinkLost(LossCause.TOKEN, Reason.plain("the token is wrong")),
        OSError("no program"),
        ValueError("no address"),
    ):
        assert str(lab.refusal) in str(lab.answer(act.Connect(doc)).no.reason)
    lab.refusal = None
    lab.do(act.Connect(doc))


def test_without_a_runtime_every_order_is_answered(lab):  # law 27
    assert str(lab.do(act.Stop())) == "there is nothing to stop: no runtime is connected"


def test_a_stop_passes_a_runtime_that_does_not_answer(lab):  # law 27
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    lab.lines[0].silent = (live.Change,)
    lab.environment.do(act.Toggle(doc, "a"), "me", lambda given: None)
    lab.do(act.Stop())
    assert lab.lines[0].runtime.is_stopped


def test_what_a_runtime_tells_by_itself_is_heard(lab):
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    lab.until(lambda: lab.environment.tree.documents[doc].tasks["a"].state == "OFF")
    home = lab.environment.model.documents[doc].live.subsystem
    lab.lines[0].runtime.lives[home]["a"].state = State.ERROR
    lab.lines[0].say(event.TaskState(home, "a", "ERROR", 1.0))
    lab.until(lambda: lab.environment.tree.documents[doc].tasks["a"].state == "ERROR")


def test_a_runtime_that_is_lost_answers_what_was_open_and_another_is_got_by_connecting(lab):  # R-E10
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    lab.lines[0].silent = (live.Reset,)
    answers = []
    lab.environment.do(act.Reset(), "me", answers.append)
    lab.lines[0].say(LinkLost(LossCause.CLOSED, Reason.plain("it was killed")))
    lab.until(lambda: answers)
    assert str(answers[0].no.reason) == "it was killed"
    assert str(lab.environment.tree.runtime.text) == "it was killed" and lab.lines[0].is_left
    assert lab.environment.tree.documents[doc].connection == "lost"
    lab.do(act.Connect(doc))
    assert len(lab.lines) == 2
    lab.until(lambda: lab.environment.tree.documents[doc].tasks["a"].state == "OFF")


def test_a_runtime_that_talks_another_language_is_given_up(lab):
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    lab.lines[0].say(ValueError("no such message"))
    lab.until(lambda: lab.environment.tree.runtime.state == "lost")
    assert str(lab.environment.tree.runtime.text) == "the runtime cannot be understood: no such message"


def test_what_is_watched_comes_in_frames_and_figures_with_loads(lab):  # R-C14, R-A11
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    home = lab.environment.model.documents[doc].live.subsystem
    lab.station.watch(frozenset((f"{doc}/A",)), frozenset(), True, 30.0)
    line = lab.lines[0]
    lab.until(lambda: live.Attend(("*",), (f"{home}/A",), (), 30.0) in line.asked)
    line.seen = {f"{home}/A": reading.encode(reading.Variable(10**9, 1, 4.0))}
    line.say()
    values = {}

    def has_come():
        frame = lab.station.frame()
        if frame is not None:
            values.update(frame.values | frame.figures)
        return {f"{doc}/A", f"{doc}/a"} <= set(values)

    lab.until(has_come)
    assert values[f"{doc}/A"] == 4.0
    lab.until(lambda: lab.environment.tree.runtime.units["rt0"].load == 0.25)


def test_the_end_lets_the_runtime_go(lab):  # R-A15
    lab.do(act.Connect(lab.new()))
    lab.station.end()
    assert lab.lines[0].is_left


def test_a_runtime_that_was_started_here_is_exchanged_for_another(lab):  # R-E10
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    lab.lines[0].silent = (live.Scene,)
    given = []
    lab.environment.do(act.Scene("boxes"), "me", given.append)
    lab.do(act.StartAnew(confirmed=True))
    assert len(lab.lines) == 2 and lab.lines[0].is_left and not lab.lines[1].is_left
    assert given[0].no.reason.key == "run.started_anew"
    assert lab.environment.tree.documents[doc].connection == "none"


def test_a_runtime_elsewhere_hears_nothing_while_the_environment_does_not_turn(lab, monkeypatch):  # R-X12
    monkeypatch.setattr("onika.desk.environment.reconcile.loop_watchdog.LIMIT_S", 0.2)
    doc = lab.new()
    assert lab.answer(act.Connect(doc, url="ws://far:1")).no is None
    line = lab.lines[-1]
    served = []
    line.due_s = lambda: served.append(time.monotonic()) or 0.01

    def grows():
        before = len(served)
        end = time.monotonic() + 0.3
        while len(served) == before and time.monotonic() < end:
            time.sleep(0.005)
        return len(served) > before

    lab.until(lambda: len(served) > 3)
    end = time.monotonic() + PATIENCE_S
    while grows():  # nothing is taken from `things`: the environment is busy
        assert time.monotonic() < end, "the thread spoke on for an environment that does not turn"
    count = len(served)
    lab.until(lambda: len(served) > count)


def test_a_runtime_rests_when_that_is_wished_and_hears_the_next_order(lab):  # R-X25
    doc = lab.new("a")
    lab.do(act.Connect(doc))
    line = lab.lines[0]
    naps = []
    line.rest = lambda: naps.append("rest") or True
    line.wake = lambda: naps.append("wake")
    lab.station.rest()
    lab.until(lambda: naps == ["rest"])
    lab.do(act.Stop())
    assert line.runtime.is_stopped
    assert naps[:2] == ["rest", "wake"]
    lab.station.wake()
    lab.until(lambda: not lab.station._rest.is_wished)

import time
from pathlib import Path
from queue import Empty, Queue

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from kit.record.recording_builder import RecordingBuilder, run as recorded
from onika.desk.environment import initial_model
from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.outcome import Simulator
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.runtime_thread import RuntimeThread
from onika.desk.run.run import run
from onika.desk.run.settings import RunSettings
from onika.store.site import open_site
from onika.wire import act, event, live, request, steer
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


@pytest.fixture
def tape(tmp_path):
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.tell(0.0, event.Began(0, 0, 2, "mass", 0.0))
    tape.ask(0.5, steer.Pause("flow0"))
    tape.ask(1.5, steer.Resume("flow0"))
    tape.variable("X", "double", (0.0, 1.0), (2.0, 2.0))
    return tape


def looked_at(play, tape, **ending):
    tape.end(**ending)
    assert play.later(act.OpenRecording(str(tape.path))).no is None


def continued(play, at_s, **more):
    """The answer of going on, when the recording was read again and the runtime has answered."""
    given = []
    play.environment.do(act.Continue(at_s, **more), "me", given.append)
    while not given:
        play.become()
        play.pump()
    return given[0]


def test_the_plan_of_then_is_begun_in_a_simulator_with_what_was_asked_up_to_the_instant(play, tape):  # R-X05
    looked_at(play, tape)
    assert continued(play, 1.0).value == 1
    order = next(order for order in play.orders if order.reach is not None and order.reach.is_anew)
    assert order.reach.simulator == Simulator(("rt0",)) and isinstance(order.asked, live.Survey)
    begin = play.carried(request.Begin)[-1]
    assert play.carried(request.Prepare)[-1] == recorded().prepare
    assert (begin.seed, begin.repeat_until_ns, len(begin.repeat)) == (3, 1_000_000_000, 1)
    assert (begin.may_ask, begin.on_error, begin.is_held, begin.record) == (True, "wait", False, "")


def test_it_is_shown_as_a_run_and_the_recording_is_put_away(play, tape):  # R-X05
    looked_at(play, tape)
    continued(play, 1.0)
    assert (play.view.state, play.view.repeats_until_s, play.view.recording) == ("running", 1.0, "")
    assert list(play.view.flows) == ["flow0"] and play.environment.tree.review is None
    assert any("up to 1.0 s" in str(say.text) for say in play.says)


def test_what_was_ended_by_hand_goes_on_all_the_same(play, tape):  # R-X05
    tape.ask(1.9, request.Abort(Reason.plain("aborted by the user")))
    looked_at(play, tape)
    assert continued(play, 2.0).no is None
    begin = play.carried(request.Begin)[-1]
    requests = [request.decode_request(line.body) for line in begin.repeat]
    assert requests == [steer.Pause("flow0"), steer.Resume("flow0")]
    assert any("ended by hand" in str(note) for note in play.view.notes)


def test_what_lives_ends_only_when_the_user_wants_it(play, tape):  # R-X01, reading 30
    doc = play.connected("c")
    looked_at(play, tape)
    no = play.no(act.Continue(1.0))
    assert "Untitled-1 with its tasks" in str(no.reason) and no.remedies[0].act == act.Continue(1.0, confirmed=True)
    assert play.environment.tree.review is not None
    assert continued(play, 1.0, confirmed=True).no is None
    assert play.document(doc).live is None
    assert any("Untitled-1 is no longer connected" in str(say.text) for say in play.says)


def test_a_configuration_in_which_nothing_lives_is_nothing_to_ask_about(play, tape):
    doc = play.new()
    play.do(act.Connect(doc))
    looked_at(play, tape)
    assert continued(play, 1.0).no is None
    assert play.document(doc).live is None


def test_a_runtime_elsewhere_is_left_only_when_the_user_wants_it(play, tape):  # R-X01
    play.do(act.Connect(play.new("c"), url="ws://there"))
    looked_at(play, tape)
    assert "ws://there is left for the simulator, and Untitled-1" in str(play.no(act.Continue(1.0)).reason)
    assert continued(play, 1.0, confirmed=True).no is None
    assert play.environment.tree.runtime.address == ""


def test_while_an_application_runs_nothing_is_gone_on_with(play, tape):
    looked_at(play, tape)
    doc = play.open([job("aC")])
    play.run(doc)
    no = play.no(act.Continue(1.0))
    assert "play runs" in str(no.reason) and no.remedies[0].act == act.Steer("abort", doc)


def test_what_cannot_be_gone_on_from_says_why(play, tmp_path):  # R-X05
    assert "no recording" in str(play.no(act.Continue(1.0)).reason)
    looked_at(play, RecordingBuilder(tmp_path / "later.mcap", recorded(is_fresh=False)))
    assert "other things had happened" in str(play.no(act.Continue(0.0)).reason)


def test_a_recording_that_is_gone_since_it_was_opened_is_told(play, tape):  # R-X05, R-X10
    looked_at(play, tape)
    tape.path.unlink()
    assert "it cannot be continued: expected" in str(continued(play, 1.0).no.reason)
    assert "found no such file" in str(continued(play, 1.0).no.reason)


def test_an_instant_that_is_none_is_refused(play, tape):
    looked_at(play, tape)
    assert "from 0 to 2 s, found 9" in str(play.no(act.Continue(9.0)).reason)


def test_without_a_simulator_the_recording_is_still_there(play, tape):  # R-E10
    looked_at(play, tape)
    play.rebuffs = {live.Survey: request.Refused(Reason.plain("no program"))}
    assert "no simulator: no program" in str(continued(play, 1.0).no.reason)
    assert play.environment.tree.run is None and play.environment.tree.review is not None


@pytest.mark.parametrize("kind", [request.Prepare, request.Begin])
def test_what_the_simulator_does_not_take_is_told_and_nothing_runs(play, tape, kind):
    looked_at(play, tape)
    play.rebuffs = {**play.rebuffs, kind: request.Refused(Reason.plain("not this one"))}
    assert "not this one" in str(continued(play, 1.0).no.reason)
    assert play.environment.tree.run is None and play.environment.tree.review is not None


class Real:
    """An environment with a real simulator behind it."""

    def __init__(self, folder: Path) -> None:
        self.changes: Queue = Queue()
        self.results = []
        site = open_site([], {}, None)
        reading = BackgroundWorker(lambda change: self.changes.put(lambda: self.environment.become(change)))
        outside = Services(site, time.monotonic, folder, reading=reading)
        self.station = RuntimeThread(RuntimeLauncher(), self.changes.put)
        model, _ = initial_model.opened(site, folder, {})
        self.environment = Environment(model, HANDLERS, outside, self.station)
        receive = self.environment.receive

        def listen(message: event.Event, station: str = "") -> None:
            self.results += [message] if isinstance(message, event.Result) else []
            receive(message, station)

        self.environment.receive = listen
        self.station.begin(self.environment)

    def do(self, wish):
        given = []
        self.environment.do(wish, "me", given.append)
        self.until(lambda: given)
        assert given[0].no is None, given[0].no.reason
        return given[0].value

    def until(self, is_so):
        until = time.monotonic() + 60
        while not is_so():
            assert time.monotonic() < until
            try:
                self.changes.get(timeout=0.1)()
            except Empty:
                continue


class Nobody:
    """A watcher who only watches."""

    can_steer = False

    def begins(self, *_): ...
    def happens(self, *_): ...
    def answer(self, _): ...
    def wishes(self):
        return ()

    def looks(self):
        return False

    def placed(self, *_): ...
    def steered(self, *_): ...


@pytest.mark.site
def test_where_nobody_steers_the_end_is_that_of_the_recorded_run(tmp_path):  # R-X05, law 29
    path = tmp_path / "run.mcap"
    outcome = run(RunSettings("go_home", is_virtual=True, record=path), open_site([], {}, None), Nobody())
    assert outcome.result is not None and outcome.result.completed
    real = Real(tmp_path / "state")
    try:
        doc = real.do(act.Open("go_home"))
        real.do(act.OpenRecording(str(path)))
        began = time.monotonic()
        real.do(act.Continue(outcome.result.runtime_s - 0.5))
        view = real.environment.tree.run
        assert view is not None and view.doc == doc and real.environment.tree.runtime.is_virtual
        real.until(lambda: real.results)
        assert [result.hash for result in real.results] == [outcome.result.hash]
        assert time.monotonic() - began > 0.4, "the rest passes as time on the wall does"
        assert {step.state for step in real.environment.tree.run.steps.values()} == {"done"}
    finally:
        real.station.end()

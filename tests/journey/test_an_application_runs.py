"""The third journey: file, readiness, plan, runtime, engine, tasks, events — in one process, over a memory link.

No process is started and no clock of this machine is read: the environment's clock is moved by hand, and the
runtime's time is virtual.
"""

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from onika.desk.plan.compile import rtpus_of
from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.program import RuntimeProgram
from onika.host.sessions.request_server import RequestServer
from onika.host.units.virtual import VirtualDriver
from onika.link.carrier import memory_pair
from onika.link.connection import Connection
from onika.link.link_events import SignalReceived
from onika.link.link_terms import LinkTerms
from onika.link.sessions import Sessions
from onika.store.site import open_site
from onika.wire import event, request
from onika.words.reason import Reason

TERMS = LinkTerms(beat_ns=10**9, suspect_ns=10**10, lost_ns=10**11, greeting_ns=10**10)


class Journey:
    """Environment and runtime in one thread: the runtime works whenever the environment waits."""

    def __init__(self, application, site):
        self.now = 0
        self.prepared = prepare_run(str(application), site)
        here, there = memory_pair()
        gate = RequestServer(Sessions("first life"), lambda: self.now)
        gate.adopt(there, TERMS)
        rtpus = rtpus_of(self.prepared.plan)
        self.program = RuntimeProgram(gate, VirtualDriver(rtpus, gate.tell), ModuleFacts(), rtpus)
        self.connection = Connection(here, lambda: self.now, TERMS, wait=self.work)
        self.connection.open()

    def work(self, _carrier, _timeout):
        self.now += 1_000_000
        self.program.advance(10**9)
        self.program.serve()

    def ask(self, wish):
        return request.decode_response(self.connection.request(request.encode(wish), timeout_s=60.0))

    def events(self):
        """Everything that is told, up to the result."""
        while True:
            for received in self.connection.poll(1.0):
                if isinstance(received, SignalReceived):
                    message = event.decode(received.body)
                    yield message
                    if isinstance(message, event.Result):
                        return


@pytest.fixture
def site(tmp_path):
    return open_site([tmp_path], {}, None)


def moves(tmp_path, *turns):
    steps = []
    for number, turn in enumerate(turns):
        steps += [job("jmoveC", "Joint job"), joints(f"place{number}", turn, -1.4, 1.5, 0.0, 0.1, 0.0, duration=0.8)]
    return Laboratory(tmp_path).application("journey", steps)


def test_an_application_runs(tmp_path, site):  # R-E01, R-E02, R-E03, R-E11, R-E14
    journey = Journey(moves(tmp_path, 0.2, 0.4), site)
    assert journey.prepared.faults == ()
    assert journey.ask(request.Prepare(journey.prepared.plan, journey.prepared.targets)) == request.Prepared(
        (), worlds={"boxes": True}
    )
    assert journey.ask(request.Begin(watch=("Q_MEZ",))) == request.Done()
    *messages, result = journey.events()
    assert (result.completed, result.done, result.of, str(result.cause)) == (True, 2, 2, "")
    assert result.values["Q_MEZ"][0] == pytest.approx(0.4, abs=1e-3)
    lives = {}
    for message in messages:
        if isinstance(message, event.TaskState):
            lives.setdefault(message.task, []).append(message.state)
    assert lives["jtraj"] == ["OFF", "ON", "OFF", "ON", "OFF", "KILLED"]
    assert lives["puma"] == ["OFF", "ON", "KILLED"]  # switching jobs touches nothing but the trigger (law 6)
    actions = [message for message in messages if isinstance(message, event.Began | event.Done)]
    assert [(type(action).__name__, action.index) for action in actions] == [
        ("Began", 0),
        ("Done", 0),
        ("Began", 1),
        ("Done", 1),
    ]
    drives = [message.state for message in messages if isinstance(message, event.Drive)]
    assert drives == ["DRIVEN", "HELD"]


def test_an_application_with_a_target_out_of_reach_does_not_run(tmp_path, site):  # R-E01, R-X02
    path = moves(tmp_path, 0.2, 9.0)
    journey = Journey(path, site)
    answer = journey.ask(request.Prepare(journey.prepared.plan, journey.prepared.targets))
    (fault,) = answer.faults
    *_, second = [number for number, line in enumerate(path.read_text().splitlines(), 1) if "jmoveC" in line]
    assert (fault.file, fault.line) == (str(path), second)
    assert str(fault.reason) == ("expected a target within reach, found place1: joint 1 at 9.00 rad is beyond 2.79")
    assert isinstance(journey.ask(request.Begin()), request.Refused)


def test_a_run_is_aborted_over_the_link(tmp_path, site):  # R-E07
    journey = Journey(moves(tmp_path, 0.2), site)
    journey.ask(request.Prepare(journey.prepared.plan, journey.prepared.targets))
    journey.program._driver.advance = slowly(journey.program._driver.advance)
    journey.ask(request.Begin())
    assert journey.ask(request.Abort(Reason.plain("the user has changed her mind"))) == request.Done()
    *_, result = journey.events()
    assert (result.completed, str(result.cause), result.done) == (False, "the user has changed her mind", 0)


def slowly(advance):
    """One instant at a time, so that the environment gets a word in."""
    return lambda _wall_ns: advance(0)


def test_the_same_journey_twice_is_the_same(tmp_path, site):  # R-X08
    hashes = set()
    for _ in range(2):
        journey = Journey(moves(tmp_path, 0.2), site)
        journey.ask(request.Prepare(journey.prepared.plan, journey.prepared.targets))
        journey.ask(request.Begin())
        hashes.add(list(journey.events())[-1].hash)
    assert len(hashes) == 1

"""Several runtimes spoken to as one; the test says what each answers and tells."""

from dataclasses import dataclass, field
from itertools import count

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.joined.joined_runtimes import JoinedRuntimes
from onika.desk.run.runtime_conversation import NumberedResponse
from onika.wire import event, live, request, steer
from onika.wire.rendezvous_link import Linked, LinkRuntimes, MeetingTerms, OfferPact, PactOffered, Way
from onika.words.reason import NOTHING, Reason

TASK = """
from onika.module import Module, OutVar

class Task(Module):
    trigger = True
    X = OutVar("double", "m", "a place")
"""
RESULT = event.Result(True, NOTHING, 1, 1, 1.0, 2.0, {}, (), "", run="flow0")


@dataclass
class Runtime:
    """Answers by kind of request; what was asked is kept."""

    answers: dict = field(default_factory=dict)
    asked: list = field(default_factory=list)
    told: list = field(default_factory=list)
    numbers: count = field(default_factory=lambda: count(1))

    def __post_init__(self):
        self.answers = {
            request.Prepare: request.Prepared(()),
            OfferPact: PactOffered(5000, bytes(8), bytes(32), 7),
            LinkRuntimes: Linked((Way(0, 2_000_000, 1_000_000),)),
            steer.Who: steer.Positions((steer.Position("flow", "running", 0),)),
            request.Snapshot: request.Worlds({"w": b"1"}),
            **self.answers,
        }

    def __enter__(self):
        return self

    def __exit__(self, *_fault):
        self.asked.append("left")

    def ask(self, message):
        self.asked.append(message)
        return self.answers.get(type(message), request.Done())

    def send(self, message):
        number = next(self.numbers)
        self.told.append(NumberedResponse(number, self.ask(message)))
        return number

    def messages(self, timeout_s=0.0):
        told, self.told = self.told, []
        return iter(told)

    def events(self, timeout_s):
        return (message for message in self.messages() if not isinstance(message, NumberedResponse))


def joined(*runtimes):
    """Of two flows, each on one of them; prepared."""
    shop = PlanBuilder()
    shop.task("a", TASK, module="task")
    plan = shop.plan([action("a")], [action("a")])
    made = JoinedRuntimes(runtimes, {"flow0": 0, "flow1": 1}, ("ws://a", "ws://b"), ("::1", "::1"))
    with made:
        return made, made.ask(request.Prepare(plan, ()))


@pytest.fixture
def two():
    return Runtime(), Runtime()


def of(runtime, kind):
    return [message for message in runtime.asked if isinstance(message, kind)]


def test_each_prepares_its_own_flows_and_all_begin_on_the_same_terms(two):  # R-E12, R-F02
    made, prepared = joined(*two)
    assert prepared.faults == ()
    assert "held after" in str(prepared.notes[0])
    assert [of(runtime, request.Prepare)[0].plan.flows[0].subsystem for runtime in two] == ["flow0", "flow1"]
    assert made.ask(request.Begin(watch=("flow0/X", "flow1/X"))) == request.Done()
    begun = [of(runtime, request.Begin)[0] for runtime in two]
    assert [message.meets for message in begun] == [MeetingTerms(1_000_000, 2_250_000)] * 2
    assert [message.watch for message in begun] == [("flow0/X",), ("flow1/X",)]


def test_faults_of_all_are_told_and_nobody_is_linked():
    fault = request.FaultText("f", 1, Reason.plain("wrong"), NOTHING)
    two = Runtime(), Runtime({request.Prepare: request.Prepared((fault,))})
    _, prepared = joined(*two)
    assert prepared.faults == (fault,)
    assert of(two[0], OfferPact) == []


def test_runtimes_that_cannot_meet_are_a_fault():
    unheard = Linked((), Reason.plain("unheard"))
    _, prepared = joined(Runtime(), Runtime({LinkRuntimes: unheard}))
    assert "ws://b: unheard" in str(prepared.faults[0].reason)


def test_where_one_will_not_begin_the_others_are_aborted():
    two = Runtime(), Runtime({request.Begin: request.Refused(Reason.plain("stopped"))})
    made, _ = joined(*two)
    assert str(made.ask(request.Begin()).reason) == "stopped"
    assert str(of(two[0], request.Abort)[0].cause) == "stopped"


def test_what_happens_is_told_with_the_numbers_of_the_whole(two):
    made, _ = joined(*two)
    two[1].told.append(event.Began(0, 0, 1, "go", 0.1, run="flow1"))
    two[0].told.append(event.Moved("flow0", "running", 0, 0.1))
    told = list(made.events(0.0))
    assert [(message.flow, message.run) for message in told if isinstance(message, event.Began)] == [(1, "flow0")]
    assert len(told) == 2


def test_the_run_is_over_when_all_parts_are_and_completed_when_all_are(two):  # R-E14
    made, _ = joined(*two)
    two[0].told.append(replace(RESULT, values={"flow0/X": 1.0}))
    assert list(made.events(0.0)) == []
    two[1].told.append(replace(RESULT, values={"flow1/X": 2.0}, wall_s=3.0, run="flow1"))
    (result,) = made.events(0.0)
    assert (result.completed, result.done, result.of, result.wall_s, result.run) == (True, 2, 2, 3.0, "flow0")
    assert result.values == {"flow0/X": 1.0, "flow1/X": 2.0}


def test_where_one_part_ends_badly_the_others_are_aborted_and_its_cause_is_told(two):
    made, _ = joined(*two)
    two[1].told.append(replace(RESULT, completed=False, cause=Reason.plain("broken")))
    list(made.events(0.0))
    assert str(of(two[0], request.Abort)[0].cause) == "broken"
    two[0].told.append(replace(RESULT, completed=False, cause=Reason.plain("aborted")))
    (result,) = made.events(0.0)
    assert not result.completed


def test_a_stop_is_for_all_and_steering_for_whose_flow_it_is(two):  # law 27, R-E13
    made, _ = joined(*two)
    made.ask(request.Stop(Reason.plain("enough")))
    made.ask(steer.Pause("flow1"))
    made.ask(live.Read("flow1", ("X",)))
    assert [len(of(runtime, request.Stop)) for runtime in two] == [1, 1]
    assert [len(of(runtime, steer.Pause)) for runtime in two] == [0, 1]
    assert [len(of(runtime, live.Read)) for runtime in two] == [0, 1]


def test_positions_and_worlds_of_all_are_one_answer(two):
    made, _ = joined(*two)
    assert len(made.ask(steer.Who()).flows) == 2
    assert made.ask(request.Snapshot()).snapshots == {"w": b"1"}
    assert (made.pid, made.printed(), made.black_box()) == (None, "", "")


def test_what_is_told_while_all_are_asked_is_not_lost(two):
    made, _ = joined(*two)
    two[0].told.append(event.Moved("flow0", "waiting", 0, 0.1))
    made.ask(steer.Who())
    assert [message.state for message in made.events(0.0)] == ["waiting"]

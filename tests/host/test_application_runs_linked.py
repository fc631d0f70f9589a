"""A run whose flows meet those of other runtimes is linked with them from its beginning to its end (decision 56)."""

import pytest

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.wire import request
from onika.wire.rendezvous_link import MeetingTerms
from onika.words.reason import NOTHING, Reason

TERMS = MeetingTerms(1, 2)


class Rendezvous:
    """A rendezvous without tags."""

    shared = frozenset()

    def __init__(self):
        self.served = 0

    def attach(self, executors, prepared, feed):
        self.executors = executors

    def due_ns(self):
        return None

    def serve(self, now):
        self.served += 1


class Links:
    """What is asked of the links of a runtime, with whatever they answer."""

    def __init__(self):
        self.calls, self.refusal, self.rendezvous = [], NOTHING, Rendezvous()

    def objection(self, *given):
        self.calls.append(("objection", *given))
        return self.refusal

    def begin(self, *given):
        self.calls.append(("begin", *given))
        return self.rendezvous

    def end(self, *given):
        self.calls.append(("end", *given))

    def forget(self, session):
        self.calls.append(("forget", session))


@pytest.fixture
def desk():
    client = DirectClient()
    client.links = client.program.applications._links = Links()
    client.ask(request.Prepare(rail_tasks().plan([action("mass", "servo", arguments="1.0")]), ()), "me")
    return client


def test_a_run_begins_with_its_rendezvous_and_ends_with_it(desk):  # R-F02
    links = desk.links
    assert desk.ask(request.Begin(meets=TERMS), "me") == request.Done()
    assert links.calls == [("objection", "me", TERMS), ("begin", "me", TERMS, desk.driver)]
    assert desk.program.subsystems.runs[0].runner.rendezvous is links.rendezvous
    assert desk.to_the_end().completed
    assert links.rendezvous.served
    assert links.calls[2:] == [("end", links.rendezvous, desk.driver.now)]


def test_a_run_whose_runtimes_are_not_linked_does_not_begin(desk):
    desk.links.refusal = Reason.plain("not linked")
    assert desk.ask(request.Begin(meets=TERMS), "me") == request.Refused(Reason.plain("not linked"))
    assert desk.links.calls == [("objection", "me", TERMS)]
    assert not desk.program.is_running


def test_what_a_session_has_linked_goes_with_it(desk):
    desk.program.applications.lost("me")
    assert desk.links.calls == [("forget", "me")]

"""Runtimes learn of each other before a run; both are in this process, datagrams are real, time is handed in."""

import select
from dataclasses import dataclass

import pytest

from onika.host.run.rendezvous_links import HEARD_NS, LINGER_NS, UNHEARD_NS, RendezvousLinks
from onika.ring.begin_words import BeginWords
from onika.wire.rendezvous_link import (
    Linked,
    LinkedRuntime,
    LinkRuntimes,
    MeetingTerms,
    OfferPact,
    PactOffered,
    SharedTag,
)
from onika.wire.request import Refused

RUN = bytes(16)
TERMS = MeetingTerms(1_000_000, 2_000_000)


@dataclass
class Driver:
    now: int = 10**9
    is_virtual: bool = False

    def begin_words(self, rtpu):
        return BeginWords()


class Runtime:
    """One runtime's links, with one session."""

    def __init__(self, driver):
        self.links, self.driver, self.answers = RendezvousLinks(), driver, []

    def ask(self, asked):
        self.links.ask("me", asked, self.driver, self.answers.append)
        return self.answers[-1] if self.answers else None

    def serve(self):
        select.select(self.links.readers(), [], [], 0.05)
        self.links.serve(self.driver.now)


@pytest.fixture
def two():
    driver = Driver()
    runtimes = Runtime(driver), Runtime(driver)
    yield runtimes
    for runtime in runtimes:
        runtime.links.forget("me")
        for channel in runtime.links.readers():
            channel.close()


def partner(site, pact, **other):
    about = {"site": site, "title": f"site {site}", "host": "127.0.0.1", "port": pact.port, "name": pact.name}
    return LinkedRuntime(**{**about, "key": pact.key, "epoch": pact.epoch, **other})


def link(two, *sites):
    """Hand the pacts round, and let those runtimes link."""
    pacts = [runtime.ask(OfferPact()) for runtime in two]
    for site in sites:
        other = partner(1 - site, pacts[1 - site])
        two[site].answers.clear()
        two[site].ask(LinkRuntimes(RUN, site, (other,), (SharedTag("x", (0, 1)),)))


def pass_time(two, until_ns):
    driver = two[0].driver
    while driver.now < until_ns:
        driver.now += 50_000_000
        for runtime in two:
            runtime.serve()


def test_runtimes_that_hear_each_other_are_linked_and_say_how_far_they_are(two):  # R-F02
    link(two, 0, 1)
    pass_time(two, two[0].driver.now + HEARD_NS)
    assert [len(runtime.answers) for runtime in two] == [1, 1]
    for site, runtime in enumerate(two):
        answer = runtime.answers[0]
        assert isinstance(answer, Linked)
        assert not answer.refusal
        assert answer.ways[0].site == 1 - site
        assert 0 <= answer.ways[0].trip_ns <= answer.ways[0].clock_ns * 2


def test_who_is_not_heard_is_named(two):
    link(two, 0)
    pass_time(two, two[0].driver.now + UNHEARD_NS)
    assert two[0].answers[0].ways[0].trip_ns == -1
    assert str(two[0].answers[0].refusal).endswith("site 1")
    assert two[0].links.objection("me", TERMS) == two[0].links.objection("me", None)


def test_a_run_begins_on_terms_only_when_its_runtimes_are_linked(two):
    assert two[0].links.objection("me", TERMS)
    link(two, 0, 1)
    assert two[0].links.objection("me", TERMS)  # nobody has answered yet
    pass_time(two, two[0].driver.now + HEARD_NS)
    assert not two[0].links.objection("me", TERMS)
    run = two[0].links.begin("me", TERMS, two[0].driver)
    assert run.shared == {"x"}
    assert run.terms.alone_ns == 85_500_000
    assert two[0].links.begin("me", None, two[0].driver) is None


def test_after_its_run_a_runtime_speaks_for_a_while(two):
    link(two, 0, 1)
    pass_time(two, two[0].driver.now + HEARD_NS)
    links, now = two[0].links, two[0].driver.now
    run = links.begin("me", TERMS, two[0].driver)
    links.end(run, now)
    links.end(None, now)
    assert len(links.readers()) == 1
    assert links.due_ns(now) is not None
    pass_time(two, now + LINGER_NS)
    assert (links.readers(), links.due_ns(now)) == ([], None)


def test_a_stop_is_passed_on_to_the_others(two):  # law 27
    link(two, 0, 1)
    pass_time(two, two[0].driver.now + HEARD_NS)
    runs = [runtime.links.begin("me", TERMS, runtime.driver) for runtime in two]
    two[0].links.stop()
    for run in (*runs, *runs):
        run.serve(two[0].driver.now + 30_000_000)
        select.select([], [], [], 0.02)
    assert two[1].links.is_stopped


@pytest.mark.parametrize(
    "wrong",
    [
        {"run": b"short"},
        {"partners": ()},
        {"site": 1},
        {"tags": (SharedTag("x", (0, 7)),)},
        {"tags": (SharedTag("x", (0,)),)},
        {"tags": (SharedTag("x", (0, 1)),) * 57},
    ],
    ids=str,
)
def test_what_cannot_be_linked_is_refused(two, wrong):
    pact = two[0].ask(OfferPact())
    two[0].answers.clear()
    asked = {"run": RUN, "site": 0, "partners": (partner(1, pact),), "tags": (SharedTag("x", (0, 1)),)} | wrong
    assert two[0].ask(LinkRuntimes(**asked)).refusal
    two[0].answers.clear()
    short = partner(1, pact, key=b"short")
    assert two[0].ask(LinkRuntimes(RUN, 0, (short,), (SharedTag("x", (0, 1)),))).refusal


def test_without_a_pact_nothing_is_linked_and_a_new_one_replaces_the_old(two):
    runtime = two[0]
    assert "OfferPact" in str(runtime.ask(LinkRuntimes(RUN, 0, (), ())).refusal)
    first, second = runtime.ask(OfferPact()), runtime.ask(OfferPact())
    assert isinstance(first, PactOffered)
    assert first.key != second.key


def test_an_address_that_is_none_of_the_machine_and_a_virtual_clock_are_refused(two):
    assert isinstance(two[0].ask(OfferPact("192.0.2.7")), Refused)
    two[1].driver.is_virtual = True
    assert "wall time" in str(two[1].ask(OfferPact()).reason)
